#include "manual.h"

#include <ctype.h>

#include "options.h"

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
static void put_option(FILE *out, const struct option *o, bool general)
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
static void put_options(FILE *out, const struct command *c)
{
    fputs(".SH OPTIONS\n", out);
    for (const struct option *o = option_table; o->name; o++)
        if (!c || option_concerns(o, c))
            put_option(out, o, !c);
}

static void put_end(FILE *out)
{
    fputs(".SH EXIT STATUS\n", out);
    for (const struct exit_line *e = exit_lines; e->code; e++)
        fprintf(out, ".TP\n%s\n%s\n", e->code, e->text);
}

static void put_commands(FILE *out)
{
    fputs(".SH COMMANDS\n", out);
    for (const struct command *c = command_table; c < command_table + COMMANDS;
         c++) {
        fprintf(out, ".TP\n\\fB%s\\fR ", c->name);
        put_line(out, "\\fI", c->arguments, "\\fR");
        put_line(out, "", c->text, "");
    }
}

void manual_print(FILE *out)
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
    put_commands(out);
    put_options(out, NULL);
    put_end(out);
    fputs(".SH SEE ALSO\n", out);
    for (int i = 0; i < COMMANDS; i++)
        fprintf(out, "%s.BR slipway\\-%s (1)", i ? " ,\n" : "",
                command_table[i].name);
    fputs("\n", out);
}

void manual_print_command(FILE *out, const struct command *c)
{
    put_head(out, c->name);
    put_line(out, "", c->text, "");
    fprintf(out, ".SH SYNOPSIS\n\\fBslipway %s\\fR ", c->name);
    put_line(out, "\\fI", c->arguments, "\\fR [\\fIoptions\\fR]");
    put_line(out, ".SH DESCRIPTION\n", c->about, "");
    put_options(out, c);
    put_line(out, ".SH EXAMPLES\n.nf\n", c->example, "\n.fi");
    put_end(out);
    fputs(".SH SEE ALSO\n.BR slipway (1)\n", out);
}
