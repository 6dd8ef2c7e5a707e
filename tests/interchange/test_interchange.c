/* Files for other programs: comments that stay comments, lines that they can
 * read, and C that computes the field of every law. */
#include "interchange.h"

#include <dlfcn.h>
#include <math.h>
#include <string.h>
#include <unistd.h>

#include "auto07p.h"
#include "check.h"
#include "own_folder.h"
#include "xppaut.h"

enum { SYSTEMS_MAX = 32 };

/* A block at v = e, with branches made up. */
static void open_block(struct block *b, const struct law *law)
{
    struct material m = material_bristol_board();

    m.V_c = 1e3;
    block_init(b, law, &m, tanl(0.34L));
    block_anchor(b, 1.0L, false);
}

static struct interchange of_block(const struct block *b, const char *remarks)
{
    return (struct interchange){
        .block = b,
        .name = "slope",
        .remarks = remarks,
        .branch = { { "upper", { 1.5, -1.0 }, 12.0 },
                    { "lower", { 0.5, -1.0 }, 30.0 } },
        .branches = 2,
        .start = { 1.1, -1.0 },
        .time = 20.0,
        .steady = { 0.1, -0.1 },
        .toward = -1.0,
        .alpha = { 0.25, 0.45 },
    };
}

/* Presets in both forms. */
static size_t every_law(struct law law[SYSTEMS_MAX])
{
    const struct law *preset;
    size_t n = 0;

    for (size_t i = 0; (preset = law_preset_at(i)) != NULL; i++)
        for (int form = 0; form < FRICTION_FORMS; form++) {
            assert_true(n < SYSTEMS_MAX);
            law[n] = *preset;
            law[n++].form = (enum friction_form) form;
        }
    return n;
}

/* ---- remarks ------------------------------------------------------------- */

static const char hostile[] =
    "title: a */ int main(void) { } /* b\nback \\\n#include /etc/passwd\n"
    "\n\x01\x7f\xc3\xa9 **/ /\\/ *\\/\n"
    "a line that is rather longer than any line needs to be, so that it goes "
    "into two, and then on and on and on, and on, and on, and on";

static char *remark(const char *before, size_t *size)
{
    char *text = NULL;
    FILE *out = open_memstream(&text, size);

    assert_non_null(out);
    interchange_remark(out, before, hostile);
    assert_int_equal(fclose(out), 0);
    return text;
}

static void remarks_stay_remarks(void **state)
{
    size_t size = 0, lines = 0;
    char *text = remark("# ", &size);

    (void) state;
    assert_null(strstr(text, "*/"));
    assert_null(strchr(text, '\\'));
    for (const char *line = text; *line; line += strcspn(line, "\n") + 1) {
        assert_int_equal(strncmp(line, "# ", 2), 0);
        assert_true(strcspn(line, "\n") <= 120);
        lines++;
    }
    for (size_t i = 0; i < size; i++)
        assert_true(text[i] == '\n' || (text[i] >= ' ' && text[i] <= '~'));
    assert_int_equal(lines, 7);
    assert_non_null(strstr(text, "# #include /etc/passwd\n"));
    free(text);
}

/* ---- C ------------------------------------------------------------------- */

static const char f2c_types[] =
    "typedef int integer;\ntypedef double doublereal;\n";

/* NUMBER.c, with functions of its own names. */
static void write_system(const struct law *law, size_t number)
{
    char name[32];
    struct block b;

    open_block(&b, law);
    const struct interchange x = of_block(&b, hostile);
    snprintf(name, sizeof name, "%zu.c", number);
    FILE *out = fopen(own_path(name), "w");
    assert_non_null(out);
    static const char *const own[] = { "func", "stpnt", "bcnd",
                                       "icnd", "fopt",  "pvls" };
    for (size_t i = 0; i < sizeof own / sizeof *own; i++)
        fprintf(out, "#define %s %s_%zu\n", own[i], own[i], number);
    auto07p_write_equations(out, &x);
    assert_int_equal(fclose(out), 0);
}

static void *compile(void)
{
    char command[1024];

    file_write(own_path("auto_f2c.h"), f2c_types, sizeof f2c_types - 1);
    snprintf(command, sizeof command,
             "cd '%s' && ${CC:-cc} -std=gnu17 -O1 -Wall -Werror "
             "-ffp-contract=off -fPIC -shared -I. -o all.so *.c -lm",
             own_path(""));
    assert_int_equal(system(command), 0);
    return dlopen(own_path("all.so"), RTLD_NOW);
}

typedef int func_function(int ndim, const double *u, const int *icp,
                          const double *par, int ijac, double *f, double *dfdu,
                          double *dfdp);
typedef int stpnt_function(int ndim, double t, double *u, double *par);

/* POSIX: dlsym's pointer is a function's. */
static void *symbol(void *all, const char *name, size_t number)
{
    char text[32];

    snprintf(text, sizeof text, "%s_%zu", name, number);
    void *found = dlsym(all, text);
    CHECK(found != NULL, "no function %s", text);
    return found;
}

static void check_near(const char *what, double found, double expected,
                       const struct law *law)
{
    CHECK(fabs(found - expected) <= 1e-11 * fabs(expected),
          "%s of %s (%s): %.17g, expected %.17g", what, law->preset,
          friction_form_names[law->form], found, expected);
}

static void check_system(void *all, size_t number, const struct law *law)
{
    uint64_t seed = check_seed() + number;
    func_function *func;
    stpnt_function *stpnt;
    double par[36], at[2], f[2];
    struct block b;

    *(void **) &func = symbol(all, "func", number);
    *(void **) &stpnt = symbol(all, "stpnt", number);
    open_block(&b, law);
    assert_int_equal(stpnt(2, 0.0, at, par), 0);
    assert_true(at[0] == 0.1 && at[1] == -0.1);
    for (int i = 0; i < 50; i++) {
        const struct vec2 z = { check_uniform(&seed, -3.0, 3.0),
                                check_uniform(&seed, -2.0, 2.0) };
        const double u[2] = { b.at.x0 + z.x, b.at.y0 + z.y };
        struct planar_field exact;
        tape_field(&b.plane, z, &exact);
        assert_int_equal(func(2, u, NULL, par, 0, f, NULL, NULL), 0);
        const double scale = exp(exact.log_scale);
        check_near("d ln v/dt", f[0], exact.direction.x * scale, law);
        check_near("dy/dt", f[1], exact.direction.y * scale, law);
    }
}

static void equations_in_c_are_the_field_of_every_law(void **state)
{
    struct law law[SYSTEMS_MAX];
    const size_t n = every_law(law);

    (void) state;
    assert_true(n >= 16);
    for (size_t i = 0; i < n; i++)
        write_system(&law[i], i);
    void *all = compile();
    assert_non_null(all);
    for (size_t i = 0; i < n; i++)
        check_system(all, i, &law[i]);
    assert_int_equal(dlclose(all), 0);
}

/* ---- files --------------------------------------------------------------- */

/* All that one of the writers says; owned by the caller. */
static char *written(const struct interchange *x,
                     void (*write)(FILE *, const struct interchange *))
{
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);

    assert_non_null(out);
    write(out, x);
    assert_int_equal(fclose(out), 0);
    return text;
}

static void write_time(FILE *out, const struct interchange *x)
{
    xppaut_write(out, x, XPPAUT_TIME);
}

static void write_arclength(FILE *out, const struct interchange *x)
{
    xppaut_write(out, x, XPPAUT_ARCLENGTH);
}

/* Lines of less than 1000 letters, no backslash, `done` at the end. */
static void check_ode(const char *text)
{
    const size_t size = strlen(text);

    for (const char *line = text; *line; line += strcspn(line, "\n") + 1)
        assert_true(strcspn(line, "\n") < 1000);
    assert_null(strchr(text, '\\'));
    assert_string_equal(text + size - 6, "\ndone\n");
}

static void xppaut_gets_a_set_for_each_branch(void **state)
{
    struct law law[SYSTEMS_MAX];
    struct block b;
    const size_t n = every_law(law);

    (void) state;
    for (size_t i = 0; i < n; i++) {
        open_block(&b, &law[i]);
        const struct interchange x = of_block(&b, hostile);
        char *arc = written(&x, write_arclength),
             *time = written(&x, write_time);
        check_ode(arc);
        check_ode(time);
        assert_non_null(strstr(arc, "\nset upper {lnv=1.5,"));
        assert_non_null(strstr(arc, "=-1,total=30}\n"));
        assert_null(strstr(time, "\nset "));
        assert_non_null(strstr(time, "\nlnv'=fx*speed\n"));
        assert_non_null(strstr(arc, "\npar alpha=0.34\n"));
        free(arc);
        free(time);
    }
}

static void constants_name_parameters_in_the_order_of_par(void **state)
{
    const struct law *law = law_preset_find("spinodal_gen");
    struct block b;

    (void) state;
    open_block(&b, law);
    const struct interchange x = of_block(&b, hostile);
    char *c = written(&x, auto07p_write_equations),
         *steady = written(&x, auto07p_write_steady),
         *folds = written(&x, auto07p_write_folds),
         *script = written(&x, auto07p_write_script);
    const char *names = "parnames = {1: 'alpha', 2: 'mu_star', 3: 'a', 4: 'b', "
                        "5: 'c', 6: 'R', 7: 'eps2', 8: 'lnv0'}\n";
    assert_non_null(strstr(steady, names));
    assert_non_null(strstr(folds, names));
    assert_non_null(strstr(c, " alpha = par[0];\n"));
    assert_non_null(strstr(c, " lnv0 = par[7];\n"));
    assert_non_null(strstr(steady, "DS = -0.01,"));
    assert_non_null(strstr(steady, "{'alpha': [0.25, 0.45]}"));
    assert_non_null(strstr(folds, "IRS = 'LP1', ISW = 2,"));
    assert_non_null(strstr(folds, "{'c': [0.0005, 100]}"));
    free(c);
    free(steady);
    assert_non_null(strstr(script, "\nsteady = run('slope')\n"));
    assert_null(strstr(script, "\nfolds = "));
    free(folds);
    free(script);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(remarks_stay_remarks),
        cmocka_unit_test_setup_teardown(
            equations_in_c_are_the_field_of_every_law, own_folder_make,
            own_folder_remove),
        cmocka_unit_test(xppaut_gets_a_set_for_each_branch),
        cmocka_unit_test(constants_name_parameters_in_the_order_of_par),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
