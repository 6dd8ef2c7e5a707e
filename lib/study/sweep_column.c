#include "sweep_column.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- which ----------------------------------------------------------------
 */

static enum status add(struct sweep_columns *c, const char *prefix,
                       const struct record_field *f, size_t base)
{
    if (c->count == c->room) {
        const size_t room = c->room ? 2 * c->room : 64;
        struct sweep_column *at = realloc(c->at, room * sizeof *at);
        if (at == NULL)
            return STATUS_NO_MEMORY;
        c->at = at;
        c->room = room;
    }
    struct sweep_column *column = &c->at[c->count++];
    *column = (struct sweep_column){ .unit = f->unit,
                                     .codes = f->codes,
                                     .offset = base + f->offset };
    snprintf(column->name, sizeof column->name, "%s%s", prefix, f->name);
    snprintf(column->text, sizeof column->text, "%s", f->text);
    return STATUS_OK;
}

static enum status add_record(struct sweep_columns *c, const char *prefix,
                              const struct record_type *type, size_t base)
{
    enum status status = STATUS_OK;

    for (size_t i = 0; i < type->count && status == STATUS_OK; i++)
        if (type->fields[i].kind == RECORD_QUANTITY ||
            type->fields[i].kind == RECORD_CODE)
            status = add(c, prefix, &type->fields[i], base);
    return status;
}

#define AT(member) offsetof(struct study, member)

static enum status add_knees(struct sweep_columns *c)
{
    const enum status status =
        add_record(c, "knee_upper_", &record_knee, AT(critical.knee_upper));

    return status ? status
                  : add_record(c, "knee_lower_", &record_knee,
                               AT(critical.knee_lower));
}

static enum status add_chi(struct sweep_columns *c)
{
    static const struct record_field chi[] = {
        { .name = "v_minus",
          .unit = "1",
          .text = "root of chi(v) = 1 below v_sp, (34)",
          .offset = AT(estimates.chi_v_minus),
          .kind = RECORD_QUANTITY },
        { .name = "v_plus",
          .unit = "1",
          .text = "root of chi(v) = 1 above v_sp, (34)",
          .offset = AT(estimates.chi_v_plus),
          .kind = RECORD_QUANTITY },
    };
    const enum status status = add(c, "estimates_chi_", &chi[0], 0);

    return status ? status : add(c, "estimates_chi_", &chi[1], 0);
}

static enum status add_xi(struct sweep_columns *c, size_t i, double xi)
{
    const size_t first = c->count;
    char prefix[48];

    snprintf(prefix, sizeof prefix, "estimates_xi_%zu_", i);
    const enum status status = add_record(
        c, prefix, &record_xi, AT(estimates.xi) + i * sizeof(struct xi_number));
    for (size_t k = first; k < c->count; k++) {
        char *text = c->at[k].text;
        const size_t end = strlen(text);
        snprintf(text + end, sizeof c->at[k].text - end, " at xi = %.15g", xi);
    }
    return status;
}

static enum status add_estimates(struct sweep_columns *c,
                                 const struct scene *scene)
{
    enum status status =
        add_record(c, "estimates_", &record_estimates, AT(estimates));

    if (status == STATUS_OK)
        status = add_chi(c);
    for (size_t i = 0; i < scene->xi_count && status == STATUS_OK; i++)
        status = add_xi(c, i, scene->xi[i]);
    return status;
}

static enum status add_sensitivities(struct sweep_columns *c)
{
    const enum status status =
        add_record(c, "sensitivities_v_plus_", &record_sensitivity,
                   AT(sensitivities.v_plus));

    return status ? status
                  : add_record(c, "sensitivities_v_minus_", &record_sensitivity,
                               AT(sensitivities.v_minus));
}

/* The last ones, so that those which no point has can be left off. */
static enum status add_equilibria(struct sweep_columns *c)
{
    enum status status = STATUS_OK;

    for (size_t i = 0; i < EQUILIBRIA_MAX && status == STATUS_OK; i++) {
        char prefix[48];
        snprintf(prefix, sizeof prefix, "equilibria_%zu_", i);
        status = add_record(c, prefix, &record_steady,
                            AT(steady) + i * sizeof(struct steady_number));
    }
    return status;
}

enum status sweep_columns_init(struct sweep_columns *c,
                               const struct scene *scene)
{
    const unsigned stages = plan_stages(scene->products);

    *c = (struct sweep_columns){
        .conditioning = plan_has(stages, STAGE_SENSITIVITIES),
    };
    enum status status =
        add_record(c, "saddle_", &record_saddle, AT(saddle_numbers));
    if (status == STATUS_OK && plan_has(stages, STAGE_CRITICAL))
        status = add_record(c, "", &record_critical, AT(critical));
    if (status == STATUS_OK && plan_has(stages, STAGE_KNEES))
        status = add_knees(c);
    if (status == STATUS_OK && plan_has(stages, STAGE_FOLDS))
        status = add_record(c, "folds_", &record_folds, AT(folds));
    if (status == STATUS_OK && plan_has(stages, STAGE_ESTIMATES))
        status = add_estimates(c, scene);
    if (status == STATUS_OK && plan_has(stages, STAGE_SENSITIVITIES))
        status = add_sensitivities(c);
    if (status == STATUS_OK)
        status = add_equilibria(c);
    if (status != STATUS_OK)
        sweep_columns_free(c);
    return status;
}

void sweep_columns_free(struct sweep_columns *c)
{
    free(c->at);
    *c = (struct sweep_columns){ .at = NULL };
}

/* ---- what is there --------------------------------------------------------
 */

void sweep_columns_complete(struct study *s)
{
    static const char fewer[] = "there are fewer steady states";
    const struct quantity none = quantity_none(fewer);

    for (size_t i = s->equilibria; i < EQUILIBRIA_MAX; i++)
        s->steady[i] =
            (struct steady_number){ -1, none, none, none, none, none };
}

struct quantity sweep_column_quantity(const struct sweep_column *c,
                                      const struct study *s)
{
    struct quantity q;

    memcpy(&q, (const char *) s + c->offset, sizeof q);
    return q;
}

int8_t sweep_column_code(const struct sweep_column *c, const struct study *s)
{
    return *((const int8_t *) s + c->offset);
}
