#include "options.h"

#include <argp.h>
#include <ctype.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "command.h"

enum key {
    KEY_SET = 256,
    KEY_LAW,
    KEY_FRICTION,
    KEY_ALPHA,
    KEY_RTOL,
    KEY_FIGURE,
    KEY_KEEP,
    KEY_JSON,
    KEY_TAP,
    KEY_RECORD,
    KEY_THREADS,
    KEY_PROGRESS,
    KEY_SEED,
    KEY_EXACT,
    KEY_QUICK,
    KEY_SENSITIVITIES,
    KEY_RESUME,
    KEY_V,
    KEY_PSI,
    KEY_STATES,
    KEY_DATA,
    KEY_SCENES,
    KEY_ONLY,
    KEY_RERUN,
    KEY_AS,
    KEY_FORM,
    KEY_HELP,
    KEY_VERSION
};

/* Of options that some commands take the text begins with their names, others
 * begin with a capital: see options_concern. */
static const struct argp_option option_table[] = {
    { "set", KEY_SET, "KEY=VALUE", 0, "Set any scene key, e.g. slope.alpha=0.3",
      0 },
    { "law", KEY_LAW, "NAME", 0, "Friction law (see 'slipway laws')", 0 },
    { "friction", KEY_FRICTION, "FORM", 0, "Friction form: asinh or log", 0 },
    { "alpha", KEY_ALPHA, "RAD", 0, "Slope angle in radians", 0 },
    { "rtol", KEY_RTOL, "TOL", 0, "Relative accuracy [1e-12]", 0 },
    { "output", 'o', "FILE", 0,
      "Write the results to this HDF5 file (check: CSV; gallery: a folder)",
      0 },
    { "figure", KEY_FIGURE, "FILE", 0, "Draw FILE.svg, .pdf or .png", 0 },
    { "keep-script", KEY_KEEP, 0, 0,
      "Leave the figure's gnuplot script and data beside it", 0 },
    { "json", KEY_JSON, 0, 0, "Print JSON instead of a table", 0 },
    { "tap", KEY_TAP, 0, 0, "check, stress: print TAP instead of a table", 0 },
    { "record", KEY_RECORD, 0, 0,
      "check: write a table from scenes or options to -o", 0 },
    { "threads", KEY_THREADS, "N", 0, "Number of threads [all]", 0 },
    { "progress", KEY_PROGRESS, "HOW", 0,
      "Show progress: auto, json or none [auto]", 0 },
    { "quiet", 'q', 0, 0, "Print nothing but errors", 0 },
    { "exact", KEY_EXACT, 0, 0,
      "basin: label every cell by its own forward integration", 0 },
    { "quick", KEY_QUICK, 0, 0,
      "workprec: in some seconds, but coarsely; stress: a part of the cases",
      0 },
    { "sensitivities", KEY_SENSITIVITIES, 0, 0,
      "Add derivatives by the inputs, and what rounding these costs", 0 },
    { "resume", KEY_RESUME, 0, 0,
      "sweep: go on where an interrupted one stopped", 0 },
    { "seed", KEY_SEED, "N", 0, "Seed of everything random", 0 },
    { "v", KEY_V, "V", 0, "push, simulate: slip rate in units of V_star", 0 },
    { "psi", KEY_PSI, "PSI", 0, "push, simulate: interfacial state", 0 },
    { "states", KEY_STATES, "FILE", 0,
      "push: many states, a CSV file with columns v and psi", 0 },
    { "data", KEY_DATA, "FILE", 0,
      "rabinowicz: a CSV file with columns tan_alpha and l_k or x_k", 0 },
    { "scenes", KEY_SCENES, "DIR", 0,
      "gallery: the folder of scenes, instead of ./scenes", 0 },
    { "only", KEY_ONLY, "PATTERN", 0, "stress: the cases with this in the name",
      0 },
    { "rerun", KEY_RERUN, 0, 0,
      "info: compute the file again from the scene in it, and compare", 0 },
    { "as", KEY_AS, "FORMAT", 0,
      "help, export: write man, bash, zsh, fish, scene, hdf5 or words; xppaut "
      "or auto",
      0 },
    { "form", KEY_FORM, "KIND", 0,
      "export: what XPPAUT integrates: arclength or time [arclength]", 0 },
    { "help", KEY_HELP, 0, 0, "Print this", -1 },
    { "version", KEY_VERSION, 0, 0, "Print the version", -1 },
    { 0 },
};

/* The scene key that an option stands for; NULL: none. */
static const char *scene_key(int key)
{
    switch (key) {
        case KEY_LAW:
            return "law.preset";
        case KEY_FRICTION:
            return "law.friction";
        case KEY_ALPHA:
            return "slope.alpha";
        case KEY_RTOL:
            return "accuracy.rtol";
        case KEY_SEED:
            return "trajectories.seed";
        case 'o':
            return "output.hdf5";
        case KEY_FIGURE:
            return "output.figure";
        case KEY_DATA:
            return "rabinowicz.data";
        default:
            return NULL;
    }
}

/* One line, exit 2: the command line is wrong. */
static _Noreturn void refuse(const char *what, const char *value,
                             const char *expected)
{
    fprintf(stderr, "slipway: %s%s: %s\n", what, value, expected);
    exit(2);
}

static bool is_path(int key)
{
    return key == 'o' || key == KEY_FIGURE || key == KEY_DATA;
}

/* Takes over one "key=value". */
static void add_text(struct options *o, char *text)
{
    if (text == NULL || o->sets == OPTIONS_SETS)
        refuse("--set ", text ? text : "", "too many settings");
    o->set[o->sets++] = text;
}

/* Adds KEY=VALUE; a path becomes a YAML single-quoted text. */
static void add_set(struct options *o, const char *key, const char *value,
                    bool quote)
{
    const size_t room = strlen(key) + 2 * strlen(value) + 4;
    char *text = malloc(room), *end = text;

    if (text == NULL)
        refuse("", key, "out of memory");
    end += sprintf(end, "%s=%s", key, quote ? "'" : "");
    for (; *value; value++) {
        *end++ = *value;
        if (quote && *value == '\'')
            *end++ = '\'';
    }
    strcpy(end, quote ? "'" : "");
    add_text(o, text);
}

static int parse_count(const char *text)
{
    char *end;
    const long n = strtol(text, &end, 10);

    if (end == text || *end || n < 1 || n > 4096)
        refuse("--threads ", text, "expected a number from 1 to 4096");
    return (int) n;
}

static enum progress parse_progress(const char *text)
{
    if (strcmp(text, "json") == 0)
        return PROGRESS_JSON;
    if (strcmp(text, "none") == 0)
        return PROGRESS_NONE;
    if (strcmp(text, "auto") != 0)
        refuse("--progress ", text, "expected auto, json or none");
    return PROGRESS_AUTO;
}

static void add_argument(struct options *o, char *argument)
{
    if (o->command == NULL)
        o->command = argument;
    else if (o->files < OPTIONS_FILES)
        o->file[o->files++] = argument;
    else
        refuse("", argument, "too many arguments");
}

static const struct argp argp;

/* All of it, or what concerns one command. */
static void print_help(const char *command)
{
    const char *nearest;
    const struct command *c = command ? command_find(command, &nearest) : NULL;
    char name[] = "slipway";

    if (c == NULL) {
        argp_help(&argp, stdout, ARGP_HELP_STD_HELP & ~ARGP_HELP_EXIT_OK, name);
        return;
    }
    command_describe(stdout, c);
    printf("Options of all commands:\n");
    argp_help(&argp, stdout, ARGP_HELP_LONG, name);
}

static _Noreturn void print_and_leave(const struct options *o, bool help)
{
    if (help)
        print_help(o->command);
    else
        printf("slipway %s\n", SLIPWAY_VERSION);
    if (fflush(stdout) != 0 || ferror(stdout))
        exit((int) command_unwritten());
    exit(EXIT_DONE);
}

/* Where an option is kept as it was given; NULL: not at all. */
static const char **text_option(struct options *o, int key)
{
    switch (key) {
        case 'o':
            return &o->output;
        case KEY_V:
            return &o->v;
        case KEY_PSI:
            return &o->psi;
        case KEY_STATES:
            return &o->states;
        case KEY_SCENES:
            return &o->scenes;
        case KEY_ONLY:
            return &o->only;
        case KEY_AS:
            return &o->as;
        case KEY_FORM:
            return &o->form;
        default:
            return NULL;
    }
}

/* Where an option without a value is noted; NULL: it has one. */
static bool *flag_option(struct options *o, int key)
{
    switch (key) {
        case KEY_SENSITIVITIES:
            return &o->sensitivities;
        case KEY_QUICK:
            return &o->quick;
        case KEY_RESUME:
            return &o->resume;
        case KEY_JSON:
            return &o->json;
        case KEY_RERUN:
            return &o->rerun;
        case KEY_TAP:
            return &o->tap;
        case KEY_RECORD:
            return &o->record;
        case KEY_KEEP:
            return &o->keep_script;
        case 'q':
            return &o->quiet;
        default:
            return NULL;
    }
}

static error_t parse(int key, char *value, struct argp_state *state)
{
    struct options *o = state->input;

    if (text_option(o, key))
        *text_option(o, key) = value;
    if (scene_key(key)) {
        add_set(o, scene_key(key), value, is_path(key));
        return 0;
    }
    if (flag_option(o, key))
        *flag_option(o, key) = true;
    if (text_option(o, key) || flag_option(o, key))
        return 0;
    switch (key) {
        case KEY_SET:
            if (strchr(value, '=') == NULL)
                refuse("--set ", value, "expected KEY=VALUE");
            add_text(o, strdup(value));
            return 0;
        case KEY_EXACT:
            add_set(o, "basins.exact", "true", false);
            return 0;
        case KEY_THREADS:
            o->threads = parse_count(value);
            return 0;
        case KEY_PROGRESS:
            o->progress = parse_progress(value);
            return 0;
        case KEY_HELP:
        case KEY_VERSION:
            print_and_leave(o, key == KEY_HELP);
        case ARGP_KEY_ARG:
            add_argument(o, value);
            return 0;
        case ARGP_KEY_ERROR:
            refuse("", state->argv[state->next > 1 ? state->next - 1 : 0],
                   "unknown option or missing value (see slipway --help)");
        default:
            return ARGP_ERR_UNKNOWN;
    }
}

/* The list of commands and the examples, below the options. */
static char *help_filter(int key, const char *text, void *input)
{
    char *help = NULL;
    size_t size = 0;

    (void) input;
    if (key != ARGP_KEY_HELP_POST_DOC)
        return (char *) (uintptr_t) text;
    FILE *out = open_memstream(&help, &size);
    if (out == NULL)
        return NULL;
    command_list(out);
    fclose(out);
    return help;
}

static const struct argp argp = {
    .options = option_table,
    .parser = parse,
    .args_doc = "COMMAND [SCENE.yaml]",
    .doc = "Phase planes of rate-and-state friction: steady states, the "
           "saddle's manifolds, critical velocities.\v-",
    .help_filter = help_filter,
};

bool options_at(size_t i, struct option_line *line)
{
    const struct argp_option *o = &option_table[i];

    if (i >= sizeof option_table / sizeof *option_table - 1)
        return false;
    *line = (struct option_line){
        .name = o->name,
        .letter = o->key < KEY_SET ? (char) o->key : '\0',
        .value = o->arg,
        .text = o->doc,
        .general = isupper((unsigned char) *o->doc),
    };
    return true;
}

bool options_concern(const struct option_line *line, const char *command)
{
    const size_t size = strlen(command);
    const char *found = line->text;

    while (!line->general && (found = strstr(found, command)) != NULL) {
        const bool begins = found == line->text || found[-1] == ' ';
        found += size;
        if (begins && (*found == ',' || *found == ':'))
            return true;
    }
    return line->general;
}

/* argp's own messages take two lines; ours is one (ARGP_KEY_ERROR). */
void options_parse(struct options *o, int argc, char *argv[])
{
    *o = (struct options){ 0 };
    argp_parse(&argp, argc, argv, ARGP_NO_ERRS | ARGP_NO_HELP | ARGP_IN_ORDER,
               NULL, o);
}

void options_free(struct options *o)
{
    for (size_t i = 0; i < o->sets; i++)
        free(o->set[i]);
    o->sets = 0;
}
