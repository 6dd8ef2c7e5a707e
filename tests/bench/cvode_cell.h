/* cvode_cell.h -- the fate of one state by CVODE's BDF to the node, as a user
 * of SUNDIALS would find it; built only where SUNDIALS was found. */
#pragma once

#include "plain.h"

bool cvode_is_there(void);

/* Of the offset z from the saddle: in (ln v, ln psi), rtol 1e-6, first step
 * 1e-3 over the fastest rate, until within 1 % of a node; FATE_CREEP or
 * FATE_SLIDING, -1 where CVODE gives up. */
int cvode_label(struct plain *p, const double z[2]);

/* Where a cell ends: within 1 % of a node of (ln v, ln psi), an offset from the
 * saddle, or (rests) at ln v = ln v_sp - 12 and what is left from there if v
 * goes on to fall at an even rate. */
struct cvode_end {
    bool rests;
    double x, y;
};

/* Slip and time from the offset z to there; slip as a component, the end by
 * root finding; `slip_least`: what tolerances of slip are relative to at least.
 * False: CVODE gives up. */
bool cvode_cell(struct plain *p, const double z[2], const struct cvode_end *end,
                double tol, double slip_least, double *slip, double *time);
