/*
 * scalar_text.h -- the functions of scalar.h as text, for programs that know
 * exp, ln, sqrt, sinh, abs, sign, max, min and if(..)then(..)else(..) and
 * nothing more: what scalar.h computes, to some units of a double's last digit.
 */
#ifndef FRICTION_SCALAR_TEXT_H
#define FRICTION_SCALAR_TEXT_H

#include <stdbool.h>
#include <stddef.h>

struct scalar_text {
    const char *name;
    const char *arguments; /* "p_,u_": their names, unlike any other name */
    const char *body;
    const char *meaning;
};

enum { SCALAR_TEXTS = 14 };

/* Those that come after need those before only. */
extern const struct scalar_text scalar_texts[SCALAR_TEXTS];

/* Whether `text` calls a function of this name. */
bool scalar_text_calls(const char *text, const char *name);

/* Adds to needed[] those that the needed ones call. */
void scalar_text_complete(bool needed[SCALAR_TEXTS]);

#endif
