/* picture_chi.h -- chi(v) for several slopes, Fig 10, as a figure. */
#ifndef APPS_PICTURE_CHI_H
#define APPS_PICTURE_CHI_H

#include "sheet.h"

/* The curves of p's study, and points where chi = 1. */
void picture_chi(const struct sheet *p);

#endif
