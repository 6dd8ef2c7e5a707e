/* What a child hands back, and every way in which it may die. */
#include "child.h"

#include <fcntl.h>
#include <signal.h>
#include <stdbool.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "check.h"
#include "fault_alloc.h"
#include "own_folder.h"
#include "tolerance.h"

/* What the child is told to do. */
struct order {
    size_t bytes; /* to write, then */
    int signal;   /* to die of; 0: none */
    int status;   /* to exit with; -1: not at all */
    enum status answer;
    volatile bool hangs;
    size_t memory; /* to ask for */
};

/* The alphabet, again and again. */
static void write_letters(FILE *out, size_t bytes)
{
    char letters[26 * 1000];

    for (size_t i = 0; i < sizeof letters; i++)
        letters[i] = (char) ('a' + i % 26);
    for (size_t part; bytes > 0; bytes -= part) {
        part = bytes < sizeof letters ? bytes : sizeof letters;
        fwrite(letters, 1, part, out);
    }
}

static enum status obey(void *ctx, FILE *out, struct fault *why)
{
    struct order *o = ctx;

    write_letters(out, o->bytes);
    if (o->signal != 0 || o->status >= 0)
        fflush(out);
    if (o->signal != 0) {
        signal(o->signal, SIG_DFL); /* cmocka has its own way with some */
        raise(o->signal);
    }
    if (o->status >= 0)
        _exit(o->status);
    while (o->hangs)
        continue;
    if (o->memory > 0 && mmap(NULL, o->memory, PROT_READ | PROT_WRITE,
                              MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) == MAP_FAILED)
        return STATUS_NO_MEMORY;
    snprintf(why->text, sizeof why->text, "as told");
    o->bytes = 0; /* which the parent never sees */
    return o->answer;
}

/* Nothing is left over, whatever happened. */
static enum status give(struct order *o, char **bytes, size_t *size,
                        struct fault *why)
{
    const int before = dup(0);

    close(before);
    const enum status s =
        child_read(obey, o, "a.h5", o->hangs ? 1 : 600, bytes, size, why);
    const int after = dup(0);
    close(after);
    assert_int_equal(before, after);
    assert_int_equal(waitpid(-1, NULL, WNOHANG), -1);
    return s;
}

static void what_is_written_comes_back(void **state)
{
    static const size_t sizes[] = { 0, 1, 511, 65535, 65536, 300000 };

    (void) state;
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        struct order o = { .bytes = sizes[i], .status = -1 };
        struct fault why = { "" };
        char *bytes;
        size_t size;
        assert_int_equal(give(&o, &bytes, &size, &why), STATUS_OK);
        assert_int_equal(size, sizes[i]);
        assert_int_equal(o.bytes, sizes[i]);
        for (size_t k = 0; k < size; k++)
            assert_int_equal(bytes[k], 'a' + k % 26);
        assert_int_equal(bytes[size], '\0');
        free(bytes);
    }
}

static void refuses(struct order o, enum status status, const char *words)
{
    struct fault why = { "" };
    char *bytes;
    size_t size;

    o.status = o.status == 0 ? -1 : o.status;
    assert_int_equal(give(&o, &bytes, &size, &why), status);
    assert_null(bytes);
    assert_int_equal(size, 0);
    CHECK(strstr(why.text, words) && !strchr(why.text, '\n'), "'%s'", why.text);
}

static void a_failure_comes_back_with_its_words(void **state)
{
    (void) state;
    refuses((struct order){ .answer = STATUS_IO }, STATUS_IO, "as told");
    refuses((struct order){ .answer = STATUS_BAD_SCENE, .bytes = 99999 },
            STATUS_BAD_SCENE, "as told");
}

static void every_death_is_an_error_in_one_line(void **state)
{
    static const int signals[] = { SIGSEGV, SIGABRT, SIGBUS,  SIGFPE,
                                   SIGILL,  SIGKILL, SIGTERM, SIGPIPE };

    (void) state;
    for (size_t i = 0; i < sizeof signals / sizeof *signals; i++)
        for (size_t bytes = 0; bytes < 2000; bytes += 900)
            refuses((struct order){ .signal = signals[i], .bytes = bytes },
                    STATUS_IO, "a.h5: damaged: HDF5 died over it");
    refuses((struct order){ .status = 3 }, STATUS_IO, "a.h5: damaged");
    refuses((struct order){ .status = 3, .bytes = 2000 }, STATUS_IO, "damaged");
}

/* Nobody waits for it, and then nobody knows how it died. */
static void children_may_be_ignored(void **state)
{
    (void) state;
    signal(SIGCHLD, SIG_IGN);
    refuses((struct order){ .signal = SIGSEGV }, STATUS_IO, "a.h5: damaged");
    refuses((struct order){ .answer = STATUS_IO }, STATUS_IO, "as told");
    signal(SIGCHLD, SIG_DFL);
}

static void what_hangs_is_ended(void **state)
{
    sigset_t alarms;

    (void) state;
    sigemptyset(&alarms);
    sigaddset(&alarms, SIGALRM);
    sigprocmask(SIG_BLOCK, &alarms, NULL); /* by whoever called us */
    signal(SIGALRM, SIG_IGN);
    refuses((struct order){ .hangs = true }, STATUS_IO, "takes too long");
    signal(SIGALRM, SIG_DFL);
    sigprocmask(SIG_UNBLOCK, &alarms, NULL);
}

static void what_eats_memory_gets_none(void **state)
{
    (void) state;
    refuses((struct order){ .memory = CHILD_BYTES + 1 }, STATUS_NO_MEMORY, "");
    refuses((struct order){ .memory = CHILD_BYTES / 2, .answer = STATUS_IO },
            STATUS_IO, "as told");
    refuses((struct order){ .bytes = CHILD_ANSWER + 1 }, STATUS_IO,
            "File too large");
}

static enum status complain(void *ctx, FILE *out, struct fault *why)
{
    struct rlimit core;

    (void) ctx, (void) out, (void) why;
    fprintf(stderr, "free(): invalid pointer\n");
    assert_int_equal(getrlimit(RLIMIT_CORE, &core), 0);
    return core.rlim_cur == 0 ? STATUS_OK : STATUS_IO;
}

/* Nor does it leave a core file. */
static void it_dies_in_silence(void **state)
{
    const int saved = dup(STDERR_FILENO);
    const int heard = open(own_path("stderr"), O_RDWR | O_CREAT, 0600);
    struct fault why;
    char *bytes;
    size_t size;

    (void) state;
    dup2(heard, STDERR_FILENO);
    const enum status s =
        child_read(complain, NULL, "a.h5", 60, &bytes, &size, &why);
    dup2(saved, STDERR_FILENO);
    assert_int_equal(s, STATUS_OK);
    assert_int_equal(lseek(heard, 0, SEEK_END), 0);
    close(heard);
    close(saved);
    free(bytes);
}

/* Writes its number, then waits for ever. */
static enum status wait_for_ever(void *ctx, FILE *out, struct fault *why)
{
    const pid_t self = getpid();

    (void) out, (void) why;
    if (write(*(int *) ctx, &self, sizeof self) != sizeof self)
        return STATUS_IO;
    for (;;)
        pause();
}

static bool is_gone(pid_t pid)
{
    for (int i = 0; i < 1000; i++) {
        if (kill(pid, 0) != 0)
            return true;
        nanosleep(&(struct timespec){ 0, 10000000 }, NULL);
    }
    return false;
}

static void it_ends_with_its_parent(void **state)
{
    int ends[2];
    pid_t grandchild = 0;

    (void) state;
    assert_int_equal(pipe(ends), 0);
    const pid_t child = fork();
    if (child == 0) {
        struct fault why;
        char *bytes;
        size_t size;
        _exit((int) child_read(wait_for_ever, &ends[1], "a.h5", 60, &bytes,
                               &size, &why));
    }
    assert_int_equal(read(ends[0], &grandchild, sizeof grandchild),
                     sizeof grandchild);
    kill(child, SIGKILL);
    assert_int_equal(waitpid(child, NULL, 0), child);
    assert_true(is_gone(grandchild));
    close(ends[0]);
    close(ends[1]);
}

static void any_allocation_may_fail(void **state)
{
    enum status s = STATUS_NO_MEMORY;

    (void) state;
    for (long k = 0; s != STATUS_OK; k++) {
        struct order o = { .bytes = 300000, .status = -1 };
        struct fault why = { "" };
        char *bytes;
        size_t size;
        fault_alloc_at(k);
        s = give(&o, &bytes, &size, &why);
        const bool failed = fault_alloc_count() > k;
        fault_alloc_at(FAULT_ALLOC_NEVER);
        CHECK(s == (failed ? STATUS_NO_MEMORY : STATUS_OK), "%ld", k);
        CHECK(!failed || strstr(why.text, "a.h5: out of memory"), "'%s'",
              why.text);
        free(bytes);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_written_comes_back),
        cmocka_unit_test(a_failure_comes_back_with_its_words),
        cmocka_unit_test(every_death_is_an_error_in_one_line),
        cmocka_unit_test(children_may_be_ignored),
        cmocka_unit_test(what_hangs_is_ended),
        cmocka_unit_test(what_eats_memory_gets_none),
        cmocka_unit_test_setup_teardown(it_dies_in_silence, own_folder_make,
                                        own_folder_remove),
        cmocka_unit_test(it_ends_with_its_parent),
        cmocka_unit_test(any_allocation_may_fail),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
