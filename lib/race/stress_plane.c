#include "stress_plane.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "clock.h"
#include "plane_map.h"
#include "plane_study.h"
#include "quad_formulas.h"
#include "stress_judge.h"
#include "stress_tolerance.h"

bool stress_plane_setting(const struct scene *scene, int k, char text[],
                          size_t size)
{
    const struct formula_system *f = scene->system;
    size_t n = (size_t) snprintf(text, size, "system.parameters={");
    bool needed[FORMULA_NODES], any = false;

    quad_formulas_needed(f, needed);
    for (int p = 0; p < f->parameters && n < size; p++) {
        const double u = vec2_spread(0.5, k * (p + 1.0)).x,
                     value = (double) f->parameter[p].value;
        if (!needed[f->parameter[p].node])
            continue;
        n += (size_t) snprintf(text + n, size - n, "%s%s: %.4g",
                               any ? ", " : "", f->parameter[p].name,
                               value * pow(1.5, 2.0 * u - 1.0));
        any = true;
    }
    if (n < size)
        n += (size_t) snprintf(text + n, size - n, "}");
    return any && n < size;
}

/* ---- numbers ------------------------------------------------------------- */

struct judging {
    const struct plane_study *s;
    struct quad_way way; /* at an equilibrium, once it is settled */
    struct stress_row *row;
};

/* A number that is `off` the truth, in units of a size. */
static void hold(const struct judging *j, quad off, double error, double slack,
                 double size, const char *what)
{
    struct stress_row *row = j->row;
    const double by = fabs((double) off);

    row->bar = fmax(row->bar, by / (error + slack));
    row->digits =
        fmin(row->digits, fmin(STRESS_DIGITS, -log10(by / size + 1e-300)));
    if (!(by <= error + slack))
        stress_row_say(row, STRESS_LIE, "further off than its bar", what);
}

static void judge_rest(struct judging *j, const struct plane_rest *r)
{
    const double error[] = { r->error.x, r->error.y },
                 at[] = { r->z.x, r->z.y };
    quad re[2], im;

    if (r->type == PLANE_NONHYPERBOLIC)
        return; /* its Jacobian may be singular */
    quad_formulas_place(&j->way, r);
    quad_way_eigenvalues(&j->way, re, &im);
    const double rate = (double) hypotq(re[0], re[1]) + (double) im;
    for (int k = 0; k < 2; k++) {
        hold(j, at[k] - j->way.z[k], error[k], STRESS_WAY_TOL * j->way.side[k],
             j->way.side[k], "equilibrium");
        hold(j, r->lambda[k].re.value - re[k], r->lambda[k].re.error,
             STRESS_SLOPE_TOL * rate, rate, "eigenvalue");
        hold(j, r->lambda[k].im.value - (k ? im : -im), r->lambda[k].im.error,
             STRESS_SLOPE_TOL * rate, rate, "eigenvalue");
    }
}

/* ---- branches ------------------------------------------------------------ */

enum { POINTS = 6, LOOKS = 8, STEPS = 300 };

/* Some points of all, of the chart, whose rounding is a double's. */
static double choose(const struct plane_study *s, const struct rows *all,
                     struct plane_point some[POINTS])
{
    const struct plane_point *p = (const struct plane_point *) all->at;
    double slack = 0.0;

    for (size_t i = 0; i < POINTS; i++) {
        some[i] = p[(i + 1) * (all->count - 1) / (POINTS + 1)];
        for (int k = 0; k < 2; k++) {
            some[i].at[k] = plane_chart(s, k, some[i].at[k]);
            slack = fmax(slack, 4 * 0x1p-53 * (1.0 + fabs(some[i].at[k])));
        }
    }
    return slack;
}

static enum status judge_branch(struct judging *j, const struct plane_branch *b)
{
    const struct record_type type = { .size = sizeof(struct plane_point) };
    const double side = vec2_length(j->s->scale.side);
    struct rows all = rows_of(&type);
    struct plane_point some[POINTS];
    struct quad_way w = j->way;
    quad off[POINTS];
    bool lost;

    const enum status status = plane_rows_branch(j->s, b, &all);
    const double slack = status == STATUS_OK && all.count > POINTS
                             ? choose(j->s, &all, some)
                             : 0.0;
    if (slack > 0.0 && some[0].arc > STRESS_WAY_NEAR * side) {
        const double *at = ((const struct plane_point *) all.at)[1].at,
                     first[] = { plane_chart(j->s, 0, at[0]),
                                 plane_chart(j->s, 1, at[1]) };
        quad_formulas_place(&w, &j->s->rest[b->rest]);
        w.step = b->kind == MANIFOLD_STABLE ? -1 : 1;
        quad_way_leave(&w, first);
        const size_t held =
            quad_way_follow(&w, some, POINTS, slack, off, &lost);
        for (size_t i = 0; i < held; i++)
            hold(j, off[i], some[i].error, slack, side, "branch");
        if (lost)
            stress_row_say(j->row, STRESS_DEGRADED,
                           "113 bits did not go so far", "branch");
        else if (held < POINTS)
            hold(j, off[held], some[held].error, slack, side, "branch");
        j->row->steps += (int64_t) b->curve.curve.count;
    }
    rows_free(&all);
    return status;
}

/* ---- labels -------------------------------------------------------------- */

/* The attracting equilibrium that the way from w->z comes to; s->rests: it
 * leaves the window far behind; else -1. */
static int64_t goal_of(const struct plane_study *s, struct quad_way *w)
{
    const struct vec2 first = s->system[0].origin;
    quad z[2];

    w->step = 0.01 / plane_study_speed(s, (struct vec2){ (double) w->z[0],
                                                         (double) w->z[1] });
    for (int n = 0; n < STEPS && quad_way_step(w, z); n++) {
        const struct vec2 at = { (double) z[0], (double) z[1] };
        for (size_t i = 0; i < s->rests; i++)
            if (s->rest[i].trap[0].size > 0.0 &&
                trap_form_distance(&s->rest[i].trap[0], &s->scale, at) <
                    0.5 * s->rest[i].trap[0].size)
                return (int64_t) i;
        if (vec2_length(arrival_from(&s->scale, at, first)) > STRESS_GONE)
            return (int64_t) s->rests;
        quad_way_take(w, z);
    }
    return -1;
}

/* Places spread over the window, beside what their labels say. */
static enum status judge_labels(struct judging *j)
{
    const struct plane_study *s = j->s;
    enum status status = STATUS_OK;

    for (int i = 0; i < LOOKS && status == STATUS_OK; i++) {
        const struct vec2 z = window_at(&s->window, vec2_spread(0.3, i));
        struct quad_way w = j->way;
        int8_t label = -1;
        w.accuracy = STRESS_ARRIVED;
        w.most = 1.0;
        w.longest = (quad) HUGE_VAL;
        status = plane_map_at(s, z, false, &label);
        if (status != STATUS_OK || label < 0)
            continue;
        w.z[0] = z.x;
        w.z[1] = z.y;
        const int64_t goal = goal_of(s, &w);
        bool same = goal < 0, rests = false;
        for (size_t k = 0; k < s->rests; k++) {
            const bool it = strcmp(s->rest[k].name, s->basin.name[label]) == 0;
            rests = rests || it;
            same = same || (it && goal == (int64_t) k);
        }
        same = same || (goal == (int64_t) s->rests && !rests);
        if (!same)
            stress_row_say(j->row, STRESS_LIE,
                           "a state goes elsewhere in 113 bits", "label");
    }
    return status;
}

/* ---- a case -------------------------------------------------------------- */

static enum status judge(const struct plane_study *s, struct stress_row *row,
                         struct quad_formulas *f)
{
    struct judging j = { s, quad_formulas_way(s, f), row };
    const double start = clock_seconds();
    enum status status = STATUS_OK;

    for (size_t i = 0; i < s->listed; i++)
        judge_rest(&j, &s->rest[i]);
    for (size_t i = 0; i < s->listed_branches && status == STATUS_OK; i++)
        status = judge_branch(&j, &s->branch[i]);
    if (status == STATUS_OK)
        status = judge_labels(&j);
    if (s->basin.disagreements > 0)
        stress_row_say(row, STRESS_LIE, "the audit of the labels disagrees",
                       "label");
    if (!s->complete)
        stress_row_say(row, STRESS_DEGRADED,
                       "equilibria are not proved complete", NULL);
    row->oracle_seconds = clock_seconds() - start;
    row->oracle_evaluations = f->scratch->evaluations;
    return status;
}

enum status stress_plane_judge(const struct scene *scene,
                               struct stress_row *row)
{
    struct plane_study *s = malloc(sizeof *s);
    struct scene all = *scene;
    struct quad_formulas f = { NULL, NULL };
    enum status status =
        s ? quad_formulas_init(&f, scene->system) : STATUS_NO_MEMORY;
    const double start = clock_seconds();

    all.products = 1u << PRODUCT_EQUILIBRIA | 1u << PRODUCT_MANIFOLDS |
                   1u << PRODUCT_BASINS;
    if (status == STATUS_OK)
        status = plane_study_run(s, &all, NULL, &row->fault);
    row->seconds = clock_seconds() - start;
    if (status == STATUS_OK) {
        status = judge(s, row, &f);
        plane_study_free(s);
    }
    quad_formulas_free(&f);
    free(s);
    return status;
}
