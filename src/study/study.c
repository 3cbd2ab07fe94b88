// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/study_impl.h"

#include "base/base_impl.h"

#include <string.h>

pdmc_status pdmc_study_source_parse(const pdmc_study_source *source, config_t *config)
{
    if (config_read_string(config, source->text.bytes)) return PDMC_OK;
    int line;
    const char *file = pdmc_study_source_place(source, (unsigned)config_error_line(config), &line);
    const char *text = config_error_text(config);
    const bool mixed = strstr(text, "mismatched element type") != NULL;
    return pdmc_raise(PDMC_ERR_CONFIG, "%s:%d: %s%s", file, line, text,
                      mixed ? ": the elements must be alike, all with a decimal point or all without" : "");
}

static pdmc_status read_problem(const pdmc_study_source *source, FILE *warnings, pdmc_study *study)
{
    config_t config;
    config_init(&config);
    pdmc_status status = pdmc_study_source_parse(source, &config);
    if (status == PDMC_OK)
        status = pdmc_study_parse(&(pdmc_study_reader){
            source, config_root_setting(&config), &study->problem, &study->motion, &study->scalar, &study->elastic,
            &study->quadrature, study, warnings});
    config_destroy(&config);
    return status;
}

pdmc_status pdmc_study_read(const char *path, pdmc_study *study)
{
    pdmc_status status = PDMC_OK;
    pdmc_study_text warnings = {0};
    *study = (pdmc_study){0};
    PDMC_NEW(study->source, 1);
    PDMC_TRY(pdmc_study_source_read(path, study->source));
    PDMC_TRY(pdmc_study_text_open(&warnings));
    PDMC_TRY(read_problem(study->source, warnings.out, study));
    PDMC_TRY(pdmc_study_text_close(&warnings));
    PDMC_TRY(pdmc_study_text_copy(&study->source->input, &study->input));
    PDMC_TRY(pdmc_study_text_copy(&warnings, &study->warnings));
    PDMC_TRY(pdmc_study_resolve(study));
done:
    if (status != PDMC_OK) pdmc_study_clear(study);
    pdmc_study_text_drop(&warnings);
    return status;
}

pdmc_status pdmc_study_set_samples(pdmc_study *study, int samples)
{
    pdmc_sampling *sampling = &study->problem.sampling;
    PDMC_REQUIRE(sampling->design == PDMC_DESIGN_MONTE_CARLO || samples % sampling->replicates == 0,
                 "%d samples are not allowed, must be a multiple of the %d replicates of the design, such as %d",
                 samples, sampling->replicates, (samples / sampling->replicates + 1) * sampling->replicates);
    PDMC_REQUIRE(sampling->target == PDMC_TARGET_NONE || samples <= sampling->most_samples,
                 "%d samples are not allowed, must be at most the %d of sampling.most_samples", samples,
                 sampling->most_samples);
    sampling->samples = samples;
    return pdmc_study_resolve(study);
}

void pdmc_study_clear(pdmc_study *study)
{
    pdmc_problem_clear(&study->problem);
    pdmc_explicit_clear(&study->motion);
    pdmc_scalar_clear(&study->scalar);
    pdmc_elastic_clear(&study->elastic);
    pdmc_horizon_study_clear(&study->quadrature);
    pdmc_free(study->input);
    pdmc_free(study->resolved);
    pdmc_free(study->warnings);
    if (study->source) pdmc_study_source_drop(study->source);
    pdmc_free(study->source);
    *study = (pdmc_study){0};
}
