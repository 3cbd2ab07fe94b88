// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What the files of this folder share: the table of settings, the reader that follows it, and the places of errors.

#include "pdmc/study.h"

#include <libconfig.h>
#include <stdio.h>

// ---- text that grows (text.c) ----

typedef struct {
    FILE *out;   // write here; NULL when closed
    char *bytes; // valid once closed
    size_t size;
} pdmc_study_text;

PDMC_NODISCARD pdmc_status pdmc_study_text_open(pdmc_study_text *text);
/// Ends the writing; PDMC_ERR_NOMEM if any of it was lost.
PDMC_NODISCARD pdmc_status pdmc_study_text_close(pdmc_study_text *text);
/// A copy of the closed text; free with pdmc_free().
PDMC_NODISCARD pdmc_status pdmc_study_text_copy(const pdmc_study_text *text, char **copy);
/// Frees the bytes, open or closed; a zeroed text is allowed.
void pdmc_study_text_drop(pdmc_study_text *text);

/// The shortest decimals that read back to the same number, always recognisable as a real.
void pdmc_study_print_real(FILE *out, double x);

// ---- the file (source.c) ----

/// A study file as one text for libconfig: its @include lines replaced by the files, and where each line came from.
struct pdmc_study_source {
    pdmc_study_text input; // the top file, untouched
    pdmc_study_text text;  // for libconfig
    pdmc_study_text names; // of the files, each ended by a zero
    pdmc_study_text lines; // an array of pdmc_study_origin, one for each line of `text`
};

typedef struct {
    size_t name; // offset in `names`
    int line;
} pdmc_study_origin;

PDMC_NODISCARD pdmc_status pdmc_study_source_read(const char *path, pdmc_study_source *source);
void pdmc_study_source_drop(pdmc_study_source *source);
/// @param[in,out] config  initialised; PDMC_ERR_CONFIG with file and line where the text is none
PDMC_NODISCARD pdmc_status pdmc_study_source_parse(const pdmc_study_source *source, config_t *config);
/// The file and line from which line `line` of the text came, counted from 1.
const char *pdmc_study_source_place(const pdmc_study_source *source, unsigned line, int *file_line);

// ---- the table (schema.c, sections.c), and what can be asked of it (setting.c) ----

typedef enum {
    SECTION_TOP,
    SECTION_UNITS,
    SECTION_PLATE,
    SECTION_MATERIAL,
    SECTION_CRACKS,
    SECTION_LOADS,
    SECTION_SUPPORTS,
    SECTION_SOLVER,
    SECTION_DYNAMICS,
    SECTION_HISTORY,
    SECTION_PROBES,
    SECTION_RANDOM,
    SECTION_CORRELATIONS,
    SECTION_SAMPLING,
    SECTION_RELIABILITY,
    SECTION_ENERGY,
    SECTION_CONTROL,
    SECTION_PARTICLE_GRID,
    SECTION_PARTICLE_MATERIALS,
    SECTION_BODIES,
    SECTION_INTERFACES,
    SECTION_PLANAR_CRACKS,
    SECTION_CONDITIONS,
    SECTION_SPHERES,
    SECTION_NO_FAIL,
    SECTION_CONTACT,
    SECTION_DAMPING,
    SECTION_TIME,
    SECTION_LOADING,
    SECTION_RECORD,
    SECTION_DOMAIN,
    SECTION_KERNEL,
    SECTION_HOLES,
    SECTION_ELEMENTS,
    SECTION_WAVE,
    SECTION_SOURCE,
    SECTION_PRESCRIBED,
    SECTION_OPEN,
    SECTION_CONVERGENCE,
    SECTION_MARCH,
    SECTION_SOLID,
    SECTION_INTEGRATION,
    SECTION_STRAIN,
    SECTION_FACES,
    SECTION_REST,
    SECTION_QUADRATURE,
    SECTIONS
} pdmc_study_section_id;

typedef enum {
    KIND_REAL,
    KIND_OPTIONAL, // a real that may be absent
    KIND_PAIR,     // two reals
    KIND_VECTOR,   // as many reals as the explicit study has dimensions
    KIND_INT,
    KIND_SEED, // a 64-bit integer
    KIND_TEXT,
    KIND_NAME, // of a crack or a probe
    KIND_CHOICE,
    KIND_CRACK, // the name of a crack, kept as its number
    KIND_MATERIAL, // the name of one of the materials of an explicit study, kept as its number
    KIND_BODY, // ... of one of its bodies; with a flag it may be absent
    KIND_TIPS,  // names of crack tips
    KIND_REALS, // an array of reals: offset is that of the pointer, flag that of the count; may be absent
    KINDS
} pdmc_study_kind;

typedef enum {
    UNIT_NONE,
    UNIT_LENGTH,
    UNIT_STRESS,
    UNIT_LINE_FORCE,
    UNIT_TIME,
    UNIT_RATE,
    UNIT_MASS_DENSITY,
    UNIT_MASS,
    UNIT_VELOCITY,
    UNIT_MICROMODULUS,
    UNIT_PENALTY, // force / length^5, of a sphere
    UNIT_DAMPING, // force time / length^4
    UNIT_PER_LENGTH,
    UNIT_SLOWNESS
} pdmc_study_unit;

/// A method, and for the collocation how it treats cracks.
typedef enum { SOLVER_ANALYTIC, SOLVER_PAPER, SOLVER_VISIBLE, SOLVER_BOND, SOLVER_GALERKIN } pdmc_study_solver;

/// What the base units are called.
typedef struct {
    const char *length, *force, *time;
} pdmc_study_units;

/// low <= x <= high, or low < x where the bound is excluded, or x < high where it must stay below.
typedef struct {
    double low, high;
    bool excluded; // low itself
    bool below;    // high itself is
} pdmc_study_range;

typedef struct {
    pdmc_study_section_id section;
    const char *key;
    pdmc_study_kind kind;
    pdmc_study_unit unit;
    pdmc_study_range range;
    size_t offset; // in the problem, or in the element of a list; NOT_STORED where there is only one choice so far
    size_t flag;   // of an optional real: the bool that says it is there; of reals: their count
    const char *const *choices; // ended by NULL, in the order of the enum
    unsigned quantities;        // the uncertain quantities the key belongs to, as bits; 0 for all
    unsigned solvers;           // the solvers the key belongs to, as bits; 0 for all
    const char *of;             // a choice or an integer of the same group that the key depends on; NULL for none
    unsigned values;            // ... its values where the key belongs, as bits
    unsigned kinds;             // the kinds of study the key belongs to, as bits; 0 for those of its section
    const char *fallback;       // as it would be written in the file; NULL where the setting is required
    double (*derive)(const pdmc_problem *problem); // the default that depends on other settings; fallback describes it
    const char *doc;
} pdmc_study_setting;

#define NOT_STORED SIZE_MAX

typedef struct pdmc_study_reader pdmc_study_reader;

typedef struct {
    const char *name; // "" for the top of the file
    const char *doc;
    size_t size;                                           // of an element, for a list of groups; 0 for a single group
    size_t items, count;                                   // offsets at home of a list's pointer and length
    pdmc_status (*check)(const pdmc_study_reader *reader); // what the values mean together; may be NULL
    unsigned kinds;      // the kinds of study the section belongs to, as bits; 0 for all
    const char *instead; // what to say where it does not belong, after which it does; may be NULL
} pdmc_study_section;

extern const pdmc_study_section pdmc_study_sections[SECTIONS];
extern const pdmc_study_setting pdmc_study_settings[]; // by section, in the order of reading; ended by key = NULL

/// Whether the key belongs to the record at `base`: the quantities of an uncertainty have different keys, and so have
/// the solvers.
bool pdmc_study_setting_belongs(const pdmc_study_setting *setting, const void *base);
/// Whether a study of this kind has the key where it has the section.
bool pdmc_study_setting_of_kind(const pdmc_study_setting *setting, pdmc_problem_kind kind);
pdmc_study_solver pdmc_study_solver_of(const pdmc_problem *problem);
/// The setting of that name, or NULL.
const pdmc_study_setting *pdmc_study_find_setting(pdmc_study_section_id section, const char *key);
/// Where the settings of a section are kept: in the study's problem of a plate, or of what else it is about.
void *pdmc_study_home(const pdmc_study_section *section, const pdmc_study *study);
/// Whether a study of this kind has the section.
bool pdmc_study_section_belongs(const pdmc_study_section *section, pdmc_problem_kind kind);
void pdmc_study_print_unit(FILE *out, pdmc_study_unit unit, const pdmc_study_units *units);
/// What values are allowed: "> 0", "from 1 to 20", "\"left\" or \"right\"".
void pdmc_study_print_range(FILE *out, const pdmc_study_setting *setting);
/// What to say before the range where the kind is wrong: "a real", "an integer"; "" where the range says it.
const char *pdmc_study_kind_noun(pdmc_study_kind kind);

// ---- defaults that depend on other settings (defaults.c) ----

/// Half the length of the shortest crack; infinite without cracks.
double pdmc_study_shortest_half_crack(const pdmc_problem *problem);
double pdmc_study_half_crack(const pdmc_crack *crack);
double pdmc_study_default_load_layer(const pdmc_problem *problem);
double pdmc_study_default_spacing(const pdmc_problem *problem);
double pdmc_study_default_control_spacing(const pdmc_problem *problem);
double pdmc_study_default_horizon(const pdmc_problem *problem);
double pdmc_study_default_shape(const pdmc_problem *problem);
double pdmc_study_default_edge_layer(const pdmc_problem *problem);
double pdmc_study_default_energy_horizon(const pdmc_problem *problem);
double pdmc_study_default_extension(const pdmc_problem *problem);
double pdmc_study_default_step(const pdmc_problem *problem);

// ---- reading (parse.c, values.c, tips.c), and places in the file (report.c) ----

struct pdmc_study_reader {
    const pdmc_study_source *source;
    const config_setting_t *root;
    pdmc_problem *problem; // filled section by section
    pdmc_explicit *motion; // ... too
    pdmc_scalar *scalar;   // ...
    pdmc_elastic *elastic; // ...
    pdmc_horizon_study *quadrature; // ...
    const pdmc_study *study; // whose parts these are
    FILE *warnings;
};

/// Where in the file something is: a setting, a group (key = NULL), an element of a list or the list itself (index <
/// 0).
typedef struct {
    pdmc_study_section_id section;
    int index;
    const char *key;
} pdmc_study_address;

/// The setting there, or the innermost of the things around it that the file does have.
const config_setting_t *pdmc_study_locate(const pdmc_study_reader *reader, pdmc_study_address address);
/// The path of a file that a setting names, which is beside the file that has the setting unless it begins at the root;
/// NULL without memory.
char *pdmc_study_path(const pdmc_study_reader *reader, pdmc_study_address address, const char *name);
/// Raises PDMC_ERR_CONFIG with "file:line: path: " before the message.
pdmc_status pdmc_study_refuse(const pdmc_study_reader *reader, pdmc_study_address address, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
/// The same in pieces: what is printed to message->out between the two becomes the message.
PDMC_NODISCARD pdmc_status pdmc_study_refusal_begin(const pdmc_study_reader *reader, pdmc_study_address address,
                                                    pdmc_study_text *message);
pdmc_status pdmc_study_refusal_end(pdmc_study_text *message);
void pdmc_study_warn(const pdmc_study_reader *reader, pdmc_study_address address, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/// Reads and checks every section into reader->problem.
PDMC_NODISCARD pdmc_status pdmc_study_parse(const pdmc_study_reader *reader);

/// One group of the file, or its absence, and the struct that it fills.
typedef struct {
    const pdmc_study_reader *reader;
    const config_setting_t *group; // NULL where the file does not have it
    pdmc_study_section_id section;
    int index; // in a list; -1 otherwise
    void *base;
} pdmc_study_record;

/// Checks and stores one value; `value` is NULL where the file leaves it to the default.
PDMC_NODISCARD pdmc_status pdmc_study_read_value(const pdmc_study_record *record, const pdmc_study_setting *setting,
                                                 const config_setting_t *value);
/// The number of the crack that is named; the first where `value` is NULL.
PDMC_NODISCARD pdmc_status pdmc_study_parse_crack(const pdmc_study_reader *reader, pdmc_study_address address,
                                                  const config_setting_t *value, int *crack);
PDMC_NODISCARD pdmc_status pdmc_study_parse_tips(const pdmc_study_reader *reader, pdmc_study_address address,
                                                 const config_setting_t *value);

enum { PDMC_STUDY_TIP_NAME_SIZE = PDMC_NAME_SIZE + 8 };
/// "<crack>.from" or "<crack>.to".
void pdmc_study_tip_name(const pdmc_problem *problem, int tip, char name[PDMC_STUDY_TIP_NAME_SIZE]);

// ---- what is wrong with a value (refusal.c) ----

pdmc_study_address pdmc_study_address_of(const pdmc_study_record *record, const pdmc_study_setting *setting);
/// Says what was found and what is allowed; `noun` is "" where the kind is right and only the range is not.
pdmc_status pdmc_study_refuse_value(const pdmc_study_record *record, const pdmc_study_setting *setting,
                                    const config_setting_t *value, const char *noun);
pdmc_status pdmc_study_refuse_kind(const pdmc_study_record *record, const pdmc_study_setting *setting,
                                   const config_setting_t *value);
pdmc_status pdmc_study_refuse_missing(const pdmc_study_record *record, const pdmc_study_setting *setting);
pdmc_status pdmc_study_refuse_section(const pdmc_study_reader *reader, pdmc_study_address address, const char *allowed);

// ---- did you mean (nearest.c) ----

enum { PDMC_STUDY_WORD_SIZE = PDMC_STUDY_TIP_NAME_SIZE };

typedef struct {
    const char *word; // as it was written
    char best[PDMC_STUDY_WORD_SIZE];
    size_t distance; // of the best; a candidate must beat it
} pdmc_study_nearest;

/// Begins a search; `word` must outlive it.
pdmc_study_nearest pdmc_study_nearest_to(const char *word);
/// Keeps the candidate if it is nearer than all before; `best` stays "" while none is near enough.
void pdmc_study_nearest_offer(pdmc_study_nearest *nearest, const char *candidate);

// ---- what values mean together (check_*.c) ----

/// A bound that was computed is compared with a value that was written in decimals.
static inline double pdmc_study_with_rounding(double bound)
{
    return bound * (1.0 + 1e-9);
}

PDMC_NODISCARD pdmc_status pdmc_study_check_cracks(const pdmc_study_reader *reader);
PDMC_NODISCARD pdmc_status pdmc_study_check_loads(const pdmc_study_reader *reader);
PDMC_NODISCARD pdmc_status pdmc_study_check_solver(const pdmc_study_reader *reader);
/// Refuse cracks that end at an edge, and cracks that meet, saying which solver can have them.
PDMC_NODISCARD pdmc_status pdmc_study_check_inner_tips(const pdmc_study_reader *reader, const char *instead);
PDMC_NODISCARD pdmc_status pdmc_study_check_apart(const pdmc_study_reader *reader, const char *instead);
PDMC_NODISCARD pdmc_status pdmc_study_check_grid(const pdmc_study_reader *reader);
PDMC_NODISCARD pdmc_status pdmc_study_check_triangles(const pdmc_study_reader *reader);
PDMC_NODISCARD pdmc_status pdmc_study_check_dynamics(const pdmc_study_reader *reader);
/// Gives a history that is empty its one point, a factor of 1 from the start.
PDMC_NODISCARD pdmc_status pdmc_study_check_history(const pdmc_study_reader *reader);
PDMC_NODISCARD pdmc_status pdmc_study_check_probes(const pdmc_study_reader *reader);
PDMC_NODISCARD pdmc_status pdmc_study_check_random(const pdmc_study_reader *reader);
PDMC_NODISCARD pdmc_status pdmc_study_check_correlations(const pdmc_study_reader *reader);
/// Completes the distribution of a scalar from the parameters that the file gives.
PDMC_NODISCARD pdmc_status pdmc_study_make_law(const pdmc_study_reader *reader, int index);
PDMC_NODISCARD pdmc_status pdmc_study_check_sampling(const pdmc_study_reader *reader);
PDMC_NODISCARD pdmc_status pdmc_study_check_reliability(const pdmc_study_reader *reader);
/// Completes the solver of the control by its defaults.
PDMC_NODISCARD pdmc_status pdmc_study_check_control(const pdmc_study_reader *reader);
PDMC_NODISCARD pdmc_status pdmc_study_check_energy(const pdmc_study_reader *reader);

// ... of a study of quadrature (check_quadrature.c)
PDMC_NODISCARD pdmc_status pdmc_study_check_quadrature(const pdmc_study_reader *reader);

// ... of an explicit study (check_explicit.c, check_bodies.c)
PDMC_NODISCARD pdmc_status pdmc_study_check_particle_grid(const pdmc_study_reader *reader);
PDMC_NODISCARD pdmc_status pdmc_study_check_particle_materials(const pdmc_study_reader *reader);
PDMC_NODISCARD pdmc_status pdmc_study_check_bodies(const pdmc_study_reader *reader);
/// Refuses the second of two equal names in a list. @param[in] what  the list is of
PDMC_NODISCARD pdmc_status pdmc_study_check_names(const pdmc_study_reader *reader, pdmc_study_section_id id,
                                                  const char *what);
PDMC_NODISCARD pdmc_status pdmc_study_check_interfaces(const pdmc_study_reader *reader);
PDMC_NODISCARD pdmc_status pdmc_study_check_planar_cracks(const pdmc_study_reader *reader);
PDMC_NODISCARD pdmc_status pdmc_study_check_conditions(const pdmc_study_reader *reader);
PDMC_NODISCARD pdmc_status pdmc_study_check_spheres(const pdmc_study_reader *reader);
/// Refuses what moves in a quasi-static study; gives the loads their first one, 0.
PDMC_NODISCARD pdmc_status pdmc_study_check_loading(const pdmc_study_reader *reader);
PDMC_NODISCARD pdmc_status pdmc_study_check_no_fail(const pdmc_study_reader *reader);
PDMC_NODISCARD pdmc_status pdmc_study_check_time(const pdmc_study_reader *reader);
PDMC_NODISCARD pdmc_status pdmc_study_check_record(const pdmc_study_reader *reader);

// ... of a scalar study (check_scalar.c)
PDMC_NODISCARD pdmc_status pdmc_study_check_kernel(const pdmc_study_reader *reader);
PDMC_NODISCARD pdmc_status pdmc_study_check_elements(const pdmc_study_reader *reader);
/// Reads the mesh of a file. (check_mesh.c)
PDMC_NODISCARD pdmc_status pdmc_study_check_mesh(const pdmc_study_reader *reader);
PDMC_NODISCARD pdmc_status pdmc_study_check_wave(const pdmc_study_reader *reader);
PDMC_NODISCARD pdmc_status pdmc_study_check_source(const pdmc_study_reader *reader);
PDMC_NODISCARD pdmc_status pdmc_study_check_prescribed(const pdmc_study_reader *reader);
PDMC_NODISCARD pdmc_status pdmc_study_check_open(const pdmc_study_reader *reader);
PDMC_NODISCARD pdmc_status pdmc_study_check_convergence(const pdmc_study_reader *reader);
PDMC_NODISCARD pdmc_status pdmc_study_check_march(const pdmc_study_reader *reader);

// ... of an elastic study (check_elastic.c)
PDMC_NODISCARD pdmc_status pdmc_study_check_solid(const pdmc_study_reader *reader);
PDMC_NODISCARD pdmc_status pdmc_study_check_integration(const pdmc_study_reader *reader);
PDMC_NODISCARD pdmc_status pdmc_study_check_faces_of_solid(const pdmc_study_reader *reader);
