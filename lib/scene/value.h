/*
 * value.h -- reads the values of keys into a scene, as the schema says.
 *
 * All are readers of schema.h: STATUS_BAD_SCENE, blamed on the value, where it
 * has the wrong shape or is out of range; STATUS_NO_MEMORY.
 */
#pragma once

#include "schema.h"

VALUE_READER(value_text);       /* char *, owned */
VALUE_READER(value_path);       /* the same; nothing: NULL */
VALUE_READER(value_figure);     /* a path that ends in .svg, .pdf, .png */
VALUE_READER(value_real);       /* double */
VALUE_READER(value_length);     /* the same, which no sweep can vary */
VALUE_READER(value_page);       /* paper, from a word or its width */
VALUE_READER(value_font);       /* char *, owned; the name of a font */
VALUE_READER(value_pair);       /* double[2], lo < hi */
VALUE_READER(value_count);      /* size_t */
VALUE_READER(value_seed);       /* uint64_t */
VALUE_READER(value_choice);     /* enum: the word's code */
VALUE_READER(value_flag);       /* bool, of "false" and "true" */
VALUE_READER(value_cells);      /* size_t[2] */
VALUE_READER(value_part);       /* the same, or a formula (scene_law.h) */
VALUE_READER(value_formula);    /* one of these only: no member */
VALUE_READER(value_state);      /* a word, read elsewhere or but the default */
VALUE_READER(value_preset);     /* law, but its form */
VALUE_READER(value_slope);      /* alpha and tan_alpha, by `side` - 1 */
VALUE_READER(value_products);   /* products, from a list of words */
VALUE_READER(value_xi);         /* xi, xi_count; each in the key's range */
VALUE_READER(value_slopes);     /* rabinowicz.tan_alpha, slopes */
VALUE_READER(value_chi_slopes); /* chi_alpha, chi_alphas */
VALUE_READER(value_input);      /* a path, beside the scene if it is there */
VALUE_READER(value_starts);     /* start, starts, in the scene's units */
VALUE_READER(value_key);        /* sweep.draft.key: a key of a real number */
VALUE_READER(value_values);     /* sweep.draft.value, count */

/* Blames a value; offers the nearest word where words are expected. */
enum status value_refuse(const struct schema_key *key, const struct node *n,
                         struct fault *why);

/* A number in the key's range, in its unit; false, *value untouched. */
bool value_is_number(const struct schema_key *key, const struct node *n,
                     double *value);

/* Whether a key holds one real number. */
bool value_is_real(const struct schema_key *key);

/* Gives such a key a value; false, and the scene as it was, where that is out
 * of its range. */
bool value_set(const struct schema_key *key, double x, struct scene *s);
