#include "plane_rows.h"

#include <math.h>

#include "plane_tolerance.h"

/* ---- manifolds ----------------------------------------------------------- */

struct sampler {
    const struct plane_study *s;
    const struct plane_branch *b;
    struct rows *rows;
    double arc;
    struct vec2 last;
};

static struct vec2 point(const struct sampler *p, size_t piece, double theta)
{
    return curve_point(&p->b->curve.curve, piece, theta);
}

static enum status add(struct sampler *p, size_t piece, double theta)
{
    const struct plane_rest *r = &p->s->rest[p->b->rest];
    const struct curve *c = &p->b->curve.curve;
    const struct vec2 z = point(p, piece, theta), at = vec2_add(r->z, z);
    double along[CURVE_DIM_MAX], slope;

    curve_slope_at(c, piece, theta, along);
    slope = along[1] / along[0];
    p->arc += vec2_length(vec2_sub(z, p->last));
    p->last = z;
    const struct plane_point row = {
        .arc = p->arc,
        .at = { plane_state(p->s, 0, at.x), plane_state(p->s, 1, at.y) },
        .slope = isfinite(slope) ? slope : (double) NAN,
        .error = c->piece[piece].error + vec2_length(r->error),
    };
    return rows_push(p->rows, &row);
}

static enum status refine(struct sampler *p, size_t piece, double from,
                          double to, int depth)
{
    const double middle = 0.5 * (from + to);
    const struct vec2 a = point(p, piece, from), b = point(p, piece, to);
    const struct vec2 m = point(p, piece, middle);
    const struct vec2 off = vec2_sub(m, vec2_scale(0.5, vec2_add(a, b)));
    const struct vec2 side = p->s->scale.side;

    if (depth == 0 ||
        (depth < 6 && hypot(off.x / side.x, off.y / side.y) <= TOL_DRAWN))
        return add(p, piece, to);
    const enum status s = refine(p, piece, from, middle, depth - 1);
    return s ? s : refine(p, piece, middle, to, depth - 1);
}

enum status plane_rows_branch(const struct plane_study *s,
                              const struct plane_branch *b, struct rows *r)
{
    struct sampler p = { .s = s, .b = b, .rows = r };
    enum status status = b->shown > 0 ? add(&p, 0, 0.0) : STATUS_OK;

    for (size_t i = 0; i < b->shown && status == STATUS_OK; i++)
        status = refine(&p, i, 0.0, i + 1 == b->shown ? b->shown_to : 1.0, 8);
    return status;
}

/* ---- the others ---------------------------------------------------------- */

enum status plane_rows_nullcline(const struct plane_study *s,
                                 const struct polyline *line, struct rows *r)
{
    double arc = 0.0;
    enum status status = STATUS_OK;

    for (size_t i = 0; i < line->count && status == STATUS_OK; i++) {
        if (i > 0)
            arc += vec2_length(vec2_sub(line->at[i], line->at[i - 1]));
        const struct plane_place row = { arc,
                                         { plane_state(s, 0, line->at[i].x),
                                           plane_state(s, 1, line->at[i].y) } };
        status = rows_push(r, &row);
    }
    return status;
}

static enum status add_moment(const struct plane_study *s,
                              const struct curve *c, size_t piece, double theta,
                              struct rows *r)
{
    const struct vec2 origin = s->system[0].origin;
    struct plane_moment row = { .time = 0.0 };
    double at[CURVE_DIM_MAX];

    curve_at(c, piece, theta, at);
    row.time = at[2];
    row.at[0] = plane_state(s, 0, origin.x + at[0]);
    row.at[1] = plane_state(s, 1, origin.y + at[1]);
    for (size_t i = 0; i < s->system[0].observable_count; i++)
        row.value[i] = at[3 + i];
    return rows_push(r, &row);
}

enum status plane_rows_trajectory(const struct plane_study *s, size_t k,
                                  struct rows *r)
{
    enum { PER_STEP = 3 };
    const struct curve *before = &s->backward.at[k].curve;
    const struct curve *after = &s->portrait.trajectories.at[k].curve;
    enum status status = STATUS_OK;

    for (size_t i = before->count; i-- > 0;)
        for (int j = PER_STEP; j > 0 && status == STATUS_OK; j--)
            status = add_moment(s, before, i, (double) j / PER_STEP, r);
    if (before->count > 0 && after->count == 0 && status == STATUS_OK)
        status = add_moment(s, before, 0, 0.0, r);
    for (size_t i = 0; i < after->count; i++)
        for (int j = i > 0; j <= PER_STEP && status == STATUS_OK; j++)
            status = add_moment(s, after, i, (double) j / PER_STEP, r);
    return status;
}

enum status plane_rows_arrows(const struct plane_study *s, struct rows *r)
{
    const struct arrows *a = &s->portrait.arrows;
    enum status status = STATUS_OK;

    for (size_t i = 0; i < a->columns * a->rows && status == STATUS_OK; i++) {
        const struct arrow *t = &a->at[i];
        const struct plane_arrow row = {
            { plane_state(s, 0, t->z.x), plane_state(s, 1, t->z.y) },
            { t->direction.x, t->direction.y },
            t->log10_speed,
        };
        status = rows_push(r, &row);
    }
    return status;
}
