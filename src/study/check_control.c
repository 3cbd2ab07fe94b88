// SPDX-License-Identifier: GPL-3.0-or-later

/// The cheaper method whose samples are controls of the study's own: its solver, made of the method's defaults.

#include "study/study_impl.h"

#include "base/base_impl.h"

static pdmc_study_address at(const char *key)
{
    return (pdmc_study_address){SECTION_CONTROL, -1, key};
}

static bool is_given(const pdmc_study_setting *setting)
{
    return setting->offset == offsetof(pdmc_problem, solver.method) ||
           setting->offset == offsetof(pdmc_problem, solver.spacing) ||
           setting->offset == offsetof(pdmc_problem, solver.horizon);
}

/// Every other setting of the solver takes its default, as it would from a file that leaves it out.
static pdmc_status read_defaults(const pdmc_study_reader *reader)
{
    pdmc_status status = PDMC_OK;
    const pdmc_study_record record = {reader, NULL, SECTION_SOLVER, -1, reader->problem};
    for (const pdmc_study_setting *s = pdmc_study_settings; s->key && status == PDMC_OK; s++)
        if (s->section == SECTION_SOLVER && !is_given(s) && pdmc_study_setting_belongs(s, reader->problem))
            status = pdmc_study_read_value(&record, s, NULL);
    return status;
}

static pdmc_status complete_solver(const pdmc_study_reader *reader)
{
    pdmc_status status = PDMC_OK;
    pdmc_study_text warnings = {0}; // of the study's own solver they have been said
    pdmc_problem cheaper = *reader->problem;
    pdmc_study_reader own = *reader;
    own.problem = &cheaper;
    cheaper.solver = cheaper.control.solver;
    cheaper.solver.horizon = reader->problem->solver.horizon;
    PDMC_TRY(pdmc_study_text_open(&warnings));
    own.warnings = warnings.out;
    PDMC_TRY(read_defaults(&own));
    PDMC_TRY(pdmc_study_check_solver(&own));
    PDMC_TRY(pdmc_study_check_energy(&own));
    reader->problem->control.solver = cheaper.solver;
done:
    pdmc_study_text_drop(&warnings);
    return status;
}

pdmc_status pdmc_study_check_control(const pdmc_study_reader *reader)
{
    const pdmc_problem *p = reader->problem;
    const pdmc_sampling *sampling = &p->sampling;
    const int samples = p->control.samples, own = sampling->target ? sampling->most_samples : sampling->samples;
    if (samples == 0) return PDMC_OK;
    if (p->uncertainty_count == 0)
        return pdmc_study_refuse(reader, at("samples"), "nothing is random, must have a list of random quantities");
    if (sampling->design != PDMC_DESIGN_MONTE_CARLO)
        return pdmc_study_refuse(reader, at("samples"), "a control needs design = \"monte_carlo\"");
    if (own < 3 || own > sampling->keep)
        return pdmc_study_refuse(
            reader, at("samples"),
            "a control needs every energy of the study's own samples, which must be from 3 to the %d "
            "that sampling.keep keeps",
            sampling->keep);
    if (samples <= own)
        return pdmc_study_refuse(reader, at("samples"), "%d is not allowed, must be more than the study's own %d",
                                 samples, own);
    if (pdmc_problem_uncertainty(p, PDMC_QUANTITY_STIFFNESS) && p->control.solver.method != PDMC_METHOD_KANSA)
        return pdmc_study_refuse(reader, at("method"), "a random stiffness needs a control by \"kansa\"");
    return complete_solver(reader);
}
