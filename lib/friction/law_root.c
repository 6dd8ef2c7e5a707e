/* From psi = 1/v (-ln v where psi is a logarithm) in steps that double, the way
 * that psi itself would go, until its rate turns; then between both (newton.h),
 * and by Newton's steps in 113 bits. */
#include "law_graph.h"

#include <math.h>

#include "newton.h"
#include "quad.h"
#include "tolerance.h"

struct at {
    struct law_long *p;
    long double x;
};

/* dpsi/dt at y */
static long double rate(const void *ctx, long double y)
{
    const struct at *at = ctx;

    return law_long_at(at->p, at->x, y, LAW_AT_GROWTH);
}

static long double find(const struct at *at, long double guess)
{
    struct newton_root_long root;
    const long double first = rate(at, guess);
    const long double side = first > 0 ? 1 : -1;
    long double near = guess;

    if (first == 0 || isnan(first))
        return first == 0 ? guess : first;
    for (long double step = 0.5L; step < 4 * (long double) LN_RANGE;
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

long double law_root(struct law_long *p, long double x)
{
    return find(&(struct at){ p, x }, -x);
}

/* Steps of Newton's, as far as the rate falls. */
formula_real law_root_quad(struct law_quad *p, formula_real x)
{
    struct law_long start;

    law_long_init(&start, p->law, p->m, 0);
    quad y = law_root(&start, (long double) x);
    for (int i = 0; i < 3; i++) {
        const quad off = law_quad_at(p, x, y, LAW_AT_GROWTH);
        const quad slope = law_quad_by(p, LAW_AT_GROWTH, p->g->y);
        y -= slope < 0 ? off / slope : 0;
    }
    return y;
}

/* ---- whether it is a function of v --------------------------------------- */

static enum status refuse(struct fault *why, const char *what, long double x)
{
    return fault_set(
        why, STATUS_BAD_SCENE,
        "%s at v = %.3Lg, expected one psi at which it is 0 and to which "
        "psi comes, or psi_ss",
        what, expl(x));
}

/* Signs of the rate from far below to far above psi = 1/v: what turns where. */
static enum status check_at(const struct at *at, bool *found, struct fault *why)
{
    enum { FAR = 40 };
    int falls = 0, rises = 0, sign = 0;

    for (int i = -FAR; i <= FAR; i++) {
        const long double here = rate(at, -at->x + i + 0.0625L);
        const int now = (here > 0) - (here < 0);
        falls += sign > 0 && now < 0;
        rises += sign < 0 && now > 0;
        sign = now ? now : sign;
    }
    *found = *found || falls;
    if (falls > 1)
        return refuse(why, "it is 0 at several psi", at->x);
    if (falls == 0 && rises > 0)
        return refuse(why, "psi leaves where it is 0", at->x);
    return STATUS_OK;
}

enum status law_root_check(const struct law *law, const struct material *m,
                           struct fault *why)
{
    enum { FAR = 40, STEP = 4 };
    enum status s = STATUS_OK;
    bool found = false;
    struct law_long p;

    if (law_text(law, LAW_PSI_SS))
        return STATUS_OK;
    law_long_init(&p, law, m, 0);
    for (int x = -FAR; x <= FAR && s == STATUS_OK; x += STEP)
        s = check_at(&(struct at){ &p, x }, &found, why);
    return s == STATUS_OK && !found ? refuse(why, "it is 0 at no psi", 0) : s;
}
