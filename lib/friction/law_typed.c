/* Laws that are formulas, and their steady states. */
#include "law_typed.h"

#include <assert.h>
#include <math.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
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
    return fault_set(why, STATUS_BAD_SCENE, "%s", text);
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

static bool is_exponent(const struct formula *f, const char *name)
{
    return f->node[formula_find(f, name, strlen(name))].exponent;
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
    for (int i = 0; i < t->owns && s == STATUS_OK; i++)
        t->own[i].exponent = is_exponent(&t->tape[1].f, t->own[i].name) ||
                             is_exponent(&t->graph.f, t->own[i].name);
    return s == STATUS_OK ? s : STATUS_BAD_SCENE;
}

/* ---- whole exponents ----------------------------------------------------- */

static bool is_whole(double x)
{
    return floor(x) >= x && fabs(x) < FORMULA_WHOLE;
}

static bool suits(const struct law_typed *t, const double own[])
{
    for (int i = 0; i < t->owns; i++) {
        const double was = t->own[i].value;
        if (t->own[i].exponent && (was < own[i] || was > own[i]) &&
            (is_whole(was) || is_whole(own[i])))
            return false;
    }
    return true;
}

static struct law_typed *make_at(const struct law_typed *t, const double own[])
{
    struct law_typed *new = calloc(1, sizeof *new);
    enum law_part wrong;
    struct fault why;

    if (new == NULL)
        return NULL;
    memcpy(new->text, t->text, sizeof new->text);
    memcpy(new->own, t->own, sizeof new->own);
    new->real = t->real;
    new->form = t->form;
    new->owns = t->owns;
    for (int i = 0; i < t->owns; i++)
        new->own[i].value = own[i];
    const enum status s = law_typed_make(new, &wrong, &why);
    assert(s == STATUS_OK); /* it was with others */
    (void) s;
    return new;
}

const struct law_typed *law_typed_at(struct law_typed *t, const double own[])
{
    struct law_typed *made = NULL, *next = NULL;

    while (!suits(t, own)) {
        next = atomic_load(&t->next);
        if (next == NULL && made == NULL && !(made = make_at(t, own)))
            return NULL;
        if (next == NULL &&
            atomic_compare_exchange_strong(&t->next, &next, made))
            return made;
        t = next; /* another thread's, if it was sooner */
    }
    law_typed_free(made);
    return t;
}

void law_typed_free(struct law_typed *t)
{
    while (t) {
        struct law_typed *next = atomic_load(&t->next);
        free(t);
        t = next;
    }
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
