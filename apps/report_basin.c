#include "report_basin.h"

#include "study.h"

static bool is_there(const struct basin_map *m, int fate)
{
    return m->fraction[fate].log.value > 0.0;
}

/* They are too many to print. */
static void print_fields(FILE *out, const struct fields *f)
{
    const struct scene *c = f->map->scene;

    fprintf(out, "  fields of each cell:");
    for (int k = 0; k < CELL_FIELDS; k++)
        if (f->which >> k & 1u)
            fprintf(out, " %s", record_cell.fields[1 + 2 * k].name);
    fprintf(out, ", to a relative %.6g\n", f->rtol);
    if (c->hdf5 == NULL)
        fprintf(out, "  they are computed for files only: give -o FILE.h5%s\n",
                c->figure ? "" : " or --figure FILE");
}

void report_basin_print(FILE *out, const struct basin_map *m,
                        const struct fields *f)
{
    fprintf(out, "basins in the window, %zu x %zu cells\n", m->columns,
            m->rows);
    fprintf(out, "  %-16s %-30s %s\n", "fate", "share in the chart",
            "share in v and psi");
    for (int i = 0; i < FATES; i++) {
        const struct basin_fraction *share = &m->fraction[i];
        if (is_there(m, i))
            fprintf(out, "  %-16s %-17.13f +- %-9.1e %.13f +- %.1e\n",
                    fate_names[i], share->log.value, share->log.error,
                    share->linear.value, share->linear.error);
    }
    if (m->audit.cells > 0)
        fprintf(out, "  audit: %zu cells followed, %zu disagree\n",
                m->audit.cells, m->audit.disagreements);
    if (f->which)
        print_fields(out, f);
}
