/* command.h -- what slipway can do, one line a command. */
#ifndef APPS_COMMAND_H
#define APPS_COMMAND_H

#include <stdio.h>

#include "options.h"
#include "scene.h"

enum exit_code {
    EXIT_DONE = 0,   /* also "does not exist" */
    EXIT_CHECK = 1,  /* a check failed */
    EXIT_USAGE = 2,  /* command line or scene */
    EXIT_NUMBER = 3, /* numerical failure */
    EXIT_FILE = 4,   /* cannot read or write */
    EXIT_INTERRUPT = 130
};

struct command {
    const char *name;
    const char *arguments;
    const char *text;    /* one phrase */
    const char *about;   /* some sentences */
    const char *example; /* a line to try */
    enum exit_code (*run)(const struct options *o);
};

/* NULL if there is no such command; *nearest then is its likely meaning. */
const struct command *command_find(const char *name, const char **nearest);

/* In the order of the table; NULL past the end. */
const struct command *command_at(size_t i);

/* What it does and an example, a few lines. */
void command_describe(FILE *out, const struct command *c);

/* The table, for --help and 'slipway help'. */
void command_list(FILE *out);

enum exit_code command_study(const struct options *o);
enum exit_code command_portrait(const struct options *o);
enum exit_code command_knees(const struct options *o);
enum exit_code command_basin(const struct options *o);
enum exit_code command_push(const struct options *o);
enum exit_code command_sweep(const struct options *o);
enum exit_code command_simulate(const struct options *o);
enum exit_code command_rabinowicz(const struct options *o);
enum exit_code command_export(const struct options *o);
enum exit_code command_gallery(const struct options *o);
enum exit_code command_workprec(const struct options *o);
enum exit_code command_stress(const struct options *o);
enum exit_code command_plan(const struct options *o);
enum exit_code command_check(const struct options *o);
enum exit_code command_laws(const struct options *o);
enum exit_code command_info(const struct options *o);
enum exit_code command_help(const struct options *o);

/* Prints "slipway: TEXT" and answers the exit code for s. */
enum exit_code command_fail(enum status s, const char *text);

/* Reads a scene, runs it and frees it. */
enum exit_code command_with_scene(
    const struct options *o,
    enum status (*read)(const struct options *o, struct scene *scene,
                        struct fault *why),
    enum exit_code (*run)(const struct options *o, const struct scene *scene));

/* The complaint when standard output refuses what was printed. */
enum exit_code command_unwritten(void);

/* For commands that take at most so many arguments: complains of the first
 * beyond them; EXIT_DONE if there is none. */
enum exit_code command_allow(const struct options *o, size_t arguments);

#endif
