#include "result_units.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WORDS = 32 };

/* What is in place of a view's own. */
struct told {
    struct record_type type;
    struct record_field *field;
    char (*name)[RESULT_NAME];
    char *at;
    const char *units[WORDS]; /* of the member that has one for each code */
};

static const char *unit_of(const struct record_array *a, size_t i,
                           const struct record_field *f)
{
    const int8_t *code = record_member(a, i, &a->type->fields[0]);

    return f->units && *code >= 0 && f->units[*code] ? f->units[*code]
                                                     : f->unit;
}

const char *result_unit(const struct record_array *a, size_t i,
                        const struct record_field *f)
{
    return unit_name(NULL, unit_of(a, i, f));
}

/* Whether alpha has its tangent beside it. */
static bool has_tangent(const struct record_type *type,
                        const struct record_field *f)
{
    bool has = false;

    for (size_t i = 0; i < type->count; i++)
        has = has || (strncmp(type->fields[i].name, "tan_", 4) == 0 &&
                      strcmp(type->fields[i].name + 4, f->name) == 0);
    return has;
}

const struct unit *result_told_unit(const struct unit_system *u,
                                    const struct record_type *type,
                                    const struct record_field *f,
                                    const char *own)
{
    const struct unit *unit = unit_find(own);

    return unit && unit->kind == UNIT_ANGLE && u->angle == ANGLE_TAN &&
                   has_tangent(type, f)
               ? NULL
               : unit;
}

/* psi is at the beginning, or behind "ln_". */
void result_told_name(const struct unit_system *u,
                      const struct record_type *type,
                      const struct record_field *f, char name[RESULT_NAME])
{
    const struct unit *unit = result_told_unit(u, type, f, f->unit);
    const size_t at = strncmp(f->name, "ln_", 3) == 0 ? 3 : 0;
    const bool angle = unit && unit->kind == UNIT_ANGLE;

    snprintf(name, RESULT_NAME, "%s%s",
             angle && u->angle == ANGLE_TAN ? "tan_" : "", f->name);
    if (unit && u->si && !angle && unit->kind >= UNIT_STATE &&
        strncmp(name + at, "psi", 3) == 0)
        memcpy(name + at, "phi", 3);
}

static const char *const *tell_units(const struct unit_system *u,
                                     struct told *t,
                                     const struct record_type *own,
                                     const char *const *units)
{
    for (size_t k = 0; own->fields[0].codes[k] && k < WORDS; k++)
        t->units[k] = unit_name(u, units[k]);
    return t->units;
}

static void tell_type(const struct unit_system *u, struct told *t,
                      const struct record_type *own)
{
    t->type = *own;
    t->type.fields = t->field;
    for (size_t i = 0; i < own->count; i++) {
        t->field[i] = own->fields[i];
        result_told_name(u, own, &own->fields[i], t->name[i]);
        t->field[i].name = t->name[i];
        if (result_told_unit(u, own, &own->fields[i], own->fields[i].unit))
            t->field[i].unit = unit_name(u, own->fields[i].unit);
        if (own->fields[i].units)
            t->field[i].units = tell_units(u, t, own, own->fields[i].units);
    }
}

/* As inputs are read. */
static double read_back(const struct unit_system *u, const struct unit *unit,
                        double told)
{
    const double x = told / unit_scale(u, unit);

    return unit->kind == UNIT_STATE && u->psi_is_log ? log(x) : x;
}

double result_input(const struct unit_system *u, const struct unit *unit,
                    double x)
{
    const double told = unit_value(u, unit, x);
    char text[32];

    if (!u->si || unit == NULL ||
        !(unit->kind == UNIT_FACTOR || unit->kind == UNIT_STATE))
        return told;
    for (int digits = 1; digits <= DBL_DIG; digits++) {
        snprintf(text, sizeof text, "%.*g", digits, told);
        const double typed = strtod(text, NULL);
        if (read_back(u, unit, typed) == x)
            return typed;
    }
    return told;
}

static void tell_member(const struct unit_system *u, const struct unit *unit,
                        const struct record_field *f, void *member)
{
    double *real = member;
    struct quantity *q = member;

    if (unit && f->kind == RECORD_REAL)
        *real = result_input(u, unit, *real);
    if (unit && f->kind == RECORD_QUANTITY)
        *q = unit_quantity(u, unit, *q);
}

static void tell_records(const struct unit_system *u, char *to,
                         const struct record_array *own)
{
    const struct record_type *type = own->type;

    if (own->count > 0)
        memcpy(to, own->at, own->count * type->size);
    for (size_t i = 0; i < own->count; i++)
        for (size_t k = 0; k < type->count; k++) {
            const struct record_field *f = &type->fields[k];
            tell_member(u, result_told_unit(u, type, f, unit_of(own, i, f)), f,
                        to + i * type->size + f->offset);
        }
}

enum status result_tell(const struct unit_system *u, struct result_view *v)
{
    const struct record_array own = v->records;
    const size_t fields = own.type->count;
    const size_t records = own.count * own.type->size;
    const size_t before =
        sizeof(struct told) + fields * sizeof(struct record_field);
    if (unit_system_is_own(u))
        return STATUS_OK;
    char *block = malloc(before + records + fields * RESULT_NAME);

    if (block == NULL) {
        result_close(v);
        return STATUS_NO_MEMORY;
    }
    struct told *t = (struct told *) (void *) block;
    t->field = (struct record_field *) (void *) (block + sizeof *t);
    t->at = block + before;
    t->name = (char(*)[RESULT_NAME])(void *) (t->at + records);
    tell_type(u, t, own.type);
    tell_records(u, t->at, &own);
    free(v->owned);
    v->owned = block;
    v->records = (struct record_array){ &t->type, t->at, own.count };
    return STATUS_OK;
}
