/* slipway help, --help; and help --as, which writes pages for other programs.
 */
#include <ctype.h>
#include <stdio.h>
#include <string.h>

#include "catalogue.h"
#include "command.h"
#include "law.h"
#include "options.h"
#include "reference.h"
#include "schema.h"
#include "texts.h"
#include "value.h"

/* ---- completion ---------------------------------------------------------- */

/* The shells' scripts only ask: what may follow is told by the program itself,
 * out of its tables. */

/* ---- what may follow ----------------------------------------------------- */

/* The i-th word that an option's value may be; NULL past the last. */
static const char *word_at(const struct option *o, size_t i)
{
    const struct schema_key *key = o->key ? schema_find(o->key) : NULL;
    const char *const *words = o->words ? o->words : key ? key->words : NULL;

    if (o->kind == OPTION_SETTING)
        return schema_table[i].path;
    if (key && key->read == value_preset)
        return law_preset_at(i) ? law_preset_at(i)->preset : NULL;
    return o->value && words ? words[i] : NULL;
}

/* Where the cursor is: the start of a word, which others may follow from. */
struct cursor {
    FILE *out;
    const char *now;
    size_t value; /* where the value begins in --NAME=VALUE; else 0 */
};

static void offer(const struct cursor *at, const char *before, const char *word,
                  const char *after, const char *text)
{
    char whole[256];

    snprintf(whole, sizeof whole, "%.*s%s%s%s", (int) at->value, at->now,
             before, word, after);
    if (strncmp(whole, at->now, strlen(at->now)) == 0)
        fprintf(at->out, "%s\t%s\n", whole, text);
}

static void offer_value(const struct cursor *at, const struct option *o)
{
    const char *word;

    if (o->kind == OPTION_FILE)
        fputs(":file\t*\n", at->out);
    if (o->kind == OPTION_FOLDER)
        fputs(":folder\t*\n", at->out);
    for (size_t i = 0; (word = word_at(o, i)) != NULL; i++)
        offer(at, "", word, o->kind == OPTION_SETTING ? "=" : "", "");
}

static void offer_commands(const struct cursor *at)
{
    for (int i = 0; i < COMMANDS; i++)
        offer(at, "", command_table[i].name, "", command_table[i].text);
}

/* Those of c; NULL: those of every command. */
static void offer_options(const struct cursor *at, const struct command *c)
{
    for (const struct option *o = option_table; o->name; o++)
        if (c ? option_concerns(o, c) : o->commands == (1u << COMMANDS) - 1u)
            offer(at, "--", o->name, "", o->text);
}

/* Files that end as those that the command takes. */
static void offer_files(FILE *out, const struct command *c)
{
    static const char *const known[] = { ".yaml", ".h5", ".csv" };

    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        if (strstr(c->arguments, known[i]))
            fprintf(out, ":file\t*%s\n", known[i]);
}

/* The option of c with a value of which a word's first `size` bytes are the
 * name; NULL: none. */
static const struct option *option_in(const char *word, size_t size,
                                      const struct command *c)
{
    for (const struct option *o = option_table; o->name; o++)
        if (o->value && option_concerns(o, c) &&
            ((size == 2 && word[0] == '-' && word[1] == o->letter) ||
             (size == strlen(o->name) + 2 && strncmp(word, "--", 2) == 0 &&
              strncmp(word + 2, o->name, size - 2) == 0)))
            return o;
    return NULL;
}

/* What may stand where the cursor is, in the last of the words after the
 * program's name: lines of a word, a tab and what it means; ":file" and
 * ":folder" with a pattern for files. */
static void completion_offer(FILE *out, const char *const word[], size_t count)
{
    const struct command *c = count > 1 ? command_find(word[0]) : NULL;
    const char *now = count > 0 ? word[count - 1] : "";
    struct cursor at = { out, strcmp(now, "=") == 0 ? "" : now, 0 };

    if (count < 2) {
        offer_commands(&at);
        offer_options(&at, NULL);
    }
    if (c == NULL)
        return;
    /* bash makes a word of '=' */
    const size_t name = strcspn(now, "=");
    const char *before = word[count - 2];
    if (strcmp(before, "=") == 0 && count > 3)
        before = word[count - 3];
    const struct option *o = option_in(before, strlen(before), c);
    if (o == NULL && now[name] && (o = option_in(now, name, c)) != NULL)
        at.value = name + 1;
    if (o)
        offer_value(&at, o);
    else if (now[0] == '-')
        offer_options(&at, c);
    else if (command_id(c) == COMMAND_HELP)
        offer_commands(&at);
    else
        offer_files(out, c);
}

/* ---- shells -------------------------------------------------------------- */

static const struct {
    const char *shell, *script;
} shells[] = { { "bash", text_bash },
               { "zsh", text_zsh },
               { "fish", text_fish } };

/* A script for "bash", "zsh" or "fish", which asks `help --as complete`;
 * nothing for others. */
static void completion_print(FILE *out, const char *shell)
{
    for (size_t i = 0; i < sizeof shells / sizeof *shells; i++)
        if (strcmp(shell, shells[i].shell) == 0)
            fputs(shells[i].script, out);
}

/* ---- manual -------------------------------------------------------------- */

/* As roff text: a hyphen that can be searched for, no macro or escape. */
static void put_text(FILE *out, const char *text)
{
    if (*text == '.' || *text == '\'')
        fputs("\\&", out);
    for (; *text; text++)
        switch (*text) {
            case '\\':
                fputs("\\e", out);
                break;
            case '-':
                fputs("\\-", out);
                break;
            case '\'':
                fputs("\\(aq", out);
                break;
            default:
                fputc(*text, out);
        }
}

static void put_line(FILE *out, const char *before, const char *text,
                     const char *after)
{
    fputs(before, out);
    put_text(out, text);
    fprintf(out, "%s\n", after);
}

static void put_head(FILE *out, const char *command)
{
    const char *dash = command ? "\\-" : "", *name = command ? command : "";

    fprintf(out, ".TH SLIPWAY%s", dash);
    for (const char *c = name; *c; c++)
        fputc(toupper((unsigned char) *c), out);
    fprintf(out, " 1 \"\" \"Slipway %s\" Slipway\n.SH NAME\nslipway%s%s \\- ",
            SLIPWAY_VERSION, dash, name);
}

/* On the page of all commands also the commands that take it. */
static void manual_put_option(FILE *out, const struct option *o, bool general)
{
    char only[256] = "";

    fputs(".TP\n", out);
    if (o->letter)
        fprintf(out, "\\fB\\-%c\\fR, ", o->letter);
    fputs("\\fB\\-\\-", out);
    put_text(out, o->name);
    fprintf(out, "\\fR%s%s%s\n", o->value ? "=\\fI" : "",
            o->value ? o->value : "", o->value ? "\\fR" : "");
    if (general)
        option_commands(o, only, sizeof only);
    fprintf(out, "%s%s", only, only[0] ? ": " : "");
    put_line(out, "", o->text, "");
}

/* Those that one command takes; of NULL: all. */
static void manual_put_options(FILE *out, const struct command *c)
{
    fputs(".SH OPTIONS\n", out);
    for (const struct option *o = option_table; o->name; o++)
        if (!c || option_concerns(o, c))
            manual_put_option(out, o, !c);
}

static void put_end(FILE *out)
{
    fputs(".SH EXIT STATUS\n", out);
    for (const struct exit_line *e = exit_lines; e->code; e++)
        fprintf(out, ".TP\n%s\n%s\n", e->code, e->text);
}

static void manual_put_commands(FILE *out)
{
    fputs(".SH COMMANDS\n", out);
    for (const struct command *c = command_table; c < command_table + COMMANDS;
         c++) {
        fprintf(out, ".TP\n\\fB%s\\fR ", c->name);
        put_line(out, "\\fI", c->arguments, "\\fR");
        put_line(out, "", c->text, "");
    }
}

/* slipway(1): all commands and all options, in roff's man macros. */
static void manual_print(FILE *out)
{
    put_head(out, NULL);
    fputs("phase planes of rate\\-and\\-state friction\n"
          ".SH SYNOPSIS\n"
          "\\fBslipway\\fR \\fICOMMAND\\fR [\\fISCENE.yaml\\fR] "
          "[\\fIoptions\\fR]\n"
          ".SH DESCRIPTION\n"
          "Slipway takes a friction law and a slope, and finds the steady "
          "states of a block on it,\nthe manifolds of the saddle, the basins "
          "these separate and the critical numbers they imply,\neach with an "
          "error.\nWhat to compute is a scene, a YAML file; every key of it "
          "can be set by \\fB\\-\\-set\\fR.\n",
          out);
    manual_put_commands(out);
    manual_put_options(out, NULL);
    put_end(out);
    fputs(".SH SEE ALSO\n", out);
    for (int i = 0; i < COMMANDS; i++)
        fprintf(out, "%s.BR slipway\\-%s (1)", i ? " ,\n" : "",
                command_table[i].name);
    fputs("\n", out);
}

/* slipway-COMMAND(1): one command and the options that it takes. */
static void manual_print_command(FILE *out, const struct command *c)
{
    put_head(out, c->name);
    put_line(out, "", c->text, "");
    fprintf(out, ".SH SYNOPSIS\n\\fBslipway %s\\fR ", c->name);
    put_line(out, "\\fI", c->arguments, "\\fR [\\fIoptions\\fR]");
    put_line(out, ".SH DESCRIPTION\n", c->about, "");
    manual_put_options(out, c);
    put_line(out, ".SH EXAMPLES\n.nf\n", c->example, "\n.fi");
    put_end(out);
    fputs(".SH SEE ALSO\n.BR slipway (1)\n", out);
}

enum { WIDTH = 79, OPTION_INDENT = 26 };

/* In lines of at most WIDTH letters, each behind so many blanks; the first
 * begins at that column. */
static void put_wrapped(FILE *out, int indent, const char *text)
{
    const size_t room = (size_t) (WIDTH - indent);

    for (bool first = true; *text; first = false) {
        size_t n = strlen(text);
        if (n > room)
            for (n = room; n > 0 && text[n] != ' ';)
                n--;
        fprintf(out, "%*s%.*s\n", first ? 0 : indent, "", (int) n, text);
        text += n;
        text += strspn(text, " ");
    }
}

/* ---- options ------------------------------------------------------------- */

/* "  -o, --output=FILE    what it does"; on the general page also where. */
static void put_option(FILE *out, const struct option *o, bool general)
{
    char name[64], only[256] = "", text[512];
    const char letter[] = { '-', o->letter, ',', '\0' };

    snprintf(name, sizeof name, "  %3s --%s%s%s", o->letter ? letter : "",
             o->name, o->value ? "=" : "", o->value ? o->value : "");
    if (general)
        option_commands(o, only, sizeof only);
    snprintf(text, sizeof text, "%s%s%s", only, only[0] ? ": " : "", o->text);
    if (strlen(name) + 1 > OPTION_INDENT) /* the text below a long name */
        fprintf(out, "%s\n%*s", name, OPTION_INDENT, "");
    else
        fprintf(out, "%-*s", OPTION_INDENT, name);
    put_wrapped(out, OPTION_INDENT, text);
}

static void put_options(FILE *out, const struct command *c)
{
    fputs("Options:\n", out);
    for (const struct option *o = option_table; o->name; o++)
        if (c == NULL || option_concerns(o, c))
            put_option(out, o, c == NULL);
}

/* ---- commands ------------------------------------------------------------ */

static void put_commands(FILE *out)
{
    fprintf(out, "Commands:\n");
    for (const struct command *c = command_table; c < command_table + COMMANDS;
         c++)
        fprintf(out, "  %-10s %-15s %s\n", c->name, c->arguments, c->text);
    fprintf(out, "\nExamples:\n");
    for (const struct command *c = command_table; c < command_table + COMMANDS;
         c++)
        fprintf(out, "  %s\n", c->example);
    fprintf(out, "\nExit status: 0 done (also when something does not exist), "
                 "1 a check failed,\n2 wrong command line or scene, 3 "
                 "numerical failure, 4 file trouble.\n");
}

void help_print(FILE *out, const struct command *c)
{
    if (c == NULL) {
        fputs("Usage: slipway COMMAND [SCENE.yaml] [options]\n"
              "Phase planes of rate-and-state friction: steady states, the "
              "saddle's manifolds,\ncritical velocities.\n\n",
              out);
        put_options(out, NULL);
        fputc('\n', out);
        put_commands(out);
        return;
    }
    fprintf(out, "slipway %s %s\n  %s\n  ", c->name, c->arguments, c->text);
    put_wrapped(out, 2, c->about);
    put_options(out, c);
    fprintf(out, "Example:\n  %s\n", c->example);
}

/* ---- the command --------------------------------------------------------- */

/* What --as can write; all but man pages know no single command. */
static enum exit_code help_as(const char *format, const struct command *c)
{
    enum status status = STATUS_OK;
    char text[64];

    if (c && strcmp(format, "man") == 0)
        manual_print_command(stdout, c);
    else if (c) {
        snprintf(text, sizeof text, "help: %s: expected --as man", c->name);
        return command_fail(STATUS_BAD_ARGUMENT, text);
    } else if (strcmp(format, "man") == 0)
        manual_print(stdout);
    else if (strcmp(format, "scene") == 0)
        reference_scene(stdout);
    else if (strcmp(format, "hdf5") == 0)
        status = reference_hdf5(stdout);
    else if (strcmp(format, "words") == 0)
        reference_words(stdout);
    else
        completion_print(stdout, format);
    return status == STATUS_OK ? EXIT_DONE : command_fail(status, "");
}

enum exit_code command_help(const struct options *o)
{
    if (o->as && strcmp(o->as, "complete") == 0) {
        completion_offer(stdout, o->file, o->files);
        return EXIT_DONE;
    }
    if (o->files > 1) {
        char text[512];
        snprintf(text, sizeof text, "help: %.300s: one argument too many",
                 o->file[1]);
        return command_fail(STATUS_BAD_ARGUMENT, text);
    }
    const struct command *c = o->files ? command_find(o->file[0]) : NULL;

    if (o->files > 0 && c == NULL)
        options_refuse_command(o->file[0]);
    if (o->as)
        return help_as(o->as, c);
    if (c) {
        help_print(stdout, c);
        return EXIT_DONE;
    }
    fputs("Usage: slipway COMMAND [SCENE.yaml] [options]   (options: slipway "
          "--help)\n\n",
          stdout);
    put_commands(stdout);
    return EXIT_DONE;
}
