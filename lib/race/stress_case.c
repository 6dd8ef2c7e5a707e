/* Each combination of a family's laws, forms, values, slopes and starts is
 * written as settings and read back by scene_read: what the catalogue runs is
 * what a user can run. */
#include "stress_case.h"

#include <fnmatch.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "number.h"
#include "room.h"
#include "stress_family.h"
#include "stress_tolerance.h"

const char *const stress_kind_names[] = { "slope", "start",  "window",
                                          "field", "system", NULL };

bool stress_matches(const char *name, const char *pattern)
{
    char wide[256];

    if (pattern == NULL || strstr(name, pattern) != NULL)
        return true;
    const int n = snprintf(wide, sizeof wide, "*%s*", pattern);
    return n > 0 && n < (int) sizeof wide && fnmatch(wide, name, 0) == 0;
}

/* ---- the list ------------------------------------------------------------ */

static struct stress_case *room_for_one(struct stress_list *list)
{
    return ROOM_FOR(list->at, list->room, list->count + 1)
               ? NULL
               : &list->at[list->count];
}

void stress_list_free(struct stress_list *list)
{
    for (size_t i = 0; i < list->count; i++)
        scene_free(&list->at[i].scene);
    free(list->at);
    *list = (struct stress_list){ .at = NULL };
}

static enum stress_kind kind_of(const struct scene *scene)
{
    const unsigned fields = 1u << PRODUCT_SLIP | 1u << PRODUCT_TIME |
                            1u << PRODUCT_FRICTION | 1u << PRODUCT_PEAK;

    return scene->system                            ? STRESS_SYSTEM
           : scene->starts                          ? STRESS_START
           : scene->products & fields               ? STRESS_FIELD
           : scene->products >> PRODUCT_BASINS & 1u ? STRESS_WINDOW
                                                    : STRESS_SLOPE;
}

enum status stress_list_add(struct stress_list *list, const char *name,
                            const char *settings, struct scene *scene)
{
    struct stress_case *c = room_for_one(list);

    if (c == NULL)
        return STATUS_NO_MEMORY;
    *c = (struct stress_case){ .kind = kind_of(scene), .scene = *scene };
    snprintf(c->name, sizeof c->name, "%s", name);
    snprintf(c->settings, sizeof c->settings, "%s", settings);
    *scene = (struct scene){ .title = NULL };
    list->count++;
    return STATUS_OK;
}

/* ---- one case as settings ------------------------------------------------ */

enum { SETTINGS_MAX = 20, SETTING = 96, LAW_NAME = 64 };

struct settings {
    char text[SETTINGS_MAX][SETTING];
    size_t count;
};

#define SET(s, ...) snprintf((s)->text[(s)->count++], SETTING, __VA_ARGS__)

/* One combination. */
struct combination {
    const struct stress_family *f;
    struct law law;
    size_t value, slope, start; /* start: or place */
    struct material m;
    double alpha;
    struct stress_centre centre; /* of a window of fields */
};

static void set_law(struct settings *s, const struct law *law)
{
    if (strcmp(law->preset, "composed") == 0) {
        SET(s, "law.theta=%s", theta_names[law->theta]);
        SET(s, "law.psi_ss=%s", psi_ss_names[law->psi_ss]);
        SET(s, "law.timescale=%s", timescale_names[law->timescale]);
        SET(s, "law.kinetics=%s", kinetics_names[law->kinetics]);
    } else {
        SET(s, "law.preset=%s", law->preset);
    }
    SET(s, "law.friction=%s", friction_form_names[law->form]);
}

/* What differs from Table 2. */
static void set_material(struct settings *s, const struct combination *k)
{
    struct material usual = material_bristol_board(), m = k->m;

    for (int key = 0; key < MATERIAL_KEYS; key++) {
        const enum material_key which = (enum material_key) key;
        const double value = *material_member(&m, which);
        const bool needed = which == MATERIAL_V_C; /* Table 2 has none */
        if (!law_uses(&k->law, which) ||
            (value == *material_member(&usual, which) && !needed))
            continue;
        SET(s, "%s%s=%s", which == MATERIAL_G ? "" : "material.",
            which == MATERIAL_G ? "gravity" : material_key_name(which),
            number_shortest(value).text);
    }
}

static void set_start(struct settings *s, const struct combination *k)
{
    const struct scene_start *at = &k->f->start[k->start];

    SET(s, "trajectories.starts=[{v: %s, psi: %s}]",
        number_shortest(at->v).text,
        number_shortest(law_psi_is_log(&k->law) ? log(at->psi) : at->psi).text);
}

/* The whole plane, with room for a few hundred labels. */
static void set_window(struct settings *s, const struct combination *k)
{
    SET(s, "window.v=[1e-300, 1e300]");
    SET(s, law_psi_is_log(&k->law) ? "window.psi=[-690, 690]"
                                   : "window.psi=[1e-300, 1e300]");
    SET(s, "window.axes=log");
    SET(s, "basins.cells=[%d, %d]", STRESS_CELLS, STRESS_CELLS);
    SET(s, "basins.audit=%d", STRESS_AUDIT);
}

/* The pair of a window of two cells, each as far aside of the centre. */
static void set_pair(struct settings *s, const char *key, double centre,
                     double aside, bool is_log)
{
    const double lo =
        is_log ? centre * exp(-2.0 * aside) : centre - 2.0 * aside;
    const double hi = is_log ? centre * exp(2.0 * aside) : centre + 2.0 * aside;

    SET(s, "%s=[%s, %s]", key, number_shortest(lo).text,
        number_shortest(hi).text);
}

static void set_field(struct settings *s, const struct combination *k)
{
    const double aside = k->f->place[k->start].aside;

    set_pair(s, "window.v", k->centre.v, aside, true);
    set_pair(s, "window.psi", k->centre.psi, aside, !law_psi_is_log(&k->law));
    SET(s, "window.axes=log");
    SET(s, "products=[slip, time, friction, peak]");
    SET(s, "basins.cells=[2, 2]");
    SET(s, "basins.audit=0");
    SET(s, "basins.rtol=%g", STRESS_FIELD_RTOL);
}

static void combine(struct settings *s, const struct combination *k)
{
    static const double rtol[STRESS_KINDS] = {
        [STRESS_SLOPE] = STRESS_RTOL,
        [STRESS_START] = STRESS_STATE_RTOL,
        [STRESS_WINDOW] = STRESS_STATE_RTOL,
        [STRESS_FIELD] = STRESS_PLACE_RTOL,
    };

    s->count = 0;
    set_law(s, &k->law);
    set_material(s, k);
    SET(s, "slope.alpha=%s", number_shortest(k->alpha).text);
    SET(s, "accuracy.rtol=%g", rtol[k->f->kind]);
    if (k->f->kind == STRESS_START)
        set_start(s, k);
    else if (k->f->kind == STRESS_WINDOW)
        set_window(s, k);
    else if (k->f->kind == STRESS_FIELD)
        set_field(s, k);
}

/* A preset's name, or THETA.PSI_SS.TIMESCALE.KINETICS. */
static void name_law(const struct law *law, char name[LAW_NAME])
{
    if (strcmp(law->preset, "composed") == 0)
        snprintf(name, LAW_NAME, "%s.%s.%s.%s", theta_names[law->theta],
                 psi_ss_names[law->psi_ss], timescale_names[law->timescale],
                 kinetics_names[law->kinetics]);
    else
        snprintf(name, LAW_NAME, "%s", law->preset);
}

/* FAMILY/LAW/FORM/VALUE/SLOPE/START as far as a family has several. */
static void name_case(const struct combination *k, char *name, size_t size)
{
    const struct stress_family *f = k->f;
    char law[LAW_NAME];

    name_law(&k->law, law);
    size_t n = (size_t) snprintf(name, size, "%s/%s/%s", f->name, law,
                                 friction_form_names[k->law.form]);
    if (f->value.count > 1)
        n += (size_t) snprintf(name + n, size - n, "/%.10g",
                               f->value.at[k->value]);
    if (f->at.count > 1)
        n +=
            (size_t) snprintf(name + n, size - n, "/%.10g", f->at.at[k->slope]);
    if (f->starts > 0)
        snprintf(name + n, size - n, "/%g,%g", f->start[k->start].v,
                 f->start[k->start].psi);
    if (f->places > 0)
        snprintf(name + n, size - n, "/%g,%g", f->place[k->start].along,
                 f->place[k->start].aside);
}

static void join_settings(const struct settings *s, char *text, size_t size)
{
    size_t n = 0;

    text[0] = '\0';
    for (size_t i = 0; i < s->count && n < size; i++)
        n += (size_t) snprintf(text + n, size - n, "%s--set '%s'",
                               i > 0 ? " " : "", s->text[i]);
}

/* ---- the catalogue ------------------------------------------------------- */

struct builder {
    struct stress_list *list;
    const char *pattern;
    bool quick;
    size_t number; /* of cases passed by */
    struct fault *why;
};

/* Of a place that there is. */
static enum status find_centre(struct combination *k)
{
    return k->f->places > 0
               ? stress_place_find(&k->law, &k->m, k->alpha,
                                   k->f->place[k->start].along, &k->centre)
               : STATUS_OK;
}

static enum status add_case(struct builder *b, struct combination *k)
{
    struct stress_case *c = room_for_one(b->list);
    char *override[SETTINGS_MAX];
    struct settings s;

    if (c == NULL)
        return STATUS_NO_MEMORY;
    *c = (struct stress_case){ .kind = k->f->kind };
    name_case(k, c->name, sizeof c->name);
    if ((b->quick && b->number++ % STRESS_QUICK != 0) ||
        !stress_matches(c->name, b->pattern))
        return STATUS_OK;
    enum status status = find_centre(k);
    if (status != STATUS_OK || (k->f->places > 0 && !k->centre.exists))
        return status;
    combine(&s, k);
    for (size_t i = 0; i < s.count; i++)
        override[i] = s.text[i];
    join_settings(&s, c->settings, sizeof c->settings);
    status = scene_read(&c->scene, NULL, override, s.count, b->why);
    b->list->count += status == STATUS_OK;
    return status;
}

/* All values, slopes and starts of one law. */
static enum status add_law(struct builder *b, const struct stress_family *f,
                           const struct law *law)
{
    struct combination k = { .f = f, .law = *law };
    enum status status = STATUS_OK;
    struct fault none;

    for (k.value = 0; k.value < f->value.count; k.value++) {
        const double value = f->value.at[k.value];
        if (!stress_material(law, f->knob, value, &k.m) ||
            law_check(law, &k.m, &none) != STATUS_OK)
            continue;
        for (k.slope = 0; k.slope < f->at.count; k.slope++) {
            if (!stress_alpha(law, &k.m, f->slope, f->at.at[k.slope], &k.alpha))
                continue;
            for (k.start = 0; k.start == 0 || k.start < f->starts + f->places;
                 k.start++) {
                status = add_case(b, &k);
                if (status != STATUS_OK)
                    return status;
            }
        }
    }
    return STATUS_OK;
}

/* Composition number i of the scene words; false past the end. */
static bool composition_at(size_t i, struct law *law)
{
    enum { SCENE_PSI_SS = PSI_SS_LAMBERT, SCENE_KINETICS = KINETICS_COMPOSITE };

    *law = (struct law){ .preset = "composed", .equation = "" };
    law->kinetics = (enum kinetics)(i % SCENE_KINETICS);
    i /= SCENE_KINETICS;
    law->timescale = (enum timescale)(i % TIMESCALES);
    i /= TIMESCALES;
    law->psi_ss = (enum psi_ss)(i % SCENE_PSI_SS);
    i /= SCENE_PSI_SS;
    law->theta = (enum theta)(i % THETAS);
    return i < THETAS;
}

static bool law_at(const struct stress_family *f, size_t i, struct law *law)
{
    if (strcmp(f->laws, "compositions") == 0 || strchr(f->laws, '.'))
        return composition_at(i, law);
    if (law_preset_at(i) == NULL)
        return false;
    *law = *law_preset_at(i);
    return true;
}

/* Whether a word of the family's list is the law's name. */
static bool has_law(const struct stress_family *f, const struct law *law)
{
    const char *p = f->laws;
    char name[LAW_NAME];

    name_law(law, name);
    const size_t size = strlen(name);
    if (strcmp(p, "presets") == 0 || strcmp(p, "compositions") == 0)
        return true;
    for (; *p; p += strspn(p, " ")) {
        const size_t n = strcspn(p, " ");
        if (n == size && strncmp(p, name, n) == 0)
            return true;
        p += n;
    }
    return false;
}

static enum status add_family(struct builder *b, const struct stress_family *f)
{
    enum status status = STATUS_OK;
    struct law law;

    for (size_t i = 0; law_at(f, i, &law); i++) {
        if (!has_law(f, &law))
            continue;
        for (int form = 0; form <= (int) f->last_form; form++) {
            law.form = (enum friction_form) form;
            status = add_law(b, f, &law);
            if (status != STATUS_OK)
                return status;
        }
    }
    return STATUS_OK;
}

enum status stress_list_init(struct stress_list *list, const char *pattern,
                             bool quick, struct fault *why)
{
    struct builder b = { list, pattern, quick, 0, why };
    enum status status = STATUS_OK;

    *list = (struct stress_list){ .at = NULL };
    for (size_t i = 0; stress_family_at(i) && status == STATUS_OK; i++)
        status = add_family(&b, stress_family_at(i));
    if (status != STATUS_OK)
        stress_list_free(list);
    return status;
}
