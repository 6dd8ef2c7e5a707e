/* From psi = 1/v (-ln v where psi is a logarithm) in steps that double, the way
 * that psi itself would go, until its rate turns; then between both (newton.h),
 * and by Newton's steps in 113 bits. */
#include "law_root.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "newton.h"
#include "quad.h"
#include "slope.h"
#include "tolerance.h"

struct at {
    const struct law_typed *t;
    struct formula_value leaf[LAW_VALUES];
};

static void place(struct at *at, const struct law *law,
                  const struct material *m, formula_real x)
{
    at->t = law->typed;
    law_values(law, m, 0, x, 0, at->leaf);
}

/* dpsi/dt at y */
static long double rate(const void *ctx, long double y)
{
    const struct at *at = ctx;
    struct formula_value leaf[LAW_VALUES];
    long double value[FORMULA_NODES];

    memcpy(leaf, at->leaf, sizeof leaf);
    leaf[LAW_Y0].value = y;
    formula_long_constants(&at->t->growth, leaf, NULL, value);
    return value[at->t->rate];
}

/* A step of Newton's in 113 bits; 0 where the rate does not fall. */
static quad newton_step(const struct at *at, quad y)
{
    const struct formula *f = &at->t->growth;
    struct formula_value leaf[LAW_VALUES];
    quad value[FORMULA_NODES], slope[FORMULA_NODES];

    memcpy(leaf, at->leaf, sizeof leaf);
    leaf[LAW_Y0].value = y;
    formula_constants(f, leaf, NULL, 0, value);
    formula_slopes(f, value, formula_find(f, "y0", 2), slope);
    return slope[at->t->rate] < 0 ? value[at->t->rate] / slope[at->t->rate] : 0;
}

static bool is_root(const struct law *law)
{
    return law->typed && law->typed->text[LAW_PSI_SS][0] == '\0';
}

static long double find(const struct at *at, long double guess)
{
    struct newton_root_long root;
    const long double first = rate(at, guess);
    const long double side = first > 0 ? 1 : -1;
    long double near = guess;

    if (first == 0 || isnan(first))
        return first == 0 ? guess : first;
    for (long double step = 0.5L; step < 4 * (long double) TOL_LN_RANGE;
         step *= 2) {
        const long double far = guess + side * step, there = rate(at, far);
        if (isnan(there))
            break;
        if (there * side > 0) {
            near = far;
            continue;
        }
        return newton_find_long(rate, at, fminl(near, far), fmaxl(near, far), 0,
                                &root) == STATUS_OK
                   ? root.x
                   : (long double) NAN;
    }
    return (long double) NAN;
}

long double law_root(const struct law *law, const struct material *m,
                     long double x)
{
    struct at at;

    if (!is_root(law))
        return 0;
    place(&at, law, m, x);
    return find(&at, -x);
}

formula_real law_root_quad(const struct law *law, const struct material *m,
                           formula_real x)
{
    struct at at;

    if (!is_root(law))
        return 0;
    place(&at, law, m, x);
    quad y = find(&at, (long double) -x);
    for (int i = 0; i < 3; i++)
        y -= newton_step(&at, y);
    return y;
}

/* ---- whether it is a function of v --------------------------------------- */

static enum status refuse(struct fault *why, const char *what, long double x)
{
    snprintf(why->text, sizeof why->text,
             "%s at v = %.3Lg, expected one psi at which it is 0 and to which "
             "psi comes, or psi_ss",
             what, expl(x));
    return STATUS_BAD_SCENE;
}

/* Signs of the rate from far below to far above psi = 1/v: what turns where. */
static enum status check_at(const struct at *at, long double x, bool *found,
                            struct fault *why)
{
    enum { FAR = 40 };
    int falls = 0, rises = 0, sign = 0;

    for (int i = -FAR; i <= FAR; i++) {
        const long double here = rate(at, -x + i + 0.0625L);
        const int now = (here > 0) - (here < 0);
        falls += sign > 0 && now < 0;
        rises += sign < 0 && now > 0;
        sign = now ? now : sign;
    }
    *found = *found || falls;
    if (falls > 1)
        return refuse(why, "it is 0 at several psi", x);
    if (falls == 0 && rises > 0)
        return refuse(why, "psi leaves where it is 0", x);
    return STATUS_OK;
}

enum status law_root_check(const struct law *law, const struct material *m,
                           struct fault *why)
{
    enum { FAR = 40, STEP = 4 };
    enum status s = STATUS_OK;
    bool found = false;
    struct at at;

    for (int x = -FAR; x <= FAR && s == STATUS_OK && is_root(law); x += STEP) {
        place(&at, law, m, x);
        s = check_at(&at, x, &found, why);
    }
    if (s == STATUS_OK && is_root(law) && !found)
        return refuse(why, "it is 0 at no psi", 0);
    return s;
}
