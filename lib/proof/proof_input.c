#include "proof_input.h"

#include "interval_graph.h"
#include "number.h"
#include "proof_tolerance.h"

void proof_input(mpfi_ptr out, double x, bool decimal)
{
    if (decimal)
        mpfi_set_str(out, number_shortest(x).text, 10);
    else
        mpfi_set_d(out, x);
}

void proof_slope(mpfi_ptr tan_alpha, const struct proof_inputs *in)
{
    mpfi_t pi;

    if (in->decimal && in->slope_text)
        mpfi_set_str(tan_alpha, in->slope_text, 10);
    else
        proof_input(tan_alpha, in->slope, in->decimal);
    if (in->slope_in == ANGLE_TAN)
        return;
    if (in->slope_in == ANGLE_DEGREE) {
        mpfi_init2(pi, PROOF_BITS);
        mpfi_const_pi(pi);
        mpfi_mul(tan_alpha, tan_alpha, pi);
        mpfi_div_ui(tan_alpha, tan_alpha, 180);
        mpfi_clear(pi);
    }
    mpfi_tan(tan_alpha, tan_alpha);
}

struct interval proof_decimal(double x)
{
    mpfi_t decimal;

    mpfi_init2(decimal, PROOF_BITS);
    proof_input(decimal, x, true);
    const struct interval out = interval_of_mpfi(decimal);
    mpfi_clear(decimal);
    return out;
}

struct interval proof_tangent(const struct proof_inputs *in)
{
    mpfi_t tan_alpha;

    mpfi_init2(tan_alpha, PROOF_BITS);
    proof_slope(tan_alpha, in);
    const struct interval out = interval_of_mpfi(tan_alpha);
    mpfi_clear(tan_alpha);
    return out;
}
