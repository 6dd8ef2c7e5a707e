/* catalogue.h -- the commands of slipway and how they end, as data: help, man
 * pages, completions and the table of options (options.h) refer to them. */
#ifndef APPS_CATALOGUE_H
#define APPS_CATALOGUE_H

#include <stdbool.h>
#include <stddef.h>

/* Each of them: COMMAND_NAME is its row of command_table, command_name() the
 * function (command.h). */
#define COMMAND_LIST(ROW)                                                      \
    ROW(PORTRAIT, portrait)                                                    \
    ROW(STUDY, study)                                                          \
    ROW(PLAN, plan)                                                            \
    ROW(KNEES, knees)                                                          \
    ROW(BASIN, basin)                                                          \
    ROW(SWEEP, sweep)                                                          \
    ROW(PUSH, push)                                                            \
    ROW(SIMULATE, simulate)                                                    \
    ROW(RABINOWICZ, rabinowicz)                                                \
    ROW(EXPORT, export)                                                        \
    ROW(GALLERY, gallery)                                                      \
    ROW(CHECK, check)                                                          \
    ROW(WORKPREC, workprec)                                                    \
    ROW(STRESS, stress)                                                        \
    ROW(LAWS, laws)                                                            \
    ROW(INFO, info)                                                            \
    ROW(HELP, help)

#define COMMAND_ID(NAME, name) COMMAND_##NAME,
enum command_id { COMMAND_LIST(COMMAND_ID) COMMANDS };

struct command {
    const char *name;
    size_t most;           /* arguments that it takes */
    const char *arguments; /* as help calls them */
    const char *text;      /* one phrase */
    const char *about;     /* some sentences */
    const char *example;   /* a line to try */
};

extern const struct command command_table[COMMANDS]; /* by command_id */

/* NULL if there is no such command. */
const struct command *command_find(const char *name);

/* The one whose name may have been meant; NULL: none. */
const char *command_nearest(const char *name);

static inline enum command_id command_id(const struct command *c)
{
    return (enum command_id)(c - command_table);
}

enum exit_code {
    EXIT_DONE = 0,   /* also "does not exist" */
    EXIT_CHECK = 1,  /* a check failed */
    EXIT_USAGE = 2,  /* command line or scene */
    EXIT_NUMBER = 3, /* numerical failure */
    EXIT_FILE = 4,   /* cannot read or write */
    EXIT_INTERRUPT = 130
};

/* What they mean; ends with a code that is NULL. */
struct exit_line {
    const char *code, *text;
};
extern const struct exit_line exit_lines[];

#endif
