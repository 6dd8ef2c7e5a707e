/* plane_push.h -- slipway push on a system of formulas. */
#pragma once

#include "command.h"

/* Whereto the state of --state goes, or each of --states. */
enum exit_code plane_push(const struct options *o, const struct scene *scene);

/* A state of a system, "x=1,y=0.5". STATUS_BAD_ARGUMENT, STATUS_NO_MEMORY. */
MUST_CHECK enum status plane_push_read(const struct scene *s, const char *text,
                                       double state[2], struct fault *why);
