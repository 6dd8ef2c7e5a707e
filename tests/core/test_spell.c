/* The word that was meant. */
#include "spell.h"

#include <string.h>

#include "check.h"

static void distance_is(const char *a, const char *b, size_t wanted)
{
    CHECK(spell_distance(a, b) == wanted, "%s, %s: %zu", a, b,
          spell_distance(a, b));
    CHECK(spell_distance(b, a) == wanted, "%s, %s: %zu", b, a,
          spell_distance(b, a));
}

static void distances_count_slips(void **state)
{
    (void) state;
    distance_is("", "", 0);
    distance_is("", "abc", 3);
    distance_is("alpha", "alpha", 0);
    distance_is("alpha", "ALPHA", 0);
    distance_is("alpha", "alpa", 1);   /* left out */
    distance_is("alpha", "alphha", 1); /* put in */
    distance_is("alpha", "alpja", 1);  /* changed */
    distance_is("alpha", "alpah", 1);  /* swapped */
    distance_is("alpha", "laphA", 1);
    distance_is("kitten", "sitting", 3);
    distance_is("ca", "abc", 3); /* no letter is touched twice */
}

static void distances_beyond_40_letters_are_of_the_first_40(void **state)
{
    char a[60], b[60];

    (void) state;
    memset(a, 'x', sizeof a);
    a[59] = '\0';
    memcpy(b, a, sizeof a);
    b[40] = 'y';
    distance_is(a, b, 0);
    b[39] = 'y';
    distance_is(a, b, 1);
}

static const char *nearest(const char *word)
{
    static const char *const known[] = {
        "alpha", "alpha_deg", "tan_alpha",     "log", "manifolds",
        "si",    "dieterich", "dieterich_gen", NULL
    };

    return spell_nearest(word, known);
}

static void the_nearest_word_is_offered(void **state)
{
    (void) state;
    assert_string_equal(nearest("alpah"), "alpha");
    assert_string_equal(nearest("Alpha"), "alpha");
    assert_string_equal(nearest("alpha_dge"), "alpha_deg");
    assert_string_equal(nearest("tanalpha"), "tan_alpha");
    assert_string_equal(nearest("manifold"), "manifolds");
    assert_string_equal(nearest("dietrich"), "dieterich");
    assert_string_equal(nearest("dietrich_gen"), "dieterich_gen");
    assert_string_equal(nearest("SI"), "si");
}

static void of_equally_near_words_the_first_is_offered(void **state)
{
    static const char *const known[] = { "abcd", "abce", NULL };

    (void) state;
    assert_string_equal(spell_nearest("abcx", known), "abcd");
}

static void nothing_is_offered_where_nothing_is_near(void **state)
{
    static const char *const none[] = { NULL };

    (void) state;
    assert_null(nearest(""));
    assert_null(nearest("q"));
    assert_null(nearest("ss"));
    assert_null(nearest("beta"));
    assert_null(nearest("granite"));
    assert_null(spell_nearest("alpha", none));
}

/* Were the limit that of the whole word, all would be near. */
static void nothing_is_near_to_an_endless_word(void **state)
{
    char word[2000];

    (void) state;
    memset(word, 'a', sizeof word);
    word[sizeof word - 1] = '\0';
    assert_null(nearest(word));
    memcpy(word, "manifolds", 9);
    assert_null(nearest(word));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(distances_count_slips),
        cmocka_unit_test(distances_beyond_40_letters_are_of_the_first_40),
        cmocka_unit_test(the_nearest_word_is_offered),
        cmocka_unit_test(of_equally_near_words_the_first_is_offered),
        cmocka_unit_test(nothing_is_offered_where_nothing_is_near),
        cmocka_unit_test(nothing_is_near_to_an_endless_word),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
