/* --report: a table with a row for each mesh, each component, each singularity, and one for all meshes together. */
#include <math.h>
#include <string.h>

#include "dirfield.h"
#include "math/vector.h"

enum {
    KIND,
    MESH,
    COMPONENT,
    POINTS,
    FACES,
    BORDERS,
    EULER,
    INDEX_SUM,
    SINGULARITIES,
    INDEX,
    X,
    Y,
    Z,
    CONFIDENCE,
    SMOOTHNESS = CONFIDENCE + 3,
    DISAGREEMENT,
    ENERGY,
    ITERATIONS,
    RESIDUAL,
    TIMES,
    COLUMNS = TIMES + PHASE_COUNT
};

/* clang-format off */
static const char *const columns[COLUMNS + 1] = {
    "kind",           "mesh",         "component",      "points",         "faces",
    "border_loops",   "euler",        "index_sum",      "singularities",  "index",
    "x",              "y",            "z",              "confidence_p25", "confidence_p50",
    "confidence_p75", "smoothness",   "disagreement",   "energy",         "iterations",
    "residual",       "surfaces_ms",  "frames_ms",      "curvature_ms",   "field_ms",
    NULL};
/* clang-format on */

_Static_assert(COLUMNS <= DIRFIELD_REPORT_COLUMNS, "DIRFIELD_REPORT_COLUMNS is too small");

void dirfield_report_begin(struct dirfield_report *report, struct cmd_args *args, uint32_t points)
{
    struct hatch_err err;
    *report = (struct dirfield_report){.args = args};
    cmd_report_begin(&report->table, args, columns);
    cmd_check(HATCH_ALLOC(&args->keep, &report->confidence, points, &err), NULL, &err);
}

/* Columns that do not apply to the kind of row stay NaN. */
static void begin_row(double row[COLUMNS])
{
    for (int i = 0; i < COLUMNS; i++)
        row[i] = NAN;
}

static void put_row(struct dirfield_report *report, const char *kind, const double row[COLUMNS])
{
    cmd_report_text(&report->table, kind);
    for (int i = KIND + 1; i < COLUMNS; i++)
        cmd_report_number(&report->table, row[i]);
}

static void put_quartiles(struct hatch_weighted *values, uint32_t count, double row[COLUMNS])
{
    static const double quartiles[3] = {0.25, 0.5, 0.75};
    hatch_percentiles(values, count, quartiles, 3, &row[CONFIDENCE]);
}

/* Appends the confidence of a component's points. */
static struct hatch_weighted *add_confidence(struct dirfield_report *report, const struct dirfield_job *job,
                                             const struct hatch_component *component)
{
    struct hatch_weighted *values = &report->confidence[report->points];
    for (uint32_t i = 0; i < component->point_count; i++)
        values[i] = (struct hatch_weighted){job->field.confidence[component->first_point + i], 1};
    report->points += component->point_count;
    return values;
}

static uint32_t component_of_face(const struct hatch_surface *surface, uint32_t face)
{
    return surface->point_component[surface->corners[3 * (size_t)face]];
}

static void put_component(struct dirfield_report *report, const struct dirfield_job *job, uint32_t c,
                          uint32_t singularities)
{
    const struct hatch_component *component = &job->surface->components[c];
    double row[COLUMNS];
    begin_row(row);
    row[MESH] = job->number;
    row[COMPONENT] = c;
    row[POINTS] = component->point_count;
    row[FACES] = component->face_count;
    row[BORDERS] = component->border_loops;
    row[EULER] = component->euler;
    row[INDEX_SUM] = job->singular.component_half_turns[c] / 2.0;
    row[SINGULARITIES] = singularities;
    put_quartiles(add_confidence(report, job, component), component->point_count, row);
    put_row(report, "component", row);
    for (int i = POINTS; i <= SINGULARITIES; i++)
        report->all[i] += row[i];
}

static void put_singularity(struct dirfield_report *report, const struct dirfield_job *job, uint32_t i)
{
    uint32_t face = job->singular.faces[i];
    double row[COLUMNS], corner[3], middle[3] = {0, 0, 0};
    begin_row(row);
    row[MESH] = job->number;
    row[COMPONENT] = component_of_face(job->surface, face);
    row[INDEX] = job->singular.half_turns[i] / 2.0;
    for (size_t c = 0; c < 3; c++) {
        hatch_surface_position(job->surface, job->surface->corners[3 * (size_t)face + c], corner);
        hatch_vec_add_scaled(middle, 1.0 / 3, corner, middle);
    }
    if (job->pose_count > 0)
        dirfield_to_scene(&job->poses[0], middle, &row[X]);
    else
        hatch_vec_copy(middle, &row[X]);
    put_row(report, "singularity", row);
}

static void put_mesh(struct dirfield_report *report, const struct dirfield_job *job)
{
    double row[COLUMNS], *all = report->all;
    begin_row(row);
    row[MESH] = job->number;
    row[POINTS] = job->surface->point_count;
    row[FACES] = job->surface->face_count;
    row[SINGULARITIES] = job->singular.count;
    all[SMOOTHNESS] += row[SMOOTHNESS] = job->field.energy[0];
    all[DISAGREEMENT] += row[DISAGREEMENT] = job->field.energy[1];
    all[ENERGY] += row[ENERGY] = job->field.solution_energy;
    row[ITERATIONS] = job->field.iterations;
    row[RESIDUAL] = job->field.residual;
    all[ITERATIONS] = fmax(all[ITERATIONS], row[ITERATIONS]);
    all[RESIDUAL] = fmax(all[RESIDUAL], row[RESIDUAL]);
    for (int phase = PHASE_FRAMES; phase < PHASE_COUNT; phase++)
        all[TIMES + phase] += row[TIMES + phase] = job->ms[phase];
    put_row(report, "mesh", row);
}

/* Singularities are sorted by face, and faces by component. */
void dirfield_report_add(struct dirfield_report *report, const struct dirfield_job *job)
{
    uint32_t first = 0;
    put_mesh(report, job);
    for (uint32_t c = 0; c < job->surface->component_count; c++) {
        uint32_t end = first;
        while (end < job->singular.count && component_of_face(job->surface, job->singular.faces[end]) == c)
            end++;
        put_component(report, job, c, end - first);
        for (; first < end; first++)
            put_singularity(report, job, first);
    }
}

struct hatch_bytes dirfield_report_end(struct dirfield_report *report, double surfaces_ms)
{
    double row[COLUMNS];
    memcpy(row, report->all, sizeof row);
    row[MESH] = row[COMPONENT] = row[INDEX] = row[X] = row[Y] = row[Z] = NAN;
    row[TIMES + PHASE_SURFACES] = surfaces_ms;
    put_quartiles(report->confidence, report->points, row);
    put_row(report, "all", row);
    return cmd_report_end(&report->table);
}
