#include "text_file.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "text.h"

static enum status cannot_read(const char *path, struct fault *why)
{
    const char *reason = strerror(errno);
    char shown[300];

    text_show_end(path, shown, sizeof shown);
    snprintf(why->text, sizeof why->text, "%s: cannot read: %s", shown, reason);
    return STATUS_IO;
}

/* *text, first NULL, is owned by the caller, whatever is returned. */
static enum status read_open(FILE *file, size_t most, char **text, size_t *size)
{
    size_t room = 2048;

    errno = 0;
    do {
        room *= 2;
        char *grown = realloc(*text, room + 1);
        if (grown == NULL)
            return STATUS_NO_MEMORY;
        *text = grown;
        *size += fread(*text + *size, 1, room - *size, file);
    } while (*size == room && *size <= most);
    (*text)[*size] = '\0';
    return ferror(file) ? STATUS_IO : STATUS_OK;
}

enum status text_file_read(const char *path, size_t most, char **text,
                           size_t *size, struct fault *why)
{
    FILE *file = fopen(path, "rb");

    *text = NULL;
    *size = 0;
    if (file == NULL)
        return cannot_read(path, why);
    enum status s = read_open(file, most, text, size);
    if (s == STATUS_IO)
        s = cannot_read(path, why);
    fclose(file);
    if (s != STATUS_OK) {
        free(*text);
        *text = NULL;
    }
    return s;
}
