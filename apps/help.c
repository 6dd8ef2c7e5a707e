/* slipway help, --help; and help --as, which writes pages for other programs.
 */
#include "help.h"

#include <string.h>

#include "command.h"
#include "completion.h"
#include "manual.h"
#include "reference.h"

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
