#include "export_fields.h"

#include <stdlib.h>
#include <string.h>

#include "store_grid.h"
#include "tolerance.h"

static const char group[] = "/basin";

/* Number i of record_cell; exit_reason always is. */
static bool is_asked(const struct study *s, size_t i)
{
    return i == 0 || (s->fields.which >> (i - 1) / 2 & 1u);
}

enum status export_field_layers(const struct study *s, struct store *out)
{
    enum status status = STATUS_OK;

    if (s->fields.which == 0)
        return STATUS_OK;
    for (size_t i = 0; i < record_cell.count && status == STATUS_OK; i++)
        if (is_asked(s, i))
            status =
                store_put_layer(out, group, &record_cell.fields[i], "psi", "v");
    if (status == STATUS_OK)
        status = store_put_real(out, group, "cell_rtol", s->fields.rtol);
    if (status == STATUS_OK)
        status = store_put_real(out, group, "cell_arrest", TOL_ARREST);
    return status;
}

/* One member of all cells, as the file holds it. */
static void gather(const struct cell cell[], size_t n,
                   const struct record_field *f, void *out)
{
    const size_t size =
        f->kind == RECORD_CODE ? sizeof(int8_t) : sizeof(double);

    for (size_t i = 0; i < n; i++)
        memcpy((char *) out + i * size, (const char *) &cell[i] + f->offset,
               size);
}

enum status export_field_rows(const struct study *s, struct store *out,
                              size_t first, size_t count,
                              const struct monitor *monitor)
{
    const size_t columns = s->basins.columns, n = count * columns;

    if (s->fields.which == 0)
        return STATUS_OK;
    struct cell *cell = malloc(n * sizeof *cell);
    double *one = malloc(n * sizeof *one);
    enum status status =
        cell && one ? fields_find(&s->fields, first, count, monitor, cell)
                    : STATUS_NO_MEMORY;
    for (size_t i = 0; i < record_cell.count && status == STATUS_OK; i++) {
        const struct record_field *f = &record_cell.fields[i];
        if (!is_asked(s, i))
            continue;
        gather(cell, n, f, one);
        status = store_put_rows(out, group, f, first, count, one);
    }
    free(cell);
    free(one);
    return status;
}
