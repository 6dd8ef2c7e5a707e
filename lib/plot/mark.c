#include "mark.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void mark_number(char *out, size_t size, double x, int digits)
{
    const char *minus = x < 0 ? "\xe2\x88\x92" : "";
    const double most = fabs(x);
    char text[64];

    snprintf(text, sizeof text, "%.*g", digits, most);
    if (x == 0 || (most >= 1e-3 && most < 1e5 && !strchr(text, 'e'))) {
        snprintf(out, size, "%s%s", minus, text);
        return;
    }
    /* rounded first: 9.996e-5 to three digits is 1e-4 */
    snprintf(text, sizeof text, "%.*e", digits - 1, most);
    char *end;
    const double factor = strtod(text, NULL);
    for (end = text; *end && *end != 'e'; end++)
        continue;
    const int power = *end ? atoi(end + 1) : 0;
    snprintf(out, size,
             "%s%.*g\xc3\x97"
             "10" SUPER("%s%d"),
             minus, digits, factor / pow(10, power),
             power < 0 ? "\xe2\x88\x92" : "", abs(power));
}

void mark_name(char *out, size_t size, const char *name)
{
    const char *under = strchr(name, '_');

    if (under && under > name && under[1])
        snprintf(out, size, ITALIC("%.*s") SUB("%s"), (int) (under - name),
                 name, under + 1);
    else
        snprintf(out, size, ITALIC("%s"), name);
}

void mark_plain(const char *text, char *out, size_t size)
{
    size_t n = 0;

    for (; *text && n + 1 < size; text++)
        if (*text == MARK_SUB || *text == MARK_SUPER)
            out[n++] = *text == MARK_SUB ? '_' : '^';
        else if (*text != MARK_ITALIC && *text != MARK_END)
            out[n++] = *text;
    out[n] = '\0';
}
