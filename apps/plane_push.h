/* plane_push.h -- slipway push on a system of formulas. */
#ifndef APPS_PLANE_PUSH_H
#define APPS_PLANE_PUSH_H

#include "command.h"

/* Whereto the state of --state goes, or each of --states. */
enum exit_code plane_push(const struct options *o, const struct scene *scene);

#endif
