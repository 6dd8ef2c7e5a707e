/* starved_study.h -- a study of which every allocation has failed once. */
#pragma once

#include "check.h"
#include "fault_alloc.h"
#include "study.h"

/* The first `each` of them, and from there on every thirteenth. */
static void starve_study(const struct scene *scene, long each)
{
    enum status status = STATUS_NO_MEMORY;

    for (long k = 0; status != STATUS_OK; k += k < each ? 1 : 13) {
        struct study s;
        struct fault why;
        fault_alloc_at(k);
        status = study_run(&s, scene, NULL, &why);
        fault_alloc_at(FAULT_ALLOC_NEVER);
        CHECK(status == STATUS_OK || status == STATUS_NO_MEMORY, "%ld: %.400s",
              k, why.text);
        study_free(&s);
        CHECK(k < 100000, "never succeeds");
    }
}
