#include "report_transient.h"

#include <math.h>

#include "state.h"

/* ---- text ---------------------------------------------------------------- */

static void print_quantity(FILE *out, const char *name,
                           const struct quantity *q)
{
    if (!quantity_exists(q))
        fprintf(out, "  %-13s -  (%s)\n", name, q->reason);
    else
        fprintf(out, "  %-13s %-22.15g +- %.1e\n", name, q->value, q->error);
}

static void print_phases(FILE *out, const struct transient *t)
{
    fprintf(out,
            "  phase  from time %-14sto time %-16sfrom slip %-14sto slip\n", "",
            "", "");
    for (int i = 0; i < PHASES; i++) {
        const struct phase *p = &t->phase[i];
        if (!quantity_exists(&p->start_time) || !quantity_exists(&p->end_time))
            fprintf(out, "  %-6d -  (%s)\n", i + 1,
                    quantity_exists(&p->start_time) ? p->end_time.reason
                                                    : p->start_time.reason);
        else
            fprintf(out, "  %-6d %-24.15g%-24.15g%-24.15g%.15g\n", i + 1,
                    p->start_time.value, p->end_time.value, p->start_slip.value,
                    p->end_slip.value);
    }
}

static void print_number(FILE *out, const struct quantity *q)
{
    if (quantity_exists(q))
        fprintf(out, " %-13.8g", q->value);
    else
        fprintf(out, " %-13s", "-");
}

static void print_event(FILE *out, const struct transient_event *e)
{
    char name[64];

    if (isnan(e->level) || e->what <= MOMENT_V_PLUS)
        snprintf(name, sizeof name, "%s", moment_names[e->what]);
    else
        snprintf(name, sizeof name, "%s %.3g", moment_names[e->what], e->level);
    fprintf(out, "  %-26s ", name);
    if (quantity_exists(&e->time))
        fprintf(out, "%-22.15g", e->time.value);
    else
        fprintf(out, "%-22s", "-");
    print_number(out, &e->slip);
    print_number(out, &e->v);
    print_number(out, &e->psi);
    print_number(out, &e->mu);
    if (quantity_exists(&e->time))
        fprintf(out, " %.1e", e->time.error);
    fputc('\n', out);
}

static void print_run(FILE *out, const struct scene *s,
                      const struct transient *t)
{
    const struct transient_summary *sum = &t->sum;

    state_print(out, s, sum->v, sum->psi);
    fprintf(out, ": %s, ends by %s%s%s%s\n", fate_names[sum->fate],
            transient_end_names[sum->end], t->reason ? " (" : "",
            t->reason ? t->reason : "", t->reason ? ")" : "");
    print_quantity(out, "time", &sum->time);
    print_quantity(out, "slip", &sum->slip);
    print_quantity(out, "mu_mean", &sum->mu_mean);
    fprintf(out, "  %-13s %.1e of its largest term\n", "energy (27)",
            sum->energy_defect);
    print_phases(out, t);
    fprintf(out, "  %-26s %-22s %-13s %-13s %-13s %-13s %s\n", "event", "time",
            "slip", "v", "psi", "mu", "time +-");
    for (size_t i = 0; i < t->events; i++)
        print_event(out, &t->event[i]);
}

void report_simulation_print(FILE *out, const struct simulation *s)
{
    for (size_t i = 0; i < s->runs; i++)
        print_run(out, &s->scene, &s->run[i]);
}
