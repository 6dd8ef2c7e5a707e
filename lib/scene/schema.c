#include "schema.h"

#include <locale.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "physical.h"
#include "spell.h"

const char *const product_names[] = {
    "equilibria", "folds", "nullclines", "field_arrows", "manifolds",
    "knees",      "estimates", "trajectories", NULL
};
static const char *const axes_names[] = { "log", "linear", "eigen", NULL };
static const char *const units_names[] = { "dimensionless", "si", NULL };
static const char *const board_names[] = { "bristol_board", NULL };

/* ---- values ------------------------------------------------------------ */

static void *member(struct scene *s, const struct schema_key *key)
{
    return (char *) s + key->offset;
}

static enum status wrong(const struct schema_key *key, const struct node *n,
                         struct fault *why)
{
    const char *what = n->kind == NODE_MAP    ? "a map of keys"
                       : n->kind == NODE_LIST ? "a list"
                                              : n->text;

    return node_blame(n, why, "%s: '%s' is not allowed, expected %s", key->path,
                      what, key->expected);
}

/* A decimal number, read the same under every locale. */
static bool to_number(const struct node *n, double *value)
{
    char *end;

    if (n->kind != NODE_SCALAR || n->text[0] == '\0')
        return false;
    if (strcmp(n->text, "inf") == 0 || strcmp(n->text, ".inf") == 0) {
        *value = HUGE_VAL;
        return true;
    }
    if (strspn(n->text, "+-.0123456789eE") != strlen(n->text))
        return false;
    const locale_t c = newlocale(LC_NUMERIC_MASK, "C", (locale_t) 0);
    if (c == (locale_t) 0)
        return false;
    *value = strtod_l(n->text, &end, c);
    freelocale(c);
    return *end == '\0' && isfinite(*value);
}

/* lo <= value <= hi; strictly greater where lo is 0 with expected "> 0". */
static bool in_range(const struct schema_key *key, double value)
{
    const bool open = strstr(key->expected, "> 0") != NULL;
    return (open ? value > key->lo : value >= key->lo) && value <= key->hi;
}

static enum status read_real(const struct schema_key *key,
                             const struct node *n, struct scene *s,
                             struct fault *why)
{
    double value;

    if (!to_number(n, &value) || !in_range(key, value))
        return wrong(key, n, why);
    *(double *) member(s, key) = value;
    return STATUS_OK;
}

static enum status read_count(const struct schema_key *key,
                              const struct node *n, struct scene *s,
                              struct fault *why)
{
    double value;

    if (!to_number(n, &value) || !in_range(key, value) ||
        value != floor(value) || strpbrk(n->text, ".eE"))
        return wrong(key, n, why);
    *(size_t *) member(s, key) = (size_t) value;
    return STATUS_OK;
}

static enum status read_pair(const struct schema_key *key,
                             const struct node *n, struct scene *s,
                             struct fault *why)
{
    double *pair = member(s, key), value[2];

    if (n->kind != NODE_LIST || n->count != 2)
        return wrong(key, n, why);
    for (int i = 0; i < 2; i++)
        if (!to_number(n->child[i], &value[i]) || !in_range(key, value[i]))
            return wrong(key, n->child[i], why);
    if (!(value[0] < value[1]))
        return node_blame(n, why, "%s: [%.17g, %.17g] is empty, expected lo < "
                          "hi", key->path, value[0], value[1]);
    pair[0] = value[0];
    pair[1] = value[1];
    return STATUS_OK;
}

static enum status read_text(const struct schema_key *key,
                             const struct node *n, struct scene *s,
                             struct fault *why)
{
    char **text = member(s, key);

    if (n->kind != NODE_SCALAR)
        return wrong(key, n, why);
    free(*text);
    *text = strdup(n->text);
    return *text ? STATUS_OK : STATUS_NO_MEMORY;
}

/* Code of a word; -1 with a message that offers the nearest. */
static int code_of(const struct schema_key *key, const struct node *n,
                   const char *const *names, struct fault *why)
{
    const char *near = NULL;

    if (n->kind != NODE_SCALAR) {
        wrong(key, n, why);
        return -1;
    }
    for (int i = 0; names[i]; i++) {
        if (strcmp(n->text, names[i]) == 0)
            return i;
        if (!near && spell_is_near(n->text, names[i]))
            near = names[i];
    }
    node_blame(n, why, "%s: unknown '%s', expected %s%s%s%s", key->path,
               n->text, key->expected, near ? " (did you mean " : "",
               near ? near : "", near ? "?)" : "");
    return -1;
}

static enum status read_choice(const struct schema_key *key,
                               const struct node *n, struct scene *s,
                               struct fault *why)
{
    const int code = code_of(key, n, key->names, why);

    if (code < 0)
        return STATUS_BAD_SCENE;
    *(int *) member(s, key) = code;
    return STATUS_OK;
}

/* ---- keys with a shape of their own ------------------------------------- */

static enum status read_preset(const struct schema_key *key,
                               const struct node *n, struct scene *s,
                               struct fault *why)
{
    const char *names[16] = { NULL };
    const enum friction_form form = s->law.form;

    for (size_t i = 0; i < 15 && law_preset_at(i); i++)
        names[i] = law_preset_at(i)->preset;
    const int code = code_of(key, n, names, why);
    if (code < 0)
        return STATUS_BAD_SCENE;
    s->law = *law_preset_at((size_t) code);
    s->law.form = form;
    return STATUS_OK;
}

static enum status read_board(const struct schema_key *key,
                              const struct node *n, struct scene *s,
                              struct fault *why)
{
    (void) s; /* the default already */
    return code_of(key, n, board_names, why) < 0 ? STATUS_BAD_SCENE : STATUS_OK;
}

static enum status read_slope(const struct schema_key *key,
                              const struct node *n, struct scene *s,
                              struct fault *why)
{
    double value;
    const char *unit = strchr(key->path, '.') + 1;

    if (!to_number(n, &value))
        return wrong(key, n, why);
    const long double pi = 3.141592653589793238462643383279502884L;
    const long double x = (long double) value;
    const long double alpha = strcmp(unit, "alpha") == 0       ? x
                              : strcmp(unit, "alpha_deg") == 0 ? x * pi / 180
                                                               : atanl(x);
    if (!(alpha > 0 && alpha < pi / 2))
        return wrong(key, n, why);
    s->alpha = (double) alpha;
    s->tan_alpha = strcmp(unit, "tan_alpha") == 0 ? x : tanl(alpha);
    return STATUS_OK;
}

static enum status read_products(const struct schema_key *key,
                                 const struct node *n, struct scene *s,
                                 struct fault *why)
{
    if (n->kind != NODE_LIST)
        return wrong(key, n, why);
    s->products = 0;
    for (size_t i = 0; i < n->count; i++) {
        const int code = code_of(key, n->child[i], product_names, why);
        if (code < 0)
            return STATUS_BAD_SCENE;
        s->products |= 1u << code;
    }
    return STATUS_OK;
}

static enum status read_xi(const struct schema_key *key, const struct node *n,
                           struct scene *s, struct fault *why)
{
    if (n->kind != NODE_LIST || n->count == 0 || n->count > 64)
        return wrong(key, n, why);
    double *xi = calloc(n->count, sizeof *xi);
    if (xi == NULL)
        return STATUS_NO_MEMORY;
    free(s->xi);
    s->xi = xi;
    s->xi_count = n->count;
    for (size_t i = 0; i < n->count; i++)
        if (!to_number(n->child[i], &xi[i]) || !(xi[i] > 0.0 && xi[i] < 1.0))
            return wrong(key, n->child[i], why);
    return STATUS_OK;
}

static enum status read_start(const struct schema_key *key,
                              const struct node *n, struct scene_start *out,
                              struct fault *why)
{
    const struct node *v = n->kind == NODE_MAP ? node_find(n, "v") : NULL;
    const struct node *psi = n->kind == NODE_MAP ? node_find(n, "psi") : NULL;

    if (v == NULL || psi == NULL || n->count != 2)
        return wrong(key, n, why);
    if (!to_number(v, &out->v) || !(out->v > 0.0) || isinf(out->v))
        return node_blame(v, why, "%s: v must be a number > 0", key->path);
    if (!to_number(psi, &out->psi) || isinf(out->psi))
        return node_blame(psi, why, "%s: psi must be a number", key->path);
    return STATUS_OK;
}

static enum status read_starts(const struct schema_key *key,
                               const struct node *n, struct scene *s,
                               struct fault *why)
{
    if (n->kind != NODE_LIST)
        return wrong(key, n, why);
    struct scene_start *start = calloc(n->count + 1, sizeof *start);
    if (start == NULL)
        return STATUS_NO_MEMORY;
    free(s->start);
    s->start = start;
    s->starts = n->count;
    enum status status = STATUS_OK;
    for (size_t i = 0; i < n->count && status == STATUS_OK; i++)
        status = read_start(key, n->child[i], &start[i], why);
    return status;
}

/* ---- the table ----------------------------------------------------------- */

#define AT(member) offsetof(struct scene, member)
#define POSITIVE 0.0, 1e300, "a number > 0"

/* clang-format off */
const struct schema_key schema_table[] = {
    { "title", read_text, AT(title), NULL, 0, 0, "a text", "none" },
    { "law.preset", read_preset, 0, NULL, 0, 0, "a law (see slipway laws)",
      "none: a law must be given" },
    { "law.theta", read_choice, AT(law.theta), theta_names, 0, 0,
      "ln_psi, psi, ln_c_psi or ln_c_1pR_psi", "none" },
    { "law.psi_ss", read_choice, AT(law.psi_ss), psi_ss_names, 0, 0,
      "inverse, minus_log, spinodal or spinodal_unit", "none" },
    { "law.timescale", read_choice, AT(law.timescale), timescale_names, 0, 0,
      "slip, spinodal, ageing44 or slip45", "none" },
    { "law.kinetics", read_choice, AT(law.kinetics), kinetics_names, 0, 0,
      "linear or sinh", "none" },
    { "law.friction", read_choice, AT(law.form), friction_form_names, 0, 0,
      "asinh or log", "asinh" },
    { "material.preset", read_board, 0, NULL, 0, 0, "bristol_board",
      "bristol_board" },
    { "material.mu_star", read_real, AT(material.mu_star), NULL, -1e3, 1e3,
      "a number", "0.369" },
    { "material.a", read_real, AT(material.a), NULL, POSITIVE, "0.0349" },
    { "material.b", read_real, AT(material.b), NULL, POSITIVE, "0.0489" },
    { "material.L", read_real, AT(material.L), NULL, POSITIVE, "0.9e-6 m" },
    { "material.V_star", read_real, AT(material.V_star), NULL, POSITIVE,
      "1e-6 m/s" },
    { "material.c", read_real, AT(material.c), NULL, 0.0, 1e300,
      "zero or a positive number", "1e-3" },
    { "material.R", read_real, AT(material.R), NULL, 0.0, HUGE_VAL,
      "a number > 0 or inf", "100" },
    { "material.V_c", read_real, AT(material.V_c), NULL, POSITIVE,
      "none: kato_tullis needs it" },
    { "slope.alpha", read_slope, 0, NULL, 0, 0,
      "an angle in rad with 0 < alpha < pi/2", "none: a slope must be given" },
    { "slope.alpha_deg", read_slope, 0, NULL, 0, 0,
      "an angle in degrees with 0 < alpha_deg < 90", "none" },
    { "slope.tan_alpha", read_slope, 0, NULL, 0, 0,
      "a number > 0", "none" },
    { "gravity", read_real, AT(material.g), NULL, POSITIVE, "9.81 m/s^2" },
    { "window.v", read_pair, AT(window.v), NULL, -1e300, 1e300,
      "[lo, hi], two numbers", "[1e-6, 1e6]" },
    { "window.psi", read_pair, AT(window.psi), NULL, -1e300, 1e300,
      "[lo, hi], two numbers", "[1e-3, 1e2], [-7, 5] where psi is a log" },
    { "window.axes", read_choice, AT(window.axes), axes_names, 0, 0,
      "log, linear or eigen", "log" },
    { "units", read_choice, AT(units), units_names, 0, 0,
      "dimensionless or si", "dimensionless" },
    { "products", read_products, 0, NULL, 0, 0,
      "a list of equilibria, folds, nullclines, field_arrows, manifolds, "
      "knees, estimates, trajectories", "per command" },
    { "estimates.xi", read_xi, 0, NULL, 0, 0,
      "a list of numbers between 0 and 1", "[0.85, 0.9, 0.99, 0.999]" },
    { "trajectories.starts", read_starts, 0, NULL, 0, 0,
      "a list of {v: V, psi: P}", "[]" },
    { "trajectories.spread", read_count, AT(spread), NULL, 0, 10000,
      "a whole number from 0 to 10000", "0" },
    { "trajectories.seed", read_count, AT(seed), NULL, 0, 9007199254740992.0,
      "a whole number from 0 to 2^53", "1" },
    { "trajectories.until.time", read_real, AT(until_time), NULL, POSITIVE,
      "none" },
    { "trajectories.until.slip", read_real, AT(until_slip), NULL, POSITIVE,
      "none" },
    { "trajectories.sample.linear_slip", read_count, AT(linear_slip), NULL, 2,
      1000000, "a whole number from 2 to 1000000", "none" },
    { "trajectories.sample.log_time", read_count, AT(log_time), NULL, 2,
      1000000, "a whole number from 2 to 1000000", "none" },
    { "accuracy.rtol", read_real, AT(rtol), NULL, 1e-14, 0.1,
      "a number from 1e-14 to 0.1", "1e-12" },
    { "output.hdf5", read_text, AT(hdf5), NULL, 0, 0, "a path", "none" },
    { "output.figure", read_text, AT(figure), NULL, 0, 0,
      "a path ending in .svg, .pdf or .png", "none" },
    { NULL, NULL, 0, NULL, 0, 0, NULL, NULL },
};
/* clang-format on */

static const struct schema_key *find_key(const char *path)
{
    for (const struct schema_key *k = schema_table; k->path; k++)
        if (strcmp(k->path, path) == 0)
            return k;
    return NULL;
}

static bool is_section(const char *path)
{
    const size_t n = strlen(path);

    for (const struct schema_key *k = schema_table; k->path; k++)
        if (strncmp(k->path, path, n) == 0 && k->path[n] == '.')
            return true;
    return false;
}

/* The known word at this level nearest to the last part of path. */
static bool nearest_key(const char *path, char *near, size_t size)
{
    const char *dot = strrchr(path, '.');
    const size_t head = dot ? (size_t) (dot - path) + 1 : 0;

    for (const struct schema_key *k = schema_table; k->path; k++) {
        if (strncmp(k->path, path, head) != 0)
            continue;
        const char *rest = k->path + head;
        snprintf(near, size, "%.*s", (int) strcspn(rest, "."), rest);
        if (spell_is_near(path + head, near))
            return true;
    }
    return false;
}

static enum status unknown(const char *path, const struct node *n,
                           struct fault *why)
{
    char near[64];

    if (nearest_key(path, near, sizeof near))
        return node_blame(n, why, "unknown key '%s' (did you mean %s?)", path,
                          near);
    return node_blame(n, why, "unknown key '%s'", path);
}

static enum status apply_below(const struct node *map, const char *prefix,
                               struct scene *s, struct fault *why)
{
    enum status status = STATUS_OK;

    for (size_t i = 0; i < map->count && status == STATUS_OK; i++) {
        const struct node *n = map->child[i];
        char path[128];
        const int used = snprintf(path, sizeof path, "%s%s%s", prefix,
                                  prefix[0] ? "." : "", n->key);
        const struct schema_key *key = find_key(path);
        if (used >= (int) sizeof path)
            status = node_blame(n, why, "unknown key");
        else if (key)
            status = key->read(key, n, s, why);
        else if (!is_section(path))
            status = unknown(path, n, why);
        else if (n->kind != NODE_MAP)
            status = node_blame(n, why, "%s: expected keys below it", path);
        else
            status = apply_below(n, path, s, why);
    }
    return status;
}

enum status schema_apply(const struct node *root, struct scene *s,
                         struct fault *why)
{
    return apply_below(root, "", s, why);
}
