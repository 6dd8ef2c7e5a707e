#include "eigen_view.h"

#include <math.h>
#include <stdlib.h>

#include "eigen_frame.h"

struct eigen_view eigen_view_of(const struct study *s)
{
    const struct mat2 P = eigen_basis(phase_plane_saddle(&s->slider.plane));
    struct eigen_view e = { { 1.0, 1.0, P.yx / P.xx, P.yy / P.xy }, 1.0 };

    for (int i = 0; i < SIDES; i++)
        if (s->stable[i].curve.count > 0)
            e.reach = fmax(e.reach, fabs(s->stable[i].limit.x));
    e.reach *= 1.5;
    return e;
}

struct vec2 *eigen_view_states(const struct eigen_view *e, size_t columns,
                               size_t rows)
{
    const struct box w = { { -e->reach, -e->reach }, { e->reach, e->reach } };
    struct vec2 *z = malloc(columns * rows * sizeof *z);

    for (size_t i = 0; z && i < columns * rows; i++) {
        const struct vec2 unit = {
            ((double) (i % columns) + 0.5) / (double) columns,
            ((double) (i / columns) + 0.5) / (double) rows
        };
        z[i] = eigen_point(e->basis, window_mix(w, unit));
    }
    return z;
}

enum status eigen_view_labels(const struct study *s, const struct vec2 z[],
                              size_t n, int8_t label[])
{
    enum status status = STATUS_OK;

    for (size_t i = 0; i < n && status == STATUS_OK; i++) {
        struct fate_told told = { .fate = FATE_UNDECIDED };
        status = labels_find(&s->basins.labels, z[i], NULL, &told);
        label[i] = told.fate;
    }
    return status;
}
