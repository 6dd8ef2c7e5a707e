#include "sweep_reason.h"

#include <ctype.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

/* Signs that are words when read aloud (at most 6 letters). */
static const char *spoken(char c)
{
    return c == '>' ? "above" : c == '<' ? "below" : c == '=' ? "equals" : "";
}

static bool is_letter(char c)
{
    return isalnum((unsigned char) c) || c == '_' || c == '.' || c == '+' ||
           c == '-';
}

/* A sentence with one underscore between words, and only what CF allows in
 * them (CF conventions, sec. 3.5): "v_minus_above_0". */
static char *word_of(const char *text)
{
    char *word = malloc(7 * strlen(text) + 1), *end = word;

    for (; word && *text; text++) {
        for (const char *c = spoken(*text); *c; c++)
            *end++ = *c;
        if (is_letter(*text))
            *end++ = *text;
        else if (end > word && end[-1] != '_')
            *end++ = '_';
    }
    while (word && end > word && (end[-1] == '_' || end[-1] == '.'))
        end--;
    if (word)
        *end = '\0';
    return word;
}

static enum status add(struct sweep_reasons *r, const char *text,
                       const char *word)
{
    char *copy = strdup(text), *code = word ? strdup(word) : word_of(text);

    if (copy == NULL || code == NULL) {
        free(copy);
        free(code);
        return STATUS_NO_MEMORY;
    }
    r->text[r->count] = copy;
    r->word[r->count++] = code;
    return STATUS_OK;
}

enum status sweep_reasons_init(struct sweep_reasons *r)
{
    *r = (struct sweep_reasons){ .count = 0 };
    enum status status = add(r, "there is no such number", "absent");
    if (status == STATUS_OK)
        status = add(r, "", "present");
    if (status != STATUS_OK)
        sweep_reasons_free(r);
    return status;
}

enum status sweep_reasons_code(struct sweep_reasons *r, const char *text,
                               int8_t *code)
{
    enum status status = STATUS_OK;
    size_t i = REASON_FIRST;

    while (i < r->count && strcmp(r->text[i], text) != 0)
        i++;
    if (i == REASONS_MAX)
        i = REASON_ABSENT;
    else if (i == r->count)
        status = add(r, text, NULL);
    if (status == STATUS_OK)
        *code = (int8_t) i;
    return status;
}

void sweep_reasons_free(struct sweep_reasons *r)
{
    for (size_t i = 0; i < r->count; i++) {
        free(r->text[i]);
        free(r->word[i]);
    }
    *r = (struct sweep_reasons){ .count = 0 };
}
