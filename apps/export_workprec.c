#include "export_workprec.h"

#include <stdio.h>

#include "export.h"
#include "library.h"
#include "result_file.h"
#include "store_records.h"

static enum status put_reasons(const struct workprec *w, struct store *out)
{
    enum status s = STATUS_OK;

    for (int q = 0; q < WORKPREC_QUANTITIES && s == STATUS_OK; q++)
        if (w->course.reason[q])
            s = store_put_text(out, "/workprec", workprec_quantity_names[q],
                               w->course.reason[q]);
    return s;
}

static enum status put_all(const struct workprec *w, struct store *out)
{
    const struct record_array runs = { &record_workprec_run, w->run, w->runs };
    const struct record_array ranks = { &record_workprec_fastest, w->fastest,
                                        w->ranks };
    enum status s = export_provenance(&w->scene, out);

    if (s == STATUS_OK)
        s = put_reasons(w, out);
    if (s == STATUS_OK)
        s = store_put_records(out, "/workprec", &runs, NULL);
    if (s == STATUS_OK)
        s = store_put_records(out, "/workprec/fastest", &ranks, NULL);
    if (s == STATUS_OK)
        s = store_put_scalars(out, "/workprec/environment",
                              &record_workprec_environment, &w->environment);
    return s;
}

enum status export_workprec(const struct workprec *w, const char *path,
                            struct fault *why)
{
    struct store *out;
    enum status s =
        result_file_begin(&out, path, &w->scene, "error against run time", why);

    if (s == STATUS_OK)
        s = result_file_end(&out, path, put_all(w, out), why);
    return s;
}
