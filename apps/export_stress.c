#include "export_stress.h"

#include <stdio.h>

#include "export.h"
#include "library.h"
#include "result_file.h"
#include "store_records.h"

static enum status put_all(const struct stress *s, struct store *out)
{
    static const char group[] = "/stress";
    const struct record_array rows = { &record_stress, s->row, s->count };
    enum status status = store_put_records(out, group, &rows, NULL);

    for (int i = 0; i < STRESS_OUTCOMES && !status; i++)
        status = store_put_count(out, group, stress_outcome_names[i],
                                 (int64_t) s->outcome[i]);
    if (!status)
        status = store_put_count(out, group, "counted", (int64_t) s->counted);
    if (!status)
        status = store_put_count(out, group, "full", (int64_t) s->full);
    if (!status)
        status = store_put_text(out, "/provenance", "version", SLIPWAY_VERSION);
    if (!status)
        status = store_put_text(out, "/provenance", "compiler", __VERSION__);
    return status;
}

enum status export_stress(const struct stress *s, const char *path,
                          struct fault *why)
{
    struct store *out;
    enum status status =
        result_file_begin(&out, path, NULL, "stiff and extreme cases", why);

    if (status == STATUS_OK)
        status = result_file_end(&out, path, put_all(s, out), why);
    return status;
}
