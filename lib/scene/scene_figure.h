/* scene_figure.h -- the paper of figures: words for kinds of it, and what a
 * scene leaves open. */
#pragma once

#include "scene.h"

enum { SCENE_FONT = 64 }; /* letters of a font's name, and one */

/* The screen's width, all else open. */
void scene_figure_begin(struct scene_figure *f);

/* Takes the width of that kind of page; false: there is no such word. */
bool scene_figure_preset(const char *word, struct scene_figure *f);

/* What is open becomes that of the kind of page that is so wide, if there is
 * one. */
void scene_figure_settle(struct scene_figure *f);

/* How far a line may be from the curve that it stands for, as a fraction of
 * the page's width: TOL_FIGURE_DOT dots. */
double scene_figure_chord(const struct scene_figure *f);
