#include "portrait.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

enum status portrait_init(struct portrait *p, const struct planar *system,
                          const struct window *window)
{
    *p = (struct portrait){ .system = system, .window = *window };
    return window_check(window, system);
}

static void free_nullclines(struct portrait *p)
{
    for (int k = 0; k < NULLCLINES; k++)
        nullcline_free(&p->nullcline[k]);
}

enum status portrait_find_nullclines(struct portrait *p, double chord)
{
    struct nullcline found[NULLCLINES];
    const enum status s = nullcline_find(p->system, &p->window, chord, found);

    if (s != STATUS_OK)
        return s;
    free_nullclines(p);
    for (int k = 0; k < NULLCLINES; k++)
        p->nullcline[k] = found[k];
    return STATUS_OK;
}

enum status portrait_find_arrows(struct portrait *p, size_t columns,
                                 size_t rows)
{
    struct arrows found;
    const enum status s =
        arrows_find(p->system, &p->window, columns, rows, &found);

    if (s != STATUS_OK)
        return s;
    arrows_free(&p->arrows);
    p->arrows = found;
    return STATUS_OK;
}

enum status portrait_spread_trajectories(
    struct portrait *p, size_t count, const struct trajectory_options *options)
{
    struct trajectories found = TRAJECTORIES_EMPTY;
    const enum status s =
        trajectory_spread(p->system, &p->window, count, options, &found);

    if (s != STATUS_OK)
        return s;
    trajectory_free(&p->trajectories);
    p->trajectories = found;
    return STATUS_OK;
}

void portrait_free(struct portrait *p)
{
    free_nullclines(p);
    arrows_free(&p->arrows);
    trajectory_free(&p->trajectories);
}

/* ---- the direction field ------------------------------------------------- */

static struct arrow arrow_at(const struct planar *system,
                             const struct window *w, struct vec2 unit)
{
    struct arrow a = { .z = window_at(w, unit) };
    struct planar_field f;

    system->field(system->ctx, vec2_sub(a.z, system->origin), &f);
    const double speed = vec2_length(f.direction);
    if (speed == 0.0) {
        a.log10_speed = -INFINITY;
        return a;
    }
    a.log10_speed = log10(speed) + f.log_scale / M_LN10;
    a.direction = (struct vec2){ f.direction.x / speed, f.direction.y / speed };
    a.direction = window_push(w, a.z, a.direction);
    a.direction = vec2_scale(1.0 / vec2_length(a.direction), a.direction);
    return a;
}

enum status arrows_find(const struct planar *system,
                        const struct window *window, size_t columns,
                        size_t rows, struct arrows *out)
{
    if (window_check(window, system) != STATUS_OK || columns == 0 ||
        rows == 0 || columns > SIZE_MAX / rows / sizeof(struct arrow))
        return STATUS_BAD_ARGUMENT;
    struct arrow *at = malloc(columns * rows * sizeof *at);
    if (at == NULL)
        return STATUS_NO_MEMORY;
    for (size_t j = 0; j < rows; j++)
        for (size_t i = 0; i < columns; i++) {
            const struct vec2 unit = { ((double) i + 0.5) / (double) columns,
                                       ((double) j + 0.5) / (double) rows };
            at[i + j * columns] = arrow_at(system, window, unit);
        }
    *out = (struct arrows){ at, columns, rows, columns * rows };
    return STATUS_OK;
}

void arrows_free(struct arrows *a)
{
    free(a->at);
    *a = ARROWS_EMPTY;
}
