#include "margin.h"

#include <math.h>
#include <stdlib.h>

bool margin_exists(const struct regions *r)
{
    size_t i = 1;

    while (i < r->count && r->region[i].label == r->region[0].label)
        i++;
    return i < r->count;
}

enum status margin_init(struct margin_line *l, const struct separatrix *one,
                        const struct separatrix *other)
{
    const size_t a = one ? one->count : 0, b = other ? other->count : 0;
    const size_t room = (a > b ? a : b) + 1;

    /* One line is found while another row is crossed for its labels. */
    *l = (struct margin_line){ .room = room };
    l->at = malloc(2 * room * sizeof *l->at);
    return l->at ? STATUS_OK : STATUS_NO_MEMORY;
}

/* The label between two crossings, either of which may be missing. */
static int8_t label_between(const struct regions *r,
                            const struct separatrix *cuts, double w, double lo,
                            double hi, struct crossing scratch[])
{
    const double middle = lo == -HUGE_VAL  ? (hi == HUGE_VAL ? 0.0 : hi - 1.0)
                          : hi == HUGE_VAL ? lo + 1.0
                                           : 0.5 * (lo + hi);
    const struct vec2 z = cuts->along == SEPARATRIX_Y
                              ? (struct vec2){ middle, w }
                              : (struct vec2){ w, middle };

    return r->region[regions_at(r, z, scratch)].label;
}

void margin_find(struct margin_line *l, const struct regions *r,
                 const struct separatrix *cuts, double w)
{
    struct crossing *scratch = l->at + l->room;
    const size_t n = separatrix_row(cuts, w, l->at);
    size_t kept = 0;

    int8_t last = label_between(r, cuts, w, -HUGE_VAL,
                                n > 0 ? l->at[0].at : HUGE_VAL, scratch);
    l->untold = last == REGION_UNLABELLED;
    for (size_t k = 0; k < n; k++) {
        const double hi = k + 1 < n ? l->at[k + 1].at : HUGE_VAL;
        const int8_t next = label_between(r, cuts, w, l->at[k].at, hi, scratch);
        l->untold = l->untold || next == REGION_UNLABELLED;
        if (next != last)
            l->at[kept++] = l->at[k];
        last = next;
    }
    l->count = kept;
}

double margin_at(const struct margin_line *l, double at, double *error)
{
    size_t k = 0;

    while (k < l->count && at >= l->at[k].at)
        k++;
    const double down = k > 0 ? at - l->at[k - 1].at : HUGE_VAL;
    const double up = k < l->count ? l->at[k].at - at : HUGE_VAL;

    if (down < up) {
        *error = l->at[k - 1].error;
        return -down;
    }
    *error = k < l->count ? l->at[k].error : HUGE_VAL;
    return up;
}

enum status margin_states(const struct regions *r,
                          const struct separatrix along[2],
                          const struct vec2 z[], size_t n, double x[],
                          double y[])
{
    struct margin_line l;
    const enum status s = margin_init(&l, &along[0], &along[1]);
    double error;

    if (s != STATUS_OK)
        return s;
    for (size_t i = 0; i < n; i++) {
        margin_find(&l, r, &along[SEPARATRIX_Y], z[i].y);
        x[i] = margin_at(&l, z[i].x, &error);
        margin_find(&l, r, &along[SEPARATRIX_X], z[i].x);
        y[i] = margin_at(&l, z[i].y, &error);
    }
    margin_free(&l);
    return STATUS_OK;
}

void margin_free(struct margin_line *l)
{
    free(l->at);
    *l = (struct margin_line){ .at = NULL };
}
