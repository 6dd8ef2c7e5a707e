/*
 * stress_case.h -- the catalogue of stiff and extreme cases.  A case is a
 * scene that anyone can run: `settings` are the options that make it.
 */
#pragma once

#include "scene.h"

/* What is asked of a case. */
enum stress_kind {
    STRESS_SLOPE,  /* the critical numbers */
    STRESS_START,  /* the fate of a state */
    STRESS_WINDOW, /* the labels of a grid */
    STRESS_FIELD,  /* slip, time, friction and peaks on a grid */
    STRESS_SYSTEM, /* of formulas: equilibria, branches, labels */
    STRESS_KINDS
};
extern const char *const stress_kind_names[];

struct stress_case {
    char name[96];      /* FAMILY/LAW/FORM/... */
    char settings[768]; /* as on the command line, to run it alone */
    enum stress_kind kind;
    struct scene scene; /* owned */
};

struct stress_list {
    struct stress_case *at; /* owned */
    size_t count, room;
};

/* Every case of the catalogue whose name holds `pattern` (shell wildcards
 * allowed; NULL: all), in order; `quick`: each STRESS_QUICK-th.  On error
 * *list is empty.  STATUS_NO_MEMORY; a case that is no scene, which is a bug,
 * keeps the status and text of scene_read. */
MUST_CHECK enum status stress_list_init(struct stress_list *list,
                                        const char *pattern, bool quick,
                                        struct fault *why);

/* Adds a user's scene, which becomes the list's: *scene is then empty.  A
 * system of formulas makes it a STRESS_SYSTEM, else its first start, if any,
 * makes it a STRESS_START, else a field of its products a STRESS_FIELD, else
 * basins a STRESS_WINDOW; `settings`: what makes it, for people.
 * STATUS_NO_MEMORY, with nothing changed. */
MUST_CHECK enum status stress_list_add(struct stress_list *list,
                                       const char *name, const char *settings,
                                       struct scene *scene);

/* A second call is harmless. */
void stress_list_free(struct stress_list *list);

/* Whether a name holds the pattern. */
bool stress_matches(const char *name, const char *pattern);
