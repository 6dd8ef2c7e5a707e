/* plane_certificate.h -- what was proved of a plane of formulas as a
 * certificate (certificate.h). */
#pragma once

#include <jansson.h>

#include "plane_study.h"

/* Of a study with proofs; what is not proved says why.  A new reference. */
json_t *plane_certificate(const struct plane_study *s);
