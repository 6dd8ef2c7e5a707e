#include "options.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "synonym.h"
#include "text.h"

/* ---- the table ----------------------------------------------------------- */

#define ON(command) (1u << COMMAND_##command)
#define ALL         ((1u << COMMANDS) - 1u)
#define TO(member)  .at = offsetof(struct options, member)

enum {
    STUDIES = COMMAND_LIST(COMMAND_STUDY_BIT),
    SCENES = COMMAND_LIST(COMMAND_READ_BIT),
    DRAW = COMMAND_LIST(COMMAND_DRAW_BIT),
    PLANES = COMMAND_LIST(COMMAND_PLANE_BIT),
    TAKE_LONG = SCENES | ON(INFO),
};

static const char *const progress_words[] = { "auto", "json", "none", NULL };
static const char *const export_words[] = { "xppaut", "auto", NULL };
static const char *const law_words[] = { "scene", NULL };
static const char *const form_words[] = { "arclength", "time", NULL };
static const char *const from_words[] = { "creep", NULL };
static const char *const help_words[] = { "man",   "bash",     "zsh",
                                          "fish",  "scene",    "hdf5",
                                          "words", "complete", NULL };

/* clang-format off */
const struct option option_table[] = {
    { "set", 0, "KEY=VALUE", OPTION_SETTING, .commands = SCENES,
      .text = "set any key of the scene, e.g. slope.alpha=0.3" },
    { "law", 0, "NAME", OPTION_TEXT, "law.preset", .commands = SCENES,
      .text = "friction law (see 'slipway laws')" },
    { "friction", 0, "FORM", OPTION_TEXT, "law.friction", .commands = SCENES,
      .text = "friction form: asinh or log" },
    { "alpha", 0, "RAD", OPTION_TEXT, "slope.alpha", .commands = SCENES,
      .text = "slope angle in radians" },
    { "ode", 0, "TEXT", OPTION_QUOTED, "system.ode", .commands = PLANES,
      .text = "a system of formulas instead: \"x' = y; y' = -k*x; k = 2\"" },
    { "window", 0, "RANGES", OPTION_RANGES, "window", .commands = PLANES,
      .text = "the part of the plane that is looked at, x=-2:2,y=-1:1" },
    { "rtol", 0, "TOL", OPTION_TEXT, "accuracy.rtol", .commands = SCENES,
      .text = "relative accuracy [1e-12]" },
    { "proved", 0, NULL, OPTION_FLAG, "accuracy.proved",
      .commands = STUDIES | ON(SWEEP),
      .text = "enclose numbers, and a slope's labels, with proof" },
    { "certificate", 0, "FILE", OPTION_FILE, TO(certificate),
      .commands = STUDIES,
      .text = "write the proof as JSON, for others to verify" },
    { "seed", 0, "N", OPTION_TEXT, "trajectories.seed",
      .commands = (STUDIES & ~ON(KNEES)) | ON(SWEEP) | ON(GALLERY),
      .text = "seed of everything random" },
    { "seed", 0, "N", OPTION_TEXT, "ensemble.seed",
      .commands = ON(ENSEMBLE) | ON(MERGE),
      .text = "seed of the draws [1]" },
    { "draws", 0, "N", OPTION_TEXT, "ensemble.draws",
      .commands = ON(ENSEMBLE) | ON(MERGE),
      .text = "how many materials" },
    { "draws", 0, "N", OPTION_TEXT, "ensemble.draws", TO(draws),
      .commands = (STUDIES & ~ON(PLAN)) | ON(PUSH),
      .text = "beside inputs X +- S: an ensemble of so many, too" },
    { "exact", 0, NULL, OPTION_FLAG, "basins.exact",
      .commands = (STUDIES & ~ON(KNEES)) | ON(SWEEP),
      .text = "label every cell of a map by its own forward integration" },
    { "data", 0, "FILE", OPTION_FILE, "rabinowicz.data",
      .commands = ON(RABINOWICZ),
      .text = "a CSV file with columns tan_alpha and l_k or x_k" },
    { "sensitivities", 0, NULL, OPTION_FLAG, TO(sensitivities),
      .commands = STUDIES,
      .text = "add derivatives by the inputs, and what rounding these costs" },
    { "v", 0, "V", OPTION_TEXT, TO(v), .commands = ON(PUSH) | ON(SIMULATE),
      .text = "slip rate in units of V_star, or with its unit: 8e-3m/s" },
    { "psi", 0, "PSI", OPTION_TEXT, TO(psi),
      .commands = ON(PUSH) | ON(SIMULATE), .text = "interfacial state" },
    { "phi", 0, "PHI", OPTION_TEXT, TO(phi),
      .commands = ON(PUSH) | ON(SIMULATE),
      .text = "the same in physical units, as 'slipway laws' has phi" },
    { "from", 0, "STATE", OPTION_WORD, TO(from), .words = from_words,
      .commands = ON(PUSH), .text = "kick the block from creep" },
    { "kick", 0, "DV", OPTION_TEXT, TO(kick), .commands = ON(PUSH),
      .text = "what that adds to its slip rate, as --v: 2.5e-3m/s" },
    { "state", 0, "POINT", OPTION_TEXT, TO(state), .commands = ON(PUSH),
      .text = "the state of a system of formulas, x=1,y=0.5" },
    { "states", 0, "FILE", OPTION_FILE, TO(states), .commands = ON(PUSH),
      .text = "many states, CSV with columns v or v [m/s], psi or phi, and id" },

    { "output", 'o', "DIR", OPTION_FOLDER, TO(output), .commands = ON(GALLERY),
      .text = "where all goes [outputs/gallery]" },
    { "output", 'o', "FILE", OPTION_FILE, TO(output), .commands = ON(CHECK),
      .text = "write the table of --record to this CSV file; -: print it" },
    { "output", 'o', "FILE", OPTION_FILE, TO(output), .commands = ON(EXPORT),
      .text = "write NAME.ode for XPPAUT, NAME.c and its like for AUTO; -: "
              "print the former" },
    { "output", 'o', "FILE", OPTION_FILE, TO(output), .commands = ON(IMPORT),
      .text = "write the scene to this YAML file; -: print it" },
    { "output", 'o', "FILE", OPTION_FILE, TO(output), .commands = ON(PUSH),
      .text = "write states and answers to this CSV or HDF5 file; -: CSV to "
              "standard output" },
    { "output", 'o', "FILE", OPTION_FILE, "output.hdf5", TO(output),
      .commands = ON(SWEEP),
      .text = "write the results to this HDF5 file; -: print them as CSV" },
    { "output", 'o', "FILE", OPTION_FILE, "output.hdf5", TO(output),
      .commands = (DRAW & ~ON(SWEEP)) | ON(STRESS),
      .text = "write the results to this HDF5 file" },
    { "figure", 0, "FILE", OPTION_FILE, "output.figure", .commands = DRAW,
      .text = "draw FILE.svg, .pdf or .png" },
    { "figure-width", 0, "MM", OPTION_TEXT, "figure.width",
      .commands = DRAW | ON(GALLERY),
      .text = "of the figure: mm, one_column, two_columns, slide or screen" },
    { "figure-height", 0, "MM", OPTION_TEXT, "figure.height",
      .commands = DRAW | ON(GALLERY),
      .text = "of the figure in mm [as the plot needs]" },
    { "figure-type", 0, "PT", OPTION_TEXT, "figure.type",
      .commands = DRAW | ON(GALLERY),
      .text = "size of its letters in points" },
    { "figure-legend", 0, "WHERE", OPTION_TEXT, "figure.legend",
      .commands = DRAW | ON(GALLERY),
      .text = "outside, inside, below or none [auto]" },
    { "keep-script", 0, NULL, OPTION_FLAG, TO(keep_script),
      .commands = DRAW | ON(GALLERY),
      .text = "leave the figure's gnuplot script and data beside it" },
    { "json", 0, NULL, OPTION_FLAG, TO(json), .commands = ALL & ~ON(HELP),
      .text = "print JSON instead of a table" },
    { "tap", 0, NULL, OPTION_FLAG, TO(tap), .commands = ON(CHECK) | ON(STRESS),
      .text = "print TAP instead of a table" },
    { "quiet", 'q', NULL, OPTION_FLAG, TO(quiet), .commands = TAKE_LONG,
      .text = "print nothing but errors" },
    { "progress", 0, "HOW", OPTION_WORD, TO(progress), .words = progress_words,
      .commands = TAKE_LONG,
      .text = "show progress: auto, json or none [auto]" },
    { "threads", 0, "N", OPTION_COUNT, TO(threads),
      .commands = TAKE_LONG & ~ON(WORKPREC),
      .text = "number of threads [all]" },

    { "resume", 0, NULL, OPTION_FLAG, TO(resume),
      .commands = ON(SWEEP) | ON(ENSEMBLE),
      .text = "go on where an interrupted run stopped" },
    { "shard", 0, "I/N", OPTION_TEXT, TO(shard),
      .commands = ON(SWEEP) | ON(ENSEMBLE),
      .text = "one of N shares of the work; see merge" },
    { "form", 0, "KIND", OPTION_WORD, TO(form), .words = form_words,
      .commands = ON(EXPORT),
      .text = "what XPPAUT integrates: arclength or time [arclength]" },
    { "scenes", 0, "DIR", OPTION_FOLDER, TO(scenes), .commands = ON(GALLERY),
      .text = "the folder of scenes [scenes]" },
    { "record", 0, NULL, OPTION_FLAG, TO(record), .commands = ON(CHECK),
      .text = "write a table from scenes or options instead" },
    { "quick", 0, NULL, OPTION_FLAG, TO(quick),
      .commands = ON(WORKPREC) | ON(STRESS),
      .text = "coarsely, or a part of the cases, in some seconds" },
    { "only", 0, "PATTERN", OPTION_TEXT, TO(only), .commands = ON(STRESS),
      .text = "the cases with this in the name" },
    { "rerun", 0, NULL, OPTION_FLAG, TO(rerun), .commands = ON(INFO),
      .text = "compute the file again from the scene in it, and compare" },
    { "as", 0, "FORMAT", OPTION_WORD, TO(as), .words = export_words,
      .commands = ON(EXPORT), .text = "for which program: xppaut or auto" },
    { "as", 0, "FORMAT", OPTION_WORD, TO(as), .words = law_words,
      .commands = ON(LAWS), .text = "write the law NAME as formulas: scene" },
    { "as", 0, "FORMAT", OPTION_WORD, TO(as), .words = help_words,
      .commands = ON(HELP),
      .text = "write man, bash, zsh, fish, scene, hdf5 or words" },
    { "help", 0, NULL, OPTION_FLAG, TO(help), .commands = ALL,
      .text = "print this" },
    { "version", 0, NULL, OPTION_FLAG, TO(version), .commands = ALL,
      .text = "print the version" },
    { NULL, .commands = 0 },
};
/* clang-format on */
_Static_assert(sizeof option_table / sizeof *option_table <= 64,
               "options.given has a bit for each");

/* Whether so many commands take it that they are not worth listing. */
static bool option_is_common(const struct option *o)
{
    return __builtin_popcount(o->commands) > COMMANDS / 2;
}

void option_commands(const struct option *o, char *text, size_t size)
{
    size_t n = 0;

    text[0] = '\0';
    for (int i = 0; !option_is_common(o) && i < COMMANDS && n < size; i++)
        if (option_concerns(o, &command_table[i]))
            n += (size_t) snprintf(text + n, size - n, "%s%s", n ? ", " : "",
                                   command_table[i].name);
}

/* The row of that name for this command; NULL: it takes none such. */
static const struct option *option_for(const char *name,
                                       const struct command *c)
{
    for (const struct option *o = option_table; o->name; o++)
        if (option_concerns(o, c) && strcmp(o->name, name) == 0)
            return o;
    return NULL;
}

/* The name of one that may have been meant; NULL: none. */
static const char *option_nearest(const char *name)
{
    const char *known[sizeof option_table / sizeof *option_table];

    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        known[i] = option_table[i].name;
    return synonym_nearest(name, known);
}

/* ---- complaints ---------------------------------------------------------- */

/* One line; the words are the user's. */
static void complain(const char *before, const char *word, const char *after)
{
    fprintf(stderr, "slipway: %s%s%s\n", before, text_shown(word).text, after);
}

/* The same and exit 2: the command line is wrong. */
static _Noreturn void refuse(const char *before, const char *word,
                             const char *after)
{
    complain(before, word, after);
    exit(EXIT_USAGE);
}

/* The same; nearest: what may have been meant, or NULL. */
static _Noreturn void refuse_unknown(const char *before, const char *word,
                                     const char *nearest)
{
    char after[96];

    snprintf(after, sizeof after, "'%s%s%s (see slipway help)",
             nearest ? ", did you mean " : "", nearest ? nearest : "",
             nearest ? "?" : "");
    refuse(before, word, after);
}

/* "--states: knees takes none, expected it with push (see ...)" */
static void complain_foreign(const struct option *o, const struct command *c)
{
    char with[256], after[384];

    option_commands(o, with, sizeof with);
    snprintf(after, sizeof after, ": %s takes none%s%s (see slipway help %s)",
             c->name, with[0] ? ", expected it with " : "", with, c->name);
    complain("--", o->name, after);
}

/* ---- values -------------------------------------------------------------- */

/* Takes over one "key=value". */
static void add_text(struct options *o, char *text)
{
    if (text == NULL || o->sets == OPTIONS_SETS)
        refuse("--set ", text ? text : "", ": too many settings");
    o->set[o->sets++] = text;
}

char *options_setting(const char *key, const char *value, bool quoted)
{
    char *text = malloc(strlen(key) + 2 * strlen(value) + 4), *end = text;

    if (text == NULL)
        return NULL;
    end += sprintf(end, "%s=%s", key, quoted ? "'" : "");
    for (; *value; value++) {
        *end++ = *value;
        if (quoted && *value == '\'')
            *end++ = '\'';
    }
    strcpy(end, quoted ? "'" : "");
    return text;
}

/* "x=-2:2,y=-1:1" as window={x: [-2, 2], y: [-1, 1]}. */
static char *window_setting(const char *text)
{
    const size_t size = 4 * strlen(text) + 16;
    char *copy = strdup(text), *rest = copy, *part, *out = malloc(size);
    size_t n = 0;

    if (copy == NULL || out == NULL)
        refuse("--window ", text, ": out of memory");
    n += (size_t) snprintf(out, size, "window={");
    while ((part = strsep(&rest, ",")) != NULL) {
        char *lo = strchr(part, '='), *hi = lo ? strchr(lo, ':') : NULL;
        if (hi == NULL || lo == part || strpbrk(part, "{}[]\"'"))
            refuse("--window ", text, ": expected x=LO:HI,y=LO:HI");
        *lo++ = *hi++ = '\0';
        n += (size_t) snprintf(out + n, size - n, "%s: [%s, %s]%s", part, lo,
                               hi, rest ? ", " : "}");
    }
    free(copy);
    return out;
}

static int read_count(const char *text)
{
    char *end;
    const long n = strtol(text, &end, 10);

    if (end == text || *end || n < 1 || n > 4096)
        refuse("--threads ", text, ": expected a number from 1 to 4096");
    return (int) n;
}

static const char *read_word(const struct option *row, const char *text)
{
    char before[64], list[128], after[160];

    if (text_index(text, row->words) >= 0)
        return row->words[text_index(text, row->words)];
    snprintf(before, sizeof before, "--%s ", row->name);
    text_list(row->words, list, sizeof list);
    snprintf(after, sizeof after, ": expected %s", list);
    refuse(before, text, after);
}

/* What the command does not take is only noted: options_suit complains. */
static void take(struct options *o, const struct option *named, char *value)
{
    const struct option *row = option_for(
        named->name, o->command ? o->command : &command_table[COMMAND_HELP]);
    void *at = row && row->at ? (char *) o + row->at : NULL;

    o->given |= UINT64_C(1) << (named - option_table);
    if (row == NULL)
        return;
    if (row->kind == OPTION_SETTING && strchr(value, '=') == NULL)
        refuse("--set ", value, ": expected KEY=VALUE");
    if (row->kind == OPTION_SETTING)
        add_text(o, strdup(value));
    if (row->kind == OPTION_RANGES)
        add_text(o, window_setting(value));
    else if (row->key)
        add_text(o, options_setting(row->key, row->value ? value : "true",
                                    row->kind == OPTION_FILE ||
                                        row->kind == OPTION_QUOTED));
    if (at && row->kind == OPTION_FLAG)
        *(bool *) at = true;
    else if (at && row->kind == OPTION_COUNT)
        *(int *) at = read_count(value);
    else if (at && row->kind == OPTION_WORD)
        *(const char **) at = read_word(row, value);
    else if (at)
        *(const char **) at = value;
}

/* ---- the command line ---------------------------------------------------- */

/* What stands there, in its order: the command it is for may come later. */
struct line {
    const struct option **option; /* owned; rows of that name */
    char **value;                 /* owned */
    size_t count;
    char **next, **end; /* arguments that are left */
};

/* --NAME VALUE, --NAME=VALUE, -n VALUE, -nVALUE */
static void read_option(struct line *l, char *argument)
{
    const size_t dashes = argument[1] == '-' ? 2 : 1;
    char *name = argument + dashes, *value = NULL;
    const size_t size = dashes == 2 ? strcspn(name, "=") : 1;
    const struct option *o = option_table;

    while (o->name && (dashes == 1 ? o->letter != *name
                                   : strncmp(o->name, name, size) != 0 ||
                                         o->name[size] != '\0'))
        o++;
    if (o->name == NULL)
        refuse_unknown("no option '", argument, option_nearest(name));
    if (name[size])
        value = name + size + dashes - 1;
    if (value && !o->value)
        refuse("", argument, ": takes no value (see slipway --help)");
    if (o->value && !value && l->next == l->end)
        refuse("", argument, ": missing value (see slipway --help)");
    l->value[l->count] = o->value && !value ? *l->next++ : value;
    l->option[l->count++] = o;
}

_Noreturn void options_refuse_command(const char *name)
{
    refuse_unknown("no command '", name, command_nearest(name));
}

static void add_argument(struct options *o, const char *argument)
{
    if (o->command != NULL)
        o->file[o->files++] = argument;
    else if ((o->command = command_find(argument)) == NULL)
        options_refuse_command(argument);
}

void options_parse(struct options *o, int argc, char *argv[])
{
    const size_t n = (size_t) argc + 1;
    struct line l = { .option = calloc(n, sizeof *l.option),
                      .value = calloc(n, sizeof *l.value),
                      .next = argv + 1,
                      .end = argv + argc };
    bool arguments = false; /* only these are left */

    *o = (struct options){ .file = calloc(n, sizeof *o->file) };
    if (o->file == NULL || l.option == NULL || l.value == NULL)
        refuse("", "command line", ": out of memory");
    while (l.next < l.end) {
        char *argument = *l.next++;
        if (arguments || argument[0] != '-' || argument[1] == '\0')
            add_argument(o, argument);
        else if (strcmp(argument, "--") == 0)
            arguments = true;
        else
            read_option(&l, argument);
    }
    for (size_t i = 0; i < l.count; i++)
        take(o, l.option[i], l.value[i]);
    free(l.option);
    free(l.value);
}

void options_free(struct options *o)
{
    for (size_t i = 0; i < o->sets; i++)
        free(o->set[i]);
    o->sets = 0;
    free(o->file);
    o->file = NULL;
}

/* A setting of output.*, and what writes is not asked by -o alone. */
static const char *foreign_setting(const struct options *o,
                                   const struct command *c)
{
    const struct option *row = option_for("output", c);

    for (size_t i = 0; i < o->sets && !(row && row->key); i++)
        if (strncmp(o->set[i], "output", 6) == 0)
            return o->set[i];
    return NULL;
}

bool options_suit(const struct options *o, const struct command *c)
{
    const char *setting = foreign_setting(o, c);
    const bool many = o->files > c->most;
    char after[96];

    for (const struct option *row = option_table; row->name; row++)
        if (o->given >> (row - option_table) & 1u &&
            !option_for(row->name, c)) {
            complain_foreign(row, c);
            return false;
        }
    if (!setting && !many)
        return true;
    snprintf(after, sizeof after, ": %s (see slipway help %s)",
             many ? "one argument too many" : "not a setting here", c->name);
    complain(many ? "" : "--set ", many ? o->file[c->most] : setting, after);
    return false;
}
