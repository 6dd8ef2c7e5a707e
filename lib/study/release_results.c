/* What an experiment says, either way. */
#include <math.h>
#include <stdlib.h>

#include "release.h"

/* A measurement as stored. */
struct point {
    double tan_alpha, value, error;
};

static const struct record_type record_measured =
    RECORD(point, "measured", "measurements",
           FIELD(point, REAL, tan_alpha, "1", "tangent of the slope angle"),
           FIELD(point, REAL, value, "m", "measured"),
           FIELD(point, REAL, error, "m", "one standard deviation, as given"));

static const struct record_type record_impact =
    RECORD(release, "impact", "the impact",
           FIELD(release, QUANTITY, K, "1",
                 "of (22), where masses and restitution are known"));

static const struct record_type record_spline = RECORD(
    slip_curve, "spline", "the smoothing spline",
    FIELD(slip_curve, REAL, smoothing, "1", "as given, or found from the data"),
    FIELD(slip_curve, REAL, freedom, "1", "parameters that the curve spends"),
    FIELD(slip_curve, TEXT, reason, "1",
          "instead of all this: why there is no curve"));

RESULT_VIEW(view_rows, release, s->row, s->rows)
RESULT_VIEW(view_impact, release, s, 1)

static enum status view_series(const struct series *s, struct result_view *out)
{
    struct point *point = calloc(s->count + 1, sizeof *point);

    if (point == NULL)
        return STATUS_NO_MEMORY;
    for (size_t i = 0; i < s->count; i++)
        point[i] = (struct point){ s->tan_alpha[i], s->value[i],
                                   s->error ? s->error[i] : (double) NAN };
    out->owned = point;
    return result_lend(out, point, s->count);
}

/* A part that only data give. */
#define VIEW_IF(function, here_, view_)                                        \
    static enum status function(const void *run, size_t k,                     \
                                struct result_view *out)                       \
    {                                                                          \
        const struct release *r = run;                                         \
        (void) k;                                                              \
        return (here_) ? view_ : STATUS_OK;                                    \
    }
#define FITTED (r->parabola.points > 0)

VIEW_IF(view_l_k, FITTED, view_series(&r->observed.l_k, out))
VIEW_IF(view_parabola, FITTED, result_lend(out, &r->parabola, 1))
VIEW_IF(view_material, FITTED, result_lend(out, &r->material, 1))
VIEW_IF(view_slip, FITTED && !r->slip.reason,
        result_lend(out, r->slip.at, r->slip.count))
VIEW_IF(view_spline, FITTED, result_lend(out, &r->slip, 1))
VIEW_IF(view_x_k, r->persistence.points > 0, view_series(&r->observed.x_k, out))
VIEW_IF(view_persistence, r->persistence.points > 0,
        result_lend(out, &r->persistence, 1))

/* clang-format off */
static const struct result release_results[] = {
    { "/rabinowicz/release", "", NULL, RESULT_ATTRIBUTES,
      .type = &record_impact, .title = "impact", .view = view_impact },
    { "/rabinowicz/release", "release",
      "rabinowicz: critical release distances of the law", RESULT_COLUMNS,
      .type = &record_release,
      .title = "critical release distances l_k and slips s_k", .view = view_rows },
    { "/rabinowicz/l_k", NULL,
      "with data: release distances as measured", RESULT_COLUMNS,
      .type = &record_measured, .view = view_l_k },
    { "/rabinowicz/fit", "fit", "with l_k: the fit of (33)",
      .type = &record_parabola, .title = "fit of (33) to release distances",
      .view = view_parabola },
    { "/rabinowicz/fit", "fit", NULL, .type = &record_release_material,
      .title = "", .view = view_material },
    { "/rabinowicz/slip", "slip.points",
      "with l_k: friction against slip, (25)", RESULT_COLUMNS, .axis = "mu",
      .type = &record_slip_point, .title = "friction against slip (25)",
      .view = view_slip },
    { "/rabinowicz/slip", "slip", NULL, RESULT_ATTRIBUTES,
      .type = &record_spline, .title = "", .view = view_spline },
    { "/rabinowicz/x_k", NULL,
      "with data: persistence lengths as measured", RESULT_COLUMNS,
      .type = &record_measured, .view = view_x_k },
    { "/rabinowicz/persistence", "persistence", "with x_k: the fit of (30)",
      .type = &record_persistence,
      .title = "fit of (30) to persistence lengths", .view = view_persistence },
    { .path = NULL },
};
/* clang-format on */

const struct result *const release_tables[] = { release_results, NULL };
