#include "line.h"

#include <math.h>
#include <stdlib.h>

#include "room.h"

void line_add(struct line *l, double x, double y)
{
    size_t room = l->room;

    l->failed = l->failed || ROOM_FOR(l->x, room, l->count + 1) ||
                ROOM_FOR(l->y, l->room, l->count + 1);
    if (l->failed)
        return;
    l->x[l->count] = x;
    l->y[l->count++] = y;
}

void line_free(struct line *l)
{
    free(l->x);
    free(l->y);
    *l = LINE_EMPTY;
}

void line_reverse(struct line *l)
{
    for (size_t i = 0; 2 * i + 1 < l->count; i++) {
        const size_t k = l->count - 1 - i;
        const double x = l->x[i], y = l->y[i];
        l->x[i] = l->x[k];
        l->y[i] = l->y[k];
        l->x[k] = x;
        l->y[k] = y;
    }
}

void figure_add_line(struct figure *f, const struct figure_layer *look,
                     struct line *l)
{
    struct figure_layer layer = *look;

    layer.x = l->x;
    layer.y = l->y;
    layer.count = l->count;
    if (l->failed && f->status == STATUS_OK)
        f->status = STATUS_NO_MEMORY;
    if (l->count >
        (l->x && (layer.kind == FIGURE_CURVE || layer.kind == FIGURE_REGION)))
        figure_add(f, &layer);
    line_free(l);
}

void figure_add_curve(struct figure *f, struct figure_style style,
                      const char *entry, struct line *l)
{
    figure_add_line(f, &(struct figure_layer){ .style = style, .entry = entry },
                    l);
}

void figure_add_way(struct figure *f, struct figure_style style,
                    const char *entry, struct line *l)
{
    static const double middle = 0.5;

    figure_add_line(
        f,
        &(struct figure_layer){
            .style = style, .entry = entry, .heads = &middle, .head_count = 1 },
        l);
}

void figure_add_arrows(struct figure *f, struct line *at, struct line *along)
{
    at->failed = at->failed || along->failed;
    figure_add_line(f,
                    &(struct figure_layer){ .kind = FIGURE_ARROWS,
                                            .style = { .role = FIGURE_FIELD },
                                            .dx = along->x,
                                            .dy = along->y },
                    at);
    line_free(along);
}

void figure_add_point(struct figure *f, double x, double y,
                      enum figure_role role, enum figure_mark mark, double size,
                      const char *entry)
{
    figure_add(f, &(struct figure_layer){ .kind = FIGURE_POINTS,
                                          .style = { .role = role },
                                          .entry = entry,
                                          .x = &x,
                                          .y = &y,
                                          .count = 1,
                                          .mark = mark,
                                          .size = size });
}

void figure_add_block(struct figure *f, const double x[2], const double y[2],
                      enum figure_role role, const char *entry)
{
    figure_add(
        f, &(struct figure_layer){ .kind = FIGURE_REGION,
                                   .style = { .role = role },
                                   .entry = entry,
                                   .x = (double[]){ x[0], x[1], x[1], x[0] },
                                   .y = (double[]){ y[0], y[0], y[1], y[1] },
                                   .count = 4 });
}

void range_grow(double range[2], const double *value, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (isfinite(value[i])) {
            range[0] = fmin(range[0], value[i]);
            range[1] = fmax(range[1], value[i]);
        }
}
