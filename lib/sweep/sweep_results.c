#include "sweep_results.h"

#include <string.h>

#include "scene_slope.h"
#include "scene_sweep.h"
#include "study_results.h"
#include "sweep_point.h"

/* Bits that no study has. */
#define BY_RELEASE   ((uint64_t) 1 << 60)
#define BY_AUDIT     ((uint64_t) 1 << 61)
#define BY_KINDS     ((uint64_t) 1 << 62)
#define BY_PSI_KINDS ((uint64_t) 1 << 63)
_Static_assert((int) STAGES + (int) PRODUCTS <= 60, "a bit for each");

uint64_t sweep_asked(const struct scene *scene)
{
    const bool steady = scene_has_slope(scene);
    const bool kinds = steady && scene->products & 1u << PRODUCT_EQUILIBRIA;

    return plan_stages(scene->products) | (uint64_t) scene->products << STAGES |
           (steady ? ASKED_BY(STEADY) : 0) |
           (scene_sweep_releases(scene) ? BY_RELEASE : 0) |
           (scene->audit > 0 && !scene->exact &&
                    plan_has(plan_stages(scene->products), STAGE_BASINS)
                ? BY_AUDIT
                : 0) |
           (kinds ? BY_KINDS : 0) |
           (kinds && !law_psi_is_log(&scene->law) ? BY_PSI_KINDS : 0);
}

/* ---- of the study -------------------------------------------------------- */

/* One for each xi of the scene. */
RESULT_COUNT(count_xi, sweep_point, s->scene.xi_count)

RESULT_VIEW(view_xi, sweep_point, &s->study.estimates.xi[k], 1)
RESULT_VIEW(view_terms, sweep_point, s->study.taylor.term, JET_SIZE)
RESULT_VIEW(view_chi, sweep_point, s->study.diagrams.chi.slope,
            s->study.diagrams.chi.slopes)
RESULT_VIEW(view_share, sweep_point, &s->study.basins.fraction[k], 1)
RESULT_VIEW(view_audit, sweep_point, &s->study.basins.audit, 1)

static const struct record_type record_arrow_cell =
    RECORD(arrow, "arrow", "direction field",
           FIELD_AS(arrow, REAL, "direction_v", direction.x, "1",
                    "unit direction as drawn, along v"),
           FIELD_AS(arrow, REAL, "direction_psi", direction.y, "1",
                    "unit direction as drawn, along psi"),
           FIELD(arrow, REAL, log10_speed, "log10(V_star/L)",
                 "log10 of the speed in (ln v, ln psi) per L/V_star"));

static enum status arrow_rows(const void *run, size_t first, size_t count,
                              const struct monitor *monitor, void *records)
{
    const struct sweep_point *p = run;
    const struct arrows *a = &p->study.portrait.arrows;

    (void) monitor;
    memcpy(records, a->at + first * a->columns,
           count * a->columns * sizeof *a->at);
    return STATUS_OK;
}

/* ---- steady states by what they are -------------------------------------- */

static const struct record_type record_kind = RECORD(
    kind_numbers, "kind", "a steady state by what it is",
    FIELD(kind_numbers, QUANTITY, v, "V_star", "slip rate in units of V_star"),
    FIELD(kind_numbers, QUANTITY, psi, "psi", "interfacial state"),
    FIELD(kind_numbers, QUANTITY, lambda_minus, "V_star/L",
          "smaller eigenvalue, per L/V_star"),
    FIELD(kind_numbers, QUANTITY, lambda_plus, "V_star/L",
          "larger eigenvalue, per L/V_star"));

static const struct record_type record_ln_v =
    RECORD(kind_numbers, "ln_v", "its slip rate",
           FIELD(kind_numbers, QUANTITY, ln_v, "ln(V_star)",
                 "natural logarithm of v"));

static const struct record_type record_ln_psi =
    RECORD(kind_numbers, "ln_psi", "its state",
           FIELD(kind_numbers, QUANTITY, ln_psi, "ln(psi)",
                 "natural logarithm of psi"));

RESULT_VIEW(view_kind, sweep_point, &s->kind[k], 1)
RESULT_VIEW(view_node, sweep_point,
            &s->kind[k == 0 ? STEADY_CREEP : STEADY_SLIDING], 1)

/* ---- runs ---------------------------------------------------------------- */

static const struct record_type record_defect =
    RECORD(transient_summary, "energy", "balance of energy",
           FIELD(transient_summary, REAL, energy_defect, "1",
                 "relative defect of the balance of energy (27)"));

static const struct record_type record_moment = RECORD(
    transient_event, "moment", "an event of a run", TRANSIENT_EVENT_NUMBERS);

/* Those that have a name of their own, in the order of the words below. */
static const enum moment firsts[] = {
    MOMENT_V_SP,    MOMENT_V_MINUS, MOMENT_V_PLUS, MOMENT_PSI_MIN,
    MOMENT_PSI_MAX, MOMENT_MU_MIN,  MOMENT_MU_MAX, MOMENT_V_MIN,
    MOMENT_V_MAX,   MOMENT_ARREST,  MOMENT_REST,
};
#define FIRST_WORDS                                                            \
    "{v_sp,v_minus,v_plus,psi_minimum,psi_maximum,mu_minimum,mu_maximum,"      \
    "v_minimum,v_maximum,arrest,rest}"
enum { FIRSTS = sizeof firsts / sizeof *firsts };

RESULT_VIEW(view_sum, sweep_point, &s->start[k].sum, 1)
RESULT_VIEW(view_phases, sweep_point, s->start[k].phase, PHASES)
RESULT_VIEW(view_first, sweep_point,
            &s->start[k / FIRSTS].first[firsts[k % FIRSTS]], 1)
RESULT_VIEW(view_levels, sweep_point,
            k % 2 ? s->start[k / 2].leaves : s->start[k / 2].nears,
            MOMENT_LEVELS_MAX)

RESULT_VIEW(view_release, sweep_point, &s->release, 1)

/* ---- the table ----------------------------------------------------------- */

/* clang-format off */
static const struct result point_results[] = {
    { NULL, "estimates.xi[K]", NULL, .type = &record_xi,
      .needs = ASKED_BY(ESTIMATES), .count = count_xi, .view = view_xi },
    { NULL, "taylor_series", NULL, RESULT_COLUMNS, .axis = "order",
      .type = &record_taylor_term, .needs = ASKED_BY(TAYLOR),
      .view = view_terms },
    { NULL, "chi", NULL, RESULT_COLUMNS, .axis = "chi_alpha",
      .type = &record_chi_slope, .needs = ASKED_BY(CHI), .view = view_chi },
    { NULL, "basin", NULL, RESULT_ATTRIBUTES,
      .member = "fraction_*_" FATE_WORDS, .type = &record_share,
      .needs = ASKED_BY(BASINS), .view = view_share },
    { NULL, "basin", NULL, RESULT_ATTRIBUTES, .member = "audit_*",
      .type = &record_audit, .needs = BY_AUDIT, .view = view_audit },
    { NULL, "trajectory", NULL, .axis = "start", .type = &record_transient,
      .needs = ASKED_BY(TRAJECTORIES), .view = view_sum },
    { NULL, "trajectory", NULL, RESULT_ATTRIBUTES, .axis = "start",
      .type = &record_defect, .needs = ASKED_BY(TRAJECTORIES),
      .view = view_sum },
    { NULL, "trajectory.phase", NULL, RESULT_COLUMNS, .axis = "start, phase",
      .type = &record_phase, .needs = ASKED_BY(TRAJECTORIES),
      .view = view_phases },
    { NULL, "trajectory." FIRST_WORDS, NULL, .axis = "start",
      .type = &record_moment, .needs = ASKED_BY(TRAJECTORIES),
      .view = view_first },
    { NULL, "trajectory.{mu_nears,mu_leaves}", NULL, RESULT_COLUMNS,
      .axis = "start, level", .type = &record_moment,
      .needs = ASKED_BY(TRAJECTORIES), .view = view_levels },
    { NULL, "rabinowicz", NULL, .type = &record_release, .needs = BY_RELEASE,
      .view = view_release },
    { NULL, "{creep,saddle,sliding}", NULL, .type = &record_ln_v,
      .needs = BY_KINDS, .view = view_kind },
    { NULL, "{creep,saddle,sliding}", NULL, .type = &record_ln_psi,
      .needs = BY_PSI_KINDS, .view = view_kind },
    { NULL, "{creep,sliding}", NULL, .type = &record_kind, .needs = BY_KINDS,
      .view = view_node },
    { "/arrow", NULL, NULL, RESULT_LAYERS, .axis = "psi, v",
      .type = &record_arrow_cell, .needs = ASKED_BY(ARROWS),
      .rows = arrow_rows },
    { .path = NULL },
};
/* clang-format on */

const struct result *const point_tables[] = { point_results, NULL };
