#include "report_sweep.h"

#include <math.h>
#include <string.h>

#include "sweep_told.h"

/* ---- tables -------------------------------------------------------------- */

/* More points than these are shown in part; and at most so many columns. */
enum { ROWS = 24, SHOWN = 8 };

/* Some columns, of those with more the same entry. */
struct shown {
    int column[SHOWN];
    struct sweep_name name[SHOWN]; /* with the unit */
    size_t count, entry;
};

static bool is_there(const struct sweep *s, int column)
{
    for (size_t i = 0; i < s->points; i++) {
        const struct quantity q = sweep_quantity(s, column, i);
        if (quantity_exists(&q) && q.value != 0.0)
            return true;
    }
    return false;
}

/* "time (s)" */
static struct sweep_name head_of(const struct sweep *s, const char *name,
                                 int column)
{
    const struct unit_system u = sweep_answer_units(s, 0);
    const char *unit = sweep_column_unit(s, &u, column);
    const bool bare = strcmp(unit, "1") == 0;
    struct sweep_name head;

    snprintf(head.text, sizeof head.text, "%s%s%s%s", name, bare ? "" : " (",
             bare ? "" : unit, bare ? "" : ")");
    return head;
}

/* A column, if the sweep has it. */
static void add(struct shown *t, const struct sweep *s, const char *column,
                const char *name)
{
    const int k = sweep_find(s, column);

    if (k < 0 || t->count == SHOWN)
        return;
    t->column[t->count] = k;
    t->name[t->count++] = head_of(s, name, k);
}

static void print_axes(FILE *out, const struct sweep *s)
{
    for (size_t k = 0; k < s->axes; k++) {
        const struct sweep_axis *a = &s->axis[k];
        const char *unit = sweep_told_unit(s, a->key.unit);
        fprintf(out, "%s: %zu values from %.6g to %.6g%s%s\n", a->key.path,
                a->count, a->value[0], a->value[a->count - 1],
                *unit == '1' ? "" : " ", *unit == '1' ? "" : unit);
    }
}

static void print_entry(FILE *out, const struct sweep *s, int k, size_t point,
                        size_t entry)
{
    const struct sweep_column *c = &s->columns.at[k];

    if (c->codes) {
        const int code = sweep_entry_code(s, k, point, entry);
        fprintf(out, " %-16s", code < 0 ? "-" : c->codes[code]);
        return;
    }
    const struct unit_system u = sweep_answer_units(s, point);
    const struct quantity q = sweep_told(s, &u, k, point, entry);
    if (quantity_exists(&q))
        fprintf(out, " %-16.10g", q.value);
    else
        fprintf(out, " %-16s", "-");
}

static void print_point(FILE *out, const struct sweep *s, const struct shown *t,
                        size_t i)
{
    const size_t inner = s->axes > 1 ? s->axis[1].count : 1;

    fprintf(out, "  %-14.8g", s->axis[0].value[i / inner]);
    if (s->axes > 1)
        fprintf(out, " %-14.8g", s->axis[1].value[i % inner]);
    for (size_t k = 0; k < t->count; k++)
        print_entry(out, s, t->column[k], i, t->entry);
    fputc('\n', out);
}

static void print_table(FILE *out, const struct sweep *s, const struct shown *t)
{
    const size_t rows = s->points < ROWS ? s->points : ROWS;

    for (size_t k = 0; k < s->axes; k++)
        fprintf(out, "%s%-14s", k ? " " : "  ", s->axis[k].name);
    for (size_t k = 0; k < t->count; k++)
        fprintf(out, " %-16s", t->name[k].text);
    fputc('\n', out);
    for (size_t i = 0; i < rows; i++)
        print_point(out, s, t, rows > 1 ? i * (s->points - 1) / (rows - 1) : 0);
    if (rows < s->points)
        fprintf(out, "  (%zu of %zu points)\n", rows, s->points);
}

/* ---- numbers ------------------------------------------------------------- */

static void print_numbers(FILE *out, const struct sweep *s)
{
    struct shown t = { .count = 0 };

    add(&t, s, "saddle_v", "saddle_v");
    add(&t, s, "v_minus", "v_minus");
    add(&t, s, "v_plus", "v_plus");
    add(&t, s, "mu_s_num", "mu_s_num");
    add(&t, s, "rabinowicz_l_k", "rabinowicz_l_k");
    print_table(out, s, &t);
}

/* "v_plus is missing at 3 of 41 points: there is no saddle at this slope" */
static void print_missing(FILE *out, const struct sweep *s, const char *name)
{
    const int column = sweep_find(s, name);

    for (size_t r = 0; column >= 0 && r < s->reasons.count; r++) {
        size_t count = 0;
        for (size_t i = 0; i < s->points; i++)
            count += sweep_code(s, column, i) == (int) r;
        if (r != REASON_PRESENT && count > 0)
            fprintf(out, "%s is missing at %zu of %zu points: %s\n", name,
                    count, s->points, s->reasons.text[r]);
    }
}

static void print_shares(FILE *out, const struct sweep *s)
{
    struct shown t = { .count = 0 };

    for (int i = 0; i < FATES; i++) {
        char name[64];
        snprintf(name, sizeof name, "basin_fraction_log_%s", fate_names[i]);
        const int k = sweep_find(s, name);
        if (k >= 0 && is_there(s, k))
            add(&t, s, name, fate_names[i]);
    }
    if (t.count == 0)
        return;
    fprintf(out, "basins: share of the window in the chart\n");
    print_table(out, s, &t);
}

static void print_start(FILE *out, const struct sweep *s, size_t i)
{
    const struct scene_start *z = &s->scene->start[i];
    const char *psi = sweep_told_unit(s, "psi");

    fprintf(out, "start %zu: v = %.10g %s, %s = %.10g%s%s\n", i,
            sweep_told_value(s, "V_star", z->v), sweep_told_unit(s, "V_star"),
            sweep_told_state(s), sweep_told_value(s, "psi", z->psi),
            *psi == '1' ? "" : " ", *psi == '1' ? "" : psi);
}

static void print_runs(FILE *out, const struct sweep *s)
{
    for (size_t i = 0; i < s->dims.of[DIM_START].count; i++) {
        struct shown t = { .entry = i };
        print_start(out, s, i);
        add(&t, s, "trajectory_fate", "fate");
        add(&t, s, "trajectory_end", "end");
        add(&t, s, "trajectory_time", "time");
        add(&t, s, "trajectory_slip", "slip");
        print_table(out, s, &t);
    }
}

/* ---- maps ---------------------------------------------------------------- */

/* "  basin_slip from 0.1 to 7, in 98.3 % of the cells" */
static void print_range(FILE *out, const struct sweep *s, size_t k)
{
    struct sweep_summary all = { .least = (double) NAN,
                                 .greatest = (double) NAN };
    const struct unit *unit = unit_find(s->layers.at[k].unit);
    const char *name = sweep_told_unit(s, s->layers.at[k].unit);
    struct fault why;

    for (size_t i = 0; i < s->points; i++) {
        struct sweep_summary is;
        if (sweep_summary_find(s, k, i, &is, &why) != STATUS_OK)
            return;
        all.cells += is.cells;
        all.present += is.present;
        const struct unit_system u = sweep_units(s, i);
        all.least = fmin(all.least, unit_value(&u, unit, is.least));
        all.greatest = fmax(all.greatest, unit_value(&u, unit, is.greatest));
    }
    fprintf(out, "  %-22s", s->layers.at[k].name);
    if (all.present > 0)
        fprintf(out, " from %.6g to %.6g%s%s,", all.least, all.greatest,
                *name == '1' ? "" : " ", *name == '1' ? "" : name);
    fprintf(out, " in %.4g %% of the cells\n",
            100.0 * (double) all.present / (double) all.cells);
}

static bool is_error(const char *name)
{
    const size_t size = strlen(name), end = strlen("_error");

    return size > end && strcmp(name + size - end, "_error") == 0;
}

static void print_maps(FILE *out, const struct sweep *s)
{
    const struct sweep_dims *d = &s->dims;
    const bool asked =
        d->of[DIM_V].count + d->of[DIM_ARROW_V].count + d->of[DIM_CHI_V].count >
        0;

    if (asked && s->layers.count == 0)
        fprintf(out, "maps are computed for files only: give -o FILE.h5\n");
    if (s->layers.count > 0)
        fprintf(out, "%zu maps at each point\n", s->layers.count);
    for (size_t k = 0; k < s->layers.count; k++)
        if (!s->layers.at[k].codes && !is_error(s->layers.at[k].name))
            print_range(out, s, k);
}

/* How many equilibria there are, and the first of them. */
static void print_equilibria(FILE *out, const struct sweep *s)
{
    enum { EACH = 3 };
    const char *x = s->scene->system->state[0].name;
    char name[EACH][2][64];
    struct shown t = { .count = 0 };

    add(&t, s, "count_equilibria", "equilibria");
    add(&t, s, "count_attractors", "attractors");
    for (size_t k = 0; k < EACH; k++) {
        snprintf(name[k][0], sizeof name[k][0], "equilibria_%zu_type", k);
        snprintf(name[k][1], sizeof name[k][1], "equilibria_%zu_state_%.32s", k,
                 x);
        for (size_t i = 0; i < 2; i++)
            add(&t, s, name[k][i], i == 0 ? "type" : x);
    }
    print_table(out, s, &t);
}

static void print_system(FILE *out, const struct sweep *s)
{
    fprintf(out, "%s\n", scene_name(s->scene));
    print_axes(out, s);
    print_equilibria(out, s);
    if (sweep_find(s, "basin_undecided") >= 0)
        print_missing(out, s, "basin_undecided");
}

void report_sweep_print(FILE *out, const struct sweep *s)
{
    if (s->scene->system) {
        print_system(out, s);
        return;
    }
    fprintf(out, "%s (%s form)\n", s->scene->law.preset,
            friction_form_names[s->scene->law.form]);
    print_axes(out, s);
    print_numbers(out, s);
    print_missing(out, s, "v_minus");
    print_missing(out, s, "v_plus");
    print_shares(out, s);
    print_runs(out, s);
    print_maps(out, s);
}

/* ---- plan ---------------------------------------------------------------- */

size_t report_sweep_plan(const struct scene *s, char *text, size_t size)
{
    size_t points = 1, end = 0;

    for (size_t k = 0; k < s->sweep.axes && end < size; k++) {
        const struct scene_axis *a = &s->sweep.axis[k];
        end += (size_t) snprintf(text + end, size - end,
                                 "%s%s at %zu values from %g to %g",
                                 k ? ", " : "", a->key, a->count, a->value[0],
                                 a->value[a->count - 1]);
        points *= a->count;
    }
    if (s->sweep.refine > 0.0 && end < size)
        end += (size_t) snprintf(text + end, size - end, ", refined to %g",
                                 s->sweep.refine);
    if (s->products & 1u << PRODUCT_TRAJECTORIES && end < size)
        snprintf(text + end, size - end, ", a run from each of %zu starts",
                 s->starts);
    return points;
}
