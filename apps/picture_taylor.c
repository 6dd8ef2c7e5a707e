#include "picture_taylor.h"

#include <float.h>
#include <math.h>
#include <stdio.h>

#include "line.h"

enum { POINTS = 2000 };

struct sums {
    const struct study *s;
    struct vec2 (*shown)(const void *ctx, struct vec2);
    const void *ctx;
    struct figure *f;
};

/* Where a sum is negative a log axis shows it falling. */
static double lowest(const struct study *s)
{
    return s->scene->window.axes == AXES_LOG &&
                   !law_psi_is_log(&s->slider.block.law)
               ? DBL_MIN
               : -DBL_MAX;
}

static void add_sum(const struct sums *q, size_t order, enum figure_role role)
{
    const struct box w = scene_box(q->s->scene);
    struct line l = LINE_EMPTY;
    char entry[32];

    for (int i = 0; i <= POINTS; i++) {
        const double v = exp(w.lo.x + (double) i / POINTS * (w.hi.x - w.lo.x));
        const double psi =
            taylor_series_at(&q->s->taylor, order, v, q->s->slider.block.at.v0);
        const struct vec2 at =
            q->shown(q->ctx, (struct vec2){ v, fmax(psi, lowest(q->s)) });
        line_add(&l, at.x, at.y);
    }
    snprintf(entry, sizeof entry, "power series, order %zu", order);
    figure_add_curve(q->f, (struct figure_style){ .role = role }, entry, &l);
}

static void add_band(const struct sums *q)
{
    const struct scene_window *w = &q->s->scene->window;
    const double v_sp = q->s->slider.block.at.v0, R = q->s->taylor.radius.value;
    const struct vec2 a =
        q->shown(q->ctx, (struct vec2){ fmax(v_sp - R, w->v[0]), w->psi[0] });
    const struct vec2 b =
        q->shown(q->ctx, (struct vec2){ v_sp + R, w->psi[1] });

    figure_add_block(q->f, (double[]){ a.x, b.x }, (double[]){ a.y, b.y },
                     FIGURE_SHADE_2, "the series converges");
}

void picture_add_taylor(const struct study *s,
                        struct vec2 (*shown)(const void *ctx, struct vec2),
                        const void *ctx, struct figure *f)
{
    static const struct {
        size_t order;
        enum figure_role role;
    } sum[] = { { 2, FIGURE_SERIES_5 },
                { 6, FIGURE_SERIES_3 },
                { TAYLOR_PAPER, FIGURE_SERIES_6 },
                { 30, FIGURE_SERIES_4 } };
    const struct sums q = { s, shown, ctx, f };

    if (s->taylor.terms == 0)
        return;
    if (quantity_exists(&s->taylor.radius) && f->raster == NULL)
        add_band(&q); /* else it would hide basins */
    for (size_t i = 0; i < sizeof sum / sizeof *sum; i++)
        add_sum(&q, sum[i].order, sum[i].role);
}
