/* The shells' scripts only ask: what may follow is told by the program itself,
 * out of its tables. */
#include "completion.h"

#include <string.h>

#include "law.h"
#include "options.h"
#include "schema.h"
#include "texts.h"
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

void completion_offer(FILE *out, const char *const word[], size_t count)
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

void completion_print(FILE *out, const char *shell)
{
    for (size_t i = 0; i < sizeof shells / sizeof *shells; i++)
        if (strcmp(shell, shells[i].shell) == 0)
            fputs(shells[i].script, out);
}
