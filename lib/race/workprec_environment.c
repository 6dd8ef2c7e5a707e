#include "workprec_environment.h"

#include <stdio.h>
#include <string.h>
#include <sys/utsname.h>

#include "method.h"
#include "workprec_clock.h"

const struct record_type record_workprec_environment = RECORD(
    workprec_environment, "workprec_environment", "where times were measured",
    FIELD(workprec_environment, TEXT, cpu, "1", "processor"),
    FIELD(workprec_environment, TEXT, system, "1", "operating system"),
    FIELD(workprec_environment, TEXT, compiler, "1", "compiler"),
    FIELD(workprec_environment, TEXT, flags, "1", "its optimisation flags"),
    FIELD(workprec_environment, TEXT, gsl, "1", "version of GSL"),
    FIELD(workprec_environment, TEXT, sundials, "1", "version of SUNDIALS"),
    FIELD(workprec_environment, REAL, clock_overhead, "s",
          "taken off every time measured"));

/* The value of the first line "KEY : value"; false where there is none. */
static bool read_value(FILE *in, const char *key, char out[WORKPREC_TEXT])
{
    char line[1024];

    while (fgets(line, sizeof line, in)) {
        const char *colon = strchr(line, ':');
        if (strncmp(line, key, strlen(key)) != 0 || colon == NULL)
            continue;
        colon += 1 + strspn(colon + 1, " \t");
        snprintf(out, WORKPREC_TEXT, "%.*s", (int) strcspn(colon, "\n"), colon);
        return true;
    }
    return false;
}

static void find_cpu(struct workprec_environment *e)
{
    FILE *in = fopen("/proc/cpuinfo", "r");

    e->cpu = e->cpu_text;
    if (in == NULL || !read_value(in, "model name", e->cpu_text))
        snprintf(e->cpu_text, WORKPREC_TEXT, "unknown");
    if (in)
        fclose(in);
}

static void find_system(struct workprec_environment *e)
{
    struct utsname u;

    e->system = e->system_text;
    if (uname(&u) == 0)
        snprintf(e->system_text, WORKPREC_TEXT, "%.60s %.60s %.30s", u.sysname,
                 u.release, u.machine);
    else
        snprintf(e->system_text, WORKPREC_TEXT, "unknown");
}

void workprec_environment_find(struct workprec_environment *e)
{
    *e = (struct workprec_environment){ .flags = WORKPREC_FLAGS,
                                        .gsl = method_gsl_version(),
                                        .sundials = method_sundials_version() };
#ifdef __clang__
    e->compiler = __VERSION__;
#else
    e->compiler = "gcc " __VERSION__;
#endif
    find_cpu(e);
    find_system(e);
    e->clock_overhead = workprec_clock_overhead();
}
