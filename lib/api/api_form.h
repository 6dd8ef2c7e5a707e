/* api_form.h -- rates that a caller has built term by term (slipway_planar.h),
 * evaluated as numbers with derivatives and as Taylor series. */
#ifndef API_API_FORM_H
#define API_API_FORM_H

#include "planar.h"
#include "slipway_planar.h"
#include "status.h"

enum { FORM_TERMS = 64 }; /* x, y, constants and operations */

struct slipway_form {
    struct form_term {
        int op; /* slipway_operation, or one of the next */
        int a, b;
        double value;
    } term[FORM_TERMS];
    int terms;
    bool failed; /* too many terms, or of a term that is none */
    slipway_term rate[2];
};
enum { FORM_CONSTANT = 100, FORM_COORDINATE };

/* As the caller's function builds it.  STATUS_BAD_ARGUMENT: it failed. */
MUST_CHECK enum status form_build(struct slipway_form *f, slipway_rates *rates,
                                  void *ctx);

/* The rates and their derivatives at an absolute point. */
struct vec2 form_rates(const struct slipway_form *f, struct vec2 z,
                       struct mat2 *slope);

/* Coefficient k of the rates' series along two curves of absolute points; as
 * planar.h's jet. */
void form_jet(const struct slipway_form *f, struct jet_work *w, size_t k,
              const jet_pair x[], const jet_pair y[], const jet_pair *rate[2]);

#endif
