/*
 * proof_root.h -- where a continuous function falls through 0: between two
 * points where its enclosures are > 0 and < 0.
 */
#pragma once

#include <mpfi.h>
#include <stdbool.h>

/* Encloses f(x); false where it has no value. */
typedef bool proof_function(void *ctx, mpfr_srcptr x, mpfi_ptr out);

/* out = [x - r, x + r] with f(x - r) > 0 > f(x + r), from a tiny r on, x from a
 * secant that begins at `near`; false where none is found. */
bool proof_root(proof_function *f, void *ctx, long double near, mpfi_ptr out);
