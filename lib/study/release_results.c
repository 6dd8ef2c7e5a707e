/* What an experiment says, either way. */
#include <math.h>

#include "release.h"
#include "rows.h"

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
    struct rows r = rows_of(&record_measured);
    enum status status = STATUS_OK;

    for (size_t i = 0; i < s->count && status == STATUS_OK; i++)
        status = rows_push(
            &r, &(struct point){ s->tan_alpha[i], s->value[i],
                                 s->error ? s->error[i] : (double) NAN });
    return rows_lend(out, &r, status);
}

/* Parts that only data give. */
#define FITTED (s->parabola.points > 0)

RESULT_VIEW_IF(view_l_k, release, FITTED, view_series(&s->observed.l_k, out))
RESULT_VIEW_IF(view_parabola, release, FITTED,
               result_lend(out, &s->parabola, 1))
RESULT_VIEW_IF(view_material, release, FITTED,
               result_lend(out, &s->material, 1))
RESULT_VIEW_IF(view_slip, release, FITTED && !s->slip.reason,
               result_lend(out, s->slip.at, s->slip.count))
RESULT_VIEW_IF(view_spline, release, FITTED, result_lend(out, &s->slip, 1))
RESULT_VIEW_IF(view_x_k, release, s->persistence.points > 0,
               view_series(&s->observed.x_k, out))
RESULT_VIEW_IF(view_persistence, release, s->persistence.points > 0,
               result_lend(out, &s->persistence, 1))

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
