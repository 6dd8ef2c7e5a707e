/*
 * mark.h -- letters as a typesetter sets them, in labels and entries of a
 * figure: italic quantities, subscripts, superscripts.  A mark is a control
 * character, which no user's text can hold when it comes here (figure.h).
 */
#pragma once

#include <stddef.h>

enum mark { MARK_ITALIC = 1, MARK_SUB, MARK_SUPER, MARK_END };

#define ITALIC(text) "\1" text "\4"
#define SUB(text)    "\2" text "\4"
#define SUPER(text)  "\3" text "\4"

/* x to so many digits: "0.025", "2.5×10^-8" below 1e-3 and from 1e5 on, with a
 * true minus, multiplication sign and superscript. */
void mark_number(char *out, size_t size, double x, int digits);

/* A variable's name: italic, what follows a _ below the line. */
void mark_name(char *out, size_t size, const char *name);

/* The text with its marks and what they raise or lower written plainly: mu_ss,
 * 10^-8. */
void mark_plain(const char *text, char *out, size_t size);
