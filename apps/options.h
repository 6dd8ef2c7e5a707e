/* options.h -- the command line.  One table says of every option what it is
 * called, what it takes, what it sets and which commands know it; parsing,
 * help, man pages and completions are made from that table. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "catalogue.h"

enum option_kind {
    OPTION_FLAG,    /* bool */
    OPTION_COUNT,   /* int, from 1 to 4096 */
    OPTION_TEXT,    /* const char *, as it was given */
    OPTION_FILE,    /* the same, a path */
    OPTION_FOLDER,  /* the same */
    OPTION_WORD,    /* const char *, one of `words` */
    OPTION_SETTING, /* KEY=VALUE of a scene */
    OPTION_QUOTED,  /* a text that is set as it is */
    OPTION_RANGES,  /* x=LO:HI,y=LO:HI of a scene's window */
};

struct option {
    const char *name;  /* without -- */
    char letter;       /* -o; 0: none */
    const char *value; /* what help calls it, "FILE"; NULL: none */
    enum option_kind kind;
    const char *key;          /* of the scene, set to the value; NULL: none */
    size_t at;                /* of the member of struct options; 0: none */
    const char *const *words; /* NULL-ended */
    unsigned commands;        /* those that take it, 1 << command_id */
    const char *text;         /* what it does, a phrase */
};

/* Ends with a name that is NULL.  A name may stand in several rows, each for
 * commands of its own. */
extern const struct option option_table[];

/* Whether a command takes it. */
static inline bool option_concerns(const struct option *o,
                                   const struct command *c)
{
    return o->commands >> command_id(c) & 1u;
}

/* "push, simulate" of one that is not; else "". */
void option_commands(const struct option *o, char *text, size_t size);

enum { OPTIONS_SETS = 64, OPTIONS_ALSO = 2 };

/* The files of a figure beside one another: "", "_time", ... (output.h). */
enum { PANELS_MAX = 8, PANEL_NAME = 64 };
struct panel_names {
    char name[PANELS_MAX][PANEL_NAME];
    size_t count;
};

struct options {
    const struct command *command; /* NULL: none named */
    const char **file; /* arguments after the command; owned, each borrowed */
    size_t files;
    char *set[OPTIONS_SETS]; /* owned: "key=value", in order */
    size_t sets;
    uint64_t given;                 /* 1 << row of option_table */
    const char *also[OPTIONS_ALSO]; /* endings that figures are drawn with
                                       beside that of their path; NULL: none */
    struct panel_names *drawn;      /* borrowed: the panels of the figure;
                                       NULL: nobody asks */

    /* As they were given, borrowed; NULL or 0: not given. */
    const char *output, *v, *psi, *phi, *from, *kick, *states, *state, *scenes,
        *only, *form, *as, *shard, *draws, *certificate;
    const char *progress; /* or "bar": also of a command that is quiet */
    bool json, keep_script, quiet, tap, record, sensitivities, resume, quick;
    bool rerun, help, version;
    int threads;
};

/* Parses argv; what cannot be understood costs one line and ends the process
 * (exit 2). */
void options_parse(struct options *o, int argc, char *argv[]);
void options_free(struct options *o);

/* "KEY=VALUE", the value as a YAML text in single quotes if asked; owned by the
 * caller, NULL without memory. */
char *options_setting(const char *key, const char *value, bool quoted);

/* Complains of a name that no command has and ends the process (exit 2). */
_Noreturn void options_refuse_command(const char *name);

/* Whether c knows every option, sets no output where it writes none, and takes
 * so many arguments: a command may be handed what was meant for another.
 * Complains if not. */
bool options_suit(const struct options *o, const struct command *c);
