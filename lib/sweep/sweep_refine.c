#include "sweep_refine.h"

#include <math.h>
#include <stdlib.h>

#include "sweep_reason.h"

/* A curve at a point. */
struct sample {
    bool exists;
    double value, error;
};

static struct sample at(const struct sweep_rows *rows, size_t i, int curve)
{
    const double *real = sweep_rows_real(rows, i, (size_t) curve);

    return (struct sample){ *sweep_rows_code(rows, i, (size_t) curve) ==
                                REASON_PRESENT,
                            real[0], real[1] };
}

static size_t row_at(const struct sweep_rows *rows, double x)
{
    return sweep_rows_find(rows, (double[2]){ x, 0.0 });
}

static double place(const struct sweep_refine *f, double x)
{
    return f->is_log ? log(x) : x;
}

static double middle(const struct sweep_refine *f, struct refine_span s)
{
    return f->is_log ? sqrt(s.lo) * sqrt(s.hi) : 0.5 * s.lo + 0.5 * s.hi;
}

double sweep_refine_middle(const struct sweep_refine *f, size_t span)
{
    return middle(f, f->span[span]);
}

/* Is the end of a curve between rows i (there) and k (not there) known well
 * enough?  A curve of one point has no slope: its end has only a place. */
static bool is_narrow(const struct sweep_refine *f,
                      const struct sweep_rows *rows, int curve, size_t i,
                      size_t k)
{
    const bool rising = i < k; /* the curve comes from the left */
    const bool first = rising ? i == 0 : i + 1 == rows->count;
    const size_t before = first ? i : rising ? i - 1 : i + 1;
    const struct sample here = at(rows, i, curve);
    const struct sample there = at(rows, before, curve);
    const double x = place(f, sweep_rows_x(rows, i)[0]);
    const double w = fabs(place(f, sweep_rows_x(rows, k)[0]) - x);
    const double h = fabs(place(f, sweep_rows_x(rows, before)[0]) - x);

    if (w > f->tol * f->length)
        return false;
    if (first || !there.exists)
        return true;
    const double rise = fabs(here.value - there.value);
    return rise * sqrt(w) <= f->tol * (sqrt(w + h) - sqrt(w)) + here.error;
}

/* Neighbours lo, hi among the rows: has any curve something to show between
 * them? */
static bool is_open(const struct sweep_refine *f, const struct sweep_rows *rows,
                    size_t lo, size_t hi)
{
    bool open = false;

    for (int c = 0; c < REFINE_CURVES; c++) {
        if (f->curve[c] < 0)
            continue;
        const bool left = at(rows, lo, f->curve[c]).exists;
        const bool right = at(rows, hi, f->curve[c]).exists;
        if (left && right)
            open = true;
        else if (left != right)
            open |= !is_narrow(f, rows, f->curve[c], left ? lo : hi,
                               left ? hi : lo);
    }
    return open;
}

/* Does any curve leave the chord, or begin or end? */
static bool is_bent(const struct sweep_refine *f, const struct sweep_rows *rows,
                    size_t lo, size_t mid, size_t hi)
{
    for (int c = 0; c < REFINE_CURVES; c++) {
        if (f->curve[c] < 0)
            continue;
        const struct sample l = at(rows, lo, f->curve[c]);
        const struct sample m = at(rows, mid, f->curve[c]);
        const struct sample h = at(rows, hi, f->curve[c]);
        const double off = fabs(m.value - 0.5 * (l.value + h.value));
        if (l.exists != m.exists || m.exists != h.exists)
            return true;
        if (m.exists && off > f->tol + l.error + m.error + h.error)
            return true;
    }
    return false;
}

/* Adds the span between two neighbours if it needs a middle. */
static void add(struct sweep_refine *f, const struct sweep_rows *rows,
                size_t lo, size_t hi)
{
    const struct refine_span s = { sweep_rows_x(rows, lo)[0],
                                   sweep_rows_x(rows, hi)[0] };
    const double x = middle(f, s);

    if (is_open(f, rows, lo, hi) && x > s.lo && x < s.hi)
        f->span[f->spans++] = s;
}

enum status sweep_refine_init(struct sweep_refine *f,
                              const struct sweep_rows *rows)
{
    f->span = calloc(rows->count + 1, sizeof *f->span);
    f->spans = 0;
    f->depth = 0;
    if (f->span == NULL)
        return STATUS_NO_MEMORY;
    f->length = rows->count ? place(f, sweep_rows_x(rows, rows->count - 1)[0]) -
                                  place(f, sweep_rows_x(rows, 0)[0])
                            : 0.0;
    for (size_t i = 0; i + 1 < rows->count; i++)
        add(f, rows, i, i + 1);
    return STATUS_OK;
}

enum status sweep_refine_next(struct sweep_refine *f,
                              const struct sweep_rows *rows)
{
    const struct sweep_refine old = *f;
    struct refine_span *span = calloc(2 * old.spans + 1, sizeof *span);

    if (span == NULL)
        return STATUS_NO_MEMORY;
    f->span = span;
    f->spans = 0;
    f->depth++;
    for (size_t i = 0; i < old.spans; i++) {
        const size_t lo = row_at(rows, old.span[i].lo);
        const size_t mid = row_at(rows, middle(f, old.span[i]));
        const size_t hi = row_at(rows, old.span[i].hi);
        if (!is_bent(f, rows, lo, mid, hi))
            continue;
        add(f, rows, lo, mid);
        add(f, rows, mid, hi);
    }
    free(old.span);
    return STATUS_OK;
}

void sweep_refine_free(struct sweep_refine *f)
{
    free(f->span);
    f->span = NULL;
    f->spans = 0;
}
