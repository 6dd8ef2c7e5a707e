#include "sweep_summary.h"

#include <math.h>
#include <stdlib.h>

static void count_codes(const int8_t code[], struct sweep_summary *out)
{
    for (size_t i = 0; i < out->cells; i++)
        if (code[i] >= 0 && code[i] < SUMMARY_WORDS) {
            out->counts[code[i]]++;
            out->present++;
        }
}

static void measure(const double value[], struct sweep_summary *out)
{
    for (size_t i = 0; i < out->cells; i++) {
        if (isnan(value[i]))
            continue;
        out->least = fmin(out->least, value[i]); /* of NaN and x: x */
        out->greatest = fmax(out->greatest, value[i]);
        out->present++;
    }
}

enum status sweep_summary_find(const struct sweep *s, size_t k, size_t point,
                               struct sweep_summary *out, struct fault *why)
{
    const struct sweep_layer *layer = &s->layers.at[k];
    void *values = malloc(sweep_layer_size(layer));

    *out = (struct sweep_summary){ .cells = layer->rows * layer->columns,
                                   .least = (double) NAN,
                                   .greatest = (double) NAN };
    if (values == NULL)
        return STATUS_NO_MEMORY;
    const enum status status = sweep_read(s, k, point, values, why);
    if (status == STATUS_OK && layer->codes)
        count_codes(values, out);
    else if (status == STATUS_OK)
        measure(values, out);
    free(values);
    return status;
}
