/* patch_field.h -- where fields lie in struct cell (cells.h), for patches. */
#pragma once

#include "cells.h"

/* is_log: its logarithm is smooth. */
struct patch_field {
    size_t value, error;
    bool is_log;
};
extern const struct patch_field patch_field[CELL_FIELDS];

static inline double patch_field_read(const struct cell *c, size_t offset)
{
    return *(const double *) ((const char *) c + offset);
}

static inline void patch_field_write(struct cell *c, size_t offset,
                                     double value)
{
    *(double *) ((char *) c + offset) = value;
}
