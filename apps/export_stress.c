#include "export_stress.h"

#include <stdio.h>

#include "export.h"
#include "library.h"
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
    struct store *out = NULL;

    store_silence();
    enum status status =
        store_create(path, "stiff and extreme cases", &out, why);
    if (status != STATUS_OK)
        return status;
    status = put_all(s, out);
    if (status == STATUS_OK || status == STATUS_IO)
        status = store_commit(out, why);
    else
        snprintf(why->text, sizeof why->text, "%s: %s", path,
                 status_text(status));
    store_free(&out);
    return status;
}
