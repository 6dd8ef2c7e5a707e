/*
 * method.h -- integrators of others and our own explicit one behind one table,
 * for races: GSL's steppers, SUNDIALS' where it was found, explicit8.h's.
 *
 * Each follows u' = rates(u), one accepted step after another, with the error
 * of a step held below tol (1 + |u_i|) in each component.
 */
#pragma once

#include <stdbool.h>
#include <stddef.h>

enum { METHOD_DIM = 3 };

/* An autonomous system.  Where it is not defined it writes NaN. */
struct method_system {
    size_t dim; /* <= METHOD_DIM */
    void (*rates)(const void *ctx, const double u[], double du[]);
    /* d du[i]/d u[j] as J[i * dim + j]. */
    void (*jacobian)(const void *ctx, const double u[], double J[]);
    const void *ctx;          /* borrowed */
    size_t calls, calls_most; /* of both; a method fails beyond the most */
};

struct method {
    const char *name; /* "gsl_rk8pd" */
    const char *text; /* one phrase */
    bool foreign;
    const void *kind; /* what of its library it is */
    /* Starts at u with a first step of h.  The state is owned by the caller;
     * NULL: out of memory. */
    void *(*open)(const struct method *m, struct method_system *system,
                  double tol, const double u[], double h);
    /* One accepted step, not beyond s_end; false: it gave up. */
    bool (*step)(void *state, double s_end, double *s, double u[]);
    /* The solution at s on the last step; NULL: none; a cubic
     * through the step's ends must do. */
    bool (*between)(void *state, double s, double u[]);
    void (*close)(void *state);
};

/* Tables, each ended by a method without a name: ours; GSL's steppers, used as
 * its manual has it, a driver with the error of y controlled and stepped by
 * hand; CVODE and ARKODE where they were found. */
extern const struct method method_explicit[], method_gsl[], method_sundials[];

/* The methods that are there, numbered from 0; NULL beyond the last. */
const struct method *method_at(size_t i);

/* "GSL 2.7.1", and "SUNDIALS 6.4.1" or "none". */
const char *method_gsl_version(void);
const char *method_sundials_version(void);

/* rates and jacobian, counted; false beyond calls_most or where they are not
 * finite. */
bool method_rates(struct method_system *system, const double u[], double du[]);
bool method_jacobian(struct method_system *system, const double u[],
                     double J[]);
