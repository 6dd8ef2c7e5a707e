/* Borders are known in the window only: a change of fate beyond it is none. */
#include "plane_margin.h"

#include <math.h>

#include "margin.h"
#include "plane_basin.h"
#include "study_tolerance.h"

static double part_of(struct vec2 z, int axis)
{
    return axis == 0 ? z.x : z.y;
}

/* Where fates change as one coordinate does, the other being `at`. */
static void find_line(const struct plane_study *s, int axis, double at,
                      struct margin_line *l)
{
    margin_find(l, &s->basin.regions,
                axis == 0 ? &s->basin.cuts : &s->basin.columns, at);
}

/* The label of the region of a place that is one of one fate; below 0: orbits
 * from there may go to different ones. */
static int8_t region_of(const struct plane_study *s, struct vec2 z,
                        struct margin_line *l)
{
    const struct regions *r = &s->basin.regions;

    return r->region[regions_at(r, z, l->at + l->room)].label;
}

/* From z to the nearest change along the line, signed; infinite where the
 * window ends before it, NaN where there may be another one before it. */
static double shift_in_window(const struct plane_study *s, int axis,
                              struct margin_line *l, struct vec2 z,
                              double *error)
{
    const double at = part_of(z, axis), shift = margin_at(l, at, error);
    const double end = at + shift,
                 past = end + copysign(*error + TOL_SHARE_ROUNDING, shift);
    const struct vec2 other =
        axis == 0 ? (struct vec2){ past, z.y } : (struct vec2){ z.x, past };

    if (region_of(s, z, l) < 0)
        return (double) NAN;
    if (!(end >= part_of(s->window.box.lo, axis) &&
          end <= part_of(s->window.box.hi, axis)))
        return (double) INFINITY;
    return region_of(s, other, l) < 0 ? (double) NAN : shift;
}

static struct quantity kick_of(const struct plane_study *s, int axis,
                               struct margin_line *l, struct vec2 z)
{
    double error;
    const double shift = shift_in_window(s, axis, l, z, &error);
    const double bar = error + 4.0 * TOL_SHARE_ROUNDING *
                                   (1.0 + fabs(part_of(z, axis)) + fabs(shift));

    if (isnan(shift))
        return quantity_none("where fates change there is not known");
    if (isinf(shift))
        return quantity_none("no other fate in the window along this line");
    if (!(bar <= fabs(shift)))
        return quantity_none("the other fate may be as near as its error bar");
    if (!s->system[0].axis[axis].is_log)
        return quantity_of(shift, bar);
    return quantity_of(exp(shift), exp(shift) * expm1(bar));
}

enum status plane_margin_at(const struct plane_study *s, struct vec2 z,
                            struct quantity kick[2])
{
    const bool inside = box_holds(s->window.box, z);
    struct margin_line l;
    int8_t label = -1;
    enum status status = plane_basin_at(s, z, &label);

    if (status == STATUS_OK)
        status = margin_init(&l, &s->basin.cuts, &s->basin.columns);
    if (status != STATUS_OK)
        return status;
    for (int i = 0; i < 2; i++) {
        kick[i] =
            quantity_none(inside ? "whereto the state itself goes is not known"
                                 : "the state is outside the window");
        if (!inside || label < 0)
            continue;
        find_line(s, i, part_of(z, 1 - i), &l);
        kick[i] = kick_of(s, i, &l, z);
    }
    margin_free(&l);
    return STATUS_OK;
}

enum status plane_margin_fill(const struct plane_study *s, size_t columns,
                              size_t rows, size_t first, size_t count,
                              struct plane_margins out[])
{
    struct margin_line l;
    double error;
    enum status status = margin_init(&l, &s->basin.cuts, &s->basin.columns);

    if (status != STATUS_OK)
        return status;
    for (size_t k = 0; k < columns + count; k++) {
        const int axis = k < count ? 0 : 1; /* along rows, then columns */
        const double at =
            axis == 0 ? plane_basin_cell(s, 1, first + k, rows, true)
                      : plane_basin_cell(s, 0, k - count, columns, true);
        find_line(s, axis, at, &l);
        for (size_t i = 0; i < (axis == 0 ? columns : count); i++) {
            const struct vec2 here =
                axis == 0
                    ? (struct vec2){ plane_basin_cell(s, 0, i, columns, true),
                                     at }
                    : (struct vec2){ at, plane_basin_cell(s, 1, first + i, rows,
                                                          true) };
            const double shift = shift_in_window(s, axis, &l, here, &error);
            const size_t cell =
                axis == 0 ? k * columns + i : i * columns + (k - count);
            out[cell].by[axis] = isfinite(shift) ? shift : (double) NAN;
        }
    }
    margin_free(&l);
    return STATUS_OK;
}
