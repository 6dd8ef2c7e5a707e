#include "batch_fate.h"

#include "kick.h"
#include "labels.h"

void batch_fate_put(const struct batch_fates *f, size_t i, int8_t fate,
                    const char *reason)
{
    if (f->fate)
        f->fate[i] = fate;
    if (f->reason)
        f->reason[i] = reason;
}

static enum status find(const struct labels *l, const struct scene_push *p,
                        size_t i, const struct monitor *monitor,
                        const struct batch_fates *f)
{
    struct fate_told told = { .fate = -1 };
    struct scene_start at;
    enum status status = STATUS_OK;

    if (kick_state(l->slider, p, &at, &told.reason))
        status = labels_find(l, block_offset(&l->slider->block, at.v, at.psi),
                             monitor, &told);
    if (status == STATUS_OK)
        batch_fate_put(f, i, told.fate, told.reason);
    return status;
}

enum status batch_fate_find(const struct batch *b, const struct study *study,
                            size_t i, const struct monitor *monitor,
                            const struct batch_fates f[])
{
    struct labels labels;
    enum status status =
        labels_init(&labels, &study->slider, study->scene->rtol, monitor);

    for (size_t k = 0; k < b->pushes && status == STATUS_OK; k++)
        status = find(&labels, &b->push[k], i, monitor, &f[k]);
    labels_free(&labels);
    return status;
}
