#include "law.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "law_graph.h"
#include "law_typed.h"

/* preset, words, equation, theta, psi_ss, timescale, kinetics */
#define LAW(name, in_words, eq, t, p, s, k)                                    \
    {                                                                          \
        .preset = name, .words = in_words, .equation = eq,                     \
        .form = FRICTION_ASINH, .theta = THETA_##t, .psi_ss = PSI_SS_##p,      \
        .timescale = TIMESCALE_##s, .kinetics = KINETICS_##k                   \
    }

/* clang-format off */
static const struct law presets[] = {
    LAW("dieterich", "Dieterich law", "(3)_1",
        LN_PSI, INVERSE, SLIP, LINEAR),
    LAW("dieterich_gen", "Generalised Dieterich law", "(5)",
        LN_PSI, INVERSE, SLIP, SINH),
    LAW("ruina", "Ruina law", "(6)",
        PSI, MINUS_LOG, SLIP, LINEAR),
    LAW("perrin", "Perrin law", "(7)",
        PSI, MINUS_LOG, SLIP, SINH),
    LAW("spinodal", "Spinodal law", "(8)",
        LN_C_PSI, SPINODAL, SPINODAL, LINEAR),
    LAW("spinodal_gen", "Generalised spinodal law", "(10)",
        LN_C_PSI, SPINODAL, SPINODAL, SINH),
    LAW("spinodal_phi_gen", "Generalised spinodal law of φ", "before (8)",
        LN_C_1PR_PSI, SPINODAL_UNIT, SPINODAL, SINH),
    LAW("kato_tullis", "Kato and Tullis law", "Kato & Tullis (2001)",
        LN_PSI, LAMBERT, SLIP, COMPOSITE),
};

const char *const friction_form_names[] = { "asinh", "log", NULL };
const char *const theta_names[] = { "ln_psi", "psi", "ln_c_psi",
                                    "ln_c_1pR_psi", NULL };
const char *const psi_ss_names[] = { "inverse", "minus_log", "spinodal",
                                     "spinodal_unit", NULL };
const char *const timescale_names[] = { "slip", "spinodal", "ageing44",
                                        "slip45", NULL };
const char *const kinetics_names[] = { "linear", "sinh", NULL };
const struct timescale_terms timescale_terms[TIMESCALES] = {
    [TIMESCALE_SLIP] = { .ln_v = 1 },
    [TIMESCALE_SPINODAL] = { .ln_r_plus_v = 1 },
    [TIMESCALE_AGEING44] = { .ln_r = 1, .ln_psi_ss = -1 },
    [TIMESCALE_SLIP45] = { .ln_r = 1, .psi_ss = -1 },
};

/* The components' formulas; no other place has them as text. */
const char *const law_part_names[] = { "theta", "psi_ss", "T", "K",
                                       "mu",    "rate",   NULL };
static const char *const mu_formula[FRICTION_FORMS] = {
    [FRICTION_ASINH] = "a*asinh(v/2*exp((mu_star + b*theta)/a))",
    [FRICTION_LOG] = "mu_star + a*ln(v) + b*theta",
};
static const char *const theta_formula[THETAS] = {
    [THETA_LN_PSI] = "ln(psi)",
    [THETA_PSI] = "psi",
    [THETA_LN_C_PSI] = "ln(c + psi)",
    [THETA_LN_C_1PR_PSI] = "ln(c + (1 + R)*psi)",
};
static const char *const psi_ss_formula[PSI_SSES] = {
    [PSI_SS_INVERSE] = "1/v",
    [PSI_SS_MINUS_LOG] = "-ln(v)",
    [PSI_SS_SPINODAL] = "(1 + R)/(1 + R*v)",
    [PSI_SS_SPINODAL_UNIT] = "1/(1 + R*v)",
    [PSI_SS_LAMBERT] = "exp(lambert(v/V_c))/v",
};
static const char *const timescale_formula[TIMESCALES] = {
    [TIMESCALE_SLIP] = "1/v",
    [TIMESCALE_SPINODAL] = "R/(1 + R*v)",
    [TIMESCALE_AGEING44] = "R*psi_ss",
    [TIMESCALE_SLIP45] = "R*exp(psi_ss)",
};
static const char *const kinetics_formula[KINETICSES] = {
    [KINETICS_LINEAR] = "d",
    [KINETICS_SINH] = "sinh(d)",
};
/* Where it is not -K/T; the one is exp(-v/V_c) - v psi ln(v psi). */
static const char *const rate_formula[KINETICSES] = {
    [KINETICS_COMPOSITE] = "v*psi*(exp(-v/V_c - ln(v*psi)) - ln(v*psi))",
};

static const struct {
    const char *name;
    size_t offset;
} keys[MATERIAL_KEYS] = {
    [MATERIAL_MU_STAR] = { "mu_star", offsetof(struct material, mu_star) },
    [MATERIAL_A] = { "a", offsetof(struct material, a) },
    [MATERIAL_B] = { "b", offsetof(struct material, b) },
    [MATERIAL_C] = { "c", offsetof(struct material, c) },
    [MATERIAL_R] = { "R", offsetof(struct material, R) },
    [MATERIAL_V_C] = { "V_c", offsetof(struct material, V_c) },
    [MATERIAL_L] = { "L", offsetof(struct material, L) },
    [MATERIAL_V_STAR] = { "V_star", offsetof(struct material, V_star) },
    [MATERIAL_G] = { "g", offsetof(struct material, g) },
};
/* clang-format on */

struct material material_bristol_board(void)
{
    return (struct material){ .mu_star = 0.369,
                              .a = 0.0349,
                              .b = 0.0489,
                              .c = 1e-3,
                              .R = 100,
                              .V_c = 1,
                              .L = 0.9e-6,
                              .V_star = 1e-6,
                              .g = 9.81 };
}

const char *material_key_name(enum material_key key)
{
    return keys[key].name;
}

double *material_member(struct material *m, enum material_key key)
{
    return (double *) (void *) ((char *) m + keys[key].offset);
}

bool law_uses_name(const struct law *law, const char *name)
{
    struct law_graph room;
    const struct law_graph *g = law_graph_kept(law, &room);
    const int leaf = formula_find(&g->f, name, strlen(name));
    bool used[FORMULA_NODES] = { false };

    used[g->node[LAW_AT_DX]] = used[g->node[LAW_AT_DY]] = true;
    if (g->psi_ss >= 0)
        used[g->psi_ss] = true;
    formula_complete(&g->f, used);
    return leaf >= 0 && (used[leaf] || g->f.node[leaf].exponent);
}

bool law_uses(const struct law *law, enum material_key key)
{
    return key >= MATERIAL_L || law_uses_name(law, material_key_name(key));
}

double material_eps2(const struct material *m)
{
    return m->V_star * m->V_star / (m->g * m->L);
}

double law_eta(const struct law *law, const struct material *m)
{
    return law_uses(law, MATERIAL_R) && isfinite(m->R) ? m->R / (1.0 + m->R)
                                                       : 1.0;
}

const struct law *law_preset_at(size_t i)
{
    return i < sizeof presets / sizeof *presets ? &presets[i] : NULL;
}

const struct law *law_preset_find(const char *name)
{
    const struct law *law = presets;

    for (size_t i = 1; law && strcmp(law->preset, name) != 0; i++)
        law = law_preset_at(i);
    return law;
}

const char *law_text(const struct law *law, enum law_part part)
{
    const bool composite = law->kinetics == KINETICS_COMPOSITE;

    if (law->typed)
        return law_typed_text(law->typed, part);
    switch (part) {
        case LAW_THETA:
            return theta_formula[law->theta];
        case LAW_PSI_SS:
            return psi_ss_formula[law->psi_ss];
        case LAW_T:
            return composite ? NULL : timescale_formula[law->timescale];
        case LAW_K:
            return kinetics_formula[law->kinetics];
        case LAW_RATE:
            return rate_formula[law->kinetics];
        default:
            return NULL;
    }
}

const char *law_text_mu(const struct law *law)
{
    const char *given = law_text(law, LAW_MU);

    return given ? given : mu_formula[law->form];
}

void law_formula(const struct law *law, char *text, size_t size)
{
    size_t used = 0;

    text[0] = '\0';
    for (int i = 0; i < LAW_PARTS && used < size; i++) {
        const char *formula = law_text(law, (enum law_part) i);
        if (formula)
            used += (size_t) snprintf(
                text + used, size - used, "%s%s = %s", used ? ", " : "",
                i == LAW_RATE ? "dpsi/dt" : law_part_names[i], formula);
    }
}

static enum status refuse(struct fault *why, const char *text)
{
    return fault_set(why, STATUS_BAD_ARGUMENT, "%s", text);
}

static enum status check_composition(const struct law *law,
                                     const struct material *m,
                                     struct fault *why)
{
    if (law->typed)
        return isinf(m->R) && law_uses(law, MATERIAL_R)
                   ? refuse(why, "R must be finite in a law of formulas")
                   : STATUS_OK;
    if (law_timescale(law)->ln_psi_ss && law->psi_ss == PSI_SS_MINUS_LOG)
        return fault_set(
            why, STATUS_BAD_ARGUMENT,
            "timescale %s is %s and needs psi_ss > 0, but psi_ss is "
            "minus_log",
            timescale_names[law->timescale], timescale_formula[law->timescale]);
    const bool composite = law->kinetics == KINETICS_COMPOSITE;
    if (composite != (law->psi_ss == PSI_SS_LAMBERT) ||
        (composite &&
         (law->theta != THETA_LN_PSI || law->timescale != TIMESCALE_SLIP)))
        return refuse(why, "kato_tullis is a law of its own, not a component");
    if (isinf(m->R) &&
        (law->theta == THETA_LN_C_1PR_PSI ||
         law->psi_ss == PSI_SS_SPINODAL_UNIT || law_timescale(law)->ln_r))
        return refuse(why, "R must be finite for this law: its limit R = inf "
                           "does not exist");
    return STATUS_OK;
}

enum status law_check(const struct law *law, const struct material *m,
                      struct fault *why)
{
    struct material copy = *m;

    for (int key = 0; key < MATERIAL_KEYS; key++) {
        const double value = *material_member(&copy, (enum material_key) key);
        const bool may_be_zero = key == MATERIAL_C;
        const bool ok = key == MATERIAL_MU_STAR ? isfinite(value)
                        : may_be_zero           ? value >= 0.0
                                                : value > 0.0;
        if (ok && (isfinite(value) || key == MATERIAL_R))
            continue;
        if (!law_uses(law, (enum material_key) key))
            continue;
        return fault_set(why, STATUS_BAD_ARGUMENT, "%s = %.17g must be %s",
                         keys[key].name, value,
                         key == MATERIAL_MU_STAR ? "finite"
                         : may_be_zero       ? "zero or positive, and finite"
                         : key == MATERIAL_R ? "positive"
                                             : "positive and finite");
    }
    return check_composition(law, m, why);
}
