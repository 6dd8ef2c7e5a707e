/* catalogue.h -- the commands of slipway and how they end, as data: help, man
 * pages, completions and the table of options (options.h) refer to them. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

/* What a command does, which decides on most of its options (options.c). */
enum {
    COMMAND_READS = 1,   /* a scene: its settings, threads, progress */
    COMMAND_STUDIES = 2, /* runs a study, or plans one: sensitivities */
    COMMAND_DRAWS = 4,   /* a figure, and writes the numbers to HDF5 */
    COMMAND_MAKES = 8,   /* the files that the scene's output names */
    COMMAND_PLANES = 16, /* also for a system of formulas */
    COMMAND_SHARES = 32  /* its work with other ranks (crew.h) */
};
#define COMMAND_ALL_OF_IT                                                      \
    (COMMAND_READS | COMMAND_STUDIES | COMMAND_DRAWS | COMMAND_MAKES)

/* Each of them: COMMAND_NAME is its row of command_table, command_name() the
 * function (command.h).  A new one: docs/new_command.md. */
#define COMMAND_LIST(ROW)                                                      \
    ROW(PORTRAIT, portrait, COMMAND_ALL_OF_IT | COMMAND_PLANES)                \
    ROW(STUDY, study, COMMAND_ALL_OF_IT | COMMAND_PLANES)                      \
    ROW(PLAN, plan, COMMAND_ALL_OF_IT | COMMAND_PLANES)                        \
    ROW(KNEES, knees, COMMAND_READS | COMMAND_STUDIES | COMMAND_DRAWS)         \
    ROW(BASIN, basin, COMMAND_ALL_OF_IT | COMMAND_PLANES)                      \
    ROW(SWEEP, sweep,                                                          \
        COMMAND_READS | COMMAND_DRAWS | COMMAND_MAKES | COMMAND_PLANES |       \
            COMMAND_SHARES)                                                    \
    ROW(MERGE, merge,                                                          \
        COMMAND_READS | COMMAND_DRAWS | COMMAND_MAKES | COMMAND_PLANES)        \
    ROW(ENSEMBLE, ensemble,                                                    \
        COMMAND_READS | COMMAND_DRAWS | COMMAND_MAKES | COMMAND_PLANES |       \
            COMMAND_SHARES)                                                    \
    ROW(PUSH, push, COMMAND_READS | COMMAND_PLANES)                            \
    ROW(SIMULATE, simulate, COMMAND_READS | COMMAND_DRAWS)                     \
    ROW(RABINOWICZ, rabinowicz, COMMAND_READS | COMMAND_DRAWS)                 \
    ROW(EXPORT, export, COMMAND_READS)                                         \
    ROW(IMPORT, import, 0)                                                     \
    ROW(GALLERY, gallery, COMMAND_READS)                                       \
    ROW(CHECK, check, COMMAND_READS | COMMAND_PLANES)                          \
    ROW(WORKPREC, workprec, COMMAND_READS | COMMAND_DRAWS | COMMAND_PLANES)    \
    ROW(STRESS, stress, COMMAND_READS | COMMAND_PLANES)                        \
    ROW(LAWS, laws, 0)                                                         \
    ROW(INFO, info, 0)                                                         \
    ROW(HELP, help, 0)

#define COMMAND_ID(NAME, name, does) COMMAND_##NAME,
enum command_id { COMMAND_LIST(COMMAND_ID) COMMANDS };

/* The bits 1 << command_id of all that do it. */
#define COMMAND_READ_BIT(NAME, name, does)                                     \
    +((does) &COMMAND_READS ? 1u << COMMAND_##NAME : 0u)
#define COMMAND_STUDY_BIT(NAME, name, does)                                    \
    +((does) &COMMAND_STUDIES ? 1u << COMMAND_##NAME : 0u)
#define COMMAND_DRAW_BIT(NAME, name, does)                                     \
    +((does) &COMMAND_DRAWS ? 1u << COMMAND_##NAME : 0u)
#define COMMAND_PLANE_BIT(NAME, name, does)                                    \
    +((does) &COMMAND_PLANES ? 1u << COMMAND_##NAME : 0u)
#define COMMAND_MAKE_BIT(NAME, name, does)                                     \
    +((does) &COMMAND_MAKES ? 1u << COMMAND_##NAME : 0u)
#define COMMAND_SHARE_BIT(NAME, name, does)                                    \
    +((does) &COMMAND_SHARES ? 1u << COMMAND_##NAME : 0u)

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
