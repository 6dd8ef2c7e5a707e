/* synonym.h -- words of the field that have another name here, such as D_c and
 * ageing: a wrong word is answered with what may have been meant. */
#pragma once

/* Of a NULL-ended list the word that may have been meant: a synonym, or the
 * nearest in spelling (spell.h); NULL if there is none. */
const char *synonym_nearest(const char *word, const char *const *known);
