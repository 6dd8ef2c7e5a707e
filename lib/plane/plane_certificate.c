#include "plane_certificate.h"

#include <stdio.h>

#include "certificate.h"
#include "plane_proof.h"
#include "proof_plane.h"
#include "quad.h"

/* ---- inputs -------------------------------------------------------------- */

/* The shortest decimal that reads as x. */
static json_t *decimal(formula_real x)
{
    char text[64], format[8];
    int digits = 0;

    do {
        snprintf(format, sizeof format, "%%.%dg", ++digits);
        strfromf128(text, sizeof text, format, x);
    } while (digits < 36 && strtof128(text, NULL) != x);
    return json_string(text);
}

static json_t *state_json(const struct system_state *z)
{
    const bool is_turn =
        z->period >= 2 * formula_pi() && z->period <= 2 * formula_pi();

    return z->chart == CHART_POSITIVE ? json_string("positive")
           : z->chart == CHART_REAL   ? json_string("real")
           : is_turn                  ? json_string("angle")
                     : json_pack("{s:o}", "angle", decimal(z->period));
}

static json_t *system_json(const struct formula_system *f)
{
    json_t *states = json_object(), *parameters = json_object();
    json_t *define = json_object(), *rates = json_object();

    for (int i = 0; i < f->states; i++)
        json_object_set_new(states, f->state[i].name, state_json(&f->state[i]));
    for (int i = 0; i < f->parameters; i++)
        json_object_set_new(parameters, f->parameter[i].name,
                            decimal(f->parameter[i].value));
    for (int i = 0; i < f->entries; i++) {
        const struct system_entry *e = &f->entry[i];
        if (e->kind != ENTRY_OBSERVABLE)
            json_object_set_new(e->kind == ENTRY_RATE ? rates : define, e->name,
                                json_string(formula_system_text(f, e)));
    }
    return json_pack("{s:o, s:o, s:o, s:o}", "state", states, "parameters",
                     parameters, "define", define, "rates", rates);
}

/* ---- the proof ----------------------------------------------------------- */

static json_t *number_json(const struct system_number *n)
{
    return certificate_interval(proof_plane_number(n));
}

static json_t *rest_json(const struct plane_rest *r)
{
    const struct system_equilibrium *e = &r->exact;
    json_t *lambda = json_array();

    for (int i = 0; i < 2; i++)
        json_array_append_new(
            lambda, json_pack("[o, o]", number_json(&e->eigenvalue[i].re),
                              number_json(&e->eigenvalue[i].im)));
    return json_pack("{s:[o, o], s:o}", "state", number_json(&e->state[0]),
                     number_json(&e->state[1]), "eigenvalues", lambda);
}

static json_t *told(const struct quantity *q)
{
    return json_pack("[f, f]", q->proved->lo, q->proved->hi);
}

static json_t *crossing_json(const struct plane_study *s,
                             const struct plane_branch *b)
{
    const int axis = b->edge / 2;

    return json_pack("{s:s, s:s, s:o, s:[o, o]}", "end", "crosses", "state",
                     s->scene->system->state[axis].name, "at",
                     certificate_decimal(plane_proof_edge(s, b)), "leaves",
                     told(&b->leaves[0]), told(&b->leaves[1]));
}

static json_t *trap_json(const struct plane_branch *b,
                         const struct plane_tube *u)
{
    return json_pack("{s:s, s:I, s:[f, f], s:[f, f, f], s:f}", "end", "trapped",
                     "to", (json_int_t) b->to, "turns", u->turns[0],
                     u->turns[1], "form", u->trap.xx, u->trap.xy, u->trap.yy,
                     "level", u->trap.level);
}

static json_t *branch_json(const struct plane_study *s,
                           const struct plane_branch *b,
                           const struct plane_tube *u)
{
    json_t *j = json_pack("{s:I, s:s}", "saddle", (json_int_t) b->rest, "kind",
                          b->kind == MANIFOLD_STABLE ? "stable" : "unstable");
    json_t *more[2] = { NULL, NULL };

    if (b->not_proved) {
        json_object_set_new(j, "not_proved", json_string(b->not_proved));
        return j;
    }
    more[0] = certificate_tube(&u->tube);
    more[1] =
        b->end_proved == PLANE_CROSSES ? crossing_json(s, b) : trap_json(b, u);
    for (int i = 0; i < 2; i++) {
        json_object_update(j, more[i]);
        json_decref(more[i]);
    }
    return j;
}

json_t *plane_certificate(const struct plane_study *s)
{
    json_t *rests = json_array(), *branches = json_array();

    for (size_t i = 0; i < s->listed; i++)
        json_array_append_new(rests, rest_json(&s->rest[i]));
    for (size_t i = 0; i < s->proof.tubes; i++)
        json_array_append_new(branches,
                              branch_json(s, &s->branch[i], &s->proof.tube[i]));
    return json_pack("{s:i, s:o, s:o, s:o}", "slipway_certificate",
                     CERTIFICATE_VERSION, "system",
                     system_json(s->scene->system), "equilibria", rests,
                     "branches", branches);
}
