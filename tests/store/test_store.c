/* A file appears whole or not at all, and the same each time. */
#include "store.h"

#include <hdf5.h>
#include <signal.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "check.h"
#include "fault_alloc.h"
#include "own_folder.h"
#include "sample_store.h"
#include "store_records.h"

static void the_same_calls_give_the_same_bytes(void **state)
{
    const char *path = own_path("out.h5"), *other = own_path("sub/other.h5");
    char *one, *two;
    size_t size[2];

    (void) state;
    assert_int_equal(mkdir(own_path("sub"), 0777), 0);
    sample_must_write(path);
    sleep(1);
    sample_must_write(other);
    one = file_read(path, &size[0]);
    two = file_read(other, &size[1]);
    assert_int_equal(size[0], size[1]);
    assert_memory_equal(one, two, size[0]);
    free(one);
    free(two);
}

static void says(const struct fault *fault, const char *name,
                 const char *reason)
{
    char line[512];

    snprintf(line, sizeof line, "%s: %s", name, reason);
    assert_string_equal(fault->text, line);
}

static void refuses(const char *name, const char *reason)
{
    struct fault fault = { "" };
    const enum status s = sample_write(name, &fault);

    CHECK(s == STATUS_IO, "%s", status_text(s));
    says(&fault, name, reason);
}

static void a_wrong_place_is_named_with_the_reason(void **state)
{
    const char *folder = own_path(""), *missing = own_path("missing.h5");
    struct fault fault = { "" };
    struct store *st;

    (void) state;
    refuses("", "No such file or directory");
    refuses(folder, "Is a directory");
    refuses("/dev/null", "not a regular file");
    file_write(own_path("file"), "old", 3);
    refuses(own_path("file/out.h5"), "Not a directory");
    assert_int_equal(store_open(missing, &st, &fault), STATUS_IO);
    CHECK(strstr(fault.text, "No such file"), "%s", fault.text);
    assert_int_equal(store_open(folder, &st, &fault), STATUS_IO);
    CHECK(strstr(fault.text, "Is a directory"), "%s", fault.text);
    assert_int_equal(own_folder_entries(), 1);
}

/* Nobody's rights, because root may write everywhere. */
static void a_read_only_folder_is_refused(void **state)
{
    const char *path = own_path("sub/out.h5");
    const uid_t user = geteuid();
    struct fault fault = { "" };
    struct store *st;
    enum status s;

    (void) state;
    assert_int_equal(mkdir(own_path("sub"), 0555), 0);
    assert_int_equal(chmod(own_path(""), 0755), 0);
    if (user == 0)
        assert_int_equal(seteuid(65534), 0);
    s = store_create(path, "sample", &st, &fault);
    if (user == 0)
        assert_int_equal(seteuid(0), 0);
    assert_int_equal(s, STATUS_IO);
    says(&fault, path, "Permission denied");
}

static void a_full_disk_leaves_the_old_file(void **state)
{
    const char *path = own_path("out.h5");
    struct rlimit old, small;

    (void) state;
    file_write(path, "old", 3);
    signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &old);
    for (rlim_t limit = 0; limit < 20000; limit += 5000) {
        small = (struct rlimit){ limit, old.rlim_max };
        setrlimit(RLIMIT_FSIZE, &small);
        refuses(path, "File too large");
    }
    setrlimit(RLIMIT_FSIZE, &old);
    file_holds(path, "old");
    assert_int_equal(own_folder_entries(), 1);
}

/* The sample, in a file that grows on disk. */
static enum status write_on_disk(const char *path, struct fault *fault)
{
    struct store *st;
    enum status s = store_create_on_disk(path, "sample", &st, fault);

    if (s == STATUS_OK && sample_put(st) == STATUS_OK)
        s = store_commit(st, fault);
    store_free(&st);
    sample_no_handles();
    return s;
}

static void a_file_on_a_full_disk_leaves_the_old_one(void **state)
{
    const char *path = own_path("out.h5");
    struct fault fault = { "" };
    struct rlimit old, small;

    (void) state;
    file_write(path, "old", 3);
    signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &old);
    for (rlim_t limit = 0; limit < 20000; limit += 2500) {
        small = (struct rlimit){ limit, old.rlim_max };
        setrlimit(RLIMIT_FSIZE, &small);
        const enum status s = write_on_disk(path, &fault);
        CHECK(s == STATUS_IO, "%d: %s", (int) limit, status_text(s));
        says(&fault, path, "File too large");
    }
    setrlimit(RLIMIT_FSIZE, &old);
    file_holds(path, "old");
    assert_int_equal(own_folder_entries(), 1);
    assert_int_equal(write_on_disk(path, &fault), STATUS_OK);
    assert_int_equal(own_folder_entries(), 1);
}

static void a_killed_run_leaves_the_old_file(void **state)
{
    const char *path = own_path("out.h5");
    int how;

    (void) state;
    file_write(path, "old", 3);
    const pid_t child = fork();
    if (child == 0) {
        struct store *st;
        struct fault fault;
        if (store_create(path, "sample", &st, &fault) == STATUS_OK &&
            sample_put(st) == STATUS_OK)
            raise(SIGKILL);
        _exit(1);
    }
    assert_int_equal(waitpid(child, &how, 0), child);
    assert_true(WIFSIGNALED(how));
    file_holds(path, "old");
    assert_int_equal(own_folder_entries(), 1);
}

static void what_is_not_committed_is_gone(void **state)
{
    const char *path = own_path("out.h5");
    struct store *st;
    struct fault fault = { "" };

    (void) state;
    assert_int_equal(store_create(path, "sample", &st, &fault), STATUS_OK);
    assert_int_equal(sample_put(st), STATUS_OK);
    store_free(&st);
    assert_null(st);
    sample_no_handles();
    assert_int_equal(own_folder_entries(), 0);
}

static void the_first_failure_sticks_and_is_told_at_the_end(void **state)
{
    const char *path = own_path("out.h5");
    struct store *st;
    struct fault fault = { "" };

    (void) state;
    file_write(path, "old", 3);
    assert_int_equal(store_create(path, "sample", &st, &fault), STATUS_OK);
    assert_int_equal(sample_put(st), STATUS_OK);
    assert_int_equal(store_put_records(st, "/equilibria", &sample_states, NULL),
                     STATUS_IO);
    assert_int_equal(store_put_text(st, "/", "k", "t"), STATUS_IO);
    assert_int_equal(store_commit(st, &fault), STATUS_IO);
    CHECK(strstr(fault.text, "name already exists"), "%s", fault.text);
    store_free(&st);
    sample_no_handles();
    file_holds(path, "old");
}

static void a_link_is_followed_and_an_old_file_replaced(void **state)
{
    const char *path = own_path("out.h5"), *link = own_path("link.h5");
    struct stat about;
    const mode_t mask = umask(027);

    (void) state;
    file_write(path, "old", 3);
    assert_int_equal(symlink("out.h5", link), 0);
    sample_must_write(link);
    umask(mask);
    assert_int_equal(lstat(link, &about), 0);
    assert_true(S_ISLNK(about.st_mode));
    assert_int_equal(lstat(path, &about), 0);
    assert_true(S_ISREG(about.st_mode) && about.st_size > 1000);
    assert_int_equal(about.st_mode & 0777, 0640);
    assert_int_equal(own_folder_entries(), 2);
}

static void a_temporary_file_of_another_is_left_alone(void **state)
{
    char name[64];

    (void) state;
    snprintf(name, sizeof name, ".slipway-%ld-0.tmp", (long) getpid());
    file_write(own_path(name), "mine", 4);
    sample_must_write(own_path("out.h5"));
    file_holds(own_path(name), "mine");
    assert_int_equal(own_folder_entries(), 2);
}

static void any_allocation_may_fail(void **state)
{
    enum status s = STATUS_NO_MEMORY;
    long k = 0;

    (void) state;
    for (; s != STATUS_OK; k++) {
        struct fault fault = { "" };
        fault_alloc_at(k);
        s = sample_write(own_path("out.h5"), &fault);
        const bool failed = fault_alloc_count() > k;
        fault_alloc_at(FAULT_ALLOC_NEVER);
        CHECK(s == (failed ? STATUS_NO_MEMORY : STATUS_OK), "%ld", k);
        assert_int_equal(own_folder_entries(), failed ? 0 : 1);
        CHECK(!failed || strstr(fault.text, "out.h5: out of memory"), "%s",
              fault.text);
    }
    CHECK(k > 50, "only %ld allocations", k);
}

#define TEST(name)                                                             \
    cmocka_unit_test_setup_teardown(name, own_folder_make, own_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(the_same_calls_give_the_same_bytes),
        TEST(a_wrong_place_is_named_with_the_reason),
        TEST(a_read_only_folder_is_refused),
        TEST(a_full_disk_leaves_the_old_file),
        TEST(a_file_on_a_full_disk_leaves_the_old_one),
        TEST(a_killed_run_leaves_the_old_file),
        TEST(what_is_not_committed_is_gone),
        TEST(the_first_failure_sticks_and_is_told_at_the_end),
        TEST(a_link_is_followed_and_an_old_file_replaced),
        TEST(a_temporary_file_of_another_is_left_alone),
        TEST(any_allocation_may_fail),
    };
    H5Eset_auto2(H5E_DEFAULT, NULL, NULL);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
