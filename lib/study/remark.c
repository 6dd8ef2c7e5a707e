#include "remark.h"

#define MEETS_V_0                                                              \
    "no v_plus: push tells whether a state stops; the watershed bends at "     \
    "knees_upper and meets v = 0 at "

/* What answers for a v_plus that is none. */
static const char *instead_of_v_plus(const struct study *s)
{
    if (!plan_has(s->stages, STAGE_CRITICAL) ||
        s->slider.critical.upper_end != END_OPEN)
        return NULL;
    return !quantity_exists(&s->slider.critical.psi_at_v0)
               ? "no v_plus: push tells whether a state stops; the watershed "
                 "bends at knees_upper"
           : s->scene->units == UNITS_SI ? MEETS_V_0 "phi_at_v0"
                                         : MEETS_V_0 "psi_at_v0";
}

size_t study_remarks(const struct study *s, const char *text[], size_t room)
{
    size_t n = 0;

    if (plan_has(s->stages, STAGE_STEADY) && s->slider.plane.equilibria == 0 &&
        n < room)
        text[n++] = "no steady state: mu_ss(v) = tan(alpha) has no solution";
    else if (s->slider.plane.equilibria > 0 && slider_saddle(&s->slider) < 0 &&
             n < room)
        text[n++] = "no saddle at this slope, hence no separatrix";
    else if (!slider_has_manifolds(&s->slider) &&
             slider_saddle(&s->slider) >= 0 && n < room)
        text[n++] = equilibrium_is_beyond(phase_plane_saddle(&s->slider.plane))
                        ? "the saddle's eigenvalues are further apart than "
                          "doubles can tell, hence no separatrix"
                        : "the saddle's psi is beyond the plane's range, hence "
                          "no separatrix";
    if (instead_of_v_plus(s) && n < room)
        text[n++] = instead_of_v_plus(s);
    const struct box window = scene_box(s->scene);
    bool inside = false;
    for (size_t i = 0; i < s->slider.plane.equilibria; i++)
        inside |= box_holds(window, s->slider.plane.equilibrium[i].z);
    if (s->slider.plane.equilibria > 0 && !inside && n < room)
        text[n++] = "no steady state inside the window";
    const bool cut = plan_has(s->stages, STAGE_UNSTABLE) &&
                     slider_has_manifolds(&s->slider) &&
                     (s->unstable[0].end == ORBIT_RUNNING ||
                      s->unstable[1].end == ORBIT_RUNNING);
    if (cut && n < room)
        text[n++] = "an unstable branch stops inside the window: it takes more "
                    "steps than the bound allows";
    if (plan_has(s->stages, STAGE_FOLD_CURVES) &&
        s->diagrams.fold_curves.reason && n < room)
        text[n++] = s->diagrams.fold_curves.reason;
    if (plan_has(s->stages, STAGE_CHI) && s->diagrams.chi.reason && n < room)
        text[n++] = s->diagrams.chi.reason;
    if (plan_has(s->stages, STAGE_BASINS) &&
        s->scene->products >> PRODUCT_MARGIN & 1u &&
        !margin_exists(&s->basins.labels.regions) && n < room)
        text[n++] = "no margins to draw: all states have the same fate";
    if (s->fields.which && s->scene->hdf5 == NULL && n < room)
        text[n++] = "fields of the cells are computed for files only: give "
                    "-o FILE.h5";
    return n;
}

const char *study_end_name(const struct trajectory *t)
{
    static const char *const name[] = {
        [ORBIT_RUNNING] = "given_up",
        [ORBIT_LEFT_DOMAIN] = "left_domain",
        [ORBIT_LEFT_WINDOW] = "left_window",
        [ORBIT_ARRIVED] = "arrived",
        [ORBIT_REACHED] = "limit",
        [ORBIT_EVENT] = "event",
    };
    return name[t->end];
}
