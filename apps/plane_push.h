/* plane_push.h -- slipway push on a system of formulas. */
#pragma once

#include "command.h"

/* Whereto the state of --state goes, or each of --states. */
enum exit_code plane_push(const struct options *o, const struct scene *scene);
