/* slipway: phase planes of rate-and-state friction.  main() reads the command
 * line and hands over to one command. */
#include <gsl/gsl_errno.h>
#include <omp.h>
#include <stdio.h>

#include "command.h"
#include "library.h"

static enum exit_code run(const struct options *o)
{
    const char *nearest = NULL;
    const struct command *c =
        command_find(o->command ? o->command : "help", &nearest);

    if (c != NULL)
        return c->run(o);
    fprintf(stderr, "slipway: no command '%s'%s%s%s (see slipway help)\n",
            o->command, nearest ? ", did you mean " : "",
            nearest ? nearest : "", nearest ? "?" : "");
    return EXIT_USAGE;
}

int main(int argc, char *argv[])
{
    struct options o;

    gsl_set_error_handler_off();
    store_silence();
    options_parse(&o, argc, argv);
    if (o.threads > 0)
        omp_set_num_threads(o.threads);
    const enum exit_code code = run(&o);
    options_free(&o);
    return (int) code;
}
