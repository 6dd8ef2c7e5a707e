#include "phase_plane.h"

#include <math.h>

static double fastest_rate(const struct planar *system)
{
    struct planar_jacobian J;

    system->jacobian(system->ctx, (struct vec2){ 0.0, 0.0 }, &J);
    const struct eigen2 e = mat2_eigenvalues(J.matrix);
    return fmax(fabs(e.re[0]), fabs(e.re[1])) * exp(J.field.log_scale);
}

struct phase_plane phase_plane_of(const struct planar *system,
                                  const struct equilibrium e[], size_t n)
{
    struct phase_plane p = { .system = *system, .equilibria = n };

    for (size_t i = 0; i < n; i++) {
        p.equilibrium[i] = e[i];
        if (e[i].type == EQUILIBRIUM_SADDLE && p.saddles < SADDLES_MAX)
            p.saddle[p.saddles++] = i;
    }
    p.fastest_rate = fastest_rate(system);
    return p;
}

const struct equilibrium *phase_plane_saddle(const struct phase_plane *p)
{
    return p->saddles > 0 ? &p->equilibrium[p->saddle[0]] : NULL;
}

double phase_plane_leaving_rate(const struct phase_plane *p)
{
    const struct equilibrium *saddle = phase_plane_saddle(p);

    return saddle ? saddle->lambda[1] : 0.0;
}

struct vec2 phase_plane_offset(const struct phase_plane *p, size_t i)
{
    return vec2_sub(p->equilibrium[i].z, p->system.origin);
}

size_t phase_plane_goals(const struct phase_plane *p,
                         struct vec2 goal[EQUILIBRIA_MAX])
{
    size_t n = 0;

    for (size_t i = 0; i < p->equilibria; i++)
        if (p->equilibrium[i].type != EQUILIBRIUM_SADDLE)
            goal[n++] = phase_plane_offset(p, i);
    return n;
}
