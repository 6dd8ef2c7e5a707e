/* Curves sampled.  A piece is halved until the cubic Hermite interpolant that
 * a reader of the file would build agrees with the curve at the middle. */
#include "curve_rows.h"

#include <math.h>

#include "remark.h"
#include "sample.h"
#include "study_results.h"
#include "study_tolerance.h"

/* A point of a branch in the making: chart coordinates and all the rest. */
struct sample {
    size_t piece;
    double theta;
    struct vec2 z; /* offset */
    double slope;  /* dy/dx */
    double at[CURVE_DIM_MAX];
};

/* Where each stored integral sits in the curve, 0: not carried. */
struct columns {
    size_t slip, time, work, excess;
    double sign; /* of the stored integrals along the curve */
};

struct sampler {
    const struct study *s;
    const struct curve *curve;
    const struct branch *branch; /* NULL for an orbit */
    struct columns columns;
    double error; /* of the whole curve */
    struct rows *rows;
    double arc;
    struct vec2 last;
};

static double slope_at(const struct sampler *p, size_t piece, double theta,
                       struct vec2 z)
{
    if (p->branch)
        return branch_slope(&p->s->slider.plane.system, p->branch, piece,
                            theta);
    return local_slope(&p->s->slider.plane.system, 0, z);
}

static struct sample sample_at(const struct sampler *p, size_t piece,
                               double theta)
{
    struct sample t = { .piece = piece, .theta = theta };

    curve_at(p->curve, piece, theta, t.at);
    t.z = (struct vec2){ t.at[0], t.at[1] };
    t.slope = slope_at(p, piece, theta, t.z);
    return t;
}

/* Distance of the middle from the Hermite cubic through the ends, over the
 * flatter coordinate. */
static double hermite_defect(const struct sample *a, const struct sample *m,
                             const struct sample *b)
{
    const bool flat = fabs(m->slope) < 1.0;
    const double s0 = flat ? a->z.x : a->z.y, s1 = flat ? b->z.x : b->z.y;
    const double u0 = flat ? a->z.y : a->z.x, u1 = flat ? b->z.y : b->z.x;
    const double d0 = flat ? a->slope : 1.0 / a->slope;
    const double d1 = flat ? b->slope : 1.0 / b->slope;
    const double h = s1 - s0, t = ((flat ? m->z.x : m->z.y) - s0) / h;

    if (h == 0.0)
        return 0.0;
    const double u =
        (1.0 - t) * (1.0 - t) * ((1.0 + 2.0 * t) * u0 + t * h * d0) +
        t * t * ((3.0 - 2.0 * t) * u1 + (t - 1.0) * h * d1);
    return fabs(u - (flat ? m->z.y : m->z.x));
}

static double carried(const struct sample *t, size_t column, double sign)
{
    return column ? sign * t->at[column] : 0.0;
}

static enum status add_branch_row(struct sampler *p, const struct sample *t)
{
    const struct vec2 step = vec2_sub(t->z, p->last);
    const struct columns *c = &p->columns;

    p->arc += vec2_length(step);
    p->last = t->z;
    const struct branch_row row = {
        .arc = p->arc,
        .v = block_v(&p->s->slider.block, t->z.x),
        .psi = block_psi(&p->s->slider.block, t->z.y),
        .slope = isfinite(t->slope) ? t->slope : (double) NAN,
        .slip = carried(t, c->slip, c->sign),
        .time = carried(t, c->time, c->sign),
        .work = carried(t, c->work, c->sign),
        .excess = carried(t, c->excess, c->sign),
        .error = p->error + p->curve->piece[t->piece].error,
    };
    return rows_push(p->rows, &row);
}

/* Rows of a piece behind a, up to and with b. */
static enum status refine(struct sampler *p, size_t piece,
                          const struct sample *a, const struct sample *b,
                          int depth)
{
    const struct sample m = sample_at(p, piece, 0.5 * (a->theta + b->theta));
    const double distance = vec2_length(vec2_sub(b->z, a->z));
    const bool fine = hermite_defect(a, &m, b) <= 0.2 * TOL_SAME &&
                      distance <= TOL_ROW_SPACING;

    if (fine || depth == 0)
        return add_branch_row(p, b);
    enum status s = refine(p, piece, a, &m, depth - 1);
    if (s == STATUS_OK)
        s = refine(p, piece, &m, b, depth - 1);
    return s;
}

static enum status sample_curve(struct sampler *p)
{
    enum status s = STATUS_OK;

    for (size_t piece = 0; piece < p->curve->count && s == STATUS_OK; piece++) {
        const struct sample a = sample_at(p, piece, 0.0);
        const struct sample b = sample_at(p, piece, 1.0);
        if (piece == 0)
            s = add_branch_row(p, &a);
        if (s == STATUS_OK)
            s = refine(p, piece, &a, &b, 12);
    }
    return s;
}

/* Beyond its last step a closed branch is its asymptote: one more row where
 * that meets the window's edge, if it is further out. */
static enum status add_asymptote(struct sampler *p)
{
    const struct branch *b = p->branch;
    const struct box w = scene_box(p->s->scene);
    const struct vec2 origin = p->s->slider.plane.system.origin;
    const size_t last = p->curve->count - 1;
    struct sample t = sample_at(p, last, 1.0);
    const struct vec2 edge = vec2_sub(b->sign > 0 ? w.hi : w.lo, origin);

    if (b->end == BRANCH_LIMIT_X && b->sign * (edge.y - t.z.y) > 0.0) {
        t.z = (struct vec2){ b->limit.x, edge.y };
        t.slope = HUGE_VAL;
    } else if (b->end == BRANCH_LIMIT_Y && b->sign * (edge.x - t.z.x) > 0.0) {
        t.z = (struct vec2){ edge.x, b->limit.y };
        t.slope = 0.0;
    } else {
        return STATUS_OK;
    }
    return add_branch_row(p, &t);
}

enum status curve_rows_branch(const struct study *s, const struct branch *b,
                              struct rows *r)
{
    struct sampler p = { .s = s,
                         .curve = &b->curve,
                         .branch = b,
                         .columns = { .sign = 1.0 },
                         .rows = r };

    for (size_t i = 0; i < b->carry.count; i++) {
        size_t *column = b->carry.which[i] == CARRY_TIME   ? &p.columns.time
                         : b->carry.which[i] == BLOCK_SLIP ? &p.columns.slip
                         : b->carry.which[i] == BLOCK_WORK ? &p.columns.work
                                                           : &p.columns.excess;
        *column = i + 2;
    }
    const enum status status = sample_curve(&p);
    return status == STATUS_OK ? add_asymptote(&p) : status;
}

enum status curve_rows_unstable(const struct study *s, const struct orbit *o,
                                struct rows *r)
{
    struct sampler p = { .s = s,
                         .curve = &o->curve,
                         .columns = { .time = 2,
                                      .slip = 3 + BLOCK_SLIP,
                                      .work = 3 + BLOCK_WORK,
                                      .excess = 3 + BLOCK_EXCESS,
                                      .sign = 1.0 },
                         .error = o->error[0] + o->error[1],
                         .rows = r };
    return sample_curve(&p);
}

/* A piece of nullcline (struct nullcline_row). */
static enum status curve_rows_nullcline(const struct study *s,
                                        const struct polyline *line,
                                        struct rows *r)
{
    double arc = 0.0;
    enum status status = STATUS_OK;

    for (size_t i = 0; i < line->count && status == STATUS_OK; i++) {
        if (i > 0)
            arc += vec2_length(vec2_sub(line->at[i], line->at[i - 1]));
        const struct vec2 z =
            vec2_sub(line->at[i], s->slider.plane.system.origin);
        const struct nullcline_row row = { arc, block_v(&s->slider.block, z.x),
                                           block_psi(&s->slider.block, z.y) };
        status = rows_push(r, &row);
    }
    return status;
}

/* As rows have a time each: of those that doubles cannot tell apart by it the
 * first, but for the end of the run. */
static enum status push_later(struct rows *r, const struct trajectory_row *row,
                              bool end)
{
    const struct trajectory_row *rows = r->at;

    while (r->count > 0 && !(row->time > rows[r->count - 1].time)) {
        if (!end || r->count == 1)
            return STATUS_OK;
        r->count--;
    }
    return rows_push(r, row);
}

enum status curve_rows_trajectory(const struct study *s, const struct curve *c,
                                  struct rows *r)
{
    enum { PER_STEP = 3 };
    double at[CURVE_DIM_MAX];
    enum status status = STATUS_OK;

    for (size_t i = 0; i < c->count; i++)
        for (int k = i == 0 ? 0 : 1; k <= PER_STEP; k++) {
            curve_at(c, i, (double) k / PER_STEP, at);
            const struct trajectory_row row = sample_row(&s->slider, at);
            status = push_later(r, &row, i + 1 == c->count && k == PER_STEP);
            if (status != STATUS_OK)
                return status;
        }
    return status;
}

/* The direction field (struct arrow_row). */
static enum status curve_rows_arrows(const struct study *s, struct rows *r)
{
    const struct arrows *a = &s->portrait.arrows;
    enum status status = STATUS_OK;

    for (size_t i = 0; i < a->columns * a->rows && status == STATUS_OK; i++) {
        const struct arrow *t = &a->at[i];
        const struct vec2 z = vec2_sub(t->z, s->slider.plane.system.origin);
        const struct arrow_row row = {
            .v = block_v(&s->slider.block, z.x),
            .psi = block_psi(&s->slider.block, z.y),
            .direction_v = t->direction.x,
            .direction_psi = t->direction.y,
            .log10_speed = t->log10_speed,
        };
        status = rows_push(r, &row);
    }
    return status;
}

/* ---- what a study says of its curves ------------------------------------- */

/* stable_upper, unstable_upper, stable_lower, unstable_lower */
static enum status view_branch(const void *run, size_t k,
                               struct result_view *out)
{
    const struct study *s = run;
    const size_t side = k / 2;
    struct rows r = rows_of(&record_branch);

    if (!slider_has_manifolds(&s->slider))
        return STATUS_OK;
    if (k % 2 == 0)
        return rows_lend(out, &r, curve_rows_branch(s, &s->stable[side], &r));
    return plan_has(s->stages, STAGE_UNSTABLE)
               ? rows_lend(out, &r,
                           curve_rows_unstable(s, &s->unstable[side], &r))
               : STATUS_OK;
}

const struct result manifold_results[] = {
    { .path = "/manifold/{stable_upper,unstable_upper,stable_lower,"
              "unstable_lower}",
      .text = "product manifolds: a branch of an invariant manifold of the "
              "saddle, from there on; stable ones also where others need them",
      .shape = RESULT_COLUMNS,
      .axis = "arc",
      .type = &record_branch,
      .needs = ASKED_BY(STABLE),
      .view = view_branch },
    { .path = NULL },
};

RESULT_COUNT(count_v, study, s->portrait.nullcline[0].count)
RESULT_COUNT(count_psi, study, s->portrait.nullcline[1].count)

ROWS_VIEW(view_v, study,
          curve_rows_nullcline(s, &s->portrait.nullcline[0].piece[k], &r))
ROWS_VIEW(view_psi, study,
          curve_rows_nullcline(s, &s->portrait.nullcline[1].piece[k], &r))
ROWS_VIEW(view_arrows, study, curve_rows_arrows(s, &r))

/* Number k of those with points: chosen starts, then spread ones; NULL. */
static const struct trajectory *track(const struct study *s, size_t k)
{
    const struct trajectories *set[] = { &s->chosen,
                                         &s->portrait.trajectories };

    for (int i = 0; i < 2; i++)
        for (size_t j = 0; j < set[i]->count; j++)
            if (set[i]->at[j].curve.count > 0 && k-- == 0)
                return &set[i]->at[j];
    return NULL;
}

static size_t count_tracks(const void *run)
{
    size_t n = 0;

    while (track(run, n))
        n++;
    return n;
}

ROWS_VIEW(view_track, study, curve_rows_trajectory(s, &track(s, k)->curve, &r))

const struct record_type record_run_end = RECORD(
    run_end, "run_end", "how an orbit ended",
    FIELD(run_end, TEXT, end, "1",
          "why it ends: arrived, left_window, left_domain, limit, event, "
          "given_up; of simulate a word of transient_end"),
    FIELD(run_end, TEXT, fate, "1",
          "simulate: what becomes of the start, a word of fate"),
    FIELD(run_end, TEXT, comment, "1",
          "simulate: why it is undecided or lost, if it is"),
    FIELD(run_end, REAL, energy_defect, "1",
          "relative defect of the balance (27)"));

enum status curve_rows_lend_end(struct result_view *out, struct run_end end)
{
    struct rows r = rows_of(&record_run_end);

    return rows_lend(out, &r, rows_push(&r, &end));
}

static enum status view_end(const void *run, size_t k, struct result_view *out)
{
    const struct trajectory *t = track(run, k);

    return curve_rows_lend_end(
        out, (struct run_end){
                 .end = study_end_name(t),
                 .energy_defect = slider_energy_defect(
                     &((const struct study *) run)->slider, &t->curve) });
}

const struct result portrait_results[] = {
    { .path = "/nullcline/v_K",
      .text = "product nullclines: a piece of the curve where v does not "
              "change",
      .shape = RESULT_COLUMNS,
      .axis = "arc",
      .type = &record_nullcline,
      .needs = ASKED_BY(NULLCLINES),
      .count = count_v,
      .view = view_v },
    { .path = "/nullcline/psi_K",
      .text = "product nullclines: a piece of the curve where psi does not "
              "change",
      .shape = RESULT_COLUMNS,
      .axis = "arc",
      .type = &record_nullcline,
      .needs = ASKED_BY(NULLCLINES),
      .count = count_psi,
      .view = view_psi },
    { .path = "/field_arrows",
      .text = "product field_arrows: the direction field",
      .shape = RESULT_COLUMNS,
      .type = &record_arrow,
      .needs = ASKED_BY(ARROWS),
      .view = view_arrows },
    { .path = "/trajectory_K",
      .text = "product trajectories: a forward orbit",
      .shape = RESULT_COLUMNS,
      .axis = "time",
      .type = &record_trajectory,
      .needs = ASKED_BY(TRAJECTORIES),
      .count = count_tracks,
      .view = view_track },
    { .path = "/trajectory_K",
      .shape = RESULT_ATTRIBUTES,
      .type = &record_run_end,
      .needs = ASKED_BY(TRAJECTORIES),
      .count = count_tracks,
      .view = view_end },
    { .path = NULL },
};
