#include "export_rabinowicz.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "export.h"
#include "library.h"
#include "result_file.h"
#include "store_records.h"

/* A measurement as stored. */
struct point {
    double tan_alpha, value, error;
};

static const struct record_field point_fields[] = {
    FIELD(point, REAL, tan_alpha, "1", "tangent of the slope angle"),
    FIELD(point, REAL, value, "m", "measured"),
    FIELD(point, REAL, error, "m", "one standard deviation, as given"),
};
const struct record_type record_measured =
    RECORD_TYPE("measured", "measurements", point_fields, point);

static enum status put_series(const struct series *s, const char *group,
                              struct store *out)
{
    struct point *point = calloc(s->count, sizeof *point);

    if (point == NULL)
        return STATUS_NO_MEMORY;
    for (size_t i = 0; i < s->count; i++)
        point[i] = (struct point){ s->tan_alpha[i], s->value[i],
                                   s->error ? s->error[i] : (double) NAN };
    const struct record_array a = { &record_measured, point, s->count };
    const enum status status = store_put_records(out, group, &a, NULL);
    free(point);
    return status;
}

static enum status put_parabola(const struct release *r, struct store *out)
{
    static const char fit[] = "/rabinowicz/fit", slip[] = "/rabinowicz/slip";
    const struct record_array curve = { &record_slip_point, r->slip.at,
                                        r->slip.count };
    enum status s = put_series(&r->observed.l_k, "/rabinowicz/l_k", out);

    if (!s)
        s = store_put_scalars(out, fit, &record_parabola, &r->parabola);
    if (!s)
        s = store_put_scalars(out, fit, &record_release_material, &r->material);
    if (!s && r->slip.reason)
        return store_put_text(out, slip, "reason", r->slip.reason);
    if (!s)
        s = store_put_records(out, slip, &curve, "mu");
    if (!s)
        s = store_put_real(out, slip, "smoothing", r->slip.smoothing);
    if (!s)
        s = store_put_real(out, slip, "freedom", r->slip.freedom);
    return s;
}

static enum status put_persistence(const struct release *r, struct store *out)
{
    const enum status s = put_series(&r->observed.x_k, "/rabinowicz/x_k", out);

    return s ? s
             : store_put_scalars(out, "/rabinowicz/persistence",
                                 &record_persistence, &r->persistence);
}

static enum status put_all(const struct release *r, const struct scene *scene,
                           struct store *out)
{
    static const char group[] = "/rabinowicz/release";
    const struct record_array rows = { &record_release, r->row, r->rows };
    enum status s = export_provenance(scene, out);

    if (!s)
        s = store_put_records(out, group, &rows, NULL);
    if (!s && quantity_exists(&r->K))
        s = store_put_real(out, group, "K", r->K.value);
    if (!s && r->parabola.points > 0)
        s = put_parabola(r, out);
    if (!s && r->persistence.points > 0)
        s = put_persistence(r, out);
    return s;
}

enum status export_rabinowicz(const struct release *r,
                              const struct scene *scene, const char *path,
                              struct fault *why)
{
    struct store *out;
    enum status s =
        result_file_begin(&out, path, scene, "Rabinowicz's experiment", why);

    if (s == STATUS_OK)
        s = result_file_end(&out, path, put_all(r, scene, out), why);
    return s;
}
