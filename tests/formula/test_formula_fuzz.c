/* Formulas nobody wrote: from the grammar of parse.h, some then spoiled byte by
 * byte.  FORMULAS=10000000 for more of them; fuzz/fuzz_formula.c says what must
 * hold of each. */
#include <signal.h>
#include <string.h>
#include <unistd.h>

#include "check.h"
#include "fuzz.h"

enum { LETTERS = 400, ROUNDS = 10000, SECONDS = 10 };

static char text[LETTERS];
static size_t size;
static uint64_t seed;

static size_t below(size_t n)
{
    return check_bits(&seed) % n;
}

static void put(const char *word)
{
    const size_t n = strlen(word);

    if (size + n < LETTERS)
        memcpy(text + size, word, n);
    size += size + n < LETTERS ? n : 0;
}

#define ANY(list) (list)[below(sizeof(list) / sizeof *(list))]

static const char *const names[] = { "v", "y", "a", "b", "v", "y" };
static const char *const numbers[] = { "0",    "1",  "2",    "0.5",
                                       "1e-9", "3",  "1e3",  "7.25",
                                       "1e12", "pi", "1e-12" };
static const char *const functions_typed[] = {
    "exp(",  "ln(",   "log10(", "sqrt(", "sin(",  "cos(",   "tan(", "asin(",
    "acos(", "atan(", "sinh(",  "cosh(", "tanh(", "asinh(", "abs2("
};
static const char *const operators[] = { "+", "-", "*", "/", " - ", "*", "+" };
static const char *const powers[] = { "^2", "^3", "^-1", "^0.5", "^a", "^y" };

/* sum of at most `depth` levels */
static void grow(int depth)
{
    const size_t what = depth > 0 ? below(10) : below(2);

    if (what == 0) {
        put(ANY(names));
    } else if (what == 1) {
        put(below(2) ? ANY(numbers) : ANY(names));
    } else if (what < 7) {
        put("(");
        grow(depth - 1);
        put(ANY(operators));
        grow(depth - 1);
        put(")");
    } else if (what < 9) {
        put(ANY(functions_typed));
        grow(depth - 1);
        put(")");
    } else {
        put(below(2) ? "-(" : "(");
        grow(depth - 1);
        put(")");
        put(ANY(powers));
    }
}

/* A byte becomes another, a byte of the text, or nothing. */
static void spoil(void)
{
    for (size_t n = 1 + below(4); n > 0 && size > 0; n--) {
        const size_t at = below(size), how = below(4);
        if (how == 0) {
            text[at] = (char) below(256);
        } else if (how == 1) {
            memmove(text + at, text + at + 1, size - at - 1);
            size--;
        } else {
            text[at] = how == 2 ? text[below(size)] : "()^*/+-.e1#"[below(11)];
        }
    }
}

/* Which text it was. */
static void tell(int sign)
{
    (void) !write(STDERR_FILENO, text, size);
    (void) !write(STDERR_FILENO, "\n", 1);
    signal(sign, SIG_DFL);
    raise(sign);
}

static void invent(void)
{
    size = 0;
    grow(1 + (int) below(6));
    put("#");
    grow(1 + (int) below(5));
    if (below(3) == 0)
        spoil();
    LLVMFuzzerTestOneInput((const uint8_t *) text, size);
}

static void formulas_nobody_wrote_are_right_or_refused(void **state)
{
    const char *more = getenv("FORMULAS");
    const long rounds = more ? atol(more) : ROUNDS;

    (void) state;
    seed = check_seed();
    printf("# CHECK_SEED=%llu\n", (unsigned long long) seed);
    signal(SIGABRT, tell);
    signal(SIGALRM, tell);
    signal(SIGSEGV, tell);
    for (long i = 0; i < rounds; i++) {
        alarm(SECONDS);
        invent();
    }
    alarm(0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(formulas_nobody_wrote_are_right_or_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
