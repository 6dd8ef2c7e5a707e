#include "text_file.h"

#include <errno.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "text.h"

static enum status cannot_read(const char *path, struct fault *why)
{
    const char *reason = strerror(errno);
    char shown[300];

    text_show_end(path, shown, sizeof shown);
    return fault_set(why, STATUS_IO, "%s: cannot read: %s", shown, reason);
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

/* All that is left of standard input, behind what *to holds. */
static bool take_input(FILE *to)
{
    char bytes[4096];
    ssize_t n;

    while ((n = read(STDIN_FILENO, bytes, sizeof bytes)) > 0)
        fwrite(bytes, 1, (size_t) n, to);
    return n == 0 && fflush(to) == 0;
}

/* Standard input, which can be read but once, as a file without a name. */
static FILE *open_input(void)
{
    static FILE *kept;

    kept = kept ? kept : tmpfile();
    if (kept == NULL || !take_input(kept))
        return NULL;
    rewind(kept);
    const int fd = dup(fileno(kept));
    return fd < 0 ? NULL : fdopen(fd, "rb");
}

enum status text_file_read(const char *path, size_t most, char **text,
                           size_t *size, struct fault *why)
{
    FILE *file = strcmp(path, "-") == 0 ? open_input() : fopen(path, "rb");

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
