/* sweeps.h -- sweeps of small scenes, and whether two are the same. */
#pragma once

#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "scene_sweep.h"
#include "sweep.h"

/* A sweep and its scene; must not move. */
struct swept {
    struct scene scene;
    struct sweep s;
};

/* Settings as of --set, and a NULL. */
static inline void scene_set(struct scene *scene, const char *const sets[])
{
    enum { MOST = 12 };
    char text[MOST][640], *set[MOST];
    struct fault why;
    size_t count = 0;

    for (; sets[count]; count++) {
        assert_true(count < MOST);
        snprintf(text[count], sizeof text[count], "%s", sets[count]);
        set[count] = text[count];
    }
    CHECK(scene_read(scene, NULL, set, count, &why) == STATUS_OK, "%s",
          why.text);
}

static inline void sweep_of(struct swept *w, const char *const sets[],
                            const struct sweep_options *o)
{
    struct fault why;

    scene_set(&w->scene, sets);
    CHECK(sweep_run(&w->s, &w->scene, o, NULL, &why) == STATUS_OK, "%s",
          why.text);
}

static inline void swept_free(struct swept *w)
{
    sweep_free(&w->s);
    scene_free(&w->scene);
}

/* To the bit: all layers of a point. */
static inline void layers_are_the_same(const struct sweep *a,
                                       const struct sweep *b, size_t point)
{
    struct fault why;

    assert_int_equal(a->layers.count, b->layers.count);
    for (size_t k = 0; k < a->layers.count; k++) {
        const size_t size = sweep_layer_size(&a->layers.at[k]);
        char *x = malloc(size), *y = malloc(size);
        assert_string_equal(a->layers.at[k].name, b->layers.at[k].name);
        CHECK(sweep_read(a, k, point, x, &why) == STATUS_OK, "%s", why.text);
        CHECK(sweep_read(b, k, point, y, &why) == STATUS_OK, "%s", why.text);
        assert_memory_equal(x, y, size);
        free(x);
        free(y);
    }
}

/* To the bit: columns, reasons, layers, and of rows what belongs to these
 * columns. */
static inline void sweeps_are_the_same(const struct sweep *a,
                                       const struct sweep *b)
{
    const size_t columns = a->columns.count;
    const struct sweep_column *last =
        columns ? &a->columns.at[columns - 1] : NULL;
    const size_t entries = last ? last->first + last->entries : 0;

    assert_int_equal(a->points, b->points);
    assert_int_equal(columns, b->columns.count);
    assert_int_equal(a->reasons.count, b->reasons.count);
    for (size_t k = 0; k < columns; k++)
        assert_string_equal(a->columns.at[k].name, b->columns.at[k].name);
    for (size_t r = 0; r < a->reasons.count; r++)
        assert_string_equal(a->reasons.word[r], b->reasons.word[r]);
    for (size_t i = 0; i < a->points; i++) {
        assert_memory_equal(sweep_rows_x(&a->rows, i),
                            sweep_rows_x(&b->rows, i), 2 * sizeof(double));
        assert_memory_equal(sweep_rows_real(&a->rows, i, 0),
                            sweep_rows_real(&b->rows, i, 0),
                            entries * a->rows.reals * sizeof(double));
        assert_memory_equal(sweep_rows_code(&a->rows, i, 0),
                            sweep_rows_code(&b->rows, i, 0), entries);
        layers_are_the_same(a, b, i);
    }
}
