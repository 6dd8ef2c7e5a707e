/* What product_setting writes is read back as the same products. */
#include "product_setting.h"

#include "scenes.h"

#define SETS "law.preset=ruina\nslope.alpha=0.3\n"

static void it_names_them_in_their_order(void **state)
{
    char line[PRODUCT_SETTING];

    (void) state;
    product_setting(1u << PRODUCT_BASINS, line);
    assert_string_equal(line, "products=[basins]");
    product_setting(1u << PRODUCT_KNEES | 1u << PRODUCT_FOLDS, line);
    assert_string_equal(line, "products=[folds, knees]");
    product_setting(0, line);
    assert_string_equal(line, "products=[]");
}

static void check_products(unsigned products)
{
    char line[PRODUCT_SETTING], sets[sizeof SETS + sizeof line];

    product_setting(products, line);
    snprintf(sets, sizeof sets, SETS "%s", line);
    struct scene s = scene_made(NULL, sets);
    assert_int_equal(s.products, products);
    scene_free(&s);
}

static void any_products_are_read_back(void **state)
{
    const unsigned all = (1u << PRODUCTS) - 1;

    uint64_t seed = check_seed();

    (void) state;
    check_products(all);
    for (int i = 0; i < 1000; i++)
        check_products((unsigned) check_uniform(&seed, 1.0, all));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(it_names_them_in_their_order),
        cmocka_unit_test(any_products_are_read_back),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
