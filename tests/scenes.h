/* scenes.h -- scenes of texts and overrides, and whether two are the same.
 * Give the test the dependency own_folder and its set-up. */
#pragma once

#include <string.h>

#include "check.h"
#include "law_typed.h"
#include "own_folder.h"
#include "scene.h"

/* Reads `text` as the file s.yaml (NULL: no file) with `sets`, one "key=value"
 * a line. */
static inline enum status scene_of(struct scene *s, const char *text,
                                   const char *sets, struct fault *why)
{
    char lines[1024], *rest = lines, *set[32], *line;
    const char *path = text ? own_path("s.yaml") : NULL;
    size_t count = 0;

    if (text)
        file_write(path, text, strlen(text));
    assert_true(strlen(sets) < sizeof lines);
    strcpy(lines, sets);
    while ((line = strsep(&rest, "\n")) != NULL && count < 32)
        if (*line)
            set[count++] = line;
    return scene_read(s, path, set, count, why);
}

/* The same, which must succeed. */
static inline struct scene scene_made(const char *text, const char *sets)
{
    struct scene s;
    struct fault why;

    CHECK(scene_of(&s, text, sets, &why) == STATUS_OK, "%s", why.text);
    return s;
}

static inline bool same_text(const char *a, const char *b)
{
    return a == b || (a && b && strcmp(a, b) == 0);
}

static inline bool same_law(const struct law *a, const struct law *b)
{
    return same_text(a->preset, b->preset) &&
           same_text(a->equation, b->equation) && a->form == b->form &&
           a->theta == b->theta && a->psi_ss == b->psi_ss &&
           a->timescale == b->timescale && a->kinetics == b->kinetics;
}

static inline bool same_experiment(const struct scene_rabinowicz *a,
                                   const struct scene_rabinowicz *b)
{
    return a->block_mass == b->block_mass && a->ball_mass == b->ball_mass &&
           a->restitution == b->restitution && a->slopes == b->slopes &&
           (a->slopes == 0 || memcmp(a->tan_alpha, b->tan_alpha,
                                     a->slopes * sizeof *a->tan_alpha) == 0) &&
           same_text(a->data, b->data) && a->smoothing == b->smoothing;
}

static inline bool same_spring(const struct scene_spring *a,
                               const struct scene_spring *b)
{
    return memcmp(a, b, sizeof *a) == 0; /* NaN where a system has none */
}

static inline bool same_lists(const struct scene *a, const struct scene *b)
{
    return a->xi_count == b->xi_count &&
           memcmp(a->xi, b->xi, a->xi_count * sizeof *a->xi) == 0 &&
           a->chi_alphas == b->chi_alphas &&
           memcmp(a->chi_alpha, b->chi_alpha,
                  a->chi_alphas * sizeof *a->chi_alpha) == 0 &&
           a->starts == b->starts &&
           (a->starts == 0 ||
            memcmp(a->start, b->start, a->starts * sizeof *a->start) == 0);
}

static inline bool same_axis(const struct scene_axis *a,
                             const struct scene_axis *b)
{
    return same_text(a->key, b->key) && a->from == b->from && a->to == b->to &&
           a->points == b->points && a->scale == b->scale &&
           a->count == b->count &&
           (a->count == 0 ||
            memcmp(a->value, b->value, a->count * sizeof *a->value) == 0);
}

static inline bool same_sweep(const struct scene_sweep *a,
                              const struct scene_sweep *b)
{
    return a->axes == b->axes && a->refine == b->refine && a->show == b->show &&
           a->y_scale == b->y_scale && a->y_range[0] == b->y_range[0] &&
           a->y_range[1] == b->y_range[1] &&
           same_axis(&a->axis[0], &b->axis[0]) &&
           same_axis(&a->axis[1], &b->axis[1]);
}

/* All but what it was read from: text and overrides. */
static inline bool same_formulas(const struct law_typed *a,
                                 const struct law_typed *b)
{
    return a && b ? memcmp(a->text, b->text, sizeof a->text) == 0 &&
                        a->real == b->real && a->owns == b->owns &&
                        memcmp(a->own, b->own, sizeof a->own) == 0
                  : a == b;
}

static inline bool same_paper(const struct scene_figure *a,
                              const struct scene_figure *b)
{
    return a->width == b->width && a->height == b->height &&
           a->type == b->type && a->dpi == b->dpi && a->title == b->title &&
           a->legend == b->legend && a->colours == b->colours &&
           same_text(a->font, b->font);
}

static inline bool same_ensemble(const struct scene_ensemble *a,
                                 const struct scene_ensemble *b)
{
    bool same = a->parameters == b->parameters && a->draws == b->draws &&
                a->method == b->method && a->seed == b->seed &&
                a->numbers == b->numbers && a->pushes == b->pushes &&
                same_text(a->samples, b->samples) &&
                same_text(a->covariance, b->covariance);

    for (size_t i = 0; i < a->parameters && same; i++)
        same = same_text(a->parameter[i].key, b->parameter[i].key) &&
               a->parameter[i].law == b->parameter[i].law &&
               a->parameter[i].of[0] == b->parameter[i].of[0] &&
               a->parameter[i].of[1] == b->parameter[i].of[1];
    for (size_t i = 0; i < a->numbers && same; i++)
        same = same_text(a->number[i].name, b->number[i].name);
    for (size_t i = 0; i < a->pushes && same; i++)
        same = a->push[i].from_creep == b->push[i].from_creep &&
               a->push[i].v == b->push[i].v && a->push[i].psi == b->push[i].psi;
    return same;
}

static inline bool scene_same(const struct scene *a, const struct scene *b)
{
    return same_text(a->title, b->title) && same_law(&a->law, &b->law) &&
           same_formulas(a->typed, b->typed) &&
           memcmp(&a->material, &b->material, sizeof a->material) == 0 &&
           a->alpha == b->alpha && a->tan_alpha == b->tan_alpha &&
           memcmp(a->window.v, b->window.v, sizeof a->window.v) == 0 &&
           memcmp(a->window.psi, b->window.psi, sizeof a->window.psi) == 0 &&
           a->window.axes == b->window.axes && a->units == b->units &&
           a->products == b->products && same_lists(a, b) &&
           a->spread == b->spread && a->seed == b->seed &&
           a->until_time == b->until_time && a->until_slip == b->until_slip &&
           a->linear_slip == b->linear_slip && a->log_time == b->log_time &&
           a->cells[0] == b->cells[0] && a->cells[1] == b->cells[1] &&
           a->audit == b->audit && a->exact == b->exact &&
           a->cell_rtol == b->cell_rtol &&
           same_experiment(&a->rabinowicz, &b->rabinowicz) &&
           same_spring(&a->spring_block, &b->spring_block) &&
           a->fold_c[0] == b->fold_c[0] && a->fold_c[1] == b->fold_c[1] &&
           same_sweep(&a->sweep, &b->sweep) &&
           same_ensemble(&a->ensemble, &b->ensemble) && a->rtol == b->rtol &&
           a->proved == b->proved && same_paper(&a->paper, &b->paper) &&
           same_text(a->hdf5, b->hdf5) && same_text(a->figure, b->figure);
}
