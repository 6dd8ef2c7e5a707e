/*
 * arithmetic.h -- + - * / of the elements of numbers, written as calls in the
 * formula headers: C has no operators for the one kind of number that is text
 * (field_text.c), which defines its own before it includes them.
 */
#ifndef FRICTION_ARITHMETIC_H
#define FRICTION_ARITHMETIC_H

#ifndef PLUS
#define PLUS(u, w)       ((u) + (w))
#define LESS(u, w)       ((u) - (w))
#define TIMES(u, w)      ((u) * (w))
#define OVER(u, w)       ((u) / (w))
#define PLAIN(n)         (n)               /* a literal as an element */
#define GIVEN(m, member) ((T) (m)->member) /* of a material */
#endif

#endif
