// SPDX-License-Identifier: GPL-3.0-or-later

/// libconfig 1.5, which Debian 12 has, does four things to a study file that a user would never find:
/// it wraps an integer above 2^31 (a modulus of 210000000000 becomes negative), it takes a comment or a text that is
/// never closed as the end of the file, it looks for every @include in one folder, and it stops at a zero byte. So the
/// file is put together here: @include lines are replaced, integers get libconfig's 64-bit suffix, comments go, and the
/// lines are remembered.

#include "study/study_impl.h"

#include "base/base_impl.h"

#include <ctype.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>

enum { DEPTH_LIMIT = 10, SIZE_LIMIT = 16 << 20 };

typedef struct {
    pdmc_study_source *source;
    const char *path;
    const char *start, *at; // the text of this file, and where we are in it
    size_t name;            // its offset in source->names
    int line;
    int depth;   // of @include
    bool *fresh; // whether the next character begins a line of the whole text
} cursor;

static pdmc_status read_file(const char *path, pdmc_study_text *text)
{
    pdmc_status status = PDMC_OK;
    char block[4096];
    size_t total = 0;
    FILE *file = fopen(path, "r");
    if (!file) PDMC_FAIL(PDMC_ERR_NO_INPUT, "%s: %s", path, strerror(errno));
    PDMC_TRY(pdmc_study_text_open(text));
    for (size_t got; (got = fread(block, 1, sizeof block, file)) > 0;) {
        total += got;
        if (total == got && got >= 8 && memcmp(block, "\x89HDF\r\n\x1a\n", 8) == 0)
            PDMC_FAIL(PDMC_ERR_CONFIG, "%s: an HDF5 file, not a study file; pdmc show prints the results in one", path);
        if (total > SIZE_LIMIT) PDMC_FAIL(PDMC_ERR_CONFIG, "%s: larger than 16 MiB, not a study file", path);
        if (memchr(block, 0, got)) PDMC_FAIL(PDMC_ERR_CONFIG, "%s: has a zero byte in it, not a study file", path);
        fwrite(block, 1, got, text->out);
    }
    if (ferror(file)) PDMC_FAIL(PDMC_ERR_NO_INPUT, "%s: %s", path, strerror(errno));
    PDMC_TRY(pdmc_study_text_close(text));
done:
    if (file) fclose(file);
    return status;
}

static void put(cursor *c, char byte)
{
    if (*c->fresh) {
        const pdmc_study_origin origin = {c->name, c->line};
        fwrite(&origin, sizeof origin, 1, c->source->lines.out);
    }
    fputc(byte, c->source->text.out);
    *c->fresh = byte == '\n';
    if (byte == '\n') c->line++;
}

static void copy(cursor *c, size_t length)
{
    for (const char *end = c->at + length; c->at < end; c->at++) put(c, *c->at);
}

static pdmc_status refuse(const cursor *c, int line, const char *what)
{
    return pdmc_raise(PDMC_ERR_CONFIG, "%s:%d: %s", c->path, line, what);
}

static pdmc_status copy_string(cursor *c)
{
    const int line = c->line;
    const char *end = c->at + 1;
    while (*end && *end != '"') end += end[0] == '\\' && end[1] ? 2 : 1;
    if (!*end) return refuse(c, line, "the text that begins here is not closed, \" is missing");
    copy(c, (size_t)(end + 1 - c->at));
    return PDMC_OK;
}

static void skip_line_comment(cursor *c)
{
    c->at += strcspn(c->at, "\n");
}

static pdmc_status skip_block_comment(cursor *c)
{
    const char *end = strstr(c->at + 2, "*/");
    if (!end) return refuse(c, c->line, "the comment that begins here is not closed, */ is missing");
    put(c, ' '); // what stands on both sides stays apart
    for (; c->at < end; c->at++)
        if (*c->at == '\n') put(c, '\n');
    c->at = end + 2;
    return PDMC_OK;
}

/// The end of the integer at `text`, L suffixes included, or NULL if it is none; errno = ERANGE beyond 64 bits.
static const char *parse_integer(const char *text, long long *value)
{
    const bool hexadecimal = text[0] == '0' && (text[1] == 'x' || text[1] == 'X');
    char *end;
    errno = 0;
    *value = strtoll(text, &end, hexadecimal ? 16 : 10);
    if (end == text) return NULL;
    for (int i = 0; i < 2 && *end == 'L'; i++) end++;
    return end;
}

static pdmc_status copy_number(cursor *c)
{
    const size_t length = strspn(c->at, "+-.0123456789abcdefABCDEFxXL");
    long long value;
    if (parse_integer(c->at, &value) != c->at + length) {
        copy(c, length); // a real, or something for libconfig to complain about
        return PDMC_OK;
    }
    if (errno == ERANGE) return refuse(c, c->line, "an integer beyond 64 bits; write a real with a decimal point");
    char digits[32];
    snprintf(digits, sizeof digits, "%lldL", value);
    for (const char *digit = digits; *digit; digit++) put(c, *digit);
    c->at += length;
    return PDMC_OK;
}

static void copy_name(cursor *c)
{
    size_t length = 1;
    while (isalnum((unsigned char)c->at[length]) || (c->at[length] && strchr("-_*", c->at[length]))) length++;
    copy(c, length);
}

/// The opening quote of the @include that the line at `c` consists of, or NULL.
static const char *include_quote(const cursor *c)
{
    if (c->at != c->start && c->at[-1] != '\n') return NULL;
    const char *word = c->at + strspn(c->at, " \t");
    if (strncmp(word, "@include", 8) != 0) return NULL;
    const size_t blanks = strspn(word + 8, " \t");
    return blanks > 0 && word[8 + blanks] == '"' ? word + 8 + blanks : NULL;
}

static pdmc_status expand(pdmc_study_source *source, const char *path, int depth, bool *fresh, pdmc_study_text *text);

static pdmc_status include(cursor *c, const char *quote)
{
    pdmc_status status = PDMC_OK;
    pdmc_study_text path = {0}, text = {0};
    const size_t length = strcspn(quote + 1, "\"\n");
    const char *slash = strrchr(c->path, '/');
    if (quote[1 + length] != '"') return refuse(c, c->line, "@include: the closing \" is missing");
    if (c->depth == DEPTH_LIMIT) return refuse(c, c->line, "@include: nested more than 10 deep");
    PDMC_TRY(pdmc_study_text_open(&path));
    if (quote[1] != '/' && slash) fprintf(path.out, "%.*s/", (int)(slash - c->path), c->path);
    fprintf(path.out, "%.*s", (int)length, quote + 1);
    PDMC_TRY(pdmc_study_text_close(&path));

    status = expand(c->source, path.bytes, c->depth + 1, c->fresh, &text);
    if (status == PDMC_ERR_NO_INPUT)
        PDMC_FAIL(PDMC_ERR_CONFIG, "%s:%d: @include: %s", c->path, c->line, pdmc_last_error());
    c->at = quote + length + 2;
done:
    pdmc_study_text_drop(&text);
    pdmc_study_text_drop(&path);
    return status;
}

static pdmc_status copy_token(cursor *c)
{
    const char *quote = include_quote(c);
    if (quote) return include(c, quote);
    if (*c->at == '"') return copy_string(c);
    if (c->at[0] == '/' && c->at[1] == '*') return skip_block_comment(c);
    if (strchr("+-.", *c->at) || isdigit((unsigned char)*c->at)) return copy_number(c);
    if (*c->at == '#' || (c->at[0] == '/' && c->at[1] == '/')) skip_line_comment(c);
    else if (isalpha((unsigned char)*c->at)) copy_name(c);
    else copy(c, 1);
    return PDMC_OK;
}

static pdmc_status expand(pdmc_study_source *source, const char *path, int depth, bool *fresh, pdmc_study_text *text)
{
    pdmc_status status = PDMC_OK;
    PDMC_TRY(read_file(path, text));
    cursor c = {source, path, text->bytes, text->bytes, (size_t)ftell(source->names.out), 1, depth, fresh};
    fprintf(source->names.out, "%s%c", path, 0);
    while (*c.at) PDMC_TRY(copy_token(&c));
    if (!*fresh) put(&c, '\n'); // the last line of an included file may lack its end
done:
    return status;
}

pdmc_status pdmc_study_source_read(const char *path, pdmc_study_source *source)
{
    pdmc_status status = PDMC_OK;
    bool fresh = true;
    PDMC_TRY(pdmc_study_text_open(&source->text));
    PDMC_TRY(pdmc_study_text_open(&source->names));
    PDMC_TRY(pdmc_study_text_open(&source->lines));
    PDMC_TRY(expand(source, path, 0, &fresh, &source->input));
    PDMC_TRY(pdmc_study_text_close(&source->text));
    PDMC_TRY(pdmc_study_text_close(&source->names));
    PDMC_TRY(pdmc_study_text_close(&source->lines));
done:
    return status;
}

void pdmc_study_source_drop(pdmc_study_source *source)
{
    pdmc_study_text_drop(&source->input);
    pdmc_study_text_drop(&source->text);
    pdmc_study_text_drop(&source->names);
    pdmc_study_text_drop(&source->lines);
}

const char *pdmc_study_source_place(const pdmc_study_source *source, unsigned line, int *file_line)
{
    const size_t count = source->lines.size / sizeof(pdmc_study_origin);
    pdmc_study_origin origin = {.line = 1}; // of an empty file
    if (count > 0) {
        const size_t last = line < count ? line : count; // an error at the end of the file is on its last line
        memcpy(&origin, source->lines.bytes + (last > 0 ? last - 1 : 0) * sizeof origin, sizeof origin);
    }
    *file_line = origin.line;
    return source->names.bytes + origin.name;
}
