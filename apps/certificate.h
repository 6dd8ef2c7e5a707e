/*
 * certificate.h -- what was proved of a slope as JSON, with all that another
 * program needs to verify it again (docs/proofs.md; tests/check_certificate.py
 * is one): the polynomials, the tubes around them, and what is claimed of the
 * numbers.  Inputs are texts, the decimals that the theorem is about; every
 * number is a double, written so that it reads back as the same one, and an
 * interval a list of two.
 */
#pragma once

#include "options.h"
#include "study.h"

/* Whether --certificate, if it is given, can be followed: something is proved,
 * and the file can be written. */
MUST_CHECK enum status certificate_check(const struct options *o,
                                         const struct scene *scene,
                                         struct fault *why);

/* Writes the file, whole or not at all, and says so; nothing if none is asked
 * for.  What is not proved says why. */
MUST_CHECK enum status certificate_write(const struct options *o,
                                         const struct study *s,
                                         struct fault *why);
