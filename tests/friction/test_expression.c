/* Formulas as trees: what is folded, where brackets are needed, and how nodes
 * get names. */
#include "expression.h"

#include <string.h>

#include "check.h"

/* Leaves u and w of one tape. */
struct page {
    struct tape tape;
    struct expression u, w, one, two;
    char text[200];
};

static void open_page(struct page *p)
{
    p->tape.nodes = 0;
    p->u = expression_leaf(&p->tape, "u", true);
    p->w = expression_leaf(&p->tape, "w", false);
    p->one = expression_number(1.0);
    p->two = expression_number(2.0);
}

static void says(struct page *p, struct expression e, const char *expected)
{
    assert_ptr_equal(e.tape, &p->tape);
    assert_true(expression_write(&p->tape, e.node, p->text, sizeof p->text));
    assert_string_equal(p->text, expected);
}

static void brackets_stand_where_they_must_and_nowhere_else(void **state)
{
    struct page p;

    (void) state;
    open_page(&p);
    const struct expression sum = expression_sum(p.u, p.w),
                            less = expression_less(p.u, p.w),
                            over = expression_over(p.u, p.w);
    says(&p, expression_times(sum, less), "(u+w)*(u-w)");
    says(&p, expression_less(less, sum), "u-w-(u+w)");
    says(&p, expression_over(over, over), "u/w/(u/w)");
    says(&p, expression_times(over, p.u), "u/w*u");
    says(&p, expression_times(p.u, over), "u*(u/w)");
    says(&p, expression_sum(over, p.two), "u/w+2");
    says(&p, expression_times(expression_number(-2.0), p.u), "(-2)*u");
    says(&p, expression_less(expression_number(0.0), sum), "-(u+w)");
    says(&p, expression_times(p.u, expression_less(expression_number(0), p.w)),
         "u*(-w)");
    says(&p, expression_call("f", (struct expression[]){ sum, p.two, over }, 3),
         "f(u+w,2,u/w)");
}

static void plain_numbers_are_folded(void **state)
{
    struct page p;

    (void) state;
    open_page(&p);
    const struct expression zero = expression_number(0.0);
    says(&p, expression_sum(zero, p.u), "u");
    says(&p, expression_less(p.u, zero), "u");
    says(&p, expression_times(p.one, p.u), "u");
    says(&p, expression_over(p.u, p.one), "u");
    says(&p, expression_times(expression_number(-1.0), p.u), "-u");
    says(&p, expression_sum(p.w, expression_less(zero, p.u)), "w-u");
    assert_null(expression_times(zero, p.u).tape);
    const struct expression four = expression_sum(p.two, p.two);
    assert_null(four.tape);
    assert_true(four.number == 4.0);
    assert_true(expression_over(p.one, p.two).number == 0.5);
    assert_true(expression_less(zero, p.two).number == -2.0);
    says(&p, expression_sum(p.u, expression_number(0.1)),
         "u+0.10000000000000001");
}

static void what_is_there_already_is_not_made_again(void **state)
{
    struct page p;

    (void) state;
    open_page(&p);
    const struct expression a = expression_over(p.u, p.w);
    const size_t before = p.tape.nodes;
    const struct expression b =
        expression_over(expression_leaf(&p.tape, "u", true), p.w);
    assert_int_equal(a.node, b.node);
    assert_int_equal(p.tape.nodes, before);
    assert_int_not_equal(expression_over(p.w, p.u).node, a.node);
}

static void a_named_node_stands_in_others_by_its_name(void **state)
{
    struct page p;

    (void) state;
    open_page(&p);
    const struct expression sum = expression_sum(p.u, p.w),
                            twice = expression_times(p.two, sum);
    says(&p, twice, "2*(u+w)");
    expression_name(sum, "total");
    expression_name(sum, "again");
    expression_name(p.u, "leaf");
    expression_name(p.two, "two");
    says(&p, twice, "2*total");
    says(&p, sum, "u+w");
}

static void uses_are_counted_for_results_only(void **state)
{
    struct page p;

    (void) state;
    open_page(&p);
    const struct expression sum = expression_sum(p.u, p.w),
                            square = expression_times(sum, sum),
                            unused = expression_times(p.u, p.u);
    expression_count(&square, 1);
    assert_int_equal(p.tape.node[square.node].uses, 1);
    assert_int_equal(p.tape.node[sum.node].uses, 2);
    assert_int_equal(p.tape.node[p.u.node].uses, 1);
    assert_int_equal(p.tape.node[unused.node].uses, 0);
    assert_true(p.tape.node[square.node].moves);
    assert_false(p.tape.node[p.w.node].moves);
}

static void a_text_that_does_not_fit_is_refused(void **state)
{
    struct page p;
    char text[4];

    (void) state;
    open_page(&p);
    const struct expression sum = expression_sum(p.u, p.w);
    assert_true(expression_write(&p.tape, sum.node, text, 4));
    assert_false(expression_write(&p.tape, sum.node, text, 3));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(brackets_stand_where_they_must_and_nowhere_else),
        cmocka_unit_test(plain_numbers_are_folded),
        cmocka_unit_test(what_is_there_already_is_not_made_again),
        cmocka_unit_test(a_named_node_stands_in_others_by_its_name),
        cmocka_unit_test(uses_are_counted_for_results_only),
        cmocka_unit_test(a_text_that_does_not_fit_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
