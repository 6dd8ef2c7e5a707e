/* What a study says of its basins: the grid, its layers and their shares. */
#include <math.h>
#include <stdlib.h>

#include "rows.h"
#include "study_results.h"
#include "tolerance.h"

/* ---- axes ---------------------------------------------------------------- */

struct psi_at {
    double psi;
};
struct v_at {
    double v;
};

static const struct record_type record_psi =
    RECORD(psi_at, "psi", "rows of the grid",
           FIELD(psi_at, REAL, psi, "psi", "interfacial state"));

static const struct record_type record_v =
    RECORD(v_at, "v", "columns of the grid",
           FIELD(v_at, REAL, v, "V_star", "slip rate in units of V_star"));

RESULT_VIEW(view_psi, study, s->basins.psi, s->basins.rows)
RESULT_VIEW(view_v, study, s->basins.v, s->basins.columns)

/* ---- labels and margins -------------------------------------------------- */

/* Of cells with orbits of their own so many between two looks at Ctrl-C. */
enum { LOOK_CELLS = 1 << 13 };

struct label {
    int8_t label;
};
struct margins {
    double margin, margin_psi;
};

static const struct record_type record_label =
    RECORD(label, "label", "a map of fates",
           FIELD_CODE(label, label, fate_names, "fate of the state"));

static const struct record_type record_margins = RECORD(
    margins, "margin", "how far another fate is",
    FIELD(margins, REAL, margin, "1",
          "ln of the factor on v to the nearest other fate; missing: there is "
          "none"),
    FIELD(margins, REAL, margin_psi, "1",
          "shift of ln psi (of psi where it is a logarithm) to the nearest "
          "other fate; missing: there is none"));

static enum status label_rows(const void *run, size_t first, size_t count,
                              const struct monitor *monitor, void *records)
{
    const struct basin_map *m = &((const struct study *) run)->basins;
    const size_t step = m->exact ? LOOK_CELLS / m->columns + 1 : count;
    int8_t *label = records;
    enum status s = STATUS_OK;

    for (size_t j = 0; j < count && s == STATUS_OK; j += step) {
        const size_t n = count - j < step ? count - j : step;
        s = basin_map_rows(m, first + j, n, label + j * m->columns);
        if (s == STATUS_OK &&
            monitor_tell(monitor, "rows", first + j + n, m->rows))
            s = STATUS_STOPPED;
    }
    return s;
}

static double known(double margin)
{
    return isfinite(margin) ? margin : (double) NAN;
}

static enum status margin_rows(const void *run, size_t first, size_t count,
                               const struct monitor *monitor, void *records)
{
    const struct basin_map *m = &((const struct study *) run)->basins;
    const size_t n = count * m->columns;
    double *both = malloc(2 * n * sizeof *both);
    struct margins *out = records;
    enum status s = both ? basin_map_margins(m, first, count, both, both + n)
                         : STATUS_NO_MEMORY;

    (void) monitor;
    for (size_t i = 0; i < n && s == STATUS_OK; i++)
        out[i] = (struct margins){ known(both[i]), known(both[n + i]) };
    free(both);
    return s;
}

/* ---- proofs ---------------------------------------------------------------
 */

static const struct record_field proved_fields[] = {
    { "proved", "1", "whether the label is proved", 0, RECORD_CODE,
      label_proof_names, NULL },
};
static const struct record_type record_proved = {
    "proved", "what is proved of labels", proved_fields, 1, sizeof(int8_t)
};

static enum status proved_rows(const void *run, size_t first, size_t count,
                               const struct monitor *monitor, void *records)
{
    const enum status status = label_rows(run, first, count, monitor, records);

    if (status == STATUS_OK)
        basin_proof_rows(run, first, count, records);
    return status;
}

static const struct record_type record_proof = RECORD(
    basin_proof, "proved", "labels that are proved",
    FIELD(basin_proof, REAL, fraction, "1",
          "share of the cells whose label is proved"),
    FIELD(basin_proof, COUNT, near, "1",
          "cells whose row meets the manifold there, as far as is proved"),
    FIELD(basin_proof, COUNT, beyond, "1",
          "cells in rows that the manifold meets beyond what is proved of it"),
    FIELD(basin_proof, TEXT, reason, "1", "why no label is proved"));

RESULT_VIEW(view_proof, study, &s->label_proof, 1)

/* ---- fields of cells ----------------------------------------------------- */

static enum status cell_rows(const void *run, size_t first, size_t count,
                             const struct monitor *monitor, void *records)
{
    const struct study *s = run;

    return fields_find(&s->fields, first, count, monitor, records);
}

/* What the fields were computed to. */
struct accuracy {
    double cell_rtol, cell_arrest;
};

const struct record_type record_accuracy = RECORD(
    accuracy, "accuracy", "what cells are computed to",
    FIELD(accuracy, REAL, cell_rtol, "1", "basins.rtol"),
    FIELD(accuracy, REAL, cell_arrest, "1",
          "a state has arrived this near to a node, in ln v and in ln psi"));

ROWS_VIEW(view_accuracy, study,
          rows_push(&r, &(struct accuracy){ s->fields.rtol, TOL_ARREST }))

/* ---- shares and audit ---------------------------------------------------- */

const struct record_type record_share = RECORD(
    basin_fraction, "fractions", "shares of the window",
    FIELD(basin_fraction, QUANTITY, log, "1",
          "share of the window with this fate, by area in (ln v, ln psi)"),
    FIELD(basin_fraction, QUANTITY, linear, "1",
          "share of the window with this fate, by area in (v, psi)"));

RESULT_VIEW_IF(view_share, study, s->basins.fraction[k].log.value > 0.0,
               result_lend(out, &s->basins.fraction[k], 1))

_Static_assert(sizeof(size_t) == sizeof(int64_t), "counts of record.h");

const struct record_type record_audit = RECORD(
    basin_audit, "audit", "map against orbits",
    FIELD(basin_audit, COUNT, cells, "1", "cells followed forward in time"),
    FIELD(basin_audit, COUNT, disagreements, "1", "those with another fate"));

RESULT_VIEW(view_audit, study, &s->basins.audit, 1)

/* A cell whose orbit has another fate than the map says. */
struct disagreement {
    double v, psi;
};

static const struct record_type record_disagreement = RECORD(
    disagreement, "disagreement",
    "cells whose orbit has another fate than the map says",
    FIELD(disagreement, REAL, v, "V_star", "slip rate in units of V_star"),
    FIELD(disagreement, REAL, psi, "psi", "interfacial state"));

static enum status view_disagreement(const void *run, size_t k,
                                     struct result_view *out)
{
    const struct basin_map *m = &((const struct study *) run)->basins;
    const size_t n = m->audit.disagreements;
    struct rows r = rows_of(&record_disagreement);
    enum status status = STATUS_OK;

    for (k = 0; k < n && status == STATUS_OK; k++)
        status = rows_push(&r, &(struct disagreement){
                                   m->v[m->audit.wrong[k] % m->columns],
                                   m->psi[m->audit.wrong[k] / m->columns] });
    return n > 0 ? rows_lend(out, &r, status) : STATUS_OK;
}

/* ---- what stands for the layers where there is no room for them -----------
 */

/* Columns, rows. */
static enum status view_cells(const void *run, size_t k,
                              struct result_view *out)
{
    const struct basin_map *m = &((const struct study *) run)->basins;
    int64_t *cells = malloc(2 * sizeof *cells);

    (void) k;
    if (cells == NULL)
        return STATUS_NO_MEMORY;
    cells[0] = (int64_t) m->columns;
    cells[1] = (int64_t) m->rows;
    out->owned = cells;
    return result_lend(out, cells, 2);
}

static enum status view_fields(const void *run, size_t k,
                               struct result_view *out)
{
    const struct fields *f = &((const struct study *) run)->fields;
    const char **name = (const char **) malloc(CELL_FIELDS * sizeof *name);
    size_t n = 0;

    (void) k;
    if (name == NULL)
        return STATUS_NO_MEMORY;
    for (int i = 0; i < CELL_FIELDS; i++)
        if (f->which >> i & 1u)
            name[n++] = cell_fields[1 + 2 * i].name;
    out->owned = (void *) name;
    return result_lend(out, (const void *) name, n);
}

static const struct record_type record_cells =
    RECORD_OF(int64_t, "cells", "size of the grid",
              FIELD_OF(COUNT, "cells", "1", "columns and rows"));
static const struct record_type record_names =
    RECORD_OF(char *, "fields", "fields of each cell",
              FIELD_OF(TEXT, "fields", "1", "a field of the cells"));

/* ---- the table ----------------------------------------------------------- */

#define FIELDS                                                                 \
    (ASKED_AS(SLIP) | ASKED_AS(TIME) | ASKED_AS(FRICTION) | ASKED_AS(PEAK))

/* Members first .. first + count - 1 of record_cell. */
#define CELLS(name_, first, count_)                                            \
    static const struct record_type name_ = { "cell",                          \
                                              "how a state comes to arrest",   \
                                              cell_fields + (first), count_,   \
                                              sizeof(struct cell) }
CELLS(record_exit, 0, 1);
CELLS(record_slip, 1, 2);
CELLS(record_time, 3, 2);
CELLS(record_mu_mean, 5, 2);
CELLS(record_peak, 7, 4);

/* clang-format off */
const struct result basin_results[] = {
    { "/basin", NULL, "product basins, and those beside it: a grid of states",
      RESULT_COLUMNS, .axis = "psi", .type = &record_psi,
      .needs = ASKED_BY(BASINS), .view = view_psi },
    { "/basin", NULL, NULL, RESULT_COLUMNS, .axis = "v", .type = &record_v,
      .needs = ASKED_BY(BASINS), .view = view_v },
    { "/basin", NULL, "product basins", RESULT_LAYERS, .axis = "psi, v",
      .type = &record_label, .needs = ASKED_BY(BASINS), .rows = label_rows },
    { "/basin", NULL, "product basins with accuracy.proved", RESULT_LAYERS,
      .axis = "psi, v", .type = &record_proved, .needs = ASKED_BY(SIDES),
      .rows = proved_rows },
    { "/basin", NULL, "product margin", RESULT_LAYERS, .axis = "psi, v",
      .type = &record_margins, .needs = ASKED_AS(MARGIN),
      .rows = margin_rows },
    { "/basin", NULL, "with any of the products below; slip and time run to "
      "arrest; a value is NaN where there is none", RESULT_LAYERS,
      .axis = "psi, v", .type = &record_exit, .needs = FIELDS,
      .rows = cell_rows },
    { "/basin", NULL, "product slip", RESULT_LAYERS, .axis = "psi, v",
      .type = &record_slip, .needs = ASKED_AS(SLIP), .rows = cell_rows },
    { "/basin", NULL, "product time", RESULT_LAYERS, .axis = "psi, v",
      .type = &record_time, .needs = ASKED_AS(TIME), .rows = cell_rows },
    { "/basin", NULL, "product friction", RESULT_LAYERS, .axis = "psi, v",
      .type = &record_mu_mean, .needs = ASKED_AS(FRICTION),
      .rows = cell_rows },
    { "/basin", NULL, "product peak", RESULT_LAYERS, .axis = "psi, v",
      .type = &record_peak, .needs = ASKED_AS(PEAK), .rows = cell_rows },
    { "/basin", NULL, "with fields of cells", RESULT_ATTRIBUTES,
      .type = &record_accuracy, .needs = FIELDS, .view = view_accuracy },
    { NULL, "basin.cells", NULL, RESULT_COLUMNS, .type = &record_cells,
      .title = "basins in the window", .needs = ASKED_BY(BASINS), .view = view_cells },
    { "/basin", "basin.fractions." FATE_WORDS,
      "shares of the window, of fates that are there", RESULT_ATTRIBUTES,
      .member = "fraction_*_" FATE_WORDS, .type = &record_share,
      .title = "", .needs = ASKED_BY(BASINS), .view = view_share },
    { "/basin", "basin.audit", NULL, RESULT_ATTRIBUTES, .member = "audit_*",
      .type = &record_audit, .title = "", .needs = ASKED_BY(BASINS), .view = view_audit },
    { "/basin", "basin.proved", NULL, RESULT_ATTRIBUTES, .member = "proved_*",
      .type = &record_proof, .title = "", .needs = ASKED_BY(SIDES), .view = view_proof },
    { NULL, "basin.fields", NULL, RESULT_COLUMNS, .type = &record_names,
      .title = "", .needs = ASKED_BY(BASINS), .view = view_fields },
    { NULL, NULL, NULL, RESULT_ATTRIBUTES, .type = &record_accuracy,
      .title = "", .needs = FIELDS, .view = view_accuracy },
    { "/basin/disagreement", NULL, "where the audit disagrees, if it does; "
      "the command then exits with 3", RESULT_COLUMNS,
      .type = &record_disagreement, .needs = ASKED_BY(BASINS),
      .view = view_disagreement },
    { .path = NULL },
};
/* clang-format on */
