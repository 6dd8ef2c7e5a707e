/* Models of XPPAUT: read as a planar system, or refused with line and reason.
 */
#include "xpp_model.h"

#include <dirent.h>
#include <math.h>
#include <string.h>
#include <time.h>

#include "check.h"
#include "equilibria.h"

static struct xpp_model m;
static struct system_equilibria found;
static struct fault why;

static void reads(const char *text)
{
    const enum status s = xpp_model_read(text, "a.ode", &m, &why);

    CHECK(s == STATUS_OK, "%s", why.text);
}

static void refused(const char *text, const char *expected)
{
    const enum status s = xpp_model_read(text, "a.ode", &m, &why);

    CHECK(s == STATUS_BAD_SCENE, "%s is read", text);
    assert_string_equal(why.text, expected);
}

static void statements_come_in_any_order_and_case(void **state)
{
    static const struct system_window w = { { -3, -3 }, { 3, 3 } };

    (void) state;
    reads("# FitzHugh and Nagumo\n"
          "\" {eps=.1} more\n"
          "V' = F(v, A) - w + I_0\n"
          "dw/dt=eps * (v - \\\n"
          "  gamma*w)\n"
          "par a=.25 eps=.05, gamma=1\n"
          "number I_0=0.\n"
          "!b = 1\n"
          "f(x,k) = g(x)*(x-k)\n"
          "g(x)= x*(b - x)\n"
          "init v=.5,W=.25\n"
          "aux k=if(v>1)then(1)else(0)\n"
          "unused=abs(v)+t\n"
          "@ total=100,xplot=w,yplot=V,xlo=-1,xhi=2,ylo=-.5,yhi=1.5\n"
          "set two {a=1}\n"
          "only v,w\n"
          "b v-v'\n"
          "done\n"
          "this is not read\n");
    assert_string_equal(m.system.state[0].name, "v");
    assert_string_equal(m.system.state[1].name, "w");
    assert_int_equal(m.system.parameters, 4);
    assert_string_equal(m.decimal[1], ".05");
    assert_true(m.start[0] == 0.5 && m.start[1] == 0.25);
    assert_true(m.lo[0] == -0.5 && m.hi[0] == 1.5);
    assert_true(m.lo[1] == -1 && m.hi[1] == 2);
    assert_int_equal(system_equilibria_find(&m.system, &w, &found, &why),
                     STATUS_OK);
    assert_true(found.complete && found.count == 1);
    assert_true(fabs((double) found.equilibrium[0].state[0].value) < 1e-30);
}

static void forcing_that_is_off_is_none(void **state)
{
    (void) state;
    reads("s(t)=al*sin(omega*t)\n"
          "x'=y\ny'=-x-k*y+s(t)+f\n"
          "par al=0,omega=2,k=0,f=0\n");
    assert_int_equal(m.system.parameters, 3);
    assert_int_equal(formula_system_find_parameter(&m.system, "al"), -1);
    assert_int_equal(formula_system_find_parameter(&m.system, "t"), -1);
    assert_true(formula_system_find_parameter(&m.system, "k") >= 0);
    refused("s(t)=al*sin(omega*t)\nx'=y\ny'=-x-k*y+s(t)\n"
            "par al=0.1,omega=2,k=0\n",
            "a.ode:3: depends on t: the system is not autonomous");
    refused("x'=y\ny'=-x-k*cos(t)\npar k=1,a=0\n",
            "a.ode:2: depends on t: the system is not autonomous");
}

static int node_of(const char *text)
{
    int node = -1;

    CHECK(formula_parse(&m.system.graph, text, &node, &why) == STATUS_OK, "%s",
          why.text);
    return node;
}

static void what_xppaut_writes_otherwise_means_the_same(void **state)
{
    (void) state;
    reads("x'=x**3*log(y) + log10(y)\ny'=-y^2 + 3*F(-x)\nf(x)=x-1\n");
    assert_int_equal(m.system.rate[0], node_of("x^3*ln(y) + log10(y)"));
    assert_int_equal(m.system.rate[1], node_of("-(y^2) + 3*(-x - 1)"));
    reads("x'=z\r\ny'=1-w*y\r\nz=w+2\r\nw=x\r\nd\r\n");
    assert_int_equal(m.system.rate[0], node_of("x + 2"));
}

static void a_folded_variable_is_an_angle(void **state)
{
    (void) state;
    reads("q'=sin(p)\np'=-sin(q)\n@ fold=p,fold=q,tor_per=6.283\n");
    assert_int_equal(m.system.state[0].chart, CHART_ANGLE);
    assert_int_equal(m.system.state[1].chart, CHART_ANGLE);
    reads("q'=p\np'=-sin(q/2)\n@ fold=q\n");
    assert_int_equal(m.system.state[0].chart, CHART_REAL);
}

static void what_is_no_planar_autonomous_flow_is_refused(void **state)
{
    (void) state;
    refused("x'=y\n\ny'=z\nz'=x\n",
            "a.ode:4: z is the third variable, expected two");
    refused("x'=x\n", "a.ode: 1 variable, expected two");
    refused("x'=y\ny'=sin(t)\n",
            "a.ode:2: depends on t: the system is not autonomous");
    refused("x'=y\ns(u)=sin(u)\ny'=a\na=s(t)\n",
            "a.ode:4: depends on t: the system is not autonomous");
    refused("x'=y\ns(t)=a*sin(t)\npar a=1\ny'=s(t)\n",
            "a.ode:4: depends on t: the system is not autonomous");
    refused("x'=y\ny(t)=int{exp(-t)#x}\n",
            "a.ode:2: an integral equation, the system is not planar");
    refused("x'=y\ny'=-delay(x,2)\n",
            "a.ode:2: delay: the system is not planar");
    refused("x'=y\ny'=heav(x)\n", "a.ode:2: heav is not analytic");
    refused("x'=y\ny'=if(x>1)then(1)else(0)\n", "a.ode:2: if is not analytic");
    refused("x'=y\ny'=abs(x)\n",
            "a.ode:2: column 1 of the formula: abs is not analytic");
    refused("x'=y\ny'=x\nglobal 1 x {x=0}\n",
            "a.ode:3: global: jumps, the system is no flow");
    refused("x'=y\ny'=x\nwiener w\n",
            "a.ode:3: wiener: noise, the system is not deterministic");
    refused("x(t+1)=y\ny(t+1)=x\n", "a.ode:1: a map, no flow");
    refused("x'=y\ny'=x\n@ meth=discrete\n", "a.ode: a map, no flow");
    refused("u[0..9]'=y\n",
            "a.ode:1: an array or a row of a table, the system is not planar");
    refused("x'=y\n0=x+y\n", "a.ode:2: 0 = : an algebraic equation, the system "
                             "is not planar");
}

static void what_is_wrong_is_blamed_in_its_line(void **state)
{
    (void) state;
    refused("x'=y\ny'=x+zz\n",
            "a.ode:2: column 3 of the formula: unknown name zz");
    refused("x'=y\ny'=f(x,y)\nf(a)=a\n",
            "a.ode:2: f is called without its 1 arguments");
    refused("x'=y\ny'=f(x)\nf(a)=f(a)\n",
            "a.ode:2: functions call one another more than 24 deep");
    refused("x'=y\ny'=a\na=b\nb=a\n",
            "a.ode:3: a needs itself, or names 24 deep");
    refused("x'=y\ny'=x\npar k=one\n",
            "a.ode:3: column 1 of the formula: 'o', expected a decimal");
    refused("x'=y\ny'=x\npar k\n", "a.ode:3: NAME=NUMBER was expected");
    refused("x'=y\nx'=x\n", "a.ode:2: state x: there is one of this name");
    refused("hello\n", "a.ode:1: no statement that is known");
    refused("", "a.ode: 0 variables, expected two");
}

static void the_scene_says_the_same(void **state)
{
    (void) state;
    reads("x'=f(y)\ny'=-x + k*z\npar k=.5\nz=y^2\nf(u)=2*u\ninit x=1\n");
    char *text = xpp_model_scene(&m, "a \"model\"");
    assert_string_equal(text, "title: \"a model\"\n"
                              "system:\n"
                              "  state: {x: real, y: real}\n"
                              "  parameters:\n"
                              "    k: .5\n"
                              "  define:\n"
                              "    z: \"y^2\"\n"
                              "  rates:\n"
                              "    x: \"(2*(y))\"\n"
                              "    y: \"-x + k*z\"\n"
                              "window: {x: [-3, 5], y: [-2, 2]}\n");
    free(text);
}

/* ---- what is installed --------------------------------------------------- */

static const char *const folders[] = { "/usr/share/doc/xppaut/examples/ode",
                                       "/usr/share/doc/xppaut/html/odes",
                                       NULL };

static char *file_text(const char *path)
{
    FILE *file = fopen(path, "rb");
    char *text = calloc(1, XPP_SIZE + 2);

    assert_non_null(file);
    assert_non_null(text);
    if (fread(text, 1, XPP_SIZE + 1, file) == 0)
        text[0] = '\0';
    fclose(file);
    return text;
}

struct counts {
    int files, analysed, complete, equilibria;
};

/* Reads one and finds its equilibria where XPPAUT looks. */
static void analyse(const char *path, const char *name, struct counts *c)
{
    char *text = file_text(path);
    const clock_t begin = clock();
    enum status s = xpp_model_read(text, name, &m, &why);

    c->files++;
    CHECK(s == STATUS_OK || (s == STATUS_BAD_SCENE && why.text[0]), "%s: %d",
          path, (int) s);
    if (s == STATUS_OK) {
        const struct system_window w = { { m.lo[0], m.lo[1] },
                                         { m.hi[0], m.hi[1] } };
        s = system_equilibria_find(&m.system, &w, &found, &why);
        CHECK(s == STATUS_OK, "%s: %s", path, why.text);
        c->analysed++;
        c->complete += found.complete;
        c->equilibria += found.count;
        print_message("%s: %d equilibria, %s\n", name, found.count,
                      found.complete ? "complete" : "undecided boxes");
    } else {
        print_message("%s\n", why.text);
    }
    const double seconds = (double) (clock() - begin) / CLOCKS_PER_SEC;
    CHECK(seconds < 10, "%s: %g s", path, seconds);
    free(text);
}

static void every_installed_model_is_analysed_or_refused(void **state)
{
    struct counts c = { .files = 0 };

    (void) state;
    for (int i = 0; folders[i]; i++) {
        DIR *folder = opendir(folders[i]);
        for (struct dirent *e; folder && (e = readdir(folder)) != NULL;) {
            const size_t size = strlen(e->d_name);
            char path[400];
            if (size < 4 || strcmp(e->d_name + size - 4, ".ode") != 0)
                continue;
            snprintf(path, sizeof path, "%s/%s", folders[i], e->d_name);
            analyse(path, e->d_name, &c);
        }
        if (folder)
            closedir(folder);
    }
    print_message("%d files, %d analysed (%d proved complete, %d equilibria)\n",
                  c.files, c.analysed, c.complete, c.equilibria);
    if (c.files == 0)
        print_message("xppaut's examples are not installed\n");
    assert_true(c.files == 0 || c.analysed > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(forcing_that_is_off_is_none),
        cmocka_unit_test(statements_come_in_any_order_and_case),
        cmocka_unit_test(what_xppaut_writes_otherwise_means_the_same),
        cmocka_unit_test(a_folded_variable_is_an_angle),
        cmocka_unit_test(what_is_no_planar_autonomous_flow_is_refused),
        cmocka_unit_test(what_is_wrong_is_blamed_in_its_line),
        cmocka_unit_test(the_scene_says_the_same),
        cmocka_unit_test(every_installed_model_is_analysed_or_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
