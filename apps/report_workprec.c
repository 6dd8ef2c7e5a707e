#include "report_workprec.h"

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

void report_workprec_print(FILE *out, const void *run)
{
    const struct workprec *w = run;

    fprintf(out, "%s at alpha = %.10g\n", w->scene.law.preset, w->scene.alpha);
    print_failures(out, w, WORKPREC_FAILED, "runs that failed:");
    print_failures(out, w, WORKPREC_SILENT_FAILURE,
                   "runs that failed silently:");
}
