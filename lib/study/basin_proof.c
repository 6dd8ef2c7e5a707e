#include "basin_proof.h"

#include <stdio.h>
#include <stdlib.h>

#include "study.h"

const char *const label_proof_names[] = { "proved", "near_separatrix",
                                          "beyond_tube", NULL };

/* ---- a cell -------------------------------------------------------------- */

/* What the theorem allows on a side; that a rest takes a finite time or not is
 * told by the law alone (rest_form.h). */
static bool may_be(const struct proof *p, int side, int8_t fate)
{
    const bool node = proof_has_node(p, side) == 1;

    if (side > 0)
        return fate == (node ? FATE_SLIDING : FATE_RUNAWAY);
    return node ? fate == FATE_CREEP
                : fate == FATE_REST_FINITE || fate == FATE_REST_ASYMPTOTIC;
}

/* -1: another label is proved. */
static int8_t judge(const struct proof *p, const struct proof_row *row,
                    size_t column, int8_t fate)
{
    const int side = column < row->slow ? -1 : column >= row->fast ? 1 : 0;

    if (side == 0 && row->beyond)
        return LABEL_BEYOND;
    if (side == 0 || fate == FATE_UNDECIDED)
        return LABEL_NEAR;
    return may_be(p, side, fate) ? LABEL_PROVED : -1;
}

/* ---- the grid ------------------------------------------------------------ */

/* Cells by what is known of their labels, at [-1 + 1] those that are another.
 */
static enum status count_cells(const struct basin_map *m, const struct proof *p,
                               const struct proof_row row[],
                               int64_t cells[1 + LABEL_PROOFS])
{
    enum { BLOCK = 64 };
    int8_t *label = malloc(BLOCK * m->columns);
    enum status status = label ? STATUS_OK : STATUS_NO_MEMORY;

    for (size_t j = 0; j < m->rows && status == STATUS_OK; j += BLOCK) {
        const size_t n = m->rows - j < BLOCK ? m->rows - j : BLOCK;
        status = basin_map_rows(m, j, n, label);
        for (size_t k = 0; k < n * m->columns && status == STATUS_OK; k++)
            cells[1 + judge(p, &row[j + k / m->columns], k % m->columns,
                            label[k])]++;
    }
    free(label);
    return status;
}

/* Into b->row; b->reason where nothing is proved. */
static enum status find(struct basin_proof *b, const struct basin_map *m,
                        const struct proof *p, int64_t cells[1 + LABEL_PROOFS])
{
    b->reason = p == NULL               ? "there is no saddle at this slope"
                : p->not_proved.text[0] ? p->not_proved.text
                : proof_has_node(p, 1) < 0 || proof_has_node(p, -1) < 0
                    ? "what becomes of the sides of the saddle's stable "
                      "manifold is not proved for this law"
                    : NULL;
    if (b->reason)
        return STATUS_OK;
    b->row = malloc(m->rows * sizeof *b->row);
    if (b->row == NULL)
        return STATUS_NO_MEMORY;
    const enum status s =
        proof_rows(p, m->v, m->columns, m->psi, m->rows, b->row);
    return s ? s : count_cells(m, p, b->row, cells);
}

/* Whether doubles say so, too. */
static enum status find_lie(struct study *s)
{
    int64_t cells[1 + LABEL_PROOFS] = { 0 };
    struct basin_proof b = { .row = NULL };
    struct proof exact;
    enum status status = study_prove_doubles(s, &exact);

    if (status == STATUS_OK)
        status = find(&b, &s->basins, &exact, cells);
    if (cells[0] > 0)
        snprintf(s->proof.lie.text, sizeof s->proof.lie.text,
                 "basin: another label is proved of %lld cells",
                 (long long) cells[0]);
    basin_proof_free(&b);
    proof_free(&exact);
    return status;
}

enum status basin_prove(struct study *s)
{
    struct basin_proof *b = &s->label_proof;
    int64_t cells[1 + LABEL_PROOFS] = { 0 };
    const size_t all = s->basins.rows * s->basins.columns;
    const enum status status = find(b, &s->basins, s->proof.exact, cells);

    b->fraction = (double) cells[1 + LABEL_PROVED] / (double) all;
    b->near = cells[1 + LABEL_NEAR] + cells[0];
    b->beyond = cells[1 + LABEL_BEYOND];
    return status == STATUS_OK && cells[0] > 0 ? find_lie(s) : status;
}

void basin_proof_rows(const struct study *s, size_t first, size_t count,
                      int8_t out[])
{
    const struct basin_proof *b = &s->label_proof;
    const size_t columns = s->basins.columns;

    for (size_t k = 0; k < count * columns; k++) {
        const struct proof_row *row =
            b->row ? &b->row[first + k / columns] : NULL;
        const int8_t found =
            row ? judge(s->proof.exact, row, k % columns, out[k]) : -1;
        out[k] = row && found < 0 ? (int8_t) LABEL_NEAR : found;
    }
}

enum status basin_proof_hide(const struct study *s, size_t columns, size_t rows,
                             int8_t out[])
{
    double *axis = malloc(2 * (columns + rows) * sizeof *axis);
    struct proof_row *row = malloc((rows + 1) * sizeof *row);
    enum status status = axis && row ? STATUS_OK : STATUS_NO_MEMORY;
    double *v = axis + columns, *psi = v + columns;

    if (status == STATUS_OK) {
        basin_map_axis(s->scene, BASIN_V, columns, axis, v);
        basin_map_axis(s->scene, BASIN_PSI, rows, psi + rows, psi);
        status = proof_rows(s->proof.exact, v, columns, psi, rows, row);
    }
    for (size_t k = 0; k < rows * columns && status == STATUS_OK; k++)
        if (judge(s->proof.exact, &row[k / columns], k % columns, out[k]) !=
            LABEL_PROVED)
            out[k] = FATE_NONE;
    free(axis);
    free(row);
    return status;
}

void basin_proof_free(struct basin_proof *b)
{
    free(b->row);
    b->row = NULL;
}
