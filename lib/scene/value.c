#include "value.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "number.h"
#include "scene_figure.h"
#include "scene_law.h"
#include "synonym.h"
#include "text.h"
#include "unit_text.h"

/* Whether it would do as an angle in degrees, where one in rad is asked for. */
static bool is_in_degrees(const struct schema_key *key, const struct node *n)
{
    double x;

    return strcmp(key->path, "slope.alpha") == 0 && n->kind == NODE_SCALAR &&
           number_read(n->text, &x) && x > 0.0 && x < 90.0;
}

enum status value_refuse(const struct schema_key *key, const struct node *n,
                         struct fault *why)
{
    const char *expected = key->expected ? key->expected : "", *near = NULL;
    char words[240] = "";

    if (key->words)
        text_list(key->words, words, sizeof words);
    if (key->words && n->kind == NODE_SCALAR)
        near = synonym_nearest(n->text, key->words);
    else if (is_in_degrees(key, n))
        near = "slope.alpha_deg";
    return place_blame(n->at, why, "%s: %s is not allowed, expected %s%s%s%s%s",
                       key->path, node_shown(n).text, expected, words,
                       near ? " (did you mean " : "", near ? near : "",
                       near ? "?)" : "");
}

/* ---- numbers ------------------------------------------------------------- */

static void *member(struct scene *s, const struct schema_key *key)
{
    return (char *) s + key->offset;
}

static bool in_range(const struct schema_key *key, double x)
{
    return x >= key->lo && x <= key->hi && !(key->open_lo && x == key->lo) &&
           !(key->open_hi && x == key->hi);
}

bool value_is_number(const struct schema_key *key, const struct node *n,
                     double *value)
{
    enum unit_text in;
    double x;

    if (n->kind != NODE_SCALAR ||
        !unit_text_read(unit_text_of(key->unit), n->text, &x, &in) ||
        !in_range(key, x))
        return false;
    *value = x;
    return true;
}

static bool is_whole(const struct schema_key *key, const struct node *n,
                     uint64_t *value)
{
    uint64_t x;

    if (n->kind != NODE_SCALAR || !number_read_whole(n->text, &x) ||
        x < (uint64_t) key->lo || x > (uint64_t) key->hi)
        return false;
    *value = x;
    return true;
}

VALUE_READER(value_real)
{
    return value_is_number(key, n, member(s, key)) ? STATUS_OK
                                                   : value_refuse(key, n, why);
}

VALUE_READER(value_length)
{
    return value_real(key, n, s, why);
}

VALUE_READER(value_page)
{
    const bool known =
        n->kind == NODE_SCALAR && scene_figure_preset(n->text, &s->paper);

    return known || value_is_number(key, n, &s->paper.width)
               ? STATUS_OK
               : value_refuse(key, n, why);
}

VALUE_READER(value_seed)
{
    return is_whole(key, n, member(s, key)) ? STATUS_OK
                                            : value_refuse(key, n, why);
}

VALUE_READER(value_count)
{
    uint64_t count;

    if (!is_whole(key, n, &count))
        return value_refuse(key, n, why);
    *(size_t *) member(s, key) = (size_t) count;
    return STATUS_OK;
}

VALUE_READER(value_pair)
{
    double *pair = member(s, key), x[2];

    if (n->kind != NODE_LIST || n->count != 2)
        return place_blame(n->at, why, "%s: this is no pair, expected [lo, hi]",
                           key->path);
    for (int i = 0; i < 2; i++)
        if (!value_is_number(key, n->child[i], &x[i]))
            return value_refuse(key, n->child[i], why);
    if (!unit_text_of(key->unit) && x[0] >= x[1])
        return place_blame(n->at, why,
                           "%s: [%s, %s] is empty, expected lo < hi", key->path,
                           text_shown(n->child[0]->text).text,
                           text_shown(n->child[1]->text).text);
    pair[0] = x[0];
    pair[1] = x[1];
    return STATUS_OK;
}

VALUE_READER(value_cells)
{
    size_t *cells = member(s, key);
    uint64_t count;

    if (n->kind != NODE_LIST || n->count != 2)
        return value_refuse(key, n, why);
    for (int i = 0; i < 2; i++) {
        if (!is_whole(key, n->child[i], &count))
            return value_refuse(key, n->child[i], why);
        cells[i] = (size_t) count;
    }
    return STATUS_OK;
}

/* ---- texts --------------------------------------------------------------- */

VALUE_READER(value_text)
{
    char **text = member(s, key);

    if (n->kind != NODE_SCALAR)
        return value_refuse(key, n, why);
    char *copy = text_copy(n->text, strlen(n->text));
    if (copy == NULL)
        return STATUS_NO_MEMORY;
    free(*text);
    *text = copy;
    return STATUS_OK;
}

VALUE_READER(value_path)
{
    char **path = member(s, key);

    if (!node_is_nothing(n))
        return value_text(key, n, s, why);
    free(*path);
    *path = NULL;
    return STATUS_OK;
}

/* The folder of the scene and the path in it; NULL: it is no other than that
 * from here, or nothing is there.  Owned by the caller. */
static char *beside(const char *scene, const char *path)
{
    const char *slash = strrchr(scene, '/');
    char *there = NULL;

    if (slash == NULL || path[0] == '/' ||
        asprintf(&there, "%.*s%s", (int) (slash - scene) + 1, scene, path) < 0)
        return NULL;
    if (access(there, R_OK) == 0)
        return there;
    free(there);
    return NULL;
}

VALUE_READER(value_input)
{
    char **path = member(s, key);
    const enum status status = value_path(key, n, s, why);
    char *there = status == STATUS_OK && *path && n->at.name && !n->at.is_set
                      ? beside(n->at.name, *path)
                      : NULL;

    if (there) {
        free(*path);
        *path = there;
    }
    return status;
}

VALUE_READER(value_font)
{
    static const char letters[] = "abcdefghijklmnopqrstuvwxyz"
                                  "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789 -";
    const bool plain = n->kind == NODE_SCALAR && strlen(n->text) < SCENE_FONT &&
                       n->text[strspn(n->text, letters)] == '\0';

    return plain ? value_path(key, n, s, why) : value_refuse(key, n, why);
}

VALUE_READER(value_figure)
{
    const char *dot = n->kind == NODE_SCALAR ? strrchr(n->text, '.') : NULL;
    const bool drawn =
        dot && (strcmp(dot, ".svg") == 0 || strcmp(dot, ".pdf") == 0 ||
                strcmp(dot, ".png") == 0);

    return drawn || node_is_nothing(n) ? value_path(key, n, s, why)
                                       : value_refuse(key, n, why);
}

/* ---- words --------------------------------------------------------------- */

/* -1 if n is none of the words. */
static int code_of(const struct node *n, const char *const *words)
{
    return n->kind == NODE_SCALAR ? text_index(n->text, words) : -1;
}

VALUE_READER(value_choice)
{
    const int code = code_of(n, key->words);

    if (code < 0)
        return value_refuse(key, n, why);
    *(int *) member(s, key) = code;
    return STATUS_OK;
}

VALUE_READER(value_formula)
{
    (void) s;
    return n->kind == NODE_SCALAR ? STATUS_OK : value_refuse(key, n, why);
}

VALUE_READER(value_part)
{
    const bool formula = n->kind == NODE_SCALAR && strpbrk(n->text, "+-*/^()");

    return s->typed && formula ? STATUS_OK : value_choice(key, n, s, why);
}

VALUE_READER(value_state)
{
    (void) s;
    return code_of(n, key->words) < 0 ? value_refuse(key, n, why) : STATUS_OK;
}

VALUE_READER(value_flag)
{
    const int code = code_of(n, key->words);

    if (code < 0)
        return value_refuse(key, n, why);
    *(bool *) member(s, key) = code == 1;
    return STATUS_OK;
}

VALUE_READER(value_products)
{
    unsigned products = 0;

    if (n->kind != NODE_LIST || n->count == 0)
        return value_refuse(key, n, why);
    for (size_t i = 0; i < n->count; i++) {
        const int code = code_of(n->child[i], key->words);
        if (code < 0)
            return value_refuse(key, n->child[i], why);
        products |= 1u << code;
    }
    s->products = products;
    return STATUS_OK;
}

VALUE_READER(value_preset)
{
    const struct law *law = NULL;

    if (n->kind == NODE_SCALAR)
        law = law_preset_find(n->text);
    if (law == NULL) {
        const char *words[32] = { NULL };
        struct schema_key with_words = *key;
        for (size_t i = 0; i < 31 && law_preset_at(i); i++)
            words[i] = law_preset_at(i)->preset;
        with_words.words = words;
        return value_refuse(&with_words, n, why);
    }
    const enum friction_form form = s->law.form;
    s->law = *law;
    s->law.form = form;
    return STATUS_OK;
}

/* ---- slopes -------------------------------------------------------------- */

static const long double pi = 3.141592653589793238462643383279502884L;

/* Steep slopes in degrees from what is left to 90, which is exact. */
static void set_slope(const struct schema_key *key, double given,
                      struct scene *s)
{
    const long double x = (long double) given, degree = pi / 180;

    s->slope_in = (enum unit_angle)(key->side - 1);
    s->slope_given = s->alpha = given;
    switch (s->slope_in) {
        case ANGLE_RAD:
            s->tan_alpha = tanl(x);
            break;
        case ANGLE_DEGREE:
            s->alpha = (double) (x * degree);
            s->tan_alpha =
                x <= 45 ? tanl(x * degree) : 1 / tanl((90 - x) * degree);
            break;
        case ANGLE_TAN:
            s->alpha = atan(given);
            s->tan_alpha = x;
    }
}

VALUE_READER(value_slope)
{
    double x;

    if (!value_is_number(key, n, &x))
        return value_refuse(key, n, why);
    set_slope(key, x, s);
    return STATUS_OK;
}

/* ---- keys of a sweep ----------------------------------------------------- */

bool value_is_real(const struct schema_key *key)
{
    return (key->read == value_real && strncmp(key->path, "sweep.", 6) != 0) ||
           key->read == value_slope;
}

bool value_set(const struct schema_key *key, double x, struct scene *s)
{
    if (!in_range(key, x))
        return false;
    if (key->read == value_slope)
        set_slope(key, x, s);
    else
        *(double *) member(s, key) = x;
    return true;
}

VALUE_READER(value_key)
{
    const char *of_law[SCHEMA_KEYS_MAX + 1] = { NULL };
    const char *const *known =
        s->system ? (const char *const *) s->parameter_key : of_law;
    size_t count = 0;

    for (const struct schema_key *k = schema_table; k->path; k++)
        if (value_is_real(k))
            of_law[count++] = k->path;
    for (size_t i = 0; known[i] && n->kind == NODE_SCALAR; i++)
        if (strcmp(known[i], n->text) == 0) {
            *(const char **) member(s, key) = known[i];
            return STATUS_OK;
        }
    const char *own = n->kind == NODE_SCALAR ? scene_law_key(s, n->text) : NULL;
    if (own) {
        *(const char **) member(s, key) = own;
        return STATUS_OK;
    }
    const char *near =
        n->kind == NODE_SCALAR ? synonym_nearest(n->text, known) : NULL;
    return place_blame(n->at, why, "%s: %s is not allowed, expected %s%s%s%s",
                       key->path, node_shown(n).text,
                       s->system ? "system.parameters.NAME" : key->expected,
                       near ? " (did you mean " : "", near ? near : "",
                       near ? "?)" : "");
}
