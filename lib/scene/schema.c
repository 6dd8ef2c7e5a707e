#include "schema.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "spell.h"
#include "text.h"
#include "tolerance.h"
#include "value.h"

const char *const product_names[] = { "equilibria",    "folds",
                                      "nullclines",    "field_arrows",
                                      "manifolds",     "knees",
                                      "estimates",     "taylor_series",
                                      "sensitivities", "trajectories",
                                      "basins",        "margin",
                                      "slip",          "time",
                                      "friction",      "peak",
                                      "friction_law",  "spring_block",
                                      "bifurcation",   "fold_curves",
                                      "chi",           NULL };
_Static_assert(sizeof product_names / sizeof *product_names == PRODUCTS + 1,
               "each product has a name");
const char *const sweep_show_names[] = {
    "velocities",      "velocity_estimates", "persistence",
    "static_friction", "fracture_energy",    NULL
};
_Static_assert(sizeof sweep_show_names / sizeof *sweep_show_names == SHOWS + 1,
               "each table of a sweep's figure has a word");
static const char *const y_scale_names[] = { "auto", "linear", "log", NULL };
static const char *const axes_names[] = { "log", "linear", "eigen", NULL };
static const char *const units_names[] = { "dimensionless", "si", NULL };
static const char *const flag_names[] = { "false", "true", NULL };
static const char *const scale_names[] = { "linear", "log", NULL };
static const char *const board_names[] = { "bristol_board", NULL };

/* ---- the table ----------------------------------------------------------- */

#define AT(member)  .offset = offsetof(struct scene, member)
#define FROM(low)   .lo = low
#define ABOVE(low)  .lo = low, .open_lo = true
#define TO(high)    .hi = high
#define BELOW(high) .hi = high, .open_hi = true
#define POSITIVE                                                               \
    .read = value_real, ABOVE(0.0), TO(DBL_MAX), .expected = "a number > 0"

/* clang-format off */
const struct schema_key schema_table[] = {
    { "title", value_text, AT(title), .expected = "a text" },

    { "law.preset", value_preset, .side = 1 },
    { "law.theta", value_choice, AT(law.theta), .words = theta_names,
      .side = 2 },
    { "law.psi_ss", value_choice, AT(law.psi_ss), .words = psi_ss_names,
      .side = 2 },
    { "law.timescale", value_choice, AT(law.timescale),
      .words = timescale_names, .side = 2 },
    { "law.kinetics", value_choice, AT(law.kinetics), .words = kinetics_names,
      .side = 2 },
    { "law.friction", value_choice, AT(law.form),
      .words = friction_form_names },

    { "material.preset", value_board, .words = board_names },
    { "material.mu_star", value_real, AT(material.mu_star), FROM(-1e3), TO(1e3),
      .expected = "a number from -1000 to 1000" },
    { "material.a", AT(material.a), POSITIVE },
    { "material.b", AT(material.b), POSITIVE },
    { "material.L", AT(material.L), POSITIVE },
    { "material.V_star", AT(material.V_star), POSITIVE },
    { "material.c", value_real, AT(material.c), FROM(0.0), TO(DBL_MAX),
      .expected = "a number >= 0" },
    { "material.R", value_real, AT(material.R), ABOVE(0.0),
      TO((double) INFINITY), .expected = "a number > 0 or inf" },
    { "material.V_c", AT(material.V_c), POSITIVE },

    { "slope.alpha", value_alpha, ABOVE(0.0), BELOW(M_PI_2), .side = 1,
      .expected = "an angle in rad, 0 < alpha < pi/2" },
    { "slope.alpha_deg", value_alpha_deg, ABOVE(0.0), BELOW(90.0), .side = 2,
      .expected = "an angle in degrees, 0 < alpha_deg < 90" },
    { "slope.tan_alpha", value_tan_alpha, ABOVE(0.0), TO(DBL_MAX), .side = 3,
      .expected = "a number > 0" },

    { "gravity", AT(material.g), POSITIVE },

    { "window.v", value_pair, AT(window.v), FROM(1 / SCENE_RANGE),
      TO(SCENE_RANGE), .expected = "a number from 1e-300 to 1e300" },
    { "window.psi", value_pair, AT(window.psi), FROM(-SCENE_RANGE),
      TO(SCENE_RANGE), .expected = "a number up to 1e300" },
    { "window.axes", value_choice, AT(window.axes), .words = axes_names },

    { "units", value_choice, AT(units), .words = units_names },

    { "products", value_products, .words = product_names,
      .expected = "a list of " },

    { "estimates.xi", value_xi, ABOVE(0.0), BELOW(1.0),
      .expected = "1 to 64 numbers xi in brackets, 0 < xi < 1" },

    { "trajectories.starts", value_starts,
      .expected = "a list [{v: V, psi: P}, ...]" },
    { "trajectories.spread", value_count, AT(spread), FROM(0), TO(10000),
      .expected = "a whole number from 0 to 10000" },
    { "trajectories.seed", value_seed, AT(seed), FROM(0), TO(0x1p53),
      .expected = "a whole number from 0 to 9007199254740992" },
    { "trajectories.until.time", AT(until_time), POSITIVE },
    { "trajectories.until.slip", AT(until_slip), POSITIVE },
    { "trajectories.sample.linear_slip", value_count, AT(linear_slip),
      FROM(2), TO(1000000), .side = 1,
      .expected = "a whole number from 2 to 1000000" },
    { "trajectories.sample.log_time", value_count, AT(log_time),
      FROM(2), TO(1000000), .side = 2,
      .expected = "a whole number from 2 to 1000000" },

    { "basins.cells", value_cells, AT(cells), FROM(1), TO(32768),
      .expected = "two whole numbers [nv, npsi] from 1 to 32768" },
    { "basins.audit", value_count, AT(audit), FROM(0), TO(1000000),
      .expected = "a whole number from 0 to 1000000" },
    { "basins.exact", value_flag, AT(exact), .words = flag_names },
    { "basins.rtol", value_real, AT(cell_rtol), FROM(1e-11), TO(0.1),
      .expected = "a number from 1e-11 to 0.1" },

    { "rabinowicz.block_mass", AT(rabinowicz.block_mass), POSITIVE },
    { "rabinowicz.ball_mass", AT(rabinowicz.ball_mass), POSITIVE },
    { "rabinowicz.restitution", value_real, AT(rabinowicz.restitution),
      FROM(0.0), TO(1.0), .expected = "a number from 0 to 1" },
    { "rabinowicz.tan_alpha", value_slopes, ABOVE(0.0), TO(SCENE_TAN),
      .expected = "1 to 1000 numbers tan_alpha > 0 in brackets" },
    { "rabinowicz.data", value_path, AT(rabinowicz.data),
      .expected = "a path" },
    { "rabinowicz.smoothing", value_real, AT(rabinowicz.smoothing),
      FROM(SCENE_SMOOTHING_LEAST), TO(1.0),
      .expected = "a number from 1e-12 to 1" },

    { "sweep.key", value_key, AT(sweep.draft.key),
      .expected = "the key of a number, such as slope.alpha" },
    { "sweep.from", value_real, AT(sweep.draft.from), FROM(-DBL_MAX),
      TO(DBL_MAX), .side = 1, .expected = "a number" },
    { "sweep.to", value_real, AT(sweep.draft.to), FROM(-DBL_MAX), TO(DBL_MAX),
      .side = 1, .expected = "a number" },
    { "sweep.points", value_count, AT(sweep.draft.points), FROM(2),
      TO(SCENE_POINTS), .side = 1,
      .expected = "a whole number from 2 to 250000" },
    { "sweep.scale", value_choice, AT(sweep.draft.scale),
      .words = scale_names },
    { "sweep.values", value_values, FROM(-DBL_MAX), TO(DBL_MAX), .side = 2,
      .expected = "1 to 250000 numbers in brackets" },
    { "sweep.refine", value_real, AT(sweep.refine), FROM(1e-6), TO(1.0),
      .expected = "a number from 1e-6 to 1, the tolerance in ln v" },
    { "sweep.show", value_choice, AT(sweep.show), .words = sweep_show_names },
    { "sweep.y_scale", value_choice, AT(sweep.y_scale),
      .words = y_scale_names },
    { "sweep.y_range", value_pair, AT(sweep.y_range), FROM(-DBL_MAX),
      TO(DBL_MAX), .expected = "a number" },

    { "spring_block.sigma", AT(spring_block.sigma), POSITIVE },
    { "spring_block.mass", value_real, AT(spring_block.mass), FROM(0.0),
      TO(DBL_MAX), .expected = "a number >= 0" },
    { "spring_block.v", value_pair, AT(spring_block.v), FROM(1 / SCENE_RANGE),
      TO(SCENE_RANGE), .expected = "a number from 1e-300 to 1e300" },

    { "fold_curves.c", value_pair, AT(fold_c), FROM(1 / SCENE_RANGE),
      TO(SCENE_RANGE), .expected = "a number from 1e-300 to 1e300" },

    { "chi.alpha", value_chi_slopes, ABOVE(0.0), BELOW(M_PI_2),
      .expected = "1 to 64 angles in rad in brackets, 0 < alpha < pi/2" },

    { "accuracy.rtol", value_real, AT(rtol), FROM(1e-14), TO(0.1),
      .expected = "a number from 1e-14 to 0.1" },

    { "output.hdf5", value_path, AT(hdf5), .expected = "a path" },
    { "output.figure", value_figure, AT(figure),
      .expected = "a path ending in .svg, .pdf or .png" },
    { .path = NULL },
};
/* clang-format on */

/* ---- keys ---------------------------------------------------------------- */

enum {
    KEYS = sizeof schema_table / sizeof *schema_table - 1,
    PATH_SIZE = 128,
    LEVEL_WORDS = 32,
    WORD_SIZE = 24
};

_Static_assert((int) KEYS <= (int) SCHEMA_KEYS_MAX, "lists of keys have room");

const struct schema_key *schema_find(const char *path)
{
    for (const struct schema_key *k = schema_table; k->path; k++)
        if (strcmp(k->path, path) == 0)
            return k;
    return NULL;
}

static bool holds_keys(const char *path)
{
    const size_t n = strlen(path);

    for (const struct schema_key *k = schema_table; k->path; k++)
        if (strncmp(k->path, path, n) == 0 && k->path[n] == '.')
            return true;
    return false;
}

bool schema_excludes(const char *path, const char *other)
{
    const struct schema_key *a = schema_find(path), *b = schema_find(other);

    return a && b && a->side && b->side && a->side != b->side;
}

/* The words that may stand behind the first `head` letters of path. */
struct level {
    char word[LEVEL_WORDS][WORD_SIZE];
    const char *list[LEVEL_WORDS + 1]; /* NULL-ended */
};

static void level_find(const char *path, size_t head, struct level *l)
{
    size_t count = 0;

    for (const struct schema_key *k = schema_table; k->path; k++) {
        char word[WORD_SIZE];
        if (strncmp(k->path, path, head) != 0 || count == LEVEL_WORDS)
            continue;
        snprintf(word, sizeof word, "%.*s", (int) strcspn(k->path + head, "."),
                 k->path + head);
        if (count > 0 && strcmp(l->word[count - 1], word) == 0)
            continue;
        memcpy(l->word[count], word, sizeof word);
        l->list[count] = l->word[count];
        count++;
    }
    l->list[count] = NULL;
}

/* The key, wherever it is, whose last word is near to this one, such as
 * slope.alpha of alpha; NULL if there is none. */
static const char *near_elsewhere(const char *word)
{
    const char *last[KEYS + 1] = { NULL };

    for (size_t i = 0; i < KEYS; i++) {
        const char *dot = strrchr(schema_table[i].path, '.');
        last[i] = dot ? dot + 1 : schema_table[i].path;
    }
    const char *near = spell_nearest(word, last);
    for (size_t i = 0; near && i < KEYS; i++)
        if (last[i] == near)
            return schema_table[i].path;
    return NULL;
}

/* Blames the word of path that begins at `head`; all before it is known. */
static enum status unknown(const char *path, size_t head, struct place at,
                           struct fault *why)
{
    struct level level;
    char words[200], word[PATH_SIZE];

    snprintf(word, sizeof word, "%.*s", (int) strcspn(path + head, "."),
             path + head);
    level_find(path, head, &level);
    text_list(level.list, words, sizeof words);
    const char *near = spell_nearest(word, level.list);
    const size_t parent = near ? head : 0;
    if (near == NULL)
        near = near_elsewhere(word);
    if (near == NULL)
        return place_blame(at, why, "unknown key '%s', expected %s",
                           text_shown(path).text, words);
    return place_blame(at, why,
                       "unknown key '%s', expected %s (did you mean %.*s%s?)",
                       text_shown(path).text, words, (int) parent, path, near);
}

enum status schema_check_path(const char *path, struct place at,
                              struct fault *why)
{
    for (size_t head = 0;;) {
        const size_t end = head + strcspn(path + head, ".");
        char known[PATH_SIZE];
        if (end >= sizeof known)
            return unknown(path, head, at, why);
        snprintf(known, sizeof known, "%.*s", (int) end, path);
        if (!holds_keys(known) && (path[end] || !schema_find(known)))
            return unknown(path, head, at, why);
        if (path[end] == '\0')
            return STATUS_OK;
        head = end + 1;
    }
}

enum status schema_blame_section(const char *path, size_t size,
                                 const struct node *n, struct fault *why)
{
    struct level level;
    char section[PATH_SIZE], words[200];

    snprintf(section, sizeof section, "%.*s.", (int) size, path);
    level_find(section, size + 1, &level);
    text_list(level.list, words, sizeof words);
    return place_blame(n->at, why,
                       "%.*s: %s is not allowed, expected a map of keys, %s",
                       (int) size, path, node_shown(n).text, words);
}

/* ---- a whole tree -------------------------------------------------------- */

/* "prefix.key", or "key" at the top; cut at size - 1. */
static void join(const char *prefix, const char *key, char *path, size_t size)
{
    snprintf(path, size, "%s%s%s", prefix, prefix[0] ? "." : "", key);
}

static enum status check_sides(const struct node *map, size_t i,
                               const char *prefix, struct fault *why)
{
    char path[PATH_SIZE], other[PATH_SIZE];
    const struct node *n = map->child[i];

    join(prefix, n->key, path, sizeof path);
    for (size_t j = 0; j < i; j++) {
        join(prefix, map->child[j]->key, other, sizeof other);
        if (schema_excludes(path, other))
            return place_blame(n->key_at, why,
                               "%s: not beside %s, expected one of the two",
                               path, other);
    }
    return STATUS_OK;
}

static enum status check_key(const struct node *n, const char *path,
                             struct fault *why)
{
    if (strchr(n->key, '.'))
        return place_blame(n->key_at, why,
                           "unknown key '%s', expected one word, as in "
                           "'slope: {alpha: RAD}' for slope.alpha",
                           text_shown(n->key).text);
    return schema_check_path(path, n->key_at, why);
}

static enum status apply_below(const struct node *map, const char *prefix,
                               struct scene *s, struct fault *why);

/* Only the axes of a sweep may be a list of sections. */
static enum status apply_axes(const struct node *list, struct scene *s,
                              struct fault *why)
{
    enum status status = STATUS_OK;

    if (list->count == 0 || list->count > SCENE_AXES)
        return place_blame(list->at, why,
                           "sweep: a list of %zu, expected one or two of "
                           "{key: KEY, ...}",
                           list->count);
    for (size_t i = 0; i < list->count && status == STATUS_OK; i++) {
        const struct node *axis = list->child[i];
        if (axis->kind != NODE_MAP)
            return schema_blame_section("sweep", strlen("sweep"), axis, why);
        status = apply_below(axis, "sweep", s, why);
        s->sweep.axis[i] = s->sweep.draft;
        s->sweep.draft = (struct scene_axis){ .key = NULL };
    }
    s->sweep.axes = list->count;
    return status;
}

static enum status apply_one(const struct node *n, const char *path,
                             struct scene *s, struct fault *why)
{
    const struct schema_key *key = schema_find(path);

    if (n->kind == NODE_LIST && strcmp(path, "sweep") == 0)
        return apply_axes(n, s, why);
    if (key)
        return key->read(key, n, s, why);
    if (n->kind == NODE_MAP)
        return apply_below(n, path, s, why);
    if (node_is_nothing(n))
        return STATUS_OK;
    return schema_blame_section(path, strlen(path), n, why);
}

static enum status apply_below(const struct node *map, const char *prefix,
                               struct scene *s, struct fault *why)
{
    enum status status = STATUS_OK;

    for (size_t i = 0; i < map->count && status == STATUS_OK; i++) {
        const struct node *n = map->child[i];
        char path[PATH_SIZE];
        join(prefix, n->key, path, sizeof path);
        status = check_key(n, path, why);
        if (status == STATUS_OK)
            status = check_sides(map, i, prefix, why);
        if (status == STATUS_OK)
            status = apply_one(n, path, s, why);
    }
    return status;
}

enum status schema_apply(const struct node *root, struct scene *s,
                         struct fault *why)
{
    return apply_below(root, "", s, why);
}
