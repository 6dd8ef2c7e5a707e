#include "completion.h"

#include <string.h>

#include "law.h"
#include "schema.h"

/* ---- what may follow ----------------------------------------------------- */

static void put_keys(FILE *out)
{
    for (const struct schema_key *key = schema_table; key->path; key++)
        fprintf(out, "%s%s=", key == schema_table ? "" : " ", key->path);
}

static void put_laws(FILE *out)
{
    const struct law *law;

    for (size_t i = 0; (law = law_preset_at(i)) != NULL; i++)
        fprintf(out, "%s%s", i ? " " : "", law->preset);
}

static void put_forms(FILE *out)
{
    for (size_t i = 0; friction_form_names[i]; i++)
        fprintf(out, "%s%s", i ? " " : "", friction_form_names[i]);
}

static void put_progress(FILE *out)
{
    fputs("auto json none", out);
}

static void put_formats(FILE *out)
{
    fputs("man bash zsh fish scene hdf5 words xppaut auto", out);
}

static void put_kinds(FILE *out)
{
    fputs("arclength time", out);
}

/* An option's value that is one of some words. */
static const struct choice {
    const char *value; /* as the table of options calls it */
    void (*put_words)(FILE *out);
} choices[] = {
    { "KEY=VALUE", put_keys }, { "NAME", put_laws },      { "FORM", put_forms },
    { "HOW", put_progress },   { "FORMAT", put_formats }, { "KIND", put_kinds },
};
enum { CHOICES = sizeof choices / sizeof *choices };

static bool is(const char *value, const char *what)
{
    return value && strcmp(value, what) == 0;
}

static const struct choice *choice_of(const struct option_line *o)
{
    for (int i = 0; i < CHOICES; i++)
        if (is(o->value, choices[i].value))
            return &choices[i];
    return NULL;
}

/* How the files that a command takes end; NULL: it takes none. */
static const char *ending_of(const struct command *c)
{
    static const char *const known[] = { "yaml", "h5", "csv" };

    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        const char *found = strstr(c->arguments, known[i]);
        if (found && found > c->arguments && found[-1] == '.')
            return known[i];
    }
    return NULL;
}

static void put_commands(FILE *out)
{
    const struct command *c;

    for (size_t i = 0; (c = command_at(i)) != NULL; i++)
        fprintf(out, "%s%s", i ? " " : "", c->name);
}

/* Within single quotes; `special` takes a backslash, and a quote becomes
 * `quote`. */
static void put_quoted(FILE *out, const char *text, const char *special,
                       const char *quote)
{
    for (; *text; text++)
        if (*text == '\'')
            fputs(quote, out);
        else
            fprintf(out, "%s%c", strchr(special, *text) ? "\\" : "", *text);
}

/* ---- bash ---------------------------------------------------------------- */

/* "    --data|--states)", the options whose values are `value`. */
static void bash_pattern(FILE *out, const char *value)
{
    struct option_line o;
    const char *bar = "    ";

    for (size_t i = 0; options_at(i, &o); i++) {
        if (!is(o.value, value))
            continue;
        fprintf(out, "%s--%s", bar, o.name);
        bar = "|";
        if (o.letter)
            fprintf(out, "|-%c", o.letter);
    }
    fputs(")\n", out);
}

static void bash_values(FILE *out)
{
    struct option_line o;

    fputs("    case $before in\n", out);
    bash_pattern(out, "FILE");
    fputs("        offer -f; return ;;\n", out);
    bash_pattern(out, "DIR");
    fputs("        offer -d; return ;;\n", out);
    for (int i = 0; i < CHOICES; i++) {
        bash_pattern(out, choices[i].value);
        if (is("KEY=VALUE", choices[i].value))
            fputs("        compopt -o nospace\n", out);
        fputs("        offer -W '", out);
        choices[i].put_words(out);
        fputs("'; return ;;\n", out);
    }
    for (size_t i = 0; options_at(i, &o); i++)
        if (o.value && !choice_of(&o) && !is(o.value, "FILE") &&
            !is(o.value, "DIR"))
            fprintf(out, "    --%s) return ;;\n", o.name);
    fputs("    esac\n", out);
}

static void bash_command(FILE *out, const struct command *c)
{
    const char *ending = ending_of(c);
    struct option_line o;

    fprintf(out, "    %s)\n        options='", c->name);
    for (size_t i = 0; options_at(i, &o); i++)
        if (options_concern(&o, c->name))
            fprintf(out, "--%s ", o.name);
    fprintf(out, "' ending='%s' ;;\n", ending ? ending : "");
}

static void bash_print(FILE *out)
{
    const struct command *c;

    fputs("# bash completion for slipway; made by: slipway help --as bash\n"
          "_slipway() {\n"
          "    local now=$2 before=$3 commands options='' ending=''\n"
          "    offer() { mapfile -t COMPREPLY < "
          "<(compgen \"$@\" -- \"$now\"); }\n"
          "    if [ \"$now\" = '=' ]; then now=''; fi\n"
          "    if [ \"$before\" = '=' ]; then\n"
          "        before=${COMP_WORDS[COMP_CWORD-2]}\n"
          "    fi\n"
          "    compopt -o filenames 2>/dev/null\n"
          "    commands='",
          out);
    put_commands(out);
    fputs("'\n", out);
    bash_values(out);
    fputs("    compopt +o filenames 2>/dev/null\n"
          "    if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
          "        offer -W \"$commands --help --version\"; return\n"
          "    fi\n"
          "    case ${COMP_WORDS[1]} in\n",
          out);
    for (size_t i = 0; (c = command_at(i)) != NULL; i++)
        bash_command(out, c);
    fputs("    esac\n"
          "    if [[ $now == -* ]]; then\n"
          "        offer -W \"$options\"\n"
          "    elif [ \"${COMP_WORDS[1]}\" = help ]; then\n"
          "        offer -W \"$commands\"\n"
          "    elif [ -n \"$ending\" ]; then\n"
          "        compopt -o filenames 2>/dev/null\n"
          "        offer -f -X \"!*.$ending\" -o plusdirs\n"
          "    fi\n"
          "}\n"
          "complete -F _slipway slipway\n",
          out);
}

/* ---- zsh ----------------------------------------------------------------- */

/* '(-o --output)'{-o,--output=}'[What it does]:FILE:_files' */
static void zsh_option(FILE *out, const struct option_line *o)
{
    const struct choice *choice = choice_of(o);

    fputs("            ", out);
    if (o->letter)
        fprintf(out, "'(-%c --%s)'{-%c%s,--%s%s}", o->letter, o->name,
                o->letter, o->value ? "+" : "", o->name, o->value ? "=" : "");
    else
        fprintf(out, "'%s--%s%s'", is(o->value, "KEY=VALUE") ? "*" : "",
                o->name, o->value ? "=" : "");
    fputs("'[", out);
    put_quoted(out, o->text, "[]\\:", "'\\''");
    fputs("]", out);
    if (o->value)
        fprintf(out, ":%s:", o->value);
    if (choice) {
        fputs(is(o->value, "KEY=VALUE") ? "{compadd -S \"\" -- " : "(", out);
        choice->put_words(out);
        fputs(is(o->value, "KEY=VALUE") ? "}" : ")", out);
    }
    if (is(o->value, "FILE"))
        fputs("_files", out);
    if (is(o->value, "DIR"))
        fputs("_files -/", out);
    fputs("' \\\n", out);
}

static void zsh_command(FILE *out, const struct command *c)
{
    const char *ending = ending_of(c);
    struct option_line o;

    fprintf(out, "    %s)\n        _arguments \\\n", c->name);
    for (size_t i = 0; options_at(i, &o); i++)
        if (options_concern(&o, c->name))
            zsh_option(out, &o);
    if (strcmp(c->name, "help") == 0)
        fputs("            '1:command:{_describe command commands}' ;;\n", out);
    else if (ending)
        fprintf(out, "            '*:%s:_files -g \"*.%s\"' ;;\n", ending,
                ending);
    else
        fputs("            ;;\n", out);
}

static void zsh_print(FILE *out)
{
    const struct command *c;

    fputs("#compdef slipway\n"
          "# made by: slipway help --as zsh\n"
          "_slipway() {\n"
          "    local -a commands\n"
          "    commands=(\n",
          out);
    for (size_t i = 0; (c = command_at(i)) != NULL; i++) {
        fprintf(out, "        '%s:", c->name);
        put_quoted(out, c->text, "\\:", "'\\''");
        fputs("'\n", out);
    }
    fputs("    )\n"
          "    if (( CURRENT == 2 )); then\n"
          "        _describe command commands\n"
          "        return\n"
          "    fi\n"
          "    shift words\n"
          "    (( CURRENT-- ))\n"
          "    case $words[1] in\n",
          out);
    for (size_t i = 0; (c = command_at(i)) != NULL; i++)
        zsh_command(out, c);
    fputs("    esac\n"
          "}\n"
          "_slipway \"$@\"\n",
          out);
}

/* ---- fish ---------------------------------------------------------------- */

/* The commands that take an option, or nothing where all do. */
static void fish_condition(FILE *out, const struct option_line *o)
{
    const struct command *c;
    const char *start = " -n '__fish_seen_subcommand_from ", *gap = start;

    if (o->general)
        return;
    for (size_t i = 0; (c = command_at(i)) != NULL; i++)
        if (options_concern(o, c->name)) {
            fprintf(out, "%s%s", gap, c->name);
            gap = " ";
        }
    fputs("'", out);
}

static void fish_option(FILE *out, const struct option_line *o)
{
    const struct choice *choice = choice_of(o);

    fputs("complete -c slipway", out);
    fish_condition(out, o);
    fprintf(out, " -l %s", o->name);
    if (o->letter)
        fprintf(out, " -s %c", o->letter);
    if (is(o->value, "FILE"))
        fputs(" -rF", out);
    else if (is(o->value, "DIR"))
        fputs(" -xa '(__fish_complete_directories)'", out);
    else if (o->value)
        fputs(" -x", out);
    if (choice) {
        fputs(" -a '", out);
        choice->put_words(out);
        fputs("'", out);
    }
    fputs(" -d '", out);
    put_quoted(out, o->text, "\\", "\\'");
    fputs("'\n", out);
}

static void fish_command(FILE *out, const struct command *c)
{
    const char *ending = ending_of(c);

    fprintf(out, "complete -c slipway -n __fish_use_subcommand -a %s -d '",
            c->name);
    put_quoted(out, c->text, "\\", "\\'");
    fputs("'\n", out);
    if (ending)
        fprintf(out,
                "complete -c slipway -n '__fish_seen_subcommand_from %s' "
                "-ka '(__fish_complete_suffix .%s)'\n",
                c->name, ending);
}

static void fish_print(FILE *out)
{
    const struct command *c;
    struct option_line o;

    fputs("# made by: slipway help --as fish\n"
          "complete -c slipway -f\n",
          out);
    for (size_t i = 0; (c = command_at(i)) != NULL; i++)
        fish_command(out, c);
    fputs("complete -c slipway -n '__fish_seen_subcommand_from help' -a '",
          out);
    put_commands(out);
    fputs("'\n", out);
    for (size_t i = 0; options_at(i, &o); i++)
        fish_option(out, &o);
}

enum exit_code completion_print(FILE *out, const char *shell)
{
    if (is(shell, "bash"))
        bash_print(out);
    else if (is(shell, "zsh"))
        zsh_print(out);
    else if (is(shell, "fish"))
        fish_print(out);
    else
        return command_fail(
            STATUS_BAD_ARGUMENT,
            "--as: expected man, bash, zsh, fish, scene, hdf5 or "
            "words");
    return EXIT_DONE;
}
