/* ensemble_tolerance.h -- the tunable numbers of lib/ensemble. */
#ifndef ENSEMBLE_ENSEMBLE_TOLERANCE_H
#define ENSEMBLE_ENSEMBLE_TOLERANCE_H

/* Draws that a thread takes at a time (batch.c): enough that what it sets up
 * for itself costs nothing, and few enough that it listens a hundred times a
 * second. */
#define BATCH_DRAWS 64

#endif
