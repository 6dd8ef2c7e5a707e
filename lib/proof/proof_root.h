/*
 * proof_root.h -- where a continuous function falls through 0: between two
 * points where its enclosures are > 0 and < 0.
 */
#pragma once

#include <mpfi.h>
#include <stdbool.h>

/* Encloses f(x); false where it has no value. */
typedef bool proof_function(void *ctx, mpfr_srcptr x, mpfi_ptr out);

/* Whether f is continuous on a place; what it finds there f may use from then
 * on. */
typedef bool proof_over(void *ctx, mpfi_srcptr place);

/* out = [l, r] with f(l) > 0 > f(r), from a tiny one on around x from a secant
 * that begins at `near`, where `over`, or NULL, has looked first; false where
 * none is found. */
bool proof_root(proof_function *f, proof_over *over, void *ctx,
                long double near, mpfi_ptr out);
