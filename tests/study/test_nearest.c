// SPDX-License-Identifier: GPL-3.0-or-later
#include "check.h"
#include "study/study_impl.h"

#include <string.h>

static void expect(const char *word, const char *candidates[], const char *best)
{
    pdmc_study_nearest nearest = pdmc_study_nearest_to(word);
    for (int i = 0; candidates[i]; i++) pdmc_study_nearest_offer(&nearest, candidates[i]);
    assert_string_equal(nearest.best, best);
}

static void one_slip_of_each_kind_is_recognised(void **state)
{
    (void)state;
    const char *words[] = {"thickness", "height", "width", NULL};
    expect("widht", words, "width");
    expect("wdth", words, "width");
    expect("widthh", words, "width");
    expect("wibth", words, "width");
    expect("idth", words, "width");
}

static void the_nearest_of_several_is_taken(void **state)
{
    (void)state;
    const char *words[] = {"a.to", "crack1.to", "crack2.to", "crack2.from", NULL};
    expect("crack2.form", words, "crack2.from");
    expect("crack3.tp", words, "crack1.to"); // two slips from two of them: the first
}

static void another_word_is_no_slip(void **state)
{
    (void)state;
    const char *words[] = {"width", "to", NULL};
    expect("colour", words, "");
    expect("it", words, ""); // every letter of it
    expect("x", words, "");
}

static void too_long_words_are_left_alone(void **state)
{
    (void)state;
    char word[200];
    memset(word, 'a', sizeof word);
    word[sizeof word - 1] = 0;
    const char *words[] = {word, "aaaa", NULL};
    expect(word, words, "");
    expect("aaab", words, "aaaa");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_slip_of_each_kind_is_recognised),
        cmocka_unit_test(the_nearest_of_several_is_taken),
        cmocka_unit_test(another_word_is_no_slip),
        cmocka_unit_test(too_long_words_are_left_alone),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
