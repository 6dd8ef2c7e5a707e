#include "export_basin.h"

#include <stdio.h>
#include <stdlib.h>

#include "export_fields.h"
#include "store_grid.h"
#include "store_records.h"
#include "tolerance.h"

/* Rows written at a time: whole chunks, each compressed once.  Of those with
 * orbits of their own so many cells between two looks at Ctrl-C. */
enum { BLOCK_ROWS = STORE_CHUNK, LOOK_CELLS = 1 << 13 };

static const char group[] = "/basin";

enum { LABEL, MARGIN, MARGIN_PSI };
static const struct record_field layer[] = {
    [LABEL] = { .name = "label",
                .unit = "1",
                .text = "fate of the state",
                .kind = RECORD_CODE,
                .codes = fate_names },
    [MARGIN] = { .name = "margin",
                 .unit = "1",
                 .text = "ln of the factor on v to the nearest other fate",
                 .kind = RECORD_REAL },
    [MARGIN_PSI] = { .name = "margin_psi",
                     .unit = "1",
                     .text = "shift of ln psi (of psi where it is a logarithm) "
                             "to the nearest other fate",
                     .kind = RECORD_REAL },
};
const struct record_type record_basin = {
    .name = "basin",
    .text = "a map of fates",
    .fields = layer,
    .count = sizeof layer / sizeof *layer,
};

static enum status put_share(struct store *out, const char *fate,
                             const char *measure, const struct quantity *q)
{
    char key[64];

    snprintf(key, sizeof key, "fraction_%s_%s", measure, fate);
    enum status s = store_put_real(out, group, key, q->value);
    if (s != STATUS_OK)
        return s;
    snprintf(key, sizeof key, "fraction_%s_%s_error", measure, fate);
    return store_put_real(out, group, key, q->error);
}

static enum status put_shares(const struct basin_map *m, struct store *out)
{
    enum status s = STATUS_OK;

    for (int i = 0; i < FATES && s == STATUS_OK; i++) {
        if (m->fraction[i].log.value == 0.0)
            continue;
        s = put_share(out, fate_names[i], "log", &m->fraction[i].log);
        if (s == STATUS_OK)
            s = put_share(out, fate_names[i], "linear", &m->fraction[i].linear);
    }
    return s;
}

/* Where map and orbit disagree; states. */
struct disagreement {
    double v, psi;
};
static const struct record_field disagreement_fields[] = {
    { .name = "v",
      .unit = "1",
      .text = "slip rate in units of V_star",
      .offset = offsetof(struct disagreement, v),
      .kind = RECORD_REAL },
    { .name = "psi",
      .unit = "1",
      .text = "interfacial state",
      .offset = offsetof(struct disagreement, psi),
      .kind = RECORD_REAL },
};
const struct record_type record_disagreement = {
    .name = "disagreement",
    .text = "cells whose orbit has another fate than the map says",
    .fields = disagreement_fields,
    .count = 2,
    .size = sizeof(struct disagreement),
};

static enum status put_audit(const struct basin_map *m, struct store *out)
{
    const struct basin_audit *a = &m->audit;
    struct disagreement *row = calloc(a->disagreements + 1, sizeof *row);
    enum status s = row ? STATUS_OK : STATUS_NO_MEMORY;

    for (size_t i = 0; row && i < a->disagreements; i++) {
        row[i].v = m->v[a->wrong[i] % m->columns];
        row[i].psi = m->psi[a->wrong[i] / m->columns];
    }
    const struct record_array rows = { &record_disagreement, row,
                                       a->disagreements };
    if (s == STATUS_OK)
        s = store_put_count(out, group, "audit_cells", (int64_t) a->cells);
    if (s == STATUS_OK)
        s = store_put_count(out, group, "audit_disagreements",
                            (int64_t) a->disagreements);
    if (s == STATUS_OK && a->disagreements > 0)
        s = store_put_records(out, "/basin/disagreement", &rows, NULL);
    free(row);
    return s;
}

struct row_block {
    int8_t *label;     /* owned */
    double *margin[2]; /* owned; NULL where nobody asks */
};

static enum status label_block(const struct basin_map *m, size_t first,
                               size_t count, int8_t label[],
                               const struct monitor *monitor)
{
    const size_t step = m->exact ? LOOK_CELLS / m->columns + 1 : count;
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

static enum status put_block(const struct basin_map *m, struct store *out,
                             struct row_block *b, size_t first, size_t count,
                             const struct monitor *monitor)
{
    enum status s = label_block(m, first, count, b->label, monitor);

    if (s == STATUS_OK)
        s = store_put_rows(out, group, &layer[LABEL], first, count, b->label);
    if (s == STATUS_OK)
        s = export_field_rows(m->study, out, first, count, monitor);
    if (s != STATUS_OK || b->margin[0] == NULL)
        return s;
    s = basin_map_margins(m, first, count, b->margin[0], b->margin[1]);
    if (s == STATUS_OK)
        s = store_put_rows(out, group, &layer[MARGIN], first, count,
                           b->margin[0]);
    if (s == STATUS_OK)
        s = store_put_rows(out, group, &layer[MARGIN_PSI], first, count,
                           b->margin[1]);
    return s;
}

static enum status put_blocks(const struct basin_map *m, struct store *out,
                              struct row_block *b,
                              const struct monitor *monitor)
{
    enum status s = STATUS_OK;

    for (size_t j = 0; j < m->rows && s == STATUS_OK; j += BLOCK_ROWS) {
        const size_t left = m->rows - j;
        s = put_block(m, out, b, j, left < BLOCK_ROWS ? left : BLOCK_ROWS,
                      monitor);
    }
    return s;
}

static enum status put_axes(const struct study *study, bool margins,
                            struct store *out)
{
    const struct basin_map *m = &study->basins;
    const struct planar_axis *axis = study->system.axis;
    enum status s = store_put_axis(out, group, "psi", axis[1].unit,
                                   axis[1].long_name, m->rows, m->psi);

    if (s == STATUS_OK)
        s = store_put_axis(out, group, "v", axis[0].unit, axis[0].long_name,
                           m->columns, m->v);
    if (s == STATUS_OK)
        s = store_put_layer(out, group, &layer[LABEL], "psi", "v");
    if (s == STATUS_OK && margins)
        s = store_put_layer(out, group, &layer[MARGIN], "psi", "v");
    if (s == STATUS_OK && margins)
        s = store_put_layer(out, group, &layer[MARGIN_PSI], "psi", "v");
    if (s == STATUS_OK)
        s = export_field_layers(study, out);
    return s;
}

enum status export_basin(const struct study *s, struct store *out,
                         const struct monitor *monitor)
{
    const struct basin_map *m = &s->basins;
    const bool margins = s->scene->products & (1u << PRODUCT_MARGIN);
    const size_t rows = m->rows < BLOCK_ROWS ? m->rows : BLOCK_ROWS;
    const size_t cells = rows * m->columns;
    struct row_block b = { .label = malloc(cells) };

    for (int i = 0; margins && i < 2; i++)
        b.margin[i] = malloc(cells * sizeof(double));
    enum status status = b.label && (!margins || (b.margin[0] && b.margin[1]))
                             ? put_axes(s, margins, out)
                             : STATUS_NO_MEMORY;
    if (status == STATUS_OK)
        status = put_blocks(m, out, &b, monitor);
    if (status == STATUS_OK)
        status = put_shares(m, out);
    if (status == STATUS_OK)
        status = put_audit(m, out);
    free(b.label);
    free(b.margin[0]);
    free(b.margin[1]);
    return status;
}
