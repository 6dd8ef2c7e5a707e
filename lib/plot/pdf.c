#include "pdf.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Finds the key in text[0 .. size-1] and resets the digits behind it. */
static void reset_dates(char *text, size_t size)
{
    static const char key[] = "/CreationDate (D:";
    static const char epoch[] = "19700101000000";
    char *end = text + size, *at = text;
    while ((at = memmem(at, (size_t) (end - at), key, sizeof key - 1))) {
        at += sizeof key - 1;
        for (size_t k = 0; epoch[k] && at < end && isdigit((unsigned char) *at);
             k++)
            *at++ = epoch[k];
    }
}

static enum status pdf_rewrite(FILE *file)
{
    long size = 0;
    if (fseek(file, 0, SEEK_END) != 0 || (size = ftell(file)) < 0)
        return STATUS_IO;
    const size_t n = (size_t) size;
    char *text = malloc(n + 1);
    if (!text)
        return STATUS_NO_MEMORY;
    rewind(file);
    enum status s = STATUS_IO;
    if (fread(text, 1, n, file) == n) {
        reset_dates(text, n);
        rewind(file);
        if (fwrite(text, 1, n, file) == n)
            s = STATUS_OK;
    }
    free(text);
    return s;
}

enum status pdf_forget_date(const char *path)
{
    FILE *file = fopen(path, "r+");
    if (!file)
        return STATUS_IO;
    const enum status s = pdf_rewrite(file);
    return fclose(file) == 0 ? s : STATUS_IO;
}
