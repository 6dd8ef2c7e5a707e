#include "proof_root.h"

#include "proof_tolerance.h"

/* Points of a secant, and f there. */
struct secant {
    proof_function *f;
    void *ctx;
    mpfr_t x[2], h[2], step;
    mpfi_t value, place;
};

static void secant_init(struct secant *s, proof_function *f, void *ctx)
{
    s->f = f;
    s->ctx = ctx;
    mpfr_inits2(PROOF_BITS, s->x[0], s->x[1], s->h[0], s->h[1], s->step, NULL);
    mpfi_init2(s->value, PROOF_BITS);
    mpfi_init2(s->place, PROOF_BITS);
}

static void secant_free(struct secant *s)
{
    mpfr_clears(s->x[0], s->x[1], s->h[0], s->h[1], s->step, NULL);
    mpfi_clear(s->value);
    mpfi_clear(s->place);
}

/* Towards the root; nothing here needs to be right. */
static void approach(struct secant *s, long double near)
{
    mpfr_set_ld(s->x[0], near, MPFR_RNDN);
    mpfr_add_d(s->x[1], s->x[0], PROOF_SECANT, MPFR_RNDN);
    for (int i = 0; i < 2; i++)
        if (s->f(s->ctx, s->x[i], s->value))
            mpfi_mid(s->h[i], s->value);
    for (int i = 0; i < PROOF_NEWTONS; i++) {
        mpfr_sub(s->step, s->h[1], s->h[0], MPFR_RNDN);
        if (mpfr_zero_p(s->step))
            break;
        mpfr_sub(s->x[0], s->x[1], s->x[0], MPFR_RNDN);
        mpfr_div(s->step, s->x[0], s->step, MPFR_RNDN);
        mpfr_mul(s->step, s->step, s->h[1], MPFR_RNDN);
        mpfr_set(s->x[0], s->x[1], MPFR_RNDN);
        mpfr_set(s->h[0], s->h[1], MPFR_RNDN);
        mpfr_sub(s->x[1], s->x[1], s->step, MPFR_RNDN);
        if (!mpfr_number_p(s->x[1]) || !s->f(s->ctx, s->x[1], s->value))
            break;
        mpfi_mid(s->h[1], s->value);
    }
}

static bool has_sign(struct secant *s, mpfr_srcptr x, int sign)
{
    return s->f(s->ctx, x, s->value) &&
           (sign > 0 ? mpfi_is_strictly_pos(s->value) > 0
                     : mpfi_is_strictly_neg(s->value) > 0);
}

bool proof_root(proof_function *f, proof_over *over, void *ctx,
                long double near, mpfi_ptr out)
{
    struct secant s;
    bool found = false;

    secant_init(&s, f, ctx);
    approach(&s, near);
    if (!mpfr_number_p(s.x[1]))
        mpfr_set_ld(s.x[1], near, MPFR_RNDN);
    for (double r = PROOF_PLACE_LEAST; r < PROOF_PLACE_MOST && !found;
         r *= 256) {
        mpfi_interv_d(s.place, -r, r);
        mpfi_add_fr(s.place, s.place, s.x[1]);
        found = (!over || over(ctx, s.place)) &&
                has_sign(&s, &s.place->left, 1) &&
                has_sign(&s, &s.place->right, -1);
    }
    if (found)
        mpfi_set(out, s.place);
    secant_free(&s);
    return found;
}
