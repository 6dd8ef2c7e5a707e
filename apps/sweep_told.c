#include "sweep_told.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "result_units.h"
#include "scene_sweep.h"
#include "scene_units.h"

struct unit_system sweep_answer_units(const struct sweep *s, size_t point)
{
    struct scene at;

    if (s->scene->system)
        return (struct unit_system){ .si = false };
    scene_at(s->scene, sweep_rows_x(&s->rows, point), &at);
    struct unit_system u = scene_units(&at);
    u.angle = at.slope_in;
    return u;
}

struct unit_system sweep_units(const struct sweep *s, size_t point)
{
    struct unit_system u = sweep_answer_units(s, point);

    u.angle = ANGLE_RAD;
    return u;
}

/* The unit in which a column is told otherwise than it is; else NULL. */
static const struct unit *column_unit(const struct sweep *s,
                                      const struct unit_system *u, int column)
{
    const struct sweep_column *c = &s->columns.at[column];

    return result_told_unit(u, c->number.of->type, c->number.field, c->unit);
}

/* What is proved of a number: beyond the bar that telling it in this unit
 * makes. */
static struct quantity outward(struct quantity q, enum result_part part)
{
    const double way = part == RESULT_LO ? -q.error : q.error;

    if (part != RESULT_VALUE && quantity_exists(&q) && q.error > 0)
        q.value = nextafter(q.value + way, way * HUGE_VAL);
    return q;
}

struct quantity sweep_told(const struct sweep *s, const struct unit_system *u,
                           int column, size_t point, size_t entry)
{
    return outward(unit_quantity(u, column_unit(s, u, column),
                                 sweep_entry(s, column, point, entry)),
                   s->columns.at[column].number.part);
}

const char *sweep_column_unit(const struct sweep *s,
                              const struct unit_system *u, int column)
{
    const char *own = s->columns.at[column].unit;

    return column_unit(s, u, column) ? unit_name(u, own) : own;
}

/* A column's name ends with its member's. */
struct sweep_name sweep_told_name(const struct sweep *s,
                                  const struct unit_system *u, int column)
{
    const struct sweep_column *c = &s->columns.at[column];
    const struct record_field *f = c->number.field;
    char member[RESULT_NAME];
    struct sweep_name name;

    result_told_name(u, c->number.of->type, f, member);
    static const char *const part[] = { "", "_lo", "_hi" };
    const char *behind = part[c->number.part];
    const size_t size = strlen(c->name) - strlen(behind), end = strlen(f->name);
    const bool ends =
        size >= end && strncmp(c->name + size - end, f->name, end) == 0;
    snprintf(name.text, sizeof name.text, "%.*s%s%s",
             ends ? (int) (size - end) : (int) size, c->name,
             ends ? member : "", behind);
    return name;
}

const char *sweep_told_unit(const struct sweep *s, const char *own)
{
    const struct unit_system u = sweep_units(s, 0);

    return unit_name(&u, own);
}

double sweep_told_value(const struct sweep *s, const char *own, double x)
{
    const struct unit_system u = sweep_units(s, 0);

    return result_input(&u, unit_find(own), x);
}

const char *sweep_told_state(const struct sweep *s)
{
    return s->scene->units == UNITS_SI ? "phi" : "psi";
}

struct sweep_name sweep_told_dim(const struct sweep *s, enum sweep_dim dim)
{
    const struct sweep_dim_axis *a = &s->dims.of[dim];
    const struct record_field f = { .name = a->name, .unit = a->unit };
    const struct record_type alone = { .fields = &f, .count = 1 };
    const struct unit_system u = sweep_units(s, 0);
    struct sweep_name name;

    result_told_name(&u, &alone, &f, name.text);
    return name;
}

/* ---- layers -------------------------------------------------------------- */

static void count_codes(const int8_t code[], struct sweep_summary *out)
{
    for (size_t i = 0; i < out->cells; i++)
        if (code[i] >= 0 && code[i] < SUMMARY_WORDS) {
            out->counts[code[i]]++;
            out->present++;
        }
}

static void measure(const double value[], struct sweep_summary *out)
{
    for (size_t i = 0; i < out->cells; i++) {
        if (isnan(value[i]))
            continue;
        out->least = fmin(out->least, value[i]); /* of NaN and x: x */
        out->greatest = fmax(out->greatest, value[i]);
        out->present++;
    }
}

enum status sweep_summary_find(const struct sweep *s, size_t k, size_t point,
                               struct sweep_summary *out, struct fault *why)
{
    const struct sweep_layer *layer = &s->layers.at[k];
    void *values = malloc(sweep_layer_size(layer));

    *out = (struct sweep_summary){ .cells = layer->rows * layer->columns,
                                   .least = (double) NAN,
                                   .greatest = (double) NAN };
    if (values == NULL)
        return STATUS_NO_MEMORY;
    const enum status status = sweep_read(s, k, point, values, why);
    if (status == STATUS_OK && layer->codes)
        count_codes(values, out);
    else if (status == STATUS_OK)
        measure(values, out);
    free(values);
    return status;
}
