#include "completion.h"

#include <string.h>

#include "law.h"
#include "options.h"
#include "schema.h"
#include "value.h"

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

static void put_words(FILE *out, const char *before, const struct option *o,
                      const char *after)
{
    const char *word, *end = o->kind == OPTION_SETTING ? "=" : "";

    for (size_t i = 0; (word = word_at(o, i)) != NULL; i++)
        fprintf(out, "%s%s%s", i ? " " : before, word, end);
    if (word_at(o, 0))
        fputs(after, out);
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
    for (int i = 0; i < COMMANDS; i++)
        fprintf(out, "%s%s", i ? " " : "", command_table[i].name);
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

/* "    push:--v|simulate:--v)", or "*:--law)" of what most commands take. */
static void bash_pattern(FILE *out, const struct option *o)
{
    const char *gap = "    ";

    for (int i = 0; i < COMMANDS; i++) {
        const char *name = command_table[i].name;
        if (!option_concerns(o, &command_table[i]))
            continue;
        if (option_is_common(o))
            name = "*";
        fprintf(out, "%s%s:--%s", gap, name, o->name);
        if (o->letter)
            fprintf(out, "|%s:-%c", name, o->letter);
        gap = "|";
        if (option_is_common(o))
            break;
    }
    fputs(")\n", out);
}

static void bash_value(FILE *out, const struct option *o)
{
    if (o->value == NULL)
        return;
    bash_pattern(out, o);
    if (o->kind == OPTION_FILE)
        fputs("        offer -f\n", out);
    if (o->kind == OPTION_FOLDER)
        fputs("        offer -d\n", out);
    if (o->kind == OPTION_SETTING)
        fputs("        compopt -o nospace\n", out);
    put_words(out, "        offer -W '", o, "'\n");
    fputs("        return ;;\n", out);
}

static void bash_command(FILE *out, const struct command *c)
{
    const char *ending = ending_of(c);

    fprintf(out, "    %s)\n        options='", c->name);
    for (const struct option *o = option_table; o->name; o++)
        if (option_concerns(o, c))
            fprintf(out, "--%s ", o->name);
    fprintf(out, "' ending='%s' ;;\n", ending ? ending : "");
}

static void bash_print(FILE *out)
{
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
    fputs("'\n    case ${COMP_WORDS[1]}:$before in\n", out);
    for (const struct option *o = option_table; o->name; o++)
        bash_value(out, o);
    fputs("    esac\n"
          "    compopt +o filenames 2>/dev/null\n"
          "    if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
          "        offer -W \"$commands --help --version\"; return\n"
          "    fi\n"
          "    case ${COMP_WORDS[1]} in\n",
          out);
    for (int i = 0; i < COMMANDS; i++)
        bash_command(out, &command_table[i]);
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
static void zsh_option(FILE *out, const struct option *o)
{
    const bool setting = o->kind == OPTION_SETTING;

    fputs("            ", out);
    if (o->letter)
        fprintf(out, "'(-%c --%s)'{-%c%s,--%s%s}", o->letter, o->name,
                o->letter, o->value ? "+" : "", o->name, o->value ? "=" : "");
    else
        fprintf(out, "'%s--%s%s'", setting ? "*" : "", o->name,
                o->value ? "=" : "");
    fputs("'[", out);
    put_quoted(out, o->text, "[]\\:", "'\\''");
    fputs("]", out);
    if (o->value)
        fprintf(out, ":%s:", o->value);
    put_words(out, setting ? "{compadd -S \"\" -- " : "(", o,
              setting ? "}" : ")");
    if (o->kind == OPTION_FILE)
        fputs("_files", out);
    if (o->kind == OPTION_FOLDER)
        fputs("_files -/", out);
    fputs("' \\\n", out);
}

static void zsh_command(FILE *out, const struct command *c)
{
    const char *ending = ending_of(c);

    fprintf(out, "    %s)\n        _arguments \\\n", c->name);
    for (const struct option *o = option_table; o->name; o++)
        if (option_concerns(o, c))
            zsh_option(out, o);
    if (command_id(c) == COMMAND_HELP)
        fputs("            '1:command:{_describe command commands}' ;;\n", out);
    else if (ending)
        fprintf(out, "            '*:%s:_files -g \"*.%s\"' ;;\n", ending,
                ending);
    else
        fputs("            ;;\n", out);
}

static void zsh_print(FILE *out)
{
    fputs("#compdef slipway\n"
          "# made by: slipway help --as zsh\n"
          "_slipway() {\n"
          "    local -a commands\n"
          "    commands=(\n",
          out);
    for (int i = 0; i < COMMANDS; i++) {
        fprintf(out, "        '%s:", command_table[i].name);
        put_quoted(out, command_table[i].text, "\\:", "'\\''");
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
    for (int i = 0; i < COMMANDS; i++)
        zsh_command(out, &command_table[i]);
    fputs("    esac\n"
          "}\n"
          "_slipway \"$@\"\n",
          out);
}

/* ---- fish ---------------------------------------------------------------- */

/* The commands that take an option. */
static void fish_condition(FILE *out, const struct option *o)
{
    fputs(" -n '__fish_seen_subcommand_from", out);
    for (int i = 0; i < COMMANDS; i++)
        if (option_concerns(o, &command_table[i]))
            fprintf(out, " %s", command_table[i].name);
    fputs("'", out);
}

static void fish_option(FILE *out, const struct option *o)
{
    fputs("complete -c slipway", out);
    fish_condition(out, o);
    fprintf(out, " -l %s", o->name);
    if (o->letter)
        fprintf(out, " -s %c", o->letter);
    if (o->kind == OPTION_FILE)
        fputs(" -rF", out);
    else if (o->kind == OPTION_FOLDER)
        fputs(" -xa '(__fish_complete_directories)'", out);
    else if (o->value)
        fputs(" -x", out);
    put_words(out, " -a '", o, "'");
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
    fputs("# made by: slipway help --as fish\n"
          "complete -c slipway -f\n"
          "complete -c slipway -n __fish_use_subcommand -l help -l version\n",
          out);
    for (int i = 0; i < COMMANDS; i++)
        fish_command(out, &command_table[i]);
    fputs("complete -c slipway -n '__fish_seen_subcommand_from help' -a '",
          out);
    put_commands(out);
    fputs("'\n", out);
    for (const struct option *o = option_table; o->name; o++)
        fish_option(out, o);
}

void completion_print(FILE *out, const char *shell)
{
    if (strcmp(shell, "bash") == 0)
        bash_print(out);
    if (strcmp(shell, "zsh") == 0)
        zsh_print(out);
    if (strcmp(shell, "fish") == 0)
        fish_print(out);
}
