/* What a quantity is: a value with a finite bar, or a reason (record.h). */
#include "record.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>

#include "check.h"

static const double odd[] = { INFINITY, -INFINITY, NAN };

static bool is_missing(const struct quantity *q)
{
    return !quantity_exists(q) && isnan(q->value) && isnan(q->error) &&
           isnan(q->conditioning) && q->reason[0] != '\0';
}

static void a_number_without_a_finite_bar_is_missing(void **state)
{
    (void) state;
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) {
            const struct quantity q = quantity_of(1.0, odd[i]),
                                  r = quantity_of(odd[i], 1.0),
                                  both = quantity_of(odd[i], odd[k]);
            assert_true(is_missing(&q) && is_missing(&r) && is_missing(&both));
        }
    const struct quantity widest = quantity_of(-DBL_MAX, DBL_MAX);
    assert_true(quantity_exists(&widest) && widest.value == -DBL_MAX &&
                widest.error == DBL_MAX);
}

static void a_bar_that_grew_is_settled(void **state)
{
    struct quantity q = quantity_of(1.0, 0.5), none = quantity_none("why");

    (void) state;
    q.conditioning = 2.0;
    q.error += 1.0;
    quantity_settle(&q);
    assert_true(q.value == 1.0 && q.error == 1.5 && q.conditioning == 2.0);
    q.error *= (double) INFINITY;
    quantity_settle(&q);
    assert_true(is_missing(&q));
    none.error += 1.0;
    quantity_settle(&none);
    assert_string_equal(none.reason, "why");
}

struct row {
    double real;
    struct quantity first;
    int8_t code;
    struct quantity second;
};

static void records_are_settled_number_by_number(void **state)
{
    static const struct record_field fields[] = {
        { .name = "real",
          .unit = "1",
          .text = "",
          .offset = offsetof(struct row, real),
          .kind = RECORD_REAL },
        { .name = "first",
          .unit = "1",
          .text = "",
          .offset = offsetof(struct row, first),
          .kind = RECORD_QUANTITY },
        { .name = "code",
          .unit = "1",
          .text = "",
          .offset = offsetof(struct row, code),
          .kind = RECORD_CODE },
        { .name = "second",
          .unit = "1",
          .text = "",
          .offset = offsetof(struct row, second),
          .kind = RECORD_QUANTITY },
    };
    static const struct record_type type = { "row", "", fields, 4,
                                             sizeof(struct row) };
    struct row row[3];

    (void) state;
    for (int i = 0; i < 3; i++)
        row[i] = (struct row){ (double) INFINITY, quantity_of(i, 1.0), 7,
                               quantity_of(-i, 2.0) };
    row[1].first.error = (double) INFINITY;
    row[2].second.value = (double) NAN;
    record_settle(&type, row, 3);
    for (int i = 0; i < 3; i++) {
        assert_true(isinf(row[i].real) && row[i].code == 7);
        assert_int_equal(quantity_exists(&row[i].first), i != 1);
        assert_int_equal(quantity_exists(&row[i].second), i != 2);
    }
    assert_true(row[0].second.error == 2.0 && row[2].first.value == 2.0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_number_without_a_finite_bar_is_missing),
        cmocka_unit_test(a_bar_that_grew_is_settled),
        cmocka_unit_test(records_are_settled_number_by_number),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
