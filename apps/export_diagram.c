#include "export_diagram.h"

#include <stdio.h>

#include "store_grid.h"
#include "store_records.h"

enum { NAME = 64 };

static enum status put_extrema(struct store *out, const char *group,
                               const char *name, const struct extremum e[],
                               size_t count)
{
    const struct record_array a = { &record_extremum, e, count };
    char path[NAME];

    snprintf(path, sizeof path, "%s/%s", group, name);
    return store_put_records(out, path, &a, NULL);
}

static enum status put_steady(struct store *out, const char *group,
                              const struct record_type *type,
                              const struct steady_curve *c)
{
    const struct record_array a = { type, c->at, c->count };

    return store_put_records(out, group, &a, "v");
}

static enum status put_friction_law(const struct diagrams *d, struct store *out)
{
    const struct steady_curve *c = d->friction_law;
    enum status s =
        put_steady(out, "/friction_law", &record_friction, &c[DIAGRAM_SCENE]);

    if (!s)
        s = put_extrema(out, "/friction_law", "extrema", c->extremum,
                        c->extrema);
    if (!s && c[DIAGRAM_DIETERICH].count > 0)
        s = put_steady(out, "/friction_law/dieterich", &record_friction,
                       &c[DIAGRAM_DIETERICH]);
    return s;
}

static enum status put_spring(struct store *out, const char *group,
                              const struct spring_curve *c)
{
    const struct record_array a = { &record_spring, c->at, c->count };

    return store_put_records(out, group, &a, "v");
}

static enum status put_spring_block(const struct diagrams *d, struct store *out)
{
    const struct spring_curve *c = d->spring_block;
    enum status s = put_spring(out, "/spring_block", &c[DIAGRAM_SCENE]);

    if (!s)
        s = put_extrema(out, "/spring_block", "extrema", c->extremum,
                        c->extrema);
    if (!s)
        s = store_put_real(out, "/spring_block", "sigma", c->block.sigma);
    if (!s)
        s = store_put_real(out, "/spring_block", "mass", c->block.mass);
    if (!s && c[DIAGRAM_DIETERICH].count > 0)
        s = put_spring(out, "/spring_block/dieterich", &c[DIAGRAM_DIETERICH]);
    return s;
}

static enum status put_bifurcation(const struct diagrams *d, struct store *out)
{
    const struct steady_curve *c = &d->bifurcation;
    const enum status s =
        put_steady(out, "/bifurcation", &record_bifurcation, c);

    return s ? s
             : put_extrema(out, "/bifurcation", "folds", c->extremum,
                           c->extrema);
}

static enum status put_fold_curves(const struct diagrams *d, struct store *out)
{
    const struct fold_curve *f = &d->fold_curves;
    const struct record_array a = { &record_fold_curve, f->at, f->count };
    enum status s = store_put_records(out, "/fold_curves", &a, "c");

    if (!s)
        s = store_put_scalars(out, "/fold_curves/cusp", &record_cusp, &f->cusp);
    if (!s && f->reason)
        s = store_put_text(out, "/fold_curves", "comment", f->reason);
    return s;
}

static const struct record_field chi_layer[] = {
    { .name = "ln_chi",
      .unit = "1",
      .text = "ln chi(v), (34)",
      .kind = RECORD_REAL },
    { .name = "ln_chi_error",
      .unit = "1",
      .text = "error bound of ln_chi",
      .kind = RECORD_REAL },
};
const struct record_type record_chi = {
    .name = "chi", .text = "chi(v)", .fields = chi_layer, .count = 2
};

static enum status put_chi(const struct diagrams *d, struct store *out)
{
    const struct chi_curves *c = &d->chi;
    const double *const cells[] = { c->ln_chi, c->error };
    const struct record_array a = { &record_chi_slope, c->slope, c->slopes };
    enum status s = store_put_records(out, "/chi", &a, "alpha");

    if (!s)
        s = store_put_axis(out, "/chi", "v", "1", "slip rate", c->points, c->v);
    for (int i = 0; i < 2 && !s; i++) {
        s = store_put_layer(out, "/chi", &chi_layer[i], "alpha", "v");
        if (!s)
            s = store_put_rows(out, "/chi", &chi_layer[i], 0, c->slopes,
                               cells[i]);
    }
    return s;
}

enum status export_diagrams(const struct study *s, struct store *out)
{
    static const struct {
        enum stage stage;
        enum status (*put)(const struct diagrams *d, struct store *out);
    } part[] = {
        { STAGE_FRICTION_LAW, put_friction_law },
        { STAGE_SPRING_BLOCK, put_spring_block },
        { STAGE_BIFURCATION, put_bifurcation },
        { STAGE_FOLD_CURVES, put_fold_curves },
        { STAGE_CHI, put_chi },
    };
    enum status status = STATUS_OK;

    for (size_t i = 0; i < sizeof part / sizeof *part && !status; i++)
        if (plan_has(s->stages, part[i].stage))
            status = part[i].put(&s->diagrams, out);
    return status;
}
