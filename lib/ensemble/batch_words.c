#include "batch_words.h"

#include <stdlib.h>
#include <string.h>

static size_t find(const struct batch_words *w, const char *text)
{
    size_t i = 0;

    while (i < w->count && strcmp(w->text[i], text) != 0)
        i++;
    return i;
}

static const char *add(struct batch_words *w, const char *text)
{
    if (w->count == w->room) {
        const size_t room = 2 * w->room + 8;
        char **more = realloc(w->text, room * sizeof *more);
        if (more == NULL)
            return NULL;
        w->text = more;
        w->room = room;
    }
    char *copy = strdup(text);
    if (copy)
        w->text[w->count++] = copy;
    return copy;
}

const char *batch_words_keep(struct batch_words *w, const char *text)
{
    const char *kept;

#pragma omp critical(batch_words)
    {
        const size_t i = find(w, text);
        kept = i < w->count ? w->text[i] : add(w, text);
    }
    return kept;
}

void batch_words_free(struct batch_words *w)
{
    for (size_t i = 0; i < w->count; i++)
        free(w->text[i]);
    free(w->text);
    *w = (struct batch_words){ .text = NULL };
}
