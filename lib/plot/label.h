/* label.h -- a user's text on its way into a gnuplot script.  Whatever the
 * text holds, it comes out as one inert string constant. */
#ifndef PLOT_LABEL_H
#define PLOT_LABEL_H

#include <stdio.h>

/* An upper estimate of the width in units of the font size: the letter widths
 * of DejaVu Sans, the widest of the usual sans-serif fonts, in five classes. */
double label_width(const char *text);

/* Writes the text in single quotes, where gnuplot expands nothing: quotes
 * doubled (those that come first as "'". before it), control characters as
 * blanks, what is no UTF-8 as '?', "]]>" as "]] >".  A text wider than `room`
 * (same unit as label_width) is cut and ends in an ellipsis. */
void label_write(FILE *out, const char *text, double room);

/* A file name of the current folder in single quotes, as "./NAME", so that
 * neither a leading '|' nor '<' can mean a pipe. */
void label_write_path(FILE *out, const char *name);

#endif
