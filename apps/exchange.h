/* exchange.h -- a study as other programs need it (lib/interchange). */
#pragma once

#include "interchange.h"
#include "study.h"

/* What exchange_of needs of a study: bits of enum product. */
extern const unsigned exchange_products;

/* Borrows the study's block, `name` and `remarks`.  Without a saddle that
 * doubles can hold there are no branches; without a steady state `steady` is a
 * point of the steady curve. */
struct interchange exchange_of(const struct study *s, const char *name,
                               const char *remarks);

/* The scene and the study's numbers with their errors, as lines; owned by the
 * caller, NULL without memory. */
char *exchange_remarks(const struct study *s);
