/* slipway workprec: error against run time, our methods and others', on one
 * slope. */
#include <omp.h>
#include <string.h>

#include "output.h"
#include "picture_workprec.h"
#include "progress.h"

/* Whether a setting names a key of that section. */
static bool has_section(const struct options *o, const char *section)
{
    for (size_t i = 0; i < o->sets; i++)
        if (strncmp(o->set[i], section, strlen(section)) == 0)
            return true;
    return false;
}

/* The scene; what nobody says of the slope is that of the paper's Fig 7b. */
static enum status read_scene(const struct options *o, struct scene *scene,
                              struct fault *why)
{
    static char law[] = "law.preset=spinodal_gen", slope[] = "slope.alpha=0.34";
    char *more[COMMAND_MORE];
    size_t count = 0;

    if (has_section(o, "system"))
        return command_read(o, NULL, 0, scene, why);
    if (o->files == 0 && !has_section(o, "law"))
        more[count++] = law;
    if (o->files == 0 && !has_section(o, "slope"))
        more[count++] = slope;
    return command_read(o, more, count, scene, why);
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

/* What stands above the results: whose race it is, and how many runs failed. */
static void print_head(FILE *out, const void *run)
{
    const struct workprec *w = run;

    if (w->scene.system)
        fprintf(out, "stable manifold of a saddle\n");
    else
        fprintf(out, "%s at alpha = %.10g\n", w->scene.law.preset,
                w->scene.alpha);
    print_failures(out, w, WORKPREC_FAILED, "runs that failed:");
    print_failures(out, w, WORKPREC_SILENT_FAILURE,
                   "runs that failed silently:");
}

/* On one thread: times must not compete. */
static enum exit_code run(const struct options *o, const struct scene *scene)
{
    static struct workprec w;
    struct panels p = PANELS_EMPTY;
    struct fault why = { "" };
    const struct results all = { .table = workprec_tables, .run = &w };
    enum status s =
        output_check(o, scene, scene->figure, picture_workprec_panel, &why);

    omp_set_num_threads(1);
    if (s == STATUS_OK)
        s = workprec_run(&w, scene, o->quick, progress_monitor(o), &why);
    progress_end();
    if (s != STATUS_OK)
        return command_fail(s, why.text);
    s = output_write(o, "workprec", &all, scene, NULL, "error against run time",
                     &why);
    if (s == STATUS_OK && scene->figure)
        picture_workprec(&w, &p);
    if (s == STATUS_OK)
        s = output_draw(o, &scene->paper, &p, scene->figure, &why);
    const enum exit_code code = s == STATUS_OK
                                    ? output_print(o, &all, print_head)
                                    : command_fail(s, why.text);
    workprec_free(&w);
    return code;
}

enum exit_code command_workprec(const struct options *o)
{
    return command_with_scene(o, read_scene, run);
}
