/* gallery_entry.h -- one scene made into one figure of the gallery. */
#pragma once

#include <limits.h>

#include "command.h"
#include "scene.h"

/* Where all of them come from and go; borrowed. */
struct gallery_place {
    const struct options *options;
    const char *scenes, *output; /* folders */
    const char *progress;        /* of each scene, an option's word */
};

enum { GALLERY_NAME = 256 };

struct gallery_entry {
    char path[PATH_MAX];      /* of the scene; given */
    char name[GALLERY_NAME];  /* of all its files; given */
    struct panel_names panel; /* its files are NAME, a panel, .svg, ... */
    struct scene scene;       /* owned */
    char *comment, *command;  /* owned: the scene's first comment, its lines
                                 joined; what makes the figure; or NULL */
    enum exit_code code;
};

/* Runs the scene by the command it is for: NAME.svg, .png, .pdf, .h5 and the
 * scene itself as NAME.yaml.  A scene that draws nothing is not run and has no
 * panels; of one that fails the command has complained, and e->code says how.
 * The user's settings hold for every scene. */
void gallery_build(const struct gallery_place *g, struct gallery_entry *e);

/* A second call is harmless. */
void gallery_entry_free(struct gallery_entry *e);

/* FOLDER/NAME + ending; false if that is too long. */
bool gallery_path(char out[PATH_MAX], const char *folder, const char *name,
                  const char *ending);
