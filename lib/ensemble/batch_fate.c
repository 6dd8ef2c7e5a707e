#include "batch_fate.h"

#include <math.h>

#include "kick.h"
#include "labels.h"

void batch_fate_put(const struct batch_fates *f, size_t i, int8_t fate,
                    const char *reason)
{
    if (f->fate)
        f->fate[i] = fate;
    if (f->reason)
        f->reason[i] = reason;
    if (f->margin)
        f->margin[i] = HUGE_VAL;
}

/* Who tells the fates at a draw: the curve of its numbers, where there is one
 * and it leaves no doubt, else one of their own, grown when it is needed. */
struct teller {
    const struct slider *slider;
    double rtol;
    const struct monitor *monitor;
    struct labels lent, own;
    bool has_own;
};

static enum status ask_own(struct teller *t, struct vec2 z,
                           struct fate_told *told)
{
    enum status status = STATUS_OK;

    if (!t->has_own)
        status = labels_init(&t->own, t->slider, t->rtol, t->monitor);
    t->has_own = status == STATUS_OK;
    return status == STATUS_OK ? labels_find(&t->own, z, t->monitor, told)
                               : status;
}

static enum status ask(struct teller *t, struct vec2 z, struct fate_told *told)
{
    *told = (struct fate_told){ .fate = FATE_UNDECIDED };
    if (t->lent.lent)
        told->fate = (int8_t) labels_side(&t->lent, z);
    return told->fate == FATE_UNDECIDED ? ask_own(t, z, told) : STATUS_OK;
}

static enum status find(struct teller *t, const struct scene_push *p, size_t i,
                        const struct batch_fates *f)
{
    const struct slider *s = t->slider;
    struct fate_told told = { .fate = -1 };
    struct scene_start at;

    if (!kick_state(s, p, &at, &told.reason)) {
        batch_fate_put(f, i, told.fate, told.reason);
        return STATUS_OK;
    }
    const struct vec2 z = block_offset(&s->block, at.v, at.psi);
    const enum status status = ask(t, z, &told);
    if (status == STATUS_OK)
        batch_fate_put(f, i, told.fate, told.reason);
    if (status == STATUS_OK && f->margin)
        f->margin[i] = labels_margin(t->has_own ? &t->own : &t->lent, z);
    return status;
}

enum status batch_fate_find(const struct batch *b, const struct sweep_point *p,
                            size_t i, const struct monitor *monitor,
                            const struct batch_fates f[])
{
    struct teller t = { .slider = &p->study.slider,
                        .rtol = p->study.scene->rtol,
                        .monitor = monitor };
    enum status status = STATUS_OK;

    if (p->study.cost[STAGE_STABLE].ran && slider_has_manifolds(t.slider))
        status = labels_lend(&t.lent, t.slider, p->study.stable);
    for (size_t k = 0; k < b->pushes && status == STATUS_OK; k++)
        status = find(&t, &b->push[k], i, &f[k]);
    labels_free(&t.lent);
    if (t.has_own)
        labels_free(&t.own);
    return status;
}
