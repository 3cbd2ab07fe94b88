// SPDX-License-Identifier: GPL-3.0-or-later

/// Files: those that are not there, those that include others, and those that end too early.

#include "study/folder.h"

// libconfig 1.5 itself loses a text that stands before a syntax error.
const char *__lsan_default_suppressions(void);
const char *__lsan_default_suppressions(void)
{
    return "leak:strbuf_append\n";
}

static const char rest[] = "material = { youngs_modulus = 2.0; fracture_energy = 0.5; };\n"
                           "supports = ( { side = \"left\"; x = 0.1; } );\n";

static void expect_refusal(const char *text, const char *message)
{
    pdmc_study study;
    CHECK_STATUS(read_text(text, &study), PDMC_ERR_CONFIG);
    assert_string_equal(pdmc_last_error(), message);
}

static void files_that_cannot_be_read(void **state)
{
    (void)state;
    pdmc_study study;
    assert_int_equal(mkdir("folder", 0700), 0);
    CHECK_STATUS(pdmc_study_read("nothing.cfg", &study), PDMC_ERR_NO_INPUT);
    assert_string_equal(pdmc_last_error(), "nothing.cfg: No such file or directory");
    CHECK_STATUS(pdmc_study_read("folder", &study), PDMC_ERR_NO_INPUT);
    assert_string_equal(pdmc_last_error(), "folder: Is a directory");
    write_text("secret.cfg", rest);
    assert_int_equal(chmod("secret.cfg", 0), 0);
    if (access("secret.cfg", R_OK) == 0) return; // root reads everything
    CHECK_STATUS(pdmc_study_read("secret.cfg", &study), PDMC_ERR_NO_INPUT);
    assert_string_equal(pdmc_last_error(), "secret.cfg: Permission denied");
}

static void files_that_are_no_study(void **state)
{
    (void)state;
    pdmc_study study;
    write_bytes("study.cfg", "a = 1;\0 b = 2;", 14);
    CHECK_STATUS(pdmc_study_read("study.cfg", &study), PDMC_ERR_CONFIG);
    assert_string_equal(pdmc_last_error(), "study.cfg: has a zero byte in it, not a study file");
    write_bytes("study.cfg", "\x89HDF\r\n\x1a\n\0", 9);
    CHECK_STATUS(pdmc_study_read("study.cfg", &study), PDMC_ERR_CONFIG);
    assert_string_equal(pdmc_last_error(),
                        "study.cfg: an HDF5 file, not a study file; pdmc show prints the results in one");
    char *blanks = malloc((16 << 20) + 1);
    assert_non_null(blanks);
    memset(blanks, ' ', (16 << 20) + 1);
    write_bytes("study.cfg", blanks, (16 << 20) + 1);
    free(blanks);
    CHECK_STATUS(pdmc_study_read("study.cfg", &study), PDMC_ERR_CONFIG);
    assert_string_equal(pdmc_last_error(), "study.cfg: larger than 16 MiB, not a study file");
    expect_refusal("", "study.cfg: plate.width: is missing, must be a real > 0");
}

static void syntax(void **state)
{
    (void)state;
    expect_refusal("seed = 1;\nplate = { width = = 1; };\n", "study.cfg:2: syntax error");
    expect_refusal("seed = 1;\nplate = { width = 1;\n", "study.cfg:2: syntax error");
    expect_refusal("seed = nan;\n", "study.cfg:1: syntax error");
    expect_refusal("seed = 1;\n\nseed = 2;\n", "study.cfg:3: duplicate setting name");
    expect_refusal("a = [1, 2.0];",
                   "study.cfg:1: mismatched element type in array: the elements must be alike, all with a "
                   "decimal point or all without");
    expect_refusal("\nseed = 9223372036854775808;",
                   "study.cfg:2: an integer beyond 64 bits; write a real with a decimal point");
}

static void what_is_never_closed(void **state)
{
    (void)state;
    expect_refusal("seed = 1;\n/* a\n* b\n", "study.cfg:2: the comment that begins here is not closed, */ is missing");
    expect_refusal("seed = 1;\n\ntitle = \"a \\\" b\n;\n",
                   "study.cfg:3: the text that begins here is not closed, \" is missing");
    expect_refusal("@include \"x\n", "study.cfg:1: @include: the closing \" is missing");
}

static void comments_and_texts_keep_the_lines(void **state)
{
    (void)state;
    expect_refusal("# \"1\n// /* 2\n/* \"3\n4 */ title = \"a # b\"\n\"5 // \\\" c /* 6\"; seed = -1;",
                   "study.cfg:5: seed: -1 is not allowed, must be >= 0");
    expect_refusal("title = \"a\nb\";",
                   "study.cfg:1: title: \"a?b\" is not allowed, must be a text, not empty and without "
                   "control characters");
    expect_refusal("seed/**/=/* \r\n */-1;\r\n", "study.cfg:1: seed: -1 is not allowed, must be >= 0");
}

static void a_comment_separates(void **state)
{
    (void)state;
    expect_refusal("se/**/ed = 1;", "study.cfg:1: syntax error"); // no seed
}

static void texts_are_left_as_they_are(void **state)
{
    (void)state;
    char text[512];
    pdmc_study study;
    snprintf(text, sizeof text,
             "title = \"5000000000 # a /* b */ @include \\\"c\\\" // \\x41 \"\n  \"next1\";\n"
             "plate = { width = 6.0; height = 4.0; };\n%s",
             rest);
    CHECK_OK(read_text(text, &study));
    assert_string_equal(study.problem.title, "5000000000 # a /* b */ @include \"c\" // A next1");
    pdmc_study_clear(&study);
}

static void includes_are_relative_to_the_including_file(void **state)
{
    (void)state;
    char path[256];
    pdmc_study study;
    assert_int_equal(mkdir("parts", 0700), 0);
    write_text("parts/plate.cfg", "plate = {\n@include \"size.cfg\"\n};\nsampling = { samples = 7; };");
    write_text("parts/size.cfg", "width = 6.0;\n  height = 4.0;"); // no newline at its end
    const char *text =
        "  @include \"parts/plate.cfg\" seed = 3;\nmaterial = { youngs_modulus = 2; fracture_energy = 1; };\n"
        "loads = ( { side = \"left\"; traction = [1, 0]; }, { side = \"right\"; traction = [-1, 0]; } );\n";
    CHECK_OK(read_text(text, &study));
    CHECK_NEAR(study.problem.plate.height, 4.0, 0.0);
    assert_int_equal(study.problem.sampling.samples, 7);
    assert_true(study.problem.sampling.seed == 3);
    assert_string_equal(study.input, text);
    pdmc_study_clear(&study);
    snprintf(path, sizeof path, "%s/study.cfg", (const char *)*state);
    assert_int_equal(chdir("/"), 0); // from anywhere
    CHECK_OK(pdmc_study_read(path, &study));
    assert_int_equal(chdir(*state), 0);
    pdmc_study_clear(&study);
}

static void errors_name_the_included_file(void **state)
{
    (void)state;
    assert_int_equal(mkdir("inner", 0700), 0);
    const char *text = "seed = 1;\n@include \"inner/a.cfg\"\nseeds = 2;\n";
    write_text("inner/a.cfg", "title = \"a\";\n@include \"b.cfg\"\n");
    write_text("inner/b.cfg", "sampling = { samples = 0;\n};");
    expect_refusal(text, "study.cfg:3: seeds: unknown setting, did you mean \"seed\"?");
    write_text("inner/b.cfg", "sampling = {\nsample = 0; };");
    expect_refusal("@include \"inner/a.cfg\"\nplate = { width = 6.0; height = 4.0; }; material = { youngs_modulus = 1; "
                   "fracture_energy = 1; }; supports = ( { side = \"left\"; x = 0.1; } );",
                   "inner/b.cfg:2: sampling.sample: unknown setting, did you mean \"samples\"?");
    expect_refusal(
        "\n@include \"inner/b.cfg\" seeds = 2;",
        "study.cfg:2: seeds: unknown setting, did you mean \"seed\"?"); // though b.cfg ends without a newline
    write_text("inner/b.cfg", "sampling = {\n\n};; = 2");
    expect_refusal(text, "inner/b.cfg:3: syntax error");
    write_text("inner/b.cfg", "@include \"c.cfg\"");
    expect_refusal(text, "inner/b.cfg:1: @include: inner/c.cfg: No such file or directory");
    write_text("inner/b.cfg", "\n@include \"b.cfg\"");
    expect_refusal(text, "inner/b.cfg:2: @include: nested more than 10 deep");
}

static char *load(const char *path, size_t *size)
{
    static char bytes[1 << 16];
    FILE *file = fopen(path, "r");
    assert_non_null(file);
    *size = fread(bytes, 1, sizeof bytes - 1, file);
    bytes[*size] = 0;
    fclose(file);
    return bytes;
}

static bool is_read_or_refused(const char *bytes, size_t size)
{
    pdmc_study study;
    write_bytes("study.cfg", bytes, size);
    const pdmc_status status = pdmc_study_read("study.cfg", &study);
    pdmc_study_clear(&study);
    if (status != PDMC_OK && status != PDMC_ERR_CONFIG) fail_msg("%zu bytes: %s", size, pdmc_status_string(status));
    if (status != PDMC_OK) assert_memory_equal(pdmc_last_error(), "study.cfg:", 10);
    return status == PDMC_OK;
}

static void a_file_cut_anywhere_is_read_or_refused(void **state)
{
    (void)state;
    size_t size;
    const char *bytes = load(STUDIES "/center_crack/study.cfg", &size);
    const size_t needed = (size_t)(strstr(bytes, "solver") - bytes); // defaults stand in for what follows
    for (size_t n = 0; n <= size; n++) {
        const bool ok = is_read_or_refused(bytes, n);
        if (n < needed - 3) assert_false(ok); // " );\n" but for the part that may go
        if (n == needed || n == size) assert_true(ok);
    }
}

static void a_file_spoilt_anywhere_is_read_or_refused(void **state)
{
    (void)state;
    size_t size;
    char *bytes = load(STUDIES "/center_crack/study.cfg", &size);
    const char spoils[] = "\"{)0@\n\\\xff/-";
    const size_t kinds = sizeof spoils - 1;
    size_t read = 0;
    for (size_t n = 0; n < size; n++)
        for (size_t k = n; k < n + 2; k++) { // two of them at each place
            const char kept = bytes[n];
            bytes[n] = spoils[k % kinds];
            read += is_read_or_refused(bytes, size);
            bytes[n] = kept;
        }
    assert_in_range(read, 1, 2 * size - 1); // some spoil a comment, most do not
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(files_that_cannot_be_read),
        cmocka_unit_test(files_that_are_no_study),
        cmocka_unit_test(syntax),
        cmocka_unit_test(what_is_never_closed),
        cmocka_unit_test(comments_and_texts_keep_the_lines),
        cmocka_unit_test(a_comment_separates),
        cmocka_unit_test(texts_are_left_as_they_are),
        cmocka_unit_test(includes_are_relative_to_the_including_file),
        cmocka_unit_test(errors_name_the_included_file),
        cmocka_unit_test(a_file_cut_anywhere_is_read_or_refused),
        cmocka_unit_test(a_file_spoilt_anywhere_is_read_or_refused),
    };
    return cmocka_run_group_tests(tests, enter_folder, leave_folder);
}
