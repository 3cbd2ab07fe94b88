// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/figure.h"

#include "base/base_impl.h"

#include <ctype.h>
#include <errno.h>
#include <fcntl.h>
#include <spawn.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

extern char **environ;

static void put_characters(const pdmc_figure *figure, const char *text)
{
    for (const char *c = text; *c; c++) {
        if (strchr("_^{}@&~\\", *c)) fputc('\\', figure->script);
        if (*c == '\'') fputs("’", figure->script); // gnuplot 5.4 misreads a string that begins with a quoted quote
        else fputc(iscntrl((unsigned char)*c) ? ' ' : *c, figure->script);
    }
}

void pdmc_figure_text(const pdmc_figure *figure, const char *text)
{
    fputc('\'', figure->script);
    put_characters(figure, text);
    fputc('\'', figure->script);
}

void pdmc_figure_label(const pdmc_figure *figure, const char *what, const char *before, const char *text,
                       const char *after)
{
    fprintf(figure->script, "set %s '%s", what, before);
    put_characters(figure, text);
    fprintf(figure->script, "%s'\n", after);
}

void pdmc_figure_mark(const pdmc_figure *figure, double x)
{
    fprintf(figure->script, "set arrow from first %.9g, graph 0 to first %.9g, graph 1", x, x);
    fputs(" nohead dashtype 2 linewidth 0.9 linecolor " PDMC_GREY "\n", figure->script);
}

/// The name of a file: no enhanced text here, and no way to write a control character. It begins with a slash or a
/// point, as a string may not begin with a quote.
static void put_output(FILE *script, const pdmc_whole_file *file)
{
    fprintf(script, "set output '%s", file->temporary[0] == '/' ? "" : "./");
    for (const char *c = file->temporary; *c; c++) {
        if (*c == '\'') fputc('\'', script);
        fputc(*c, script);
    }
    fputs("'\n", script);
}

static void put_png_terminal(FILE *script, int height)
{
    fprintf(script,
            "set terminal pngcairo enhanced color rounded size 1600,%d font 'Sans,22' linewidth 2.2 pointscale 2.2 "
            "background 'white'\n",
            height);
}

/// Three quarters of the PNG, since a point of a font is a pixel here and 4/3 of one there.
static void put_svg_terminal(FILE *script, int height)
{
    fprintf(script,
            "set terminal svg enhanced rounded size 1200,%d dynamic font 'sans-serif,22' linewidth 1.7 "
            "background 'white'\n",
            3 * height / 4);
}

static const char *const settings = "set encoding utf8\n"
                                    "set minussign\n"
                                    "set border 3 linewidth 1.2\n"
                                    "set tics nomirror out scale 0.8\n"
                                    "set style line 100 linecolor '#d8d8d8' linewidth 0.7\n"
                                    "set grid back linestyle 100\n"
                                    "set key top right Left reverse samplen 1.8 spacing 1.25\n"
                                    "set title font ',20'\n"
                                    "set style fill transparent solid 0.25 noborder\n";

static pdmc_status open_file(const char *folder, const char *stem, const char *ending, pdmc_whole_file *file)
{
    pdmc_status status = PDMC_OK;
    char *path = NULL;
    char name[256];
    snprintf(name, sizeof name, "%s.%s", stem, ending);
    for (char *c = name; *c; c++)
        if (*c == '/' || iscntrl((unsigned char)*c)) *c = '_';
    if (!(path = pdmc_folder_path(folder, name))) return PDMC_ERR_NOMEM;
    for (const char *c = folder; *c; c++)
        if (iscntrl((unsigned char)*c))
            PDMC_FAIL(PDMC_ERR_CREATE, "%s: gnuplot cannot write where a name has control characters", folder);
    PDMC_TRY(pdmc_whole_file_open(path, true, file));

done:
    pdmc_free(path);
    return status;
}

pdmc_status pdmc_figure_open(const char *folder, const char *stem, pdmc_figure *figure)
{
    pdmc_status status = PDMC_OK;
    *figure = (pdmc_figure){.height = 1100};
    PDMC_TRY(open_file(folder, stem, "png", &figure->png));
    PDMC_TRY(open_file(folder, stem, "svg", &figure->svg));
    figure->script = open_memstream(&figure->drawing, &figure->drawing_size);
    if (!figure->script) status = pdmc_raise_errno("the script of gnuplot", errno);

done:
    return status;
}

/// The drawing once for each file: a drawing of several plots cannot be replotted.
static pdmc_status write_script(pdmc_figure *figure, FILE *script)
{
    const struct {
        void (*put_terminal)(FILE *script, int height);
        const pdmc_whole_file *file;
    } passes[] = {{put_png_terminal, &figure->png}, {put_svg_terminal, &figure->svg}};
    if (fflush(figure->script) != 0 || ferror(figure->script)) return pdmc_raise_errno("the script of gnuplot", errno);
    for (size_t i = 0; i < sizeof passes / sizeof passes[0]; i++) {
        passes[i].put_terminal(script, figure->height);
        put_output(script, passes[i].file);
        fputs(settings, script);
        fwrite(figure->drawing, 1, figure->drawing_size, script);
        fputs("unset output\nreset\n", script);
    }
    if (fflush(script) != 0 || ferror(script)) return pdmc_raise_errno("the script of gnuplot", errno);
    rewind(script); // and with it the place from where gnuplot reads
    return PDMC_OK;
}

/// Starts gnuplot with the script as its input and its messages in `errors`.
static pdmc_status spawn(FILE *script, FILE *errors, pid_t *process)
{
    char program[] = "gnuplot", defaults[] = "-d"; // without the user's own settings
    char *const arguments[] = {program, defaults, NULL};
    posix_spawn_file_actions_t actions;
    int error = posix_spawn_file_actions_init(&actions);
    if (error == 0) {
        error = posix_spawn_file_actions_adddup2(&actions, fileno(script), STDIN_FILENO);
        if (error == 0) error = posix_spawn_file_actions_adddup2(&actions, fileno(errors), STDERR_FILENO);
        if (error == 0) error = posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
        if (error == 0) error = posix_spawnp(process, program, &actions, NULL, arguments, environ);
        posix_spawn_file_actions_destroy(&actions);
    }
    if (error == ENOENT) return pdmc_raise(PDMC_ERR_EXTERN, "gnuplot not found: install gnuplot-nox");
    if (error != 0) return pdmc_raise(PDMC_ERR_EXTERN, "gnuplot cannot be started: error %d", error);
    return PDMC_OK;
}

/// The line of gnuplot's messages that says what is wrong: the last one that is not empty.
static void last_line(FILE *errors, size_t size, char line[])
{
    char next[256];
    snprintf(line, size, "no message");
    rewind(errors);
    while (fgets(next, sizeof next, errors)) {
        next[strcspn(next, "\r\n")] = '\0';
        if (next[strspn(next, " \t^")] != '\0') snprintf(line, size, "%s", next);
    }
}

static pdmc_status run(const pdmc_figure *figure, FILE *script)
{
    pdmc_status status = PDMC_OK;
    pid_t process = 0;
    int outcome = 0;
    char line[256];
    FILE *errors = tmpfile();
    if (!errors) return pdmc_raise_errno("the messages of gnuplot", errno);
    PDMC_TRY(spawn(script, errors, &process));
    while (waitpid(process, &outcome, 0) < 0 && errno == EINTR) continue;
    if (!WIFEXITED(outcome) || WEXITSTATUS(outcome) != 0) {
        last_line(errors, sizeof line, line);
        PDMC_FAIL(PDMC_ERR_EXTERN, "gnuplot failed on %s: %s", figure->png.path, line);
    }

done:
    fclose(errors);
    return status;
}

/// gnuplot may end without complaint where a terminal is missing, or the disk is full.
static pdmc_status check_drawn(const pdmc_whole_file *file)
{
    struct stat properties;
    if (fstat(file->descriptor, &properties) == 0 && properties.st_size > 0) return PDMC_OK;
    return pdmc_raise(PDMC_ERR_EXTERN, "gnuplot left %s empty", file->path);
}

pdmc_status pdmc_figure_draw(pdmc_figure *figure)
{
    pdmc_status status = PDMC_OK;
    FILE *script = tmpfile();
    if (!script) return pdmc_raise_errno("the script of gnuplot", errno);
    PDMC_TRY(write_script(figure, script));
    PDMC_TRY(run(figure, script));
    PDMC_TRY(check_drawn(&figure->png));
    PDMC_TRY(check_drawn(&figure->svg));
    PDMC_TRY(pdmc_whole_file_appear(&figure->png, true));
    PDMC_TRY(pdmc_whole_file_appear(&figure->svg, true));

done:
    fclose(script);
    return status;
}

void pdmc_figure_close(pdmc_figure *figure)
{
    if (figure->script) fclose(figure->script);
    free(figure->drawing); // the stream's own
    pdmc_whole_file_discard(&figure->png);
    pdmc_whole_file_discard(&figure->svg);
    *figure = (pdmc_figure){0};
}
