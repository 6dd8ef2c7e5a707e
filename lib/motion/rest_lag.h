/*
 * rest_lag.h -- the last of a rest that only inertia slows (rest_form.h): psi
 * follows psi_ss(v) ~ 1/v at once, behind it by as much as makes it as fast,
 *
 *     psi = psi_ss - lag,     lag = asinh(T dpsi/dt).
 *
 * x and y: offsets from the system's origin.
 */
#pragma once

struct slider;

/* A point of that curve. */
struct rest_lag {
    double y, y_slope; /* dy/dx */
    double slowness;   /* -1/(d ln v/dt) */
    double lag;        /* psi_ss - psi */
    double wrong;      /* of it, relative; NaN where v is not small enough */
};
struct rest_lag rest_lag_at(const struct slider *s, double x);

/* -1/(d ln v/dt) anywhere: eps^2 v/(cos(alpha) mu - sin(alpha)). */
double rest_lag_slowness(const struct slider *s, double x, double y);
