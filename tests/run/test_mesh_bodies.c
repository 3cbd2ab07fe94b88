// SPDX-License-Identifier: GPL-3.0-or-later

/// Bodies whose nodes are those of a mesh: they hold the energy, and carry the wave, of the same body on a grid.

#include "run/studies.h"

#include "mesh/cube.h"
#include "mesh/msh_file.h"
#include "pdmc/results.h"

#define MATERIALS "materials = ( { density = 1.0; youngs_modulus = 1.0; } );\n"

static void run_text(const char *text, int threads, pdmc_results *results)
{
    const pdmc_run_options options = {.threads = threads};
    pdmc_study study;
    CHECK_OK(read_text(text, &study));
    CHECK_OK(pdmc_run(&study, &options, results));
    pdmc_study_clear(&study);
}

static void write_plate(double width, double height, double spacing)
{
    const pdmc_mesh_plate plate = {.width = width, .height = height, .spacing = spacing, .fine_spacing = spacing};
    pdmc_mesh mesh;
    CHECK_OK(pdmc_mesh_triangles(&plate, &mesh));
    write_msh("plate.msh", &mesh, false);
    pdmc_mesh_clear(&mesh);
}

// Of all nodes with the displacement of a uniform strain.
static double strain_energy(const char *grid, const char *body, const char *condition)
{
    char text[1024];
    pdmc_results r;
    snprintf(text, sizeof text,
             "kind = \"quasi_static\"; grid = { %s };\n" MATERIALS "bodies = ( { %s } ); loading = { steps = 1; };\n"
             "conditions = ( { prescribed = \"displacement\"; %s } );\n",
             grid, body, condition);
    run_text(text, 2, &r);
    const double energy = r.particles.elastic[1];
    pdmc_results_clear(&r);
    return energy;
}

// With six nodes a horizon sums of either are within 1 % of the integral (they differ by 0.3 %), surfaces included.
static void a_plate_has_the_energy_of_a_grid(void **state)
{
    (void)state;
    static const char grid[] = "dimension = 2; spacing = 0.05; offset = [0.025, 0.025]; horizon = 0.3;",
                      strained[] = "from = [-0.75, -0.5]; to = [0.75, 0.5]; x = 0; x_gradient = [0.01, 0.002]; y = 0;";
    write_plate(1.5, 1.0, 0.05);
    const double want = strain_energy(grid, "from = [-0.75, -0.5]; to = [0.75, 0.5];", strained);
    const double shared = strain_energy(grid, "shape = \"mesh\"; file = \"plate.msh\";", strained);
    const double voronoi =
        strain_energy(grid, "shape = \"mesh\"; file = \"plate.msh\"; volumes = \"voronoi\";", strained);
    CHECK_NEAR(shared, want, 0.01 * want);
    CHECK_NEAR(voronoi, want, 0.01 * want);
}

// A cube whose tetrahedra have the corners of cubic cells: its nodes, listed with the Voronoi cells that these have, are the same.
static void a_cube_of_tetrahedra_is_that_of_its_nodes(void **state)
{
    (void)state;
    static const char grid[] = "dimension = 3; spacing = 1.0; horizon = 3.0;",
                      strained[] =
                          "from = [0, 0, 0]; to = [5, 5, 5]; x = 0; x_gradient = [0.01, 0.0, 0.0]; y = 0; z = 0;";
    pdmc_mesh mesh;
    cube_create(5, &mesh);
    write_msh("cube.msh", &mesh, false);
    FILE *nodes = fopen("nodes.txt", "w");
    assert_non_null(nodes);
    for (int i = 0; i < mesh.node_count; i++) {
        const double *x = &mesh.x[3 * i];
        double cell = 1.0;
        for (int a = 0; a < 3; a++) cell *= x[a] == 0.0 || x[a] == 5.0 ? 0.5 : 1.0;
        fprintf(nodes, "%g %g %g %g\n", x[0], x[1], x[2], cell);
    }
    assert_int_equal(fclose(nodes), 0);
    pdmc_mesh_clear(&mesh);
    const double want = strain_energy(grid, "shape = \"nodes\"; file = \"nodes.txt\";", strained);
    const double got = strain_energy(grid, "shape = \"mesh\"; file = \"cube.msh\"; volumes = \"voronoi\";", strained);
    CHECK_NEAR(got, want, 1e-12 * want);
}

// One end is moved: the kinetic energy grows by rho v^2 / 2 of what the wave reaches, 1 wide.
static double wave_speed(const char *body)
{
    char text[1024];
    pdmc_results r;
    snprintf(
        text, sizeof text,
        "kind = \"explicit\"; grid = { dimension = 2; spacing = 0.0625; offset = [0.03125, 0.03125]; horizon = 0.3; "
        "};\n" MATERIALS "bodies = ( { %s } ); time = { duration = 1.6; };\n"
        "conditions = ( { prescribed = \"velocity\"; from = [-1.5, -0.5]; to = [-1.2, 0.5]; x = 0.001; } );\n",
        body);
    run_text(text, 2, &r);
    const pdmc_explicit_record *p = &r.particles;
    const int last = p->record_count - 1, first = last / 2;
    const double speed = 2e6 * (p->kinetic[last] - p->kinetic[first]) / (p->time[last] - p->time[first]);
    pdmc_results_clear(&r);
    return speed;
}

static void a_wave_runs_as_on_a_grid(void **state)
{
    (void)state;
    write_plate(3.0, 1.0, 0.0625);
    const double want = wave_speed("from = [-1.5, -0.5]; to = [1.5, 0.5];");
    const double got = wave_speed("shape = \"mesh\"; file = \"plate.msh\"; volumes = \"voronoi\";");
    CHECK_NEAR(got, want, 0.02 * want); // with five nodes a horizon; they differ by 1.2 %
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_plate_has_the_energy_of_a_grid),
        cmocka_unit_test(a_cube_of_tetrahedra_is_that_of_its_nodes),
        cmocka_unit_test(a_wave_runs_as_on_a_grid),
    };
    return cmocka_run_group_tests(tests, enter_folder, leave_folder);
}
