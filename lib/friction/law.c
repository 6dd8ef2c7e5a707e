#include "law.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "law_plain.h"
#include "law_typed.h"

/* preset, equation, theta, psi_ss, timescale, kinetics */
#define LAW(name, eq, t, p, s, k)                                              \
    {                                                                          \
        .preset = name, .equation = eq, .form = FRICTION_ASINH,                \
        .theta = THETA_##t, .psi_ss = PSI_SS_##p, .timescale = TIMESCALE_##s,  \
        .kinetics = KINETICS_##k                                               \
    }

/* clang-format off */
static const struct law presets[] = {
    LAW("dieterich",     "(3)_1", LN_PSI,   INVERSE,   SLIP,     LINEAR),
    LAW("dieterich_gen", "(5)",   LN_PSI,   INVERSE,   SLIP,     SINH),
    LAW("ruina",         "(6)",   PSI,      MINUS_LOG, SLIP,     LINEAR),
    LAW("perrin",        "(7)",   PSI,      MINUS_LOG, SLIP,     SINH),
    LAW("spinodal",      "(8)",   LN_C_PSI, SPINODAL,  SPINODAL, LINEAR),
    LAW("spinodal_gen",  "(10)",  LN_C_PSI, SPINODAL,  SPINODAL, SINH),
    LAW("spinodal_phi_gen", "before (8)",
        LN_C_1PR_PSI, SPINODAL_UNIT, SPINODAL, SINH),
    LAW("kato_tullis", "Kato & Tullis (2001)",
        LN_PSI, LAMBERT, SLIP, COMPOSITE),
};

const char *const friction_form_names[] = { "asinh", "log", NULL };
const char *const theta_names[] = { "ln_psi", "psi", "ln_c_psi",
                                    "ln_c_1pR_psi", NULL };
const char *const psi_ss_names[] = { "inverse", "minus_log", "spinodal",
                                     "spinodal_unit", NULL };
const char *const timescale_names[] = { "slip", "spinodal", "ageing44",
                                        "slip45", NULL };
const struct timescale_terms timescale_terms[TIMESCALES] = {
    [TIMESCALE_SLIP] = { "1/v", .ln_v = 1 },
    [TIMESCALE_SPINODAL] = { "R/(1+R v)", .ln_r_plus_v = 1 },
    [TIMESCALE_AGEING44] = { "R psi_ss", .ln_r = 1, .ln_psi_ss = -1 },
    [TIMESCALE_SLIP45] = { "R exp(psi_ss)", .ln_r = 1, .psi_ss = -1 },
};
const char *const kinetics_names[] = { "linear", "sinh", NULL };

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

static bool law_uses_R(const struct law *law)
{
    const struct timescale_terms *t = law_timescale(law);

    return law->theta == THETA_LN_C_1PR_PSI || law->psi_ss == PSI_SS_SPINODAL ||
           law->psi_ss == PSI_SS_SPINODAL_UNIT || t->ln_r || t->ln_r_plus_v;
}

bool law_uses(const struct law *law, enum material_key key)
{
    const bool always = key >= MATERIAL_L && key != MATERIAL_V_C;

    if (law->typed && !always)
        return law_typed_uses(law->typed, material_key_name(key)) ||
               (key == MATERIAL_R && law_typed_uses(law->typed, "one_R"));
    switch (key) {
        case MATERIAL_C:
            return law->theta == THETA_LN_C_PSI ||
                   law->theta == THETA_LN_C_1PR_PSI;
        case MATERIAL_R:
            return law_uses_R(law);
        case MATERIAL_V_C:
            return law->kinetics == KINETICS_COMPOSITE;
        default:
            return true;
    }
}

bool law_is_hyperbolic(const struct law *law, const struct material *m)
{
    if (law->typed)
        return law_plain_is_hyperbolic(law, m) &&
               law_plain_theta_is_log(law, m);
    return law->kinetics == KINETICS_SINH && !law_psi_is_log(law);
}

bool law_is_spinodal(const struct law *law, const struct material *m)
{
    if (law->typed)
        return law_plain_is_spinodal(law, m) && law_plain_theta_is_log(law, m);
    return law->psi_ss == PSI_SS_SPINODAL ||
           law->psi_ss == PSI_SS_SPINODAL_UNIT;
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

void law_formula(const struct law *law, char *text, size_t size)
{
    static const char *const theta[] = { "ln psi", "psi", "ln(c + psi)",
                                         "ln(c + (1+R) psi)" };
    static const char *const psi_ss[] = { "1/v", "-ln v", "(1+R)/(1+R v)",
                                          "1/(1+R v)",
                                          "exp(W(exp(-v/V_c)))/v" };
    static const char *const rate[] = { "-(psi - psi_ss)/T",
                                        "-sinh(psi - psi_ss)/T",
                                        "exp(-v/V_c) - v psi ln(v psi)" };

    if (law->typed)
        law_typed_formula(law->typed, text, size);
    else if (law->kinetics == KINETICS_COMPOSITE)
        snprintf(text, size, "theta = %s, dpsi/dt = %s", theta[law->theta],
                 rate[law->kinetics]);
    else
        snprintf(text, size, "theta = %s, psi_ss = %s, T = %s, dpsi/dt = %s",
                 theta[law->theta], psi_ss[law->psi_ss],
                 law_timescale(law)->formula, rate[law->kinetics]);
}

static enum status refuse(struct fault *why, const char *text)
{
    snprintf(why->text, sizeof why->text, "%s", text);
    return STATUS_BAD_ARGUMENT;
}

static enum status check_composition(const struct law *law,
                                     const struct material *m,
                                     struct fault *why)
{
    if (law->typed)
        return isinf(m->R) && law_uses(law, MATERIAL_R)
                   ? refuse(why, "R must be finite in a law of formulas")
                   : STATUS_OK;
    if (law_timescale(law)->ln_psi_ss && law->psi_ss == PSI_SS_MINUS_LOG) {
        snprintf(why->text, sizeof why->text,
                 "timescale %s is %s and needs psi_ss > 0, but psi_ss is "
                 "minus_log",
                 timescale_names[law->timescale], law_timescale(law)->formula);
        return STATUS_BAD_ARGUMENT;
    }
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
        snprintf(why->text, sizeof why->text, "%s = %.17g must be %s",
                 keys[key].name, value,
                 key == MATERIAL_MU_STAR ? "finite"
                 : may_be_zero           ? "zero or positive, and finite"
                 : key == MATERIAL_R     ? "positive"
                                         : "positive and finite");
        return STATUS_BAD_ARGUMENT;
    }
    return check_composition(law, m, why);
}
