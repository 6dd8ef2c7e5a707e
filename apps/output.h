/* output.h -- what a command leaves behind: an HDF5 file, a figure of one file
 * or several, and its results as JSON or text. */
#pragma once

#include "command.h"
#include "draw.h"
#include "result.h"

struct ensemble;

_Static_assert((int) PANELS_MAX == (int) FIGURES_MAX, "drawn together");

/* Could a file be written there: replace_check, and it is none that the command
 * line or the scene (NULL: none) names to be read (STATUS_BAD_SCENE). */
MUST_CHECK enum status output_path_check(const struct options *o,
                                         const struct scene *scene,
                                         const char *path, struct fault *why);

/* And an HDF5 file?  "-" could not: it is no text. */
MUST_CHECK enum status output_file_check(const struct options *o,
                                         const struct scene *scene,
                                         const char *path, struct fault *why);

/* Could the scene's HDF5 file and all files of the figure at `path` (NULL:
 * none) be written?  Asked before anything is computed.  panel: names as of
 * panel_path, "" for the path itself, ended by NULL. */
MUST_CHECK enum status output_check(const struct options *o,
                                    const struct scene *scene, const char *path,
                                    const char *const panel[],
                                    struct fault *why);

/* Writes the scene's HDF5 file, if it names one, with its ensemble (drawn.h;
 * NULL: none), and says so.  command: which
 * makes it again.  Errors as of result_file.h. */
MUST_CHECK enum status output_write(const struct options *o,
                                    const char *command,
                                    const struct results *all,
                                    const struct scene *scene,
                                    const struct ensemble *drawn,
                                    const char *untitled, struct fault *why);

/* Whether -o names standard output, "-": the text that a file would hold then
 * is all that is printed.  STATUS_BAD_ARGUMENT beside --json. */
bool output_is_standard(const struct options *o);
MUST_CHECK enum status output_standard_check(const struct options *o,
                                             struct fault *why);

/* The file that -o names; NULL: none, or standard output. */
const char *output_path(const struct options *o);

/* "wrote PATH", unless the command is quiet. */
void output_tell(const struct options *o, const char *path);

/* Figures in the making; owned. */
struct panels {
    struct figure figure[PANELS_MAX];
    struct panel_names names; /* as of panel_path */
};

#define PANELS_EMPTY ((struct panels){ .names.count = 0 })

/* One more, to be begun by figure_init. */
struct figure *panels_add(struct panels *p, const char *name);

/* Draws the files of a figure on that paper, all or none, says so, and frees p.
 * Errors as figures_write. */
MUST_CHECK enum status output_draw(const struct options *o,
                                   const struct scene_figure *paper,
                                   struct panels *p, const char *path,
                                   struct fault *why);

/* Prints JSON or, unless the command is quiet, text, below what `head` prints
 * (NULL: nothing). */
enum exit_code output_print(const struct options *o, const struct results *all,
                            void (*head)(FILE *out, const void *run));
