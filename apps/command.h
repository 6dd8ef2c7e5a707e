/* command.h -- the commands as functions, and what they share. */
#pragma once

#include <stdio.h>

#include "options.h"
#include "scene.h"

/* Runs one, which need not be that of the command line. */
enum exit_code command_run(const struct command *c, const struct options *o);

#define COMMAND_FUNCTION(NAME, name, does)                                     \
    enum exit_code command_##name(const struct options *o);
COMMAND_LIST(COMMAND_FUNCTION)

/* Which command a scene is for, where it does not say: "sweep" for one with a
 * sweep, "ensemble" for one with an ensemble; of those that name no products,
 * "rabinowicz" for one with that section and "simulate" for one with starts of
 * its own and no spread; else "study". */
const char *scene_command(const struct scene *s);

/* Reads the scene of the command line, if one is given, with the settings of it
 * and then these: borrowed, at most COMMAND_MORE.  A scene read again with more
 * says in its file what was run.  Its output is for the commands that make
 * files (portrait, study, plan, basin, sweep, ensemble); of the others, which
 * answer a question, only what the settings name remains. */
enum { COMMAND_MORE = 2 };
MUST_CHECK enum status command_read(const struct options *o, char *const more[],
                                    size_t count, struct scene *scene,
                                    struct fault *why);

/* *why as of the format with one %s, for the user's own text;
 * STATUS_BAD_ARGUMENT. */
enum status command_refuse(struct fault *why, const char *format,
                           const char *text);

/* A command, its options and an example; of NULL: all commands and options. */
void help_print(FILE *out, const struct command *c);

/* Prints "slipway: TEXT" and answers the exit code for s. */
enum exit_code command_fail(enum status s, const char *text);

/* Reads a scene, by command_read where `read` is NULL, runs it and frees it. */
enum exit_code command_with_scene(
    const struct options *o,
    enum status (*read)(const struct options *o, struct scene *scene,
                        struct fault *why),
    enum exit_code (*run)(const struct options *o, const struct scene *scene));

/* The complaint when standard output refuses what was printed. */
enum exit_code command_unwritten(void);

/* A text in which no harness of TAP finds a directive. */
void command_plain(FILE *out, const char *text);
