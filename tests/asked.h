/* asked.h -- a study asked for as a user would: settings "key=value". */
#pragma once

#include <string.h>

#include "check.h"
#include "csv.h"
#include "study.h"

enum { ASKED_MAX = 16, ASKED_TEXT = 128 };

struct asked {
    char set[ASKED_MAX][ASKED_TEXT];
    size_t sets;
    struct scene scene; /* owned */
    struct study study; /* owned; must not move */
};

/* One more setting. */
static inline void ask(struct asked *a, const char *key, const char *value)
{
    assert_true(a->sets < ASKED_MAX);
    const int n = snprintf(a->set[a->sets++], ASKED_TEXT, "%s=%s", key, value);
    assert_in_range(n, 1, ASKED_TEXT - 1);
}

/* The row's cells of these columns (NULL-ended) as material.COLUMN. */
static inline void ask_material(struct asked *a, const struct csv *c,
                                const char *const columns[])
{
    for (; *columns; columns++) {
        char key[ASKED_TEXT];
        const int n = snprintf(key, sizeof key, "material.%s", *columns);
        assert_in_range(n, 1, ASKED_TEXT - 1);
        ask(a, key, csv_text(c, *columns));
    }
}

/* Runs it; free with asked_free. */
static inline void asked_run(struct asked *a)
{
    char *set[ASKED_MAX];
    struct fault why;

    for (size_t i = 0; i < a->sets; i++)
        set[i] = a->set[i];
    enum status status = scene_read(&a->scene, NULL, set, a->sets, &why);
    CHECK(status == STATUS_OK, "%s", why.text);
    status = study_run(&a->study, &a->scene, NULL, &why);
    CHECK(status == STATUS_OK, "%s", why.text);
}

static inline void asked_free(struct asked *a)
{
    study_free(&a->study);
    scene_free(&a->scene);
}
