#include "proof_units.h"

#include "interval_math.h"
#include "proof_input.h"
#include "unit.h"

struct proof_units proof_units_of(const struct law *law,
                                  const struct material *m)
{
    const struct interval one = interval_point(1), V = proof_decimal(m->V_star);
    const struct interval L = proof_decimal(m->L), time = interval_divide(L, V);
    struct proof_units u = { V, L, one, law_psi_is_log(law) };

    if (law->theta == THETA_LN_PSI || u.psi_is_log)
        u.phi_1 = u.psi_is_log && law->kinetics == KINETICS_SINH
                      ? interval_add(time, time)
                      : time;
    else if (law->theta == THETA_LN_C_PSI && isfinite(m->R))
        u.phi_1 = interval_divide(one, interval_add(one, proof_decimal(m->R)));
    return u;
}

static struct interval power(struct interval x, struct interval u, int exponent)
{
    return exponent > 0   ? interval_times(x, u)
           : exponent < 0 ? interval_divide(x, u)
                          : x;
}

struct interval_double proof_in_si(const struct proof_units *u,
                                   const char *unit, struct interval_double x)
{
    const struct interval wide = interval_of_double(x);
    const struct unit *of = unit_find(unit);
    const bool state =
        of && (of->kind == UNIT_STATE || of->kind == UNIT_LN_STATE);

    if (of == NULL)
        return x;
    const struct interval scale =
        state ? u->phi_1
              : power(power(interval_point(1), u->V_star, of->rate), u->L,
                      of->length);
    if (of->kind == UNIT_LN || of->kind == UNIT_LN_STATE)
        return interval_outward(interval_add(wide, interval_ln(scale)));
    return interval_outward(interval_times(
        scale, state && u->psi_is_log ? interval_exp(wide) : wide));
}
