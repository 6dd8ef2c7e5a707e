#include "report_workprec.h"

#include <math.h>

static const char *name_of(const char *method)
{
    return method ? method : "-";
}

/* ---- text ------------------------------------------------------------ */

static void print_time(FILE *out, double seconds)
{
    if (isnan(seconds))
        fprintf(out, " %9s", "-");
    else
        fprintf(out, " %9.4g", 1e6 * seconds);
}

static void print_fastest(FILE *out, const struct workprec *w)
{
    fprintf(out, "%-11s %-7s %-12s %9s  %-12s %9s  %s\n", "quantity", "error",
            "ours", "us", "others'", "us", "others/ours");
    for (size_t i = 0; i < w->ranks; i++) {
        const struct workprec_fastest *f = &w->fastest[i];
        fprintf(out, "%-11s %-7.0e %-12s", workprec_quantity_names[f->quantity],
                f->accuracy, name_of(f->own));
        print_time(out, f->own_seconds);
        fprintf(out, "  %-12s", name_of(f->foreign));
        print_time(out, f->foreign_seconds);
        if (isnan(f->ratio_to_best_foreign))
            fprintf(out, "  -\n");
        else
            fprintf(out, "  %.2f\n", f->ratio_to_best_foreign);
    }
}

static void print_missing(FILE *out, const struct workprec *w)
{
    for (int q = 0; q < WORKPREC_QUANTITIES; q++)
        if (w->course.reason[q])
            fprintf(out, "%-11s -  (%s)\n", workprec_quantity_names[q],
                    w->course.reason[q]);
}

/* How many of the runs of a method on a quantity, from number i on, went like
 * that; *next: the first of another. */
static size_t count_status(const struct workprec *w, size_t i,
                           enum workprec_status status, size_t *next)
{
    const struct workprec_run *first = &w->run[i];
    size_t n = 0;

    for (; i < w->runs && w->run[i].method == first->method &&
           w->run[i].quantity == first->quantity;
         i++)
        n += w->run[i].status == (int8_t) status;
    *next = i;
    return n;
}

/* One line for each status but the good one: quantity, then methods. */
static void print_failures(FILE *out, const struct workprec *w,
                           enum workprec_status status, const char *title)
{
    int quantity = -1;
    size_t next;

    fprintf(out, "%s", title);
    for (size_t i = 0; i < w->runs; i = next) {
        const size_t n = count_status(w, i, status, &next);
        if (n == 0)
            continue;
        if (w->run[i].quantity != quantity) {
            quantity = w->run[i].quantity;
            fprintf(out, "\n  %-11s", workprec_quantity_names[quantity]);
        }
        fprintf(out, " %s %zu/%zu", w->run[i].method, n, next - i);
    }
    fprintf(out, quantity < 0 ? " none\n" : "\n");
}

static void print_environment(FILE *out, const struct workprec_environment *e)
{
    fprintf(out,
            "measured on %s, %s; %s %s; GSL %s, SUNDIALS %s; one thread, "
            "clock %.0f ns\n",
            e->cpu, e->system, e->compiler, e->flags, e->gsl, e->sundials,
            1e9 * e->clock_overhead);
}

void report_workprec_print(FILE *out, const struct workprec *w)
{
    fprintf(out,
            "%s at alpha = %.10g: time to a true error, ours with error bars, "
            "others' without\n",
            w->scene.law.preset, w->scene.alpha);
    print_fastest(out, w);
    print_missing(out, w);
    print_failures(out, w, WORKPREC_FAILED, "runs that failed:");
    print_failures(out, w, WORKPREC_SILENT_FAILURE,
                   "runs that failed silently:");
    print_environment(out, &w->environment);
}
