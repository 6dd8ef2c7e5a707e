#include "portrait.h"

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
