/* Values that are lists: numbers, and the states where orbits start. */
#include <float.h>
#include <stdlib.h>
#include <string.h>

#include "synonym.h"
#include "text.h"
#include "tolerance.h"
#include "value.h"

/* One to `most` numbers in the key's range, instead of those in *list. */
static enum status read_list(const struct schema_key *key, const struct node *n,
                             size_t most, double **list, size_t *count,
                             struct fault *why)
{
    if (n->kind != NODE_LIST || n->count == 0 || n->count > most)
        return value_refuse(key, n, why);
    double *x = malloc(n->count * sizeof *x);
    if (x == NULL)
        return STATUS_NO_MEMORY;
    for (size_t i = 0; i < n->count; i++)
        if (!value_is_number(key, n->child[i], &x[i])) {
            free(x);
            return value_refuse(key, n->child[i], why);
        }
    free(*list);
    *list = x;
    *count = n->count;
    return STATUS_OK;
}

VALUE_READER(value_xi)
{
    return read_list(key, n, SCENE_XI, &s->xi, &s->xi_count, why);
}

VALUE_READER(value_slopes)
{
    return read_list(key, n, SCENE_SLOPES, &s->rabinowicz.tan_alpha,
                     &s->rabinowicz.slopes, why);
}

VALUE_READER(value_chi_slopes)
{
    return read_list(key, n, SCENE_CHI, &s->chi_alpha, &s->chi_alphas, why);
}

VALUE_READER(value_values)
{
    return read_list(key, n, SCENE_POINTS, &s->sweep.draft.value,
                     &s->sweep.draft.count, why);
}

static enum status unknown_in_start(const struct schema_key *key,
                                    const struct node *n, struct fault *why)
{
    static const char *const known[] = { "v", "psi", "phi", NULL };
    const char *near = synonym_nearest(n->key, known);

    return place_blame(
        n->key_at, why, "%s: unknown key '%s', expected v and psi%s%s%s",
        key->path, text_shown(n->key).text, near ? " (did you mean " : "",
        near ? near : "", near ? "?)" : "");
}

/* {v: V, psi: P} or {v: V, phi: P}, as they stand there (scene_units.h):
 * positive v, the other any finite number yet. */
static enum status read_start(const struct schema_key *key,
                              const struct node *n, struct scene_start *start,
                              struct fault *why)
{
    static const struct schema_key parts[] = {
        { .path = "trajectories.starts: v",
          .lo = 0.0,
          .open_lo = true,
          .hi = DBL_MAX,
          .unit = "V_star",
          .expected = "a number > 0" },
        { .path = "trajectories.starts: psi",
          .lo = -DBL_MAX,
          .hi = DBL_MAX,
          .expected = "a number" },
    };

    if (n->kind != NODE_MAP)
        return value_refuse(key, n, why);
    for (size_t i = 0; i < n->count; i++)
        if (strcmp(n->child[i]->key, "v") != 0 &&
            strcmp(n->child[i]->key, "psi") != 0 &&
            strcmp(n->child[i]->key, "phi") != 0)
            return unknown_in_start(key, n->child[i], why);
    const struct node *v = node_find(n, "v"), *psi = node_find(n, "psi");
    const struct node *phi = node_find(n, "phi");
    if (v == NULL || (psi == NULL && phi == NULL))
        return place_blame(n->at, why,
                           "%s: %s is missing, expected {v: V, psi: P}",
                           key->path, v ? "psi" : "v");
    if (psi && phi)
        return place_blame(phi->key_at, why, "%s: phi beside psi, expected one",
                           key->path);
    psi = psi ? psi : phi;
    if (!value_is_number(&parts[0], v, &start->v))
        return value_refuse(&parts[0], v, why);
    if (!value_is_number(&parts[1], psi, &start->psi))
        return value_refuse(&parts[1], psi, why);
    return STATUS_OK;
}

VALUE_READER(value_starts)
{
    enum status status = STATUS_OK;

    if (n->kind != NODE_LIST)
        return value_refuse(key, n, why);
    struct scene_start *start = malloc((n->count + 1) * sizeof *start);
    if (start == NULL)
        return STATUS_NO_MEMORY;
    for (size_t i = 0; i < n->count && status == STATUS_OK; i++)
        status = read_start(key, n->child[i], &start[i], why);
    if (status != STATUS_OK) {
        free(start);
        return status;
    }
    free(s->start);
    s->start = start;
    s->starts = n->count;
    return STATUS_OK;
}
