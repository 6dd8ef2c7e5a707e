/*
 * slow_off.h -- how far time and slip are off along a curve that an orbit is
 * run along, by its drift (drift.h), where a function of the chart has its
 * value: step by step, and added up from where they are counted from, for most
 * of a curve takes far less time than its first steps, whose sums have none of
 * its digits.
 */
#pragma once

#include "drift.h"

struct slow_off {
    double time, slip;
};

/* What the orbit's last step made of both; late: how far along the function
 * the orbit is off, times what time and slip to come change by; *was: the same
 * where the step began, and then here.  Not finite where the function stands
 * still: the next step tells it. */
struct slow_off slow_off_gained(struct drift *d, struct slow_off late,
                                struct slow_off *was);

/* Of several steps: the errors, and a deviation of what is not known of them.
 */
struct slow_sum {
    struct slow_off off, unsure;
};

void slow_sum_add(struct slow_sum *sum, struct slow_off gained);

/* A bound of both. */
struct slow_off slow_sum_bar(const struct slow_sum *sum);
