#include "basin_proof.h"

#include <stdio.h>
#include <stdlib.h>

#include "study.h"

const char *const label_proof_names[] = { "proved", "near_separatrix",
                                          "beyond_tube", NULL };

/* ---- a cell -------------------------------------------------------------- */

#define BIT(fate) (1u << FATE_##fate)

/* What the theorem allows on a side; that a rest takes a finite time or not is
 * told by the law alone (rest_form.h). */
static unsigned may_be(bool fast, int node)
{
    if (fast)
        return node > 0 ? BIT(SLIDING) : BIT(RUNAWAY);
    return node > 0 ? BIT(CREEP) : BIT(REST_FINITE) | BIT(REST_ASYMPTOTIC);
}

/* -1: another label is proved. */
static int8_t judge(const struct basin_proof *b, const struct proof_row *row,
                    size_t column, int8_t fate)
{
    const int side = column < row->slow ? -1 : column >= row->fast ? 1 : 0;

    if (side == 0 && row->beyond)
        return LABEL_BEYOND;
    if (side == 0 || fate == FATE_UNDECIDED)
        return LABEL_NEAR;
    return b->may[side > 0] >> fate & 1 ? LABEL_PROVED : -1;
}

/* ---- the grid ------------------------------------------------------------ */

/* Cells by what is known of their labels, at [-1 + 1] those that are another.
 */
static enum status count_cells(const struct basin_map *m,
                               const struct basin_proof *b,
                               int64_t cells[1 + LABEL_PROOFS])
{
    enum { BLOCK = 64 };
    int8_t *label = malloc(BLOCK * m->columns);
    enum status status = label ? STATUS_OK : STATUS_NO_MEMORY;

    for (size_t j = 0; j < m->rows && status == STATUS_OK; j += BLOCK) {
        const size_t n = m->rows - j < BLOCK ? m->rows - j : BLOCK;
        status = basin_map_rows(m, j, n, label);
        for (size_t k = 0; k < n * m->columns && status == STATUS_OK; k++)
            cells[1 + judge(b, &b->row[j + k / m->columns], k % m->columns,
                            label[k])]++;
    }
    free(label);
    return status;
}

/* Without a saddle all states are on one side, or go to one node whatever it is
 * called.  Answers why that is not known, or NULL. */
static const char *know_alone(struct basin_proof *b, const struct study *s)
{
    const struct law *law = &s->scene->law;
    const struct material *m = &s->scene->material;
    const struct proof_inputs in = study_proof_inputs(s->scene);
    double window[2];

    b->alone = proof_no_saddle(law, m, &in, window);
    if (b->alone == PROOF_ALONE_NOT)
        return "that there is no saddle was not proved";
    if (b->alone == PROOF_ALONE_RISING) {
        if (!proof_rises_through(law, m))
            return "that there is a steady state was not proved";
        b->may[0] = BIT(CREEP) | BIT(SLIDING);
    }
    const bool to_node =
        b->may[b->alone == PROOF_ALONE_FAST] & (BIT(CREEP) | BIT(SLIDING));
    return to_node && s->slider.plane.equilibria == 0
               ? "the steady state is beyond [1e-300, 1e300]"
               : NULL;
}

/* What becomes of both sides.  Answers why that is not known, or NULL. */
static const char *know(struct basin_proof *b, const struct study *s,
                        const struct proof *p)
{
    const struct law *law = p ? &p->law.law : &s->scene->law;
    const int slow = proof_has_node(law, &s->scene->material, -1);
    const int fast = proof_has_node(law, &s->scene->material, 1);

    b->may[0] = may_be(false, slow);
    b->may[1] = may_be(true, fast);
    if (p && p->not_proved.text[0])
        return p->not_proved.text;
    if (slow < 0 || fast < 0)
        return "what becomes of the sides of the saddle's stable manifold is "
               "not proved for this law";
    return p ? NULL : know_alone(b, s);
}

/* Rows of a grid. */
static enum status cut_rows(const struct proof *p, enum proof_alone alone,
                            const double v[], size_t columns,
                            const double psi[], size_t rows,
                            struct proof_row out[])
{
    const size_t slow = alone == PROOF_ALONE_FAST ? 0 : columns;

    if (p)
        return proof_rows(p, v, columns, psi, rows, out);
    for (size_t j = 0; j < rows; j++)
        out[j] = (struct proof_row){ .slow = slow, .fast = slow };
    return STATUS_OK;
}

/* Into b->row; b->reason where nothing is proved. */
static enum status find(struct basin_proof *b, const struct study *study,
                        const struct proof *p, int64_t cells[1 + LABEL_PROOFS])
{
    const struct basin_map *m = &study->basins;

    b->reason = know(b, study, p);
    if (b->reason)
        return STATUS_OK;
    b->row = malloc(m->rows * sizeof *b->row);
    if (b->row == NULL)
        return STATUS_NO_MEMORY;
    const enum status s =
        cut_rows(p, b->alone, m->v, m->columns, m->psi, m->rows, b->row);
    return s ? s : count_cells(m, b, cells);
}

/* Of so many cells, unless doubles do not say so; without a saddle there is
 * none for them either, but within rounding of a fold. */
static enum status find_lie(struct study *s, int64_t cells[1 + LABEL_PROOFS])
{
    struct basin_proof b = { .row = NULL };
    struct proof exact = { .law.growth = NULL };
    enum status status = STATUS_OK;

    if (s->proof.exact) {
        cells[0] = 0;
        status = study_prove_doubles(s, &exact);
        if (status == STATUS_OK)
            status = find(&b, s, &exact, cells);
    }
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
    const enum status status = find(b, s, s->proof.exact, cells);

    b->fraction = (double) cells[1 + LABEL_PROVED] / (double) all;
    b->near = cells[1 + LABEL_NEAR] + cells[0];
    b->beyond = cells[1 + LABEL_BEYOND];
    return status == STATUS_OK && cells[0] > 0 ? find_lie(s, cells) : status;
}

void basin_proof_rows(const struct study *s, size_t first, size_t count,
                      int8_t out[])
{
    const struct basin_proof *b = &s->label_proof;
    const size_t columns = s->basins.columns;

    for (size_t k = 0; k < count * columns; k++) {
        const struct proof_row *row =
            b->row ? &b->row[first + k / columns] : NULL;
        const int8_t found = row ? judge(b, row, k % columns, out[k]) : -1;
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
        status = cut_rows(s->proof.exact, s->label_proof.alone, v, columns, psi,
                          rows, row);
    }
    for (size_t k = 0; k < rows * columns && status == STATUS_OK; k++)
        if (judge(&s->label_proof, &row[k / columns], k % columns, out[k]) !=
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
