#include "report_diagram.h"

/* ---- text ---------------------------------------------------------------- */

static void print_quantity(FILE *out, const char *name,
                           const struct quantity *q)
{
    if (quantity_exists(q))
        fprintf(out, "  %-16s %-22.15g +- %.1e\n", name, q->value, q->error);
    else
        fprintf(out, "  %-16s -  (%s)\n", name, q->reason);
}

static void print_extrema(FILE *out, const struct extremum e[], size_t count)
{
    for (size_t i = 0; i < count; i++) {
        fprintf(out, "  %s of mu_ss\n", extremum_names[e[i].kind]);
        print_quantity(out, "  v", &e[i].v);
        print_quantity(out, "  mu", &e[i].mu);
        print_quantity(out, "  alpha", &e[i].alpha);
    }
    if (count == 0)
        fprintf(out, "  mu_ss has no extremum for this law and material\n");
}

static void print_spring_block(FILE *out, const struct spring_curve *c)
{
    const struct spring_point *top = NULL;

    fprintf(out, "spring-block, sigma = %.17g Pa, mass = %.17g kg/m^2\n",
            c->block.sigma, c->block.mass);
    print_extrema(out, c->extremum, c->extrema);
    for (size_t i = 0; i < c->count; i++)
        if (quantity_exists(&c->at[i].k) &&
            (top == NULL || c->at[i].k.value > top->k.value))
            top = &c->at[i];
    if (top)
        fprintf(out, "  stick-slip below k = %.6g Pa/m at most, at v = %.4g\n",
                top->k.value, top->v);
    else
        fprintf(out, "  no stick-slip at any of these speeds\n");
}

static void print_fold_curves(FILE *out, const struct fold_curve *f)
{
    fprintf(out, "fold curves, %zu values of c; their cusp\n", f->count);
    print_quantity(out, "c", &f->cusp.c);
    print_quantity(out, "v", &f->cusp.v);
    print_quantity(out, "mu", &f->cusp.mu);
    print_quantity(out, "alpha", &f->cusp.alpha);
}

static void print_chi(FILE *out, const struct chi_curves *c)
{
    for (size_t i = 0; i < c->slopes; i++) {
        const struct chi_slope *s = &c->slope[i];
        fprintf(out, "chi(v) at alpha = %.17g rad\n", s->alpha);
        print_quantity(out, "v_sp0", &s->v_sp0);
        print_quantity(out, "v_low", &s->v_low);
        print_quantity(out, "v_high", &s->v_high);
    }
}

void report_diagrams_print(FILE *out, const struct study *s)
{
    const struct diagrams *d = &s->diagrams;

    if (plan_has(s->stages, STAGE_FRICTION_LAW)) {
        fprintf(out, "friction law\n");
        print_extrema(out, d->friction_law->extremum, d->friction_law->extrema);
    }
    if (plan_has(s->stages, STAGE_SPRING_BLOCK))
        print_spring_block(out, d->spring_block);
    if (plan_has(s->stages, STAGE_BIFURCATION)) {
        fprintf(out, "folds of the bifurcation diagram\n");
        print_extrema(out, d->bifurcation.extremum, d->bifurcation.extrema);
    }
    if (plan_has(s->stages, STAGE_FOLD_CURVES))
        print_fold_curves(out, &d->fold_curves);
    if (plan_has(s->stages, STAGE_CHI))
        print_chi(out, &d->chi);
}
