/*
 * interchange.h -- a block on its slope, as programs need it that continue
 * steady states or integrate in time.  Coordinates are absolute, in the chart
 * (ln v, ln psi) [(ln v, psi) where psi is a logarithm]; time in L/V_star.
 */
#pragma once

#include <stdio.h>

#include "field_text.h"

/* A branch of the saddle's stable manifold, from the end of its series. */
struct interchange_branch {
    const char *name; /* "upper", "lower" */
    struct vec2 start;
    double length; /* of arc from the start to where its limit is reached */
};

struct interchange {
    const struct block *block; /* borrowed; anchored at a steady state if
                                  there is one */
    const char *name;          /* borrowed: NAME of the files */
    const char *remarks;       /* borrowed: lines that the header repeats */
    struct interchange_branch branch[2];
    size_t branches;   /* 0: there is no saddle */
    struct vec2 start; /* of a motion in time, and how long it is followed */
    double time;
    struct vec2 steady; /* a steady state to be continued in alpha, */
    double toward;      /* where to first: +1 or -1, */
    double alpha[2];    /* and between which slopes, rad */
    bool has_folds;     /* and the law has c to follow them in */
};

/* Writes `text` line by line behind `before`, blanks for what could mean
 * something to a program that reads comments. */
void interchange_remark(FILE *out, const char *before, const char *text);

/* What a parameter is: "slope angle (rad)". */
void interchange_meaning(FILE *out, enum text_parameter p);
