// SPDX-License-Identifier: GPL-3.0-or-later

/// Rules for integrals over the horizon side by side: as part of the table, as JSON, as CSV, and as pictures.

#include "views/csv.h"
#include "views/json_parts.h"
#include "views/plots.h"
#include "views/table.h"

#include <math.h>

static bool is_stress(const pdmc_quadrature_record *q)
{
    return q->state_count > 0;
}

static const char *integral_of(const pdmc_quadrature_record *q)
{
    return is_stress(q) ? "stress" : "volume";
}

static double at(const pdmc_quadrature_record *q, const double values[], int rule, int ratio)
{
    return values[rule * q->ratio_count + ratio];
}

static void print_names(const pdmc_quadrature_record *q, const char *what, FILE *stream)
{
    fprintf(stream, "\n%-24s", what);
    for (int r = 0; r < q->rule_count; r++) fprintf(stream, " %11.11s", q->rules[r].name);
    fputc('\n', stream);
}

static void print_block(const pdmc_quadrature_record *q, const char *what, const double values[], double factor,
                        FILE *stream)
{
    char n[PDMC_BRIEF_SIZE];
    print_names(q, what, stream);
    for (int i = 0; i < q->ratio_count; i++) {
        fprintf(stream, "  horizon / spacing %4.4g", q->ratio[i]);
        for (int r = 0; r < q->rule_count; r++) fprintf(stream, " %11s", pdmc_brief(n, factor * at(q, values, r, i)));
        fputc('\n', stream);
    }
}

static void print_orders(const pdmc_quadrature_record *q, FILE *stream)
{
    char n[PDMC_BRIEF_SIZE];
    fprintf(stream, "\n%-24s", "order over spacing");
    for (int r = 0; r < q->rule_count; r++) fprintf(stream, " %11s", pdmc_brief(n, q->rules[r].spacing_order));
    fprintf(stream, "\n%-24s", "over distance of points");
    for (int r = 0; r < q->rule_count; r++) fprintf(stream, " %11s", pdmc_brief(n, q->rules[r].distance_order));
    fputc('\n', stream);
}

/// Whether a component is more than rounding by any rule.
static bool is_there(const pdmc_quadrature_record *q, int place)
{
    double largest = 0.0, most = 0.0;
    for (int i = 0; i < 9; i++) largest = fmax(largest, fabs(q->exact_stress[i]));
    for (int i = 0; i < q->rule_count * q->ratio_count; i++) most = fmax(most, fabs(q->stress[9 * i + place]));
    return most > 1e-9 * largest;
}

static void print_stresses(const pdmc_results *r, FILE *stream)
{
    static const char *const names[] = {"xx", "yy", "zz", "yz", "zx", "xy"};
    static const int place[] = {0, 4, 8, 5, 2, 1};
    const pdmc_quadrature_record *q = &r->quadrature;
    char unit[PDMC_UNIT_SIZE], n[PDMC_BRIEF_SIZE];
    pdmc_results_unit(r, PDMC_UNIT_STRESS, sizeof unit, unit);
    for (int c = 0; c < 6; c++) {
        if (!is_there(q, place[c])) continue;
        fprintf(stream, "\nstress %s, exactly %s %.20s\n", names[c], pdmc_brief(n, q->exact_stress[place[c]]), unit);
        for (int i = 0; i < q->ratio_count; i++) {
            fprintf(stream, "  horizon / spacing %4.4g", q->ratio[i]);
            for (int k = 0; k < q->rule_count; k++)
                fprintf(stream, " %11s", pdmc_brief(n, q->stress[9 * (k * q->ratio_count + i) + place[c]]));
            fputc('\n', stream);
        }
    }
}

void pdmc_table_quadrature(const pdmc_results *r, FILE *stream)
{
    const pdmc_quadrature_record *q = &r->quadrature;
    char n[PDMC_BRIEF_SIZE], unit[PDMC_LINE_SIZE];
    fprintf(stream, "  %s, horizon %s %.20s in %s\n",
            is_stress(q) ? "the stress at a node of an infinite body" : "the volume of the horizon",
            pdmc_brief(n, q->horizon), pdmc_one_line(unit, r->length_unit), q->dimension == 2 ? "the plane" : "space");
    print_block(q, "error, %", q->error, 100.0, stream);
    print_orders(q, stream);
    print_block(q, is_stress(q) ? "points, half a horizon" : "points", q->points, 1.0, stream);
    print_block(q, "milliseconds", q->seconds, 1e3, stream);
    if (is_stress(q)) print_stresses(r, stream);
    fprintf(stream, "\nseconds  rules %.2f, output %.2f\n", r->runtime.motion, r->runtime.output);
}

json_t *pdmc_json_quadrature(const pdmc_quadrature_record *q)
{
    json_t *object = json_object(), *rules = json_array();
    const size_t n = (size_t)q->ratio_count;
    pdmc_json_put(&object, "integral", pdmc_json_text(integral_of(q)));
    pdmc_json_put(&object, "dimension", json_integer(q->dimension));
    pdmc_json_put(&object, "horizon", pdmc_json_number(q->horizon));
    pdmc_json_put(&object, "ratio", pdmc_json_numbers(n, q->ratio));
    if (is_stress(q)) pdmc_json_put(&object, "exact_stress", pdmc_json_numbers(9, q->exact_stress));
    for (int r = 0; r < q->rule_count; r++) {
        const size_t first = (size_t)r * n;
        json_t *rule = json_object(), *stress = json_array();
        pdmc_json_put(&rule, "name", pdmc_json_text(q->rules[r].name));
        pdmc_json_put(&rule, "error", pdmc_json_numbers(n, &q->error[first]));
        pdmc_json_put(&rule, "points", pdmc_json_numbers(n, &q->points[first]));
        pdmc_json_put(&rule, "distance", pdmc_json_numbers(n, &q->distance[first]));
        pdmc_json_put(&rule, "seconds", pdmc_json_numbers(n, &q->seconds[first]));
        pdmc_json_put(&rule, "spacing_order", pdmc_json_number(q->rules[r].spacing_order));
        pdmc_json_put(&rule, "distance_order", pdmc_json_number(q->rules[r].distance_order));
        for (size_t i = 0; i < n; i++) pdmc_json_append(&stress, pdmc_json_numbers(9, &q->stress[9 * (first + i)]));
        pdmc_json_put(&rule, "stress", stress);
        pdmc_json_append(&rules, rule);
    }
    pdmc_json_put(&object, "rules", rules);
    return object;
}

pdmc_status pdmc_csv_quadrature(const pdmc_results *r, FILE *stream)
{
    static const char *const components[] = {"xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz"};
    const pdmc_quadrature_record *q = &r->quadrature;
    char unit[PDMC_UNIT_SIZE], name[32];
    pdmc_results_unit(r, PDMC_UNIT_STRESS, sizeof unit, unit);
    fputs("rule,horizon_over_spacing,error,points", stream);
    pdmc_csv_column(stream, "distance", r->length_unit);
    pdmc_csv_column(stream, "seconds", "s");
    for (int c = 0; c < 9 && is_stress(q); c++) {
        snprintf(name, sizeof name, "stress_%s", components[c]);
        pdmc_csv_column(stream, name, unit);
    }
    fputc('\n', stream);
    for (int i = 0; i < q->rule_count * q->ratio_count; i++) {
        pdmc_csv_text(stream, q->rules[i / q->ratio_count].name);
        pdmc_csv_number(stream, q->ratio[i % q->ratio_count]);
        pdmc_csv_number(stream, q->error[i]);
        pdmc_csv_number(stream, q->points[i]);
        pdmc_csv_number(stream, q->distance[i]);
        pdmc_csv_number(stream, q->seconds[i]);
        if (is_stress(q)) pdmc_csv_numbers(stream, 9, &q->stress[9 * i]);
        fputc('\n', stream);
    }
    return PDMC_OK;
}

// Errors that are rounding have no place on a logarithmic axis.
static bool is_rounding(const pdmc_quadrature_record *q, int rule, int ratio)
{
    return !(fabs(at(q, q->error, rule, ratio)) > 1e-12);
}

static bool is_drawn(const pdmc_quadrature_record *q, int rule)
{
    bool has_error = false;
    for (int i = 0; i < q->ratio_count; i++) has_error |= !is_rounding(q, rule, i);
    return has_error;
}

static void put_points(const pdmc_quadrature_record *q, const double over[], double factor, FILE *script)
{
    for (int r = 0; r < q->rule_count; r++) {
        fprintf(script, "$rule%d << EOD\n", r);
        for (int i = 0; i < q->ratio_count; i++)
            if (!is_rounding(q, r, i))
                fprintf(script, "%.9g %.9g\n", factor * at(q, over, r, i), 100.0 * fabs(at(q, q->error, r, i)));
        fputs("EOD\n", script);
    }
}

static void draw_errors(const pdmc_quadrature_record *q, const double over[], double factor, const pdmc_figure *figure)
{
    static const char *const colours[] = {PDMC_VERMILION, "'#56b4e9'", PDMC_BLUE, "'#cc79a7'", PDMC_GREY, PDMC_GREEN};
    FILE *script = figure->script;
    put_points(q, over, factor, script);
    fprintf(script, "set logscale xy\nset format xy '10^{%%L}'\nset ylabel 'Error of the %s (%%)'\n", integral_of(q));
    fputs("set key outside top center horizontal maxrows 2\nplot NaN notitle", script);
    for (int r = 0; r < q->rule_count; r++) {
        if (!is_drawn(q, r)) continue;
        fprintf(script, ", $rule%d using 1:2 with linespoints pointtype %d linecolor %s title ", r, r + 4,
                colours[r % 6]);
        pdmc_figure_text(figure, q->rules[r].name);
    }
    fputc('\n', script);
}

void pdmc_draw_quadrature_points(const pdmc_results *r, const pdmc_figure *figure)
{
    fputs("set xlabel 'Integration points'\n", figure->script);
    draw_errors(&r->quadrature, r->quadrature.points, 1.0, figure);
}

void pdmc_draw_quadrature_time(const pdmc_results *r, const pdmc_figure *figure)
{
    fputs("set xlabel 'Time (ms)'\n", figure->script);
    draw_errors(&r->quadrature, r->quadrature.seconds, 1e3, figure);
}
