/* options.h -- the command line, once for all commands. */
#ifndef APPS_OPTIONS_H
#define APPS_OPTIONS_H

#include <stdbool.h>
#include <stddef.h>

enum { OPTIONS_SETS = 64, OPTIONS_FILES = 64 };

enum progress { PROGRESS_AUTO, PROGRESS_JSON, PROGRESS_NONE };

struct options {
    const char *command;
    const char *file[OPTIONS_FILES]; /* arguments after the command */
    size_t files;
    char *set[OPTIONS_SETS]; /* owned: "key=value", in order */
    size_t sets;
    const char *output;           /* of -o, borrowed; NULL: none */
    const char *v, *psi, *states; /* of push, borrowed; NULL: not given */
    const char *scenes;           /* of gallery, likewise */
    const char *only;             /* of stress, likewise */
    const char *form;             /* of export, likewise */
    const char *as;               /* of help, export: "man", "xppaut", ... */
    bool json, keep_script, quiet, tap, record, sensitivities, resume, quick;
    bool rerun;
    int threads; /* 0: what OpenMP chooses */
    enum progress progress;
};

/* One of them, as man pages and completions need it; all static. */
struct option_line {
    const char *name;  /* without -- */
    char letter;       /* -o; 0: none */
    const char *value; /* "FILE"; NULL: none */
    const char *text;
    bool general; /* all commands take it */
};

/* In the order of the table; false past the end. */
bool options_at(size_t i, struct option_line *line);

/* Whether a command takes it: one that is not general begins its text with the
 * commands that do, "push, simulate: ...". */
bool options_concern(const struct option_line *line, const char *command);

/* Parses argv; prints help, version or one line of complaint itself and ends
 * the process for those (exit 0, 0, 2). */
void options_parse(struct options *o, int argc, char *argv[]);
void options_free(struct options *o);

#endif
