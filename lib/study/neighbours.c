/*
 * An input is moved by -h and +h.  Near a fold that may be too far: numbers
 * whose two differences are unlike, or which a neighbour lacks, wait for a
 * smaller h.
 */
#include "neighbours.h"

#include <math.h>
#include <stdlib.h>

#include "difference.h"
#include "scene_units.h"
#include "study_results.h"
#include "study_tolerance.h"

struct neighbour {
    struct study study;
    struct scene scene;
    struct unit_system units; /* of the SI */
    struct numbers numbers;   /* of the study */
    bool found;
};
enum { HERE, UP, DOWN, AROUND };

/* ---- numbers ------------------------------------------------------------- */

static void add(struct numbers *n, const void *q, const struct unit *unit)
{
    if (n->count == NEIGHBOUR_NUMBERS)
        return;
    n->unit[n->count] = unit;
    n->at[n->count++] = (struct quantity *) (uintptr_t) q;
}

static void add_records(struct numbers *n, const struct record_array *a)
{
    for (size_t i = 0; i < a->count; i++)
        for (size_t k = 0; k < a->type->count; k++) {
            const struct record_field *f = &a->type->fields[k];
            if (f->kind == RECORD_QUANTITY)
                add(n, record_member(a, i, f), unit_find(f->unit));
        }
}

/* Records that the study holds, rather than makes for whoever looks. */
static enum status add_result(struct numbers *n, const struct results *all,
                              const struct result *r)
{
    const size_t count = result_count(r, all->run);
    enum status status = STATUS_OK;

    for (size_t k = 0; k < count && status == STATUS_OK; k++) {
        struct result_view v;
        status = result_open(all, r, k, &v);
        if (v.here && !v.owned)
            add_records(n, &v.records);
        result_close(&v);
    }
    return status;
}

/* Of the results that need nothing but `from`, and that one with these stages
 * was asked for. */
static enum status numbers_of(struct study *s, uint64_t from, unsigned stages,
                              struct numbers *n)
{
    const struct results all = study_results(s);
    enum status status = study_keep(s, STUDY_NUMBERS);

    n->count = 0;
    for (size_t t = 0; all.table[t]; t++)
        for (const struct result *r = all.table[t]; r->type && !status; r++)
            if (r->name && result_asked(r, &all) && (r->needs & stages) &&
                !(r->needs & ~from))
                status = add_result(n, &all, r);
    return status;
}

/* ---- neighbours ---------------------------------------------------------- */

/* The study with an input moved (move NULL: with none), at an accuracy fit for
 * differences; only STATUS_NO_MEMORY is an error. */
static enum status recompute(struct neighbours *f, neighbour_move *move,
                             const void *ctx, double nudge, int which)
{
    struct neighbour *n = &f->around[which];
    struct scene *c = &n->scene;
    struct fault why;

    *c = *f->s->scene; /* borrows what that owns */
    c->rtol = fmin(c->rtol, TOL_RTOL_DEFAULT);
    study_free(&n->study);
    n->found = false;
    if (move && !move(ctx, nudge, c))
        return STATUS_OK;
    c->products = plan_products((unsigned) (f->s->stages & f->stages));
    c->ensemble.scattered = 0;
    c->proved = c->exact = false;
    c->audit = 0;
    n->units = scene_units(c);
    n->units.si = true;
    enum status status = study_run(&n->study, c, NULL, &why);
    n->found = status == STATUS_OK;
    if (n->found)
        status = numbers_of(&n->study, f->stages, f->s->stages, &n->numbers);
    if (n->found)
        f->evaluations += study_cost(&n->study).field_evaluations;
    return status == STATUS_NO_MEMORY ? status : STATUS_OK;
}

enum status neighbours_init(struct neighbours *f, struct study *s,
                            uint64_t stages)
{
    *f = (struct neighbours){ .s = s, .stages = stages };
    f->around = calloc(AROUND, sizeof *f->around);
    if (f->around == NULL)
        return STATUS_NO_MEMORY;
    enum status status = numbers_of(s, stages, s->stages, &f->numbers);
    if (status == STATUS_OK)
        status = recompute(f, NULL, NULL, 0.0, HERE);
    f->same = f->around[HERE].found &&
              f->around[HERE].numbers.count == f->numbers.count;
    if (status != STATUS_OK)
        neighbours_free(f);
    return status;
}

void neighbours_free(struct neighbours *f)
{
    for (int i = 0; f->around && i < AROUND; i++)
        study_free(&f->around[i].study);
    free(f->around);
    *f = (struct neighbours){ .s = NULL };
}

/* ---- rates --------------------------------------------------------------- */

static void set_rate(const struct neighbour n[AROUND], size_t i, double nudge,
                     struct neighbour_rate *rate)
{
    struct quantity own[AROUND], si[AROUND];

    for (int k = 0; k < AROUND; k++) {
        own[k] = *n[k].numbers.at[i];
        si[k] = unit_quantity(&n[k].units, n[k].numbers.unit[i], own[k]);
    }
    rate->settled = difference_rate(own, nudge, &rate->own);
    (void) difference_rate(si, nudge, &rate->si);
}

/* False if some would rather have a smaller nudge. */
static bool find_rates(const struct neighbours *f, double nudge,
                       struct neighbour_rate rate[])
{
    const struct neighbour *n = f->around;
    const size_t count = n[HERE].numbers.count;
    bool all = true;

    if (!n[UP].found || !n[DOWN].found || n[UP].numbers.count != count ||
        n[DOWN].numbers.count != count)
        return false;
    for (size_t i = 0; i < count; i++) {
        if (!rate[i].settled)
            set_rate(n, i, nudge, &rate[i]);
        all = all && rate[i].settled;
    }
    return all;
}

enum status neighbours_rates(struct neighbours *f, neighbour_move *move,
                             const void *ctx, struct neighbour_rate rate[])
{
    double nudge = TOL_CONDITION_NUDGE;
    enum status status;

    for (size_t i = 0; i < f->numbers.count; i++)
        rate[i] = (struct neighbour_rate){ HUGE_VAL, HUGE_VAL, false };
    do {
        status = recompute(f, move, ctx, nudge, UP);
        if (status == STATUS_OK)
            status = recompute(f, move, ctx, -nudge, DOWN);
        if (status != STATUS_OK)
            return status;
    } while (!find_rates(f, nudge, rate) &&
             (nudge *= 1.0 / TOL_RETRY) >= TOL_RTOL_DEFAULT);
    return STATUS_OK;
}
