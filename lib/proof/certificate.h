/*
 * certificate.h -- what was proved as JSON, with all that another program needs
 * to verify it again (docs/proofs.md; tests/check_certificate.py is one): the
 * polynomials, the tubes around them, and what is claimed of the numbers.
 * Inputs are texts, the decimals that the theorem is about; every number is a
 * double, and an interval a list of two.
 *
 * Answers are new references; what no memory was found for is NULL or left out.
 */
#pragma once

#include <jansson.h>

#include "proof_tube.h"

enum { CERTIFICATE_VERSION = 3 };

/* The shortest decimal that reads as x. */
json_t *certificate_decimal(double x);
json_t *certificate_interval(struct interval u);

/* An object with the cone, and the pieces with their cells; an open branch may
 * have no cells, but the cone's piece. */
json_t *certificate_tube(const struct proof_branch *b);
