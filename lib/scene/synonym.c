#include "synonym.h"

#include <string.h>
#include <strings.h>

#include "spell.h"

/* Dieterich (1979), Ruina (1983), Rice & Ruina (1983), Marone (1998). */
static const struct {
    const char *word, *meant;
} table[] = {
    { "aging", "dieterich" },
    { "ageing", "dieterich" },
    { "slowness", "dieterich" },
    { "slip", "ruina" },
    { "Dc", "L" },
    { "D_c", "L" },
    { "d_c", "L" },
    { "mu0", "mu_star" },
    { "mu_0", "mu_star" },
    { "f0", "mu_star" },
    { "f_0", "mu_star" },
    { "V0", "V_star" },
    { "V_0", "V_star" },
    { "vref", "V_star" },
    { "theta", "psi" },
    { "state", "psi" },
    { "velocity", "v" },
    { "angle", "alpha_deg" },
    { "dip", "alpha_deg" },
};

const char *synonym_nearest(const char *word, const char *const *known)
{
    for (size_t i = 0; i < sizeof table / sizeof *table; i++)
        for (size_t k = 0; strcasecmp(word, table[i].word) == 0 && known[k];
             k++)
            if (strcmp(known[k], table[i].meant) == 0)
                return known[k];
    return spell_nearest(word, known);
}
