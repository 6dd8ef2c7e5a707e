#include "batch_fate.h"

#include "labels.h"
#include "physical.h"

void batch_fate_put(const struct batch_fates *f, size_t i, int8_t fate,
                    const char *reason)
{
    if (f->fate)
        f->fate[i] = fate;
    if (f->reason)
        f->reason[i] = reason;
}

/* The creep state: the node below the saddle, or the only one there is; NULL:
 * there is none. */
static const struct steady_number *creep_of(const struct slider *s)
{
    for (size_t i = 0; i < s->plane.equilibria; i++)
        if (s->plane.equilibrium[i].type == EQUILIBRIUM_STABLE_NODE &&
            fate_of_node(s, &s->plane.equilibrium[i]) == FATE_CREEP)
            return &s->steady[i];
    return NULL;
}

/* The state that a push leads to; false, and why, where there is none. */
static bool state_of(const struct slider *s, const struct scene_push *p,
                     struct vec2 *z, const char **reason)
{
    const struct steady_number *creep = p->from_creep ? creep_of(s) : NULL;
    const struct material *m = &s->block.material;
    const double given = p->is_si ? p->v / m->V_star : p->v;
    const double v = given + (creep ? creep->v.value : 0.0);
    const double psi = creep       ? creep->psi.value
                       : p->is_phi ? physical_psi(&s->block.law, m, p->psi)
                                   : p->psi;

    *reason = p->from_creep && creep == NULL
                  ? "there is no creep node at this slope"
                  : "the state is outside [1e-300, 1e300]";
    if ((p->from_creep && creep == NULL) || !(v > 0.0) ||
        (s->plane.system.axis[1].is_log && !(psi > 0.0)))
        return false;
    *z = block_offset(&s->block, v, psi);
    return box_holds(s->plane.system.domain,
                     vec2_add(s->plane.system.origin, *z));
}

static enum status find(const struct labels *l, const struct scene_push *p,
                        size_t i, const struct monitor *monitor,
                        const struct batch_fates *f)
{
    struct fate_told told = { .fate = -1 };
    struct vec2 z;
    enum status status = STATUS_OK;

    if (state_of(l->slider, p, &z, &told.reason))
        status = labels_find(l, z, monitor, &told);
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
