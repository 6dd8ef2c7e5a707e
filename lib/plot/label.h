/* label.h -- a text on its way into a gnuplot script.  Whatever the text
 * holds, it comes out as one inert string constant; only the marks of mark.h
 * mean something. */
#pragma once

#include <stdio.h>

/* Height of letters above and below the line, in that of the others; what
 * gnuplot takes. */
#define LABEL_SCRIPT 0.8

/* A line of a text. */
struct label_part {
    const char *text; /* borrowed */
    size_t size;
};

/* An upper estimate of the width in units of the font size: the letter widths
 * of DejaVu Sans, the widest of the usual sans-serif fonts, in five classes. */
double label_width(const char *text);
double label_part_width(struct label_part line);

/* Breaks the text at blanks into at most `most` lines of that width; what does
 * not fit is left to the last.  Returns how many there are, at least 1. */
size_t label_break(const char *text, double room, struct label_part line[],
                   size_t most);

/* Writes the line in single quotes, where gnuplot expands nothing: quotes
 * doubled (those that come first as "'". before it), control characters as
 * blanks, what is no UTF-8 as '?', "]]>" as "]] >".  A line wider than `room`
 * (same unit as label_width) is cut and ends in an ellipsis.  Then " enhanced",
 * if there are marks, each as gnuplot has it, or " noenhanced".  script: size
 * of letters above and below the line, in LABEL_SCRIPT. */
void label_write(FILE *out, struct label_part line, double room, double script);

/* A text without marks, on one line, as a comment may hold it. */
void label_comment(FILE *out, const char *text);

/* A file name of the current folder in single quotes, as "./NAME", so that
 * neither a leading '|' nor '<' can mean a pipe. */
void label_write_path(FILE *out, const char *name);
