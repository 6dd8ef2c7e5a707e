/* States that random ones (test_cell_bars.c) found, whose largest friction had
 * bars that were far wider than its error; in 113 bits. */
#include "cells_of.h"
#include "fast_cells.h"
#include "found.h"
#include "study.h"

/* It rises to the curve's, which falls, or to a peak that follows at once, or
 * is largest ahead on it, or where the orbit comes to it. */
static const struct {
    struct found slope;
    long double tan_alpha;
    struct vec2 z;
    double mu_peak, bar;
} is[] = {
    { { FRICTION_ASINH, THETA_LN_C_PSI, PSI_SS_SPINODAL, TIMESCALE_SPINODAL,
        KINETICS_SINH, 0.369, 0.038280176998547417, 0.0489,
        0.00021766313500024798, 30.498928794857644, 1.5762045826358809e-06,
        1e-6, 0.0, 1e-4 },
      0.306511892357508314603L,
      { 3.9476680251625815, -10.456528698293031 },
      0.30649504480925599,
      1e-10 },
    { { FRICTION_LOG, THETA_LN_C_PSI, PSI_SS_SPINODAL, TIMESCALE_SPINODAL,
        KINETICS_LINEAR, 0.369, 0.026727496891001169, 0.0489,
        0.004914795141027363, 57.8201034493405, 1.8764367438752149e-05, 1e-6,
        0.0, 1e-7 },
      0.341931512504706269865L,
      { -2.5839390992797773, -0.27204086453944742 },
      0.34193151698846852,
      1e-10 },
    { { FRICTION_ASINH, THETA_LN_C_1PR_PSI, PSI_SS_SPINODAL_UNIT,
        TIMESCALE_SLIP, KINETICS_SINH, 0.29539445753909022,
        0.019520628383186876, 0.0084694474375038593, 0.057110552131546838,
        2.2670776193931097, 3.7577573744962018e-05, 3.042651991402666e-07, 0.0,
        1e-5 },
      0.373258371261809623876L,
      { 1.1418133528531076, -1.4748193817846884 },
      0.37325836697248399,
      1e-14 },
    { { FRICTION_ASINH, THETA_LN_PSI, PSI_SS_SPINODAL_UNIT, TIMESCALE_SPINODAL,
        KINETICS_SINH, 0.2513734383221603, 0.011134255165788335,
        0.0024297119454379222, 3.9036637636214845e-06, 654.25814474846084,
        7.4598131157905303e-06, 3.1300398219982368e-08, 0.0, 1e-5 },
      0.229437763111911418717L,
      { -3.6408491174635262, -6.830000788409829 },
      0.22943776311338379,
      1e-12 },
};

static void the_largest_friction_is_as_good_as_its_own_place(void **state)
{
    struct fault why;

    (void) state;
    for (size_t i = 0; i < sizeof is / sizeof *is; i++) {
        static struct slope s;
        struct fast_cells fast;
        struct cell c;
        found_scene(&is[i].slope, steady_only, &s.scene);
        s.scene.tan_alpha = is[i].tan_alpha;
        s.scene.alpha = (double) atanl(is[i].tan_alpha);
        assert_int_equal(study_run(&s.study, &s.scene, NULL, &why), 0);
        assert_int_equal(fast_cells_init(&fast, &s.study.slider, NULL), 0);
        assert_int_equal(fast_cells_find(&fast, &is[i].z, 1, is[i].slope.rtol,
                                         ALL, NULL, &c, NULL),
                         0);
        CHECK(fabs(c.mu_peak - is[i].mu_peak) <= c.mu_peak_error + 1e-16,
              "%zu: %.17g +- %g", i, c.mu_peak, c.mu_peak_error);
        CHECK(c.mu_peak_error < is[i].bar, "%zu: %g", i, c.mu_peak_error);
        fast_cells_free(&fast);
        slope_free(&s);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_largest_friction_is_as_good_as_its_own_place),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
