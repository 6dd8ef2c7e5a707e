/* study_certificate.h -- what was proved of a slope as a certificate. */
#pragma once

#include <jansson.h>

struct study;

/* Of a study with proofs; what is not proved says why.  A new reference. */
json_t *study_certificate(const struct study *s);
