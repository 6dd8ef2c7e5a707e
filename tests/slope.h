/* slope.h -- the study of a law at a slope, and rows of basin.csv. */
#pragma once

#include <math.h>
#include <string.h>

#include "check.h"
#include "csv.h"
#include "study.h"

/* Must not move. */
struct slope {
    struct scene scene;
    struct study study;
};

/* Of a law, form (NULL: asinh) and slope, with more settings, as of --set, and
 * a NULL. */
static inline void slope_scene(struct scene *s, const char *law,
                               const char *form, const char *alpha,
                               const char *const more[])
{
    enum { MOST = 10 };
    char text[MOST][160], *set[MOST];
    size_t sets = 3;
    struct fault why;

    snprintf(text[0], sizeof text[0], "law.preset=%s", law);
    snprintf(text[1], sizeof text[1], "law.friction=%s", form ? form : "asinh");
    snprintf(text[2], sizeof text[2], "slope.alpha=%s", alpha);
    for (size_t i = 0; more[i]; i++)
        snprintf(text[sets++], sizeof text[0], "%s", more[i]);
    for (size_t i = 0; i < sets; i++)
        set[i] = text[i];
    const enum status status = scene_read(s, NULL, set, sets, &why);
    CHECK(status == STATUS_OK, "%s", why.text);
}

static inline void slope_make(struct slope *s, const char *law,
                              const char *form, const char *alpha,
                              const char *const more[])
{
    struct fault why;

    slope_scene(&s->scene, law, form, alpha, more);
    const enum status status = study_run(&s->study, &s->scene, NULL, &why);
    CHECK(status == STATUS_OK, "%s", why.text);
}

static inline void slope_free(struct slope *s)
{
    study_free(&s->study);
    scene_free(&s->scene);
}

/* A state in the chart. */
static inline struct vec2 slope_point(const struct slope *s, double v,
                                      double psi)
{
    return (struct vec2){ log(v), s->study.slider.plane.system.axis[1].is_log
                                      ? log(psi)
                                      : psi };
}

/* ---- basin.csv ----------------------------------------------------------- */

/* The table's word as a fate. */
static inline int row_fate(const struct csv *c)
{
    return strcmp(csv_text(c, "label"), "creep") == 0 ? FATE_CREEP
                                                      : FATE_SLIDING;
}

/* How far from the boundary, relative; infinite for those just anywhere. */
static inline double row_distance(const struct csv *c)
{
    return fabs(csv_number(c, "rel_dist", HUGE_VAL));
}

static inline struct vec2 row_point(const struct slope *s, const struct csv *c)
{
    return slope_point(s, csv_number(c, "v0", 0), csv_number(c, "psi0", 0));
}

/* Each row at least `nearest` from the boundary, with its slope; the number of
 * rows. */
static inline int each_basin_row(double nearest, const char *const more[],
                                 void (*check)(struct slope *s,
                                               const struct csv *c))
{
    struct slope s;
    struct csv c;
    char alpha[64] = "";
    int rows = 0;

    csv_open(&c, "basin.csv");
    while (csv_next(&c)) {
        if (strcmp(alpha, csv_text(&c, "alpha")) != 0) {
            if (alpha[0])
                slope_free(&s);
            snprintf(alpha, sizeof alpha, "%s", csv_text(&c, "alpha"));
            slope_make(&s, csv_text(&c, "law"), csv_text(&c, "form"), alpha,
                       more);
        }
        if (row_distance(&c) < 0.9 * nearest)
            continue;
        check(&s, &c);
        rows++;
    }
    slope_free(&s);
    return rows;
}
