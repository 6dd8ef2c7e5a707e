#include "slope_row.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "number.h"
#include "scene_slope.h"
#include "slope_law.h"

const char *const slope_row_columns[] = {
    "law",     "form", "theta", "psi_ss", "timescale", "kinetics",
    "mu_star", "a",    "b",     "L",      "V_star",    "g",
    "eps2",    "c",    "R",     "V_c",    "alpha",     NULL
};

/* The number in a cell; STATUS_BAD_SCENE blames the column `name`. */
static enum status slope_row_number(const struct table *t,
                                    const struct table_cell *cell,
                                    const char *name, double *value,
                                    struct fault *why)
{
    const bool minus = strcmp(cell->text, "-inf") == 0;

    if (!number_read(minus ? "inf" : cell->text, value))
        return place_blame(table_place(t, cell), why,
                           "%s: '%s' is no number, expected a decimal number",
                           name, text_shown(cell->text).text);
    if (minus)
        *value = -*value;
    return STATUS_OK;
}

/* *value keeps what it has where the row says nothing. */
static enum status read_number(const struct table *t, size_t row,
                               const char *name, double *value,
                               struct fault *why)
{
    const struct table_cell *cell = table_find(t, row, name);

    return cell ? slope_row_number(t, cell, name, value, why) : STATUS_OK;
}

static enum status read_word(const struct table *t, size_t row,
                             const char *name, const char *const *words,
                             unsigned *code, struct fault *why)
{
    const struct table_cell *cell = table_find(t, row, name);
    const int i = cell ? text_index(cell->text, words) : -1;
    char list[128];

    if (i >= 0) {
        *code = (unsigned) i;
        return STATUS_OK;
    }
    text_list(words, list, sizeof list);
    if (cell == NULL)
        return place_blame(table_place(t, table_at(t, row, 0)), why,
                           "%s is missing, expected %s", name, list);
    return place_blame(table_place(t, cell), why, "%s is '%s', expected %s",
                       name, text_shown(cell->text).text, list);
}

/* ---- the law ------------------------------------------------------------- */

static enum status read_composed(const struct table *t, size_t row,
                                 struct slope_row *s, struct fault *why)
{
    unsigned theta = 0, psi_ss = 0, timescale = 0, kinetics = 0;
    enum status status = read_word(t, row, "theta", theta_names, &theta, why);

    if (status == STATUS_OK)
        status = read_word(t, row, "psi_ss", psi_ss_names, &psi_ss, why);
    if (status == STATUS_OK)
        status =
            read_word(t, row, "timescale", timescale_names, &timescale, why);
    if (status == STATUS_OK)
        status = read_word(t, row, "kinetics", kinetics_names, &kinetics, why);
    s->laws = 1;
    s->law[0] = (struct law){ .preset = "composed",
                              .equation = "composed",
                              .theta = (enum theta) theta,
                              .psi_ss = (enum psi_ss) psi_ss,
                              .timescale = (enum timescale) timescale,
                              .kinetics = (enum kinetics) kinetics };
    return status;
}

/* The preset named in text[0 .. size-1]; NULL if there is none. */
static const struct law *find_preset(const char *text, size_t size)
{
    const struct law *law;

    for (size_t i = 0; (law = law_preset_at(i)) != NULL; i++)
        if (strlen(law->preset) == size &&
            strncmp(law->preset, text, size) == 0)
            return law;
    return NULL;
}

static enum status read_presets(const struct table *t,
                                const struct table_cell *cell,
                                struct slope_row *s, struct fault *why)
{
    const char *at = cell->text;

    for (bool more = true; more; s->laws++) {
        const size_t size = strcspn(at, "|");
        const struct law *law = find_preset(at, size);
        if (law == NULL || s->laws == SLOPE_LAWS_MAX)
            return place_blame(table_place(t, cell), why,
                               "law: no law '%s' (see slipway laws)",
                               text_shown(at).text);
        s->law[s->laws] = *law;
        more = at[size] == '|';
        at += size + more;
    }
    return STATUS_OK;
}

static enum status read_formulas(const struct table *t,
                                 const struct table_cell *cell,
                                 enum friction_form form, struct slope_row *s,
                                 struct fault *why)
{
    struct fault reason = { "" };

    s->typed = calloc(1, sizeof *s->typed);
    if (s->typed == NULL)
        return STATUS_NO_MEMORY;
    const enum status status =
        slope_law_read(cell->text, form, s->typed, &reason);
    if (status == STATUS_BAD_SCENE)
        return place_blame(table_place(t, cell), why, "law: %s", reason.text);
    if (status != STATUS_OK)
        return status;
    s->laws = 1;
    s->law[0] = law_of_typed(s->typed);
    return STATUS_OK;
}

static enum status read_law(const struct table *t, size_t row,
                            struct slope_row *s, struct fault *why)
{
    const struct table_cell *cell = table_find(t, row, "law");
    const bool composed = cell ? strcmp(cell->text, "composed") == 0
                               : table_find(t, row, "theta") != NULL;
    unsigned form = FRICTION_ASINH;
    enum status status = STATUS_OK;

    if (!cell && !composed)
        return place_blame(table_place(t, table_at(t, row, 0)), why,
                           "no law, expected one in a column law");
    if (table_find(t, row, "form"))
        status = read_word(t, row, "form", friction_form_names, &form, why);
    if (status == STATUS_OK)
        status = composed ? read_composed(t, row, s, why)
                 : slope_law_is(cell->text)
                     ? read_formulas(t, cell, (enum friction_form) form, s, why)
                     : read_presets(t, cell, s, why);
    for (size_t i = 0; i < s->laws; i++)
        s->law[i].form = (enum friction_form) form;
    return status;
}

/* ---- the numbers --------------------------------------------------------- */

static enum status read_material(const struct table *t, size_t row,
                                 struct slope_row *s, struct fault *why)
{
    struct material *m = &s->material;
    enum status status = STATUS_OK;
    double eps2 = NAN;

    *m = material_bristol_board();
    for (int i = 0; i < MATERIAL_KEYS && status == STATUS_OK; i++) {
        const enum material_key key = (enum material_key) i;
        status = read_number(t, row, material_key_name(key),
                             material_member(m, key), why);
    }
    if (status == STATUS_OK)
        status = read_number(t, row, "eps2", &eps2, why);
    if (!isnan(eps2) && !table_find(t, row, "g"))
        m->g = m->V_star * m->V_star / (eps2 * m->L);
    return status;
}

static enum status check_laws(const struct table *t, size_t row,
                              const struct slope_row *s, struct fault *why)
{
    const struct table_cell *law = table_find(t, row, "law");
    const struct place at = table_place(t, law ? law : table_at(t, row, 0));
    struct fault reason;

    for (size_t i = 0; i < s->laws; i++) {
        if (law_uses(&s->law[i], MATERIAL_V_C) && !table_find(t, row, "V_c"))
            return place_blame(at, why, "law: %s needs V_c", s->law[i].preset);
        if (law_check(&s->law[i], &s->material, &reason) != STATUS_OK)
            return place_blame(at, why, "law: %s", reason.text);
    }
    return STATUS_OK;
}

static enum status read_slope(const struct table *t, size_t row,
                              struct slope_row *s, struct fault *why)
{
    const struct table_cell *cell = table_find(t, row, "alpha");
    const enum status status = read_number(t, row, "alpha", &s->alpha, why);

    if (cell && status == STATUS_OK && !(s->alpha > 0.0 && s->alpha < M_PI_2))
        return place_blame(table_place(t, cell), why,
                           "alpha: %s is not allowed, expected an angle in "
                           "rad, 0 < alpha < pi/2",
                           text_shown(cell->text).text);
    return status;
}

enum status slope_row_read(const struct table *t, size_t row,
                           struct slope_row *s, struct fault *why)
{
    *s = (struct slope_row){ .alpha = (double) NAN };
    enum status status = read_law(t, row, s, why);
    if (status == STATUS_OK)
        status = read_material(t, row, s, why);
    for (int i = 0; s->typed && i < s->typed->owns; i++)
        s->material.own[i] = s->typed->own[i].value;
    if (status == STATUS_OK)
        status = check_laws(t, row, s, why);
    if (status == STATUS_OK)
        status = read_slope(t, row, s, why);
    return status;
}

void slope_row_free(struct slope_row *s)
{
    free(s->typed);
    s->typed = NULL;
}

/* ---- to and from scenes -------------------------------------------------- */

struct scene slope_row_scene(const struct slope_row *s, size_t k, double rtol,
                             unsigned products)
{
    const bool is_log = law_psi_is_log(&s->law[k]);

    return (struct scene){
        .law = s->law[k],
        .material = s->material,
        .alpha = s->alpha,
        .tan_alpha = tanl((long double) s->alpha),
        .window = { { 1e-6, 1e6 },
                    { is_log ? -7.0 : 1e-3, is_log ? 5.0 : 1e2 },
                    AXES_LOG },
        .products = products,
        .seed = 1,
        .rtol = rtol,
    };
}

struct slope_row slope_row_of(const struct scene *scene)
{
    const bool has_slope = scene_has_slope(scene);

    return (struct slope_row){ .law = { scene->law },
                               .laws = 1,
                               .material = scene->material,
                               .alpha =
                                   has_slope ? scene->alpha : (double) NAN };
}
