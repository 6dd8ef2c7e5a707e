#include "report.h"

#include <math.h>
#include <string.h>

#include "json_results.h"
#include "report_basin.h"
#include "report_diagram.h"
#include "scene_slope.h"
#include "study_results.h"

/* ---- text ------------------------------------------------------------- */

/* "name   value +- error" or "name   -   reason"; what rounding of the inputs
 * costs follows where it is known. */
static void print_quantity(FILE *out, const char *name,
                           const struct quantity *q)
{
    if (!quantity_exists(q))
        fprintf(out, "  %-16s -  (%s)\n", name, q->reason);
    else
        fprintf(out, "  %-16s %-22.15g +- %.1e", name, q->value, q->error);
    if (quantity_exists(q) && !isnan(q->conditioning))
        fprintf(out, "  (inputs +- %.1e)", q->conditioning * fabs(q->value));
    if (quantity_exists(q))
        fputc('\n', out);
}

static void print_record(FILE *out, const struct record_type *type,
                         const void *at)
{
    const struct record_array one = { type, at, 1 };

    for (size_t i = 0; i < type->count; i++) {
        const struct record_field *f = &type->fields[i];
        const void *member = record_member(&one, 0, f);
        if (f->kind == RECORD_QUANTITY)
            print_quantity(out, f->name, member);
        else if (f->kind == RECORD_CODE && *(const int8_t *) member >= 0)
            fprintf(out, "  %-16s %s\n", f->name,
                    f->codes[*(const int8_t *) member]);
    }
}

static void print_sensitivities(FILE *out, const struct sensitivities *d)
{
    fprintf(out, "sensitivities d ln v_plus/d p\n");
    print_record(out, &record_sensitivity, &d->v_plus);
    fprintf(out, "sensitivities d ln v_minus/d p\n");
    print_record(out, &record_sensitivity, &d->v_minus);
}

static void print_steady(FILE *out, const struct study *s)
{
    fprintf(out, "steady states\n");
    if (s->equilibria == 0)
        fprintf(out, "  none: mu_ss(v) = tan(alpha) has no solution for v in "
                     "[1e-300, 1e300]\n");
    else
        fprintf(out, "  %-12s %-22s %-22s %-15s %s\n", "type", "v", "psi",
                "lambda_minus", "lambda_plus");
    for (size_t i = 0; i < s->equilibria; i++) {
        const struct steady_number *e = &s->steady[i];
        char lambda[2][32] = { "-", "-" };
        if (quantity_exists(&e->lambda_minus))
            snprintf(lambda[0], 32, "%.8g", e->lambda_minus.value);
        if (quantity_exists(&e->lambda_plus))
            snprintf(lambda[1], 32, "%.8g", e->lambda_plus.value);
        fprintf(out, "  %-12s %-22.15g %-22.15g %-15s %s\n",
                equilibrium_type_names[e->type], e->v.value, e->psi.value,
                lambda[0], lambda[1]);
    }
}

static void print_knees(FILE *out, const char *name,
                        const struct knee_number knee[], size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (quantity_exists(&knee[i].v))
            fprintf(out, "  %-16s v = %.12g +- %.1e, psi = %.12g +- %.1e\n",
                    name, knee[i].v.value, knee[i].v.error, knee[i].psi.value,
                    knee[i].psi.error);
        else
            fprintf(out, "  %-16s -  (%s)\n", name, knee[i].v.reason);
    if (count == 0)
        fprintf(out, "  %-16s -  (slope never rises through 1)\n", name);
}

/* The estimates of one xi; "-" and reasons where they do not exist. */
static void print_xi(FILE *out, const struct xi_number *xi)
{
    static const char *const name[] = { "v_minus", "v_plus", "mu_s", "G" };
    const struct quantity *q[] = { &xi->v_minus, &xi->v_plus, &xi->mu_s,
                                   &xi->G };

    fprintf(out, "  xi = %-11g ", xi->xi);
    for (size_t i = 0; i < sizeof q / sizeof *q; i++)
        if (quantity_exists(q[i]))
            fprintf(out, "%s%s %.6g", i ? ", " : "", name[i], q[i]->value);
        else if (i > 0 && q[i]->reason == q[i - 1]->reason)
            fprintf(out, ", %s -", name[i]);
        else
            fprintf(out, "%s%s - (%s)", i ? ", " : "", name[i], q[i]->reason);
    fputc('\n', out);
}

/* The paper's estimates, and where they mislead. */
static void print_estimates(FILE *out, const struct study *s)
{
    const struct estimate_numbers *e = &s->estimates;

    fprintf(out, "estimates of the paper (log form, c = 0)\n");
    print_record(out, &record_estimates, e);
    if (!quantity_exists(&e->x_k))
        return;
    print_quantity(out, "chi v_minus", &e->chi_v_minus);
    print_quantity(out, "chi v_plus", &e->chi_v_plus);
    for (size_t i = 0; i < e->xi_count; i++)
        print_xi(out, &e->xi[i]);
    fprintf(out,
            "  note: x_k neglects psi_ss, so (41) diverges near alpha_f where "
            "mu_s_mean does not;\n"
            "  note: the xi estimate has no limit as xi -> 1; chi = 1 finds "
            "the knees, not v_plus and v_minus;\n"
            "  note: (43) prints 0.378 = atan(alpha_f); a friction coefficient "
            "is tan_alpha_f, and it depends on the arbitrary e = 1e-16.\n");
}

void report_print(FILE *out, const struct study *s)
{
    const struct critical_numbers *c = &s->critical;

    fprintf(out, "%s (%s form)", s->block.law.preset,
            friction_form_names[s->block.law.form]);
    if (scene_has_slope(s->scene))
        fprintf(out, ", alpha = %.17g rad", s->scene->alpha);
    fputc('\n', out);
    if (plan_has(s->stages, STAGE_STEADY))
        print_steady(out, s);
    if (plan_has(s->stages, STAGE_FOLDS)) {
        fprintf(out, "folds\n");
        print_record(out, &record_folds, &s->folds);
    }
    if (plan_has(s->stages, STAGE_CRITICAL)) {
        fprintf(out, "stable manifold of the saddle\n");
        print_record(out, &record_critical, c);
    }
    if (plan_has(s->stages, STAGE_KNEES) && study_has_manifolds(s)) {
        print_knees(out, "knees_upper", c->knees_upper, c->knees_upper_count);
        print_knees(out, "knees_lower", c->knees_lower, c->knees_lower_count);
    }
    if (plan_has(s->stages, STAGE_TAYLOR)) {
        fprintf(out, "power series of the manifold in v - v_sp\n");
        print_record(out, &record_taylor, &s->taylor);
    }
    if (plan_has(s->stages, STAGE_SENSITIVITIES))
        print_sensitivities(out, &s->sensitivities);
    if (plan_has(s->stages, STAGE_ESTIMATES))
        print_estimates(out, s);
    if (plan_has(s->stages, STAGE_BASINS))
        report_basin_print(out, &s->basins);
    report_diagrams_print(out, s);
}

/* ---- JSON ------------------------------------------------------------- */

static json_t *parameters_json(const struct study *s)
{
    struct material m = s->block.material;
    json_t *j = json_object();

    for (int key = 0; key < MATERIAL_KEYS; key++)
        if (key != MATERIAL_V_C || law_uses(&s->block.law, MATERIAL_V_C))
            json_object_set_new(
                j, material_key_name((enum material_key) key),
                json_number(*material_member(&m, (enum material_key) key)));
    json_object_set_new(j, "eps2", json_number(material_eps2(&m)));
    json_object_set_new(j, "eta", json_number(law_eta(&s->block.law, &m)));
    return j;
}

static json_t *cost_json(const struct study *s)
{
    const struct stage_cost total = study_cost(s);
    json_t *j = json_object();

    json_object_set_new(j, "field_evaluations",
                        json_integer((json_int_t) total.field_evaluations));
    json_object_set_new(j, "seconds", json_number(total.seconds));
    return j;
}

json_t *report_json(const struct study *s)
{
    const struct results all = study_results(s);
    json_t *j = json_object();

    json_object_set_new(j, "law", json_string(s->block.law.preset));
    json_object_set_new(j, "form",
                        json_string(friction_form_names[s->block.law.form]));
    json_object_set_new(j, "alpha",
                        scene_has_slope(s->scene) ? json_number(s->scene->alpha)
                                                  : json_null());
    json_object_set_new(j, "parameters", parameters_json(s));
    j = json_results(j, &all);
    json_object_set_new(j, "cost", cost_json(s));
    return j;
}
