#include "verify.h"

#include <math.h>

#include "backward.h"

/* The numbers by the second route. */
static enum status second_route(const struct block *b, const struct planar *sys,
                                const struct equilibrium *e,
                                const struct backward_options *o,
                                struct critical_numbers *out,
                                size_t *evaluations)
{
    struct branch upper = { .kind = MANIFOLD_STABLE }, lower = upper;
    enum status s = backward_branch(sys, e, 1, o, &upper);

    if (s == STATUS_OK)
        s = backward_branch(sys, e, -1, o, &lower);
    if (s == STATUS_OK &&
        (upper.end == BRANCH_STEPS || lower.end == BRANCH_STEPS))
        s = STATUS_TOO_MANY_STEPS;
    if (s == STATUS_OK) {
        *out = numbers_critical(b, e, &upper, &lower);
        *evaluations = upper.evaluations + lower.evaluations;
    }
    branch_free(&upper);
    branch_free(&lower);
    return s;
}

static struct verified_number compare(const char *name,
                                      const struct quantity *first,
                                      const struct quantity *second)
{
    struct verified_number n = { name, *first, *second, NAN, false };

    n.difference = first->value - second->value;
    if (quantity_exists(first) && quantity_exists(second))
        n.agree = fabs(n.difference) <= first->error + second->error;
    else
        n.agree = quantity_exists(first) == quantity_exists(second);
    return n;
}

static struct verified_end compare_end(const char *name, int8_t first,
                                       int8_t second)
{
    return (struct verified_end){ name, first, second, first == second };
}

static size_t count_disagreements(const struct verification *v)
{
    size_t n = 0;

    for (size_t i = 0; i < VERIFIED_ENDS; i++)
        n += !v->end[i].agree;
    for (size_t i = 0; i < VERIFIED_NUMBERS; i++)
        n += !v->number[i].agree;
    return n;
}

enum status verify_numbers(const struct block *b, const struct planar *sys,
                           const struct equilibrium *e,
                           const struct critical_numbers *first, double rtol,
                           const struct monitor *monitor,
                           struct verification *out)
{
    struct backward_options o = backward_defaults(rtol);
    struct critical_numbers again;
    size_t evaluations;

    o.carry = (struct carry){ { BLOCK_EXCESS }, 1 };
    o.monitor = monitor;
    const enum status s = second_route(b, sys, e, &o, &again, &evaluations);
    if (s != STATUS_OK)
        return s;
    if (first->lower_end == END_TRUNCATED && again.lower_end != END_TRUNCATED)
        return STATUS_TOO_MANY_STEPS;
    *out = (struct verification){
        .end = { compare_end("upper_end", first->upper_end, again.upper_end),
                 compare_end("lower_end", first->lower_end, again.lower_end) },
        .number = { compare("v_plus", &first->v_plus, &again.v_plus),
                    compare("v_minus", &first->v_minus, &again.v_minus),
                    compare("psi_at_v0", &first->psi_at_v0, &again.psi_at_v0),
                    compare("x_excess", &first->x_excess, &again.x_excess),
                    compare("x_deficit", &first->x_deficit, &again.x_deficit) },
        .field_evaluations = evaluations,
    };
    out->disagreements = count_disagreements(out);
    return STATUS_OK;
}
