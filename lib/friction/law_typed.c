/* Laws that are formulas, and their steady states. */
#include "law_typed.h"

#include <stdio.h>
#include <string.h>

/* ---- making -------------------------------------------------------------- */

static enum law_part part_of(const char *name)
{
    int part = 0;

    while (name && part < LAW_PARTS && strcmp(law_part_names[part], name) != 0)
        part++;
    return !name                       ? LAW_PARTS
           : strcmp(name, "dpsi") == 0 ? LAW_RATE
                                       : (enum law_part) part;
}

static enum status lack(struct fault *why, const char *text)
{
    snprintf(why->text, sizeof why->text, "%s", text);
    return STATUS_BAD_SCENE;
}

static enum status check_parts(const struct law_typed *t, struct fault *why)
{
    const bool rate = t->text[LAW_RATE][0];

    if (!t->text[LAW_PSI_SS][0] && !rate)
        return lack(why, "psi_ss is missing, expected the state in steady "
                         "sliding, as in 1/v, or rate");
    if (!t->text[LAW_THETA][0] && !t->text[LAW_MU][0])
        return lack(why, "theta is missing, expected it, as in ln(psi), or mu");
    if (rate && (t->text[LAW_T][0] || t->text[LAW_K][0]))
        return lack(why, "rate beside T or K, expected one of the two");
    if (!rate && !t->text[LAW_T][0])
        return lack(why, "T is missing, expected it, as in 1/v, or rate");
    return STATUS_OK;
}

enum status law_typed_make(struct law_typed *t, enum law_part *wrong,
                           struct fault *why)
{
    const struct law law = law_of_typed(t);
    enum status s = check_parts(t, why);

    *wrong = LAW_PARTS;
    for (int i = 0; i < 2 && s == STATUS_OK; i++) {
        const char *name = NULL;
        law_names(&law, &t->tape[i].f);
        s = law_tape_observed(&law, i, &t->tape[i], &name, why);
        *wrong = part_of(name);
    }
    if (s == STATUS_OK)
        law_graph_make(&law, &t->graph);
    return s == STATUS_OK ? s : STATUS_BAD_SCENE;
}

/* Kato and Tullis', of which the closed forms of others do not hold. */
struct law law_of_typed(const struct law_typed *t)
{
    return (struct law){ .preset = "typed",
                         .words = "The scene's law",
                         .equation = "formulas of the scene",
                         .form = t->form,
                         .theta = t->real ? THETA_PSI : THETA_LN_PSI,
                         .psi_ss = PSI_SS_LAMBERT,
                         .timescale = TIMESCALE_SLIP,
                         .kinetics = KINETICS_COMPOSITE,
                         .typed = t };
}

void law_typed_of_preset(const struct law *p, struct law_typed *out)
{
    memset(out, 0, sizeof *out);
    out->real = law_psi_is_log(p);
    out->form = p->form;
    for (int i = 0; i < LAW_PARTS; i++) {
        const char *text = law_text(p, (enum law_part) i);
        strcpy(out->text[i], text ? text : "");
    }
}

const char *law_typed_text(const struct law_typed *t, enum law_part part)
{
    return t->text[part][0] ? t->text[part] : NULL;
}
