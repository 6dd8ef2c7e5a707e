/* Borders are known in the window only: a change of fate beyond it is none. */
#include "plane_margin.h"

#include <math.h>

#include "margin.h"
#include "plane_map.h"
#include "plane_patch.h"
#include "plane_tolerance.h"

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

static struct vec2 moved(struct vec2 z, int axis, double to)
{
    return axis == 0 ? (struct vec2){ to, z.y } : (struct vec2){ z.x, to };
}

/* How far it is, up or down a column, to a door (plane_patch.h) that is shut.
 */
static double door_at(const struct plane_study *s, struct margin_line *l,
                      struct vec2 z, int way)
{
    const struct regions *r = &s->basin.regions;
    const struct box w = s->window.box;
    const double in = TOL_SAME * s->scale.side.y;
    const int8_t own = region_of(s, z, l);
    double nearest = HUGE_VAL;

    for (size_t i = 0; i < r->bands; i++) {
        const double edge = way > 0 ? r->band[i].lo : r->band[i].hi;
        const double d = way * (edge - z.y), y = edge + way * in;
        if (d > 0.0 && y > w.lo.y && y < w.hi.y &&
            plane_patch_is_door(s, &r->band[i]) &&
            region_of(s, moved(z, 1, y), l) != own)
            nearest = fmin(nearest, d + 2.0 * in);
    }
    return nearest;
}

/* Towards one side: how far it is to where fates change, and whereto one goes
 * from there; where one goes oneself: it is outside the window.  Infinite where
 * there is none. */
static double change_at(const struct plane_study *s, int axis,
                        struct margin_line *l, struct vec2 z, int way,
                        int8_t *label, double *error)
{
    const double at = vec2_part(z, axis),
                 edge = vec2_part(way > 0 ? s->window.box.hi : s->window.box.lo,
                                  axis);
    const double door =
        axis == 1 && s->basin.shut > 0.0 ? door_at(s, l, z, way) : HUGE_VAL;
    const int8_t own = region_of(s, z, l);

    for (size_t i = 0; i < l->count; i++) {
        const struct crossing *c = &l->at[way > 0 ? i : l->count - 1 - i];
        const double d = way * (c->at - at);
        const double next = i + 1 < l->count ? c[way].at : edge;
        if (d < 0.0)
            continue;
        if (d > door)
            break;
        *error = c->error;
        *label = own;
        if (way * (edge - c->at) < 0.0)
            return d;
        *label = region_of(
            s,
            moved(z, axis,
                  0.5 * (c->at + (way * (next - edge) < 0.0 ? next : edge))),
            l);
        if (*label != own)
            return d;
    }
    *label = -1;
    return door;
}

/* From z to the nearest change along the line, signed; infinite where the
 * window ends before it, NaN where there may be another one before it. */
static double shift_in_window(const struct plane_study *s, int axis,
                              struct margin_line *l, struct vec2 z,
                              double *error)
{
    double off[2] = { HUGE_VAL, HUGE_VAL };
    int8_t label[2] = { -1, -1 };
    const double down = change_at(s, axis, l, z, -1, &label[0], &off[0]);
    const double up = change_at(s, axis, l, z, 1, &label[1], &off[1]);
    const bool is_up = !(down < up);
    const int8_t own = region_of(s, z, l);

    *error = off[is_up];
    if (own < 0 || (fmin(down, up) < HUGE_VAL && label[is_up] < 0))
        return (double) NAN;
    if (label[is_up] == own)
        return (double) INFINITY;
    return is_up ? up : -down;
}

static struct quantity kick_of(const struct plane_study *s, int axis,
                               struct margin_line *l, struct vec2 z)
{
    double error;
    const double shift = shift_in_window(s, axis, l, z, &error);
    const double bar =
        error + 4.0 * TOL_FAR_BELOW * TOL_ROUNDED *
                    (1.0 + fabs(vec2_part(z, axis)) + fabs(shift));

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
    enum status status = plane_map_at(s, z, true, &label);

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
        find_line(s, i, vec2_part(z, 1 - i), &l);
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
        const double at = axis == 0
                              ? plane_map_cell(s, 1, first + k, rows, true)
                              : plane_map_cell(s, 0, k - count, columns, true);
        find_line(s, axis, at, &l);
        for (size_t i = 0; i < (axis == 0 ? columns : count); i++) {
            const struct vec2 here =
                axis == 0
                    ? (struct vec2){ plane_map_cell(s, 0, i, columns, true),
                                     at }
                    : (struct vec2){ at, plane_map_cell(s, 1, first + i, rows,
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
