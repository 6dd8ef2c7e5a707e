#include "kick.h"

#include "fate.h"
#include "physical.h"

/* NULL: there is none. */
static const struct steady_number *creep_of(const struct slider *s)
{
    for (size_t i = 0; i < s->plane.equilibria; i++)
        if (s->plane.equilibrium[i].type == EQUILIBRIUM_STABLE_NODE &&
            fate_of_node(s, &s->plane.equilibrium[i]) == FATE_CREEP)
            return &s->steady[i];
    return NULL;
}

/* Of a block with psi > 0 or any, in the plane. */
static bool is_state(const struct slider *s, double v, double psi)
{
    const struct planar *p = &s->plane.system;

    return v > 0.0 && (psi > 0.0 || !p->axis[1].is_log) &&
           box_holds(p->domain,
                     vec2_add(p->origin, block_offset(&s->block, v, psi)));
}

bool kick_state(const struct slider *s, const struct scene_push *p,
                struct scene_start *out, const char **reason)
{
    const struct material *m = &s->block.material;
    const struct steady_number *creep = p->from_creep ? creep_of(s) : NULL;
    const double v = p->is_si ? p->v / m->V_star : p->v;

    if (p->from_creep && creep == NULL) {
        *reason = "there is no creep node at this slope";
        return false;
    }
    if (creep)
        *out = (struct scene_start){ creep->v.value + v, creep->psi.value };
    else
        *out = (struct scene_start){
            v, p->is_phi ? physical_psi(&s->block.law, m, p->psi) : p->psi
        };
    *reason = "the state is outside [1e-300, 1e300]";
    return is_state(s, out->v, out->psi);
}
