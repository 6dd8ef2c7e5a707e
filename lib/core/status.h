/* status.h -- the one error vocabulary of the project. */
#pragma once

/* Before a function whose answer must not be ignored. */
#define MUST_CHECK __attribute__((warn_unused_result))

/* name, what it means to the person reading the message */
/* clang-format off */
#define STATUS_LIST(ENTRY)                                                  \
    ENTRY(STATUS_OK, "success")                                             \
    ENTRY(STATUS_NO_MEMORY, "out of memory")                                \
    ENTRY(STATUS_BAD_ARGUMENT, "argument outside its documented range")     \
    ENTRY(STATUS_NO_CONVERGENCE, "iteration stopped before its tolerance")  \
    ENTRY(STATUS_NOT_HYPERBOLIC, "equilibrium is not a hyperbolic saddle")  \
    ENTRY(STATUS_TOO_MANY_STEPS, "more steps than the bound allows")        \
    ENTRY(STATUS_STOPPED, "interrupted")                                    \
    ENTRY(STATUS_BAD_SCENE, "the scene or an option is wrong")              \
    ENTRY(STATUS_IO, "cannot read or write a file")                         \
    ENTRY(STATUS_NO_GNUPLOT, "gnuplot is missing or failed")
/* clang-format on */

/* An entry of the list as a name of the enum. */
#define STATUS_AS_ENUM(name, text) name,
/* How a call went. */
enum status { STATUS_LIST(STATUS_AS_ENUM) STATUS_COUNT };
#undef STATUS_AS_ENUM

/* Never NULL, never freed; also answers for values that are not a status. */
const char *status_text(enum status s);

/* One line for the user that names the wrong file, key or number.  Functions
 * that can blame the user's input take one as last argument and fill it only
 * when they fail. */
struct fault {
    char text[512];
};

/* Its text as printf makes it; returns s. */
enum status fault_set(struct fault *why, enum status s, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
