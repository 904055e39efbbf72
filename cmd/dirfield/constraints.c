#include <float.h>
#include <math.h>
#include <string.h>

#include "base/text.h"
#include "dirfield.h"
#include "math/vector.h"
#include "surface/nearest.h"

#define WEIGHT_MAX 1e6

enum { VERTEX, X, Y, Z, DX, DY, DZ, WEIGHT, KEYS };

static const char *const key_names[KEYS] = {"vertex", "x", "y", "z", "dx", "dy", "dz", "weight"};
#define WANTED_COLUMNS "want vertex, or x y z, and dx dy dz weight"

struct header {
    int column_of[KEYS]; /* number of the key's column, or -1 */
    uint32_t columns;
};

/* The points that rows may name. */
struct targets {
    struct dirfield_job *jobs;
    uint32_t job_count;
    struct hatch_surface_groups *groups; /* per job: the points of each vertex, or of each position */
    struct hatch_surface_points *points; /* per job that the scene shows; NULL when rows name vertices */
    uint64_t vertices;                   /* as for dirfield_read_constraints */
};

static enum hatch_status parse_header(struct hatch_text line, struct header *header, struct hatch_err *err)
{
    struct hatch_text field;
    for (int k = 0; k < KEYS; k++)
        header->column_of[k] = -1;
    for (header->columns = 0; hatch_text_field(&line, &field); header->columns++) {
        int key = 0;
        while (key < KEYS && !hatch_text_is(field, key_names[key]))
            key++;
        if (key == KEYS || header->column_of[key] >= 0)
            return hatch_fail(err, HATCH_BAD_INPUT, "header: '%.*s' %s", (int)(field.length < 40 ? field.length : 40),
                              field.at, key == KEYS ? "is not a column; " WANTED_COLUMNS : "appears twice");
        header->column_of[key] = (int)header->columns;
    }
    bool by_vertex = header->column_of[VERTEX] >= 0;
    for (int k = 0; k < KEYS; k++) {
        bool wanted = k == VERTEX ? by_vertex : k > Z || !by_vertex;
        if (wanted != (header->column_of[k] >= 0))
            return hatch_fail(err, HATCH_BAD_INPUT, "header: %s '%s'; " WANTED_COLUMNS,
                              wanted ? "no column" : "'vertex' cannot be combined with", key_names[k]);
    }
    return HATCH_OK;
}

static enum hatch_status parse_row(struct hatch_text line, const struct header *header, uint32_t row,
                                   double values[KEYS], struct hatch_err *err)
{
    struct hatch_text field;
    uint32_t column = 0;
    for (; hatch_text_field(&line, &field); column++)
        for (int k = 0; k < KEYS; k++)
            if (header->column_of[k] == (int)column && !hatch_text_number(field, &values[k]))
                return hatch_fail(err, HATCH_BAD_INPUT, "line %u: %s '%.*s' is not a number", row, key_names[k],
                                  (int)(field.length < 40 ? field.length : 40), field.at);
    if (column != header->columns)
        return hatch_fail(err, HATCH_BAD_INPUT, "line %u: %u %s, want %u", row, column,
                          cmd_plural(column, "field", "fields"), header->columns);
    if (!(values[WEIGHT] > 0 && values[WEIGHT] <= WEIGHT_MAX))
        return hatch_fail(err, HATCH_BAD_INPUT, "line %u: weight %g, want over 0 and at most %g", row, values[WEIGHT],
                          WEIGHT_MAX);
    for (int k = X; k <= Z; k++)
        if (!(fabs(values[k]) <= FLT_MAX))
            return hatch_fail(err, HATCH_BAD_INPUT, "line %u: %s %g, want at most %g, the largest coordinate of a mesh",
                              row, key_names[k], values[k], FLT_MAX);
    double largest = fmax(fmax(fabs(values[DX]), fabs(values[DY])), fabs(values[DZ]));
    if (!(largest > 0))
        return hatch_fail(err, HATCH_BAD_INPUT, "line %u: the direction dx dy dz must not be zero", row);
    for (int k = DX; k <= DZ; k++)
        values[k] /= largest; /* squares of lengths neither overflow nor vanish */
    return HATCH_OK;
}

uint32_t dirfield_vertex_count(const struct hatch_scene_mesh *mesh)
{
    return mesh->numbers ? mesh->numbers_end : mesh->file_vertices;
}

/* Finds the points of a vertex.
 *   job      out: number of the job
 *   vertex   in: in the file; out: in the mesh of the job */
static enum hatch_status find_vertex(const struct targets *targets, double number, uint32_t row, uint32_t *job,
                                     uint32_t *vertex, struct hatch_err *err)
{
    const double end = (double)targets->vertices;
    for (*job = 0; *job < targets->job_count; ++*job) {
        const struct hatch_scene_mesh *mesh = targets->jobs[*job].mesh;
        double first = (double)mesh->file_first;
        if (number >= first && number < first + dirfield_vertex_count(mesh) && number == floor(number)) {
            const uint32_t *points = targets->groups[*job].first;
            *vertex = (uint32_t)(number - first);
            if (points[*vertex] < points[*vertex + 1])
                return HATCH_OK;
            break;
        }
    }
    if (number >= 0 && number < end && number == floor(number))
        return hatch_fail(err, HATCH_BAD_INPUT, "line %u: no face uses vertex %.0f", row, number);
    return hatch_fail(err, HATCH_BAD_INPUT, "line %u: vertex %.10g, want a whole number from 0 to %.0f", row, number,
                      end - 1);
}

/* A search for the point of a posed mesh that is nearest in the scene. */
struct search {
    const struct hatch_surface *surface;
    const struct dirfield_pose *pose;
    const double *position; /* in the scene */
    double least_scale;
};

static double distance_in_scene(const struct search *search, uint32_t point)
{
    double at[3], in_scene[3];
    hatch_surface_position(search->surface, point, at);
    dirfield_to_scene(search->pose, at, in_scene);
    return hatch_vec_distance(in_scene, search->position);
}

/* In mesh units where the pose stretches least: the tree has the positions of the mesh. */
static double distance_in_tree(const void *context, uint32_t point)
{
    const struct search *search = context;
    return distance_in_scene(search, point) / search->least_scale;
}

/* Returns the distance in the scene from a position to the nearest point of a posed mesh; INFINITY when the pose is
 * singular.
 *   point  out: the point of the surface */
static double distance(const struct hatch_surface_points *points, const struct dirfield_pose *pose,
                       const double position[3], uint32_t *point)
{
    const struct search search = {points->surface, pose, position, dirfield_least_scale(pose)};
    double offset[3], local[3];
    hatch_vec_sub(position, pose->offset, offset);
    if (!(search.least_scale > 0) || !dirfield_to_mesh(pose, offset, local))
        return INFINITY;
    *point = dirfield_is_similarity(pose) ? hatch_surface_nearest(points, local)
                                          : hatch_point_tree_nearest(&points->tree, local, distance_in_tree, &search);
    return *point == HATCH_POINT_NONE ? INFINITY : distance_in_scene(&search, *point);
}

/* Finds the nearest point of all posed meshes. Returns false when there is none. */
static bool find_nearest(const struct targets *targets, const double position[3], uint32_t *job,
                         const struct dirfield_pose **pose, uint32_t *point)
{
    double least = INFINITY;
    for (uint32_t i = 0; i < targets->job_count; i++)
        for (uint32_t k = 0; k < targets->jobs[i].pose_count; k++) {
            uint32_t candidate = 0;
            double length = distance(&targets->points[i], &targets->jobs[i].poses[k], position, &candidate);
            if (!(length < least))
                continue;
            least = length;
            *job = i;
            *pose = &targets->jobs[i].poses[k];
            *point = candidate;
        }
    return least < INFINITY;
}

/* Appends a constraint. If a point has several, the last one counts, because constrain() in solve.c applies them in
 * this order. */
static enum hatch_status add(struct cmd_args *args, struct dirfield_job *job, struct dirfield_constraint constraint,
                             struct hatch_err *err)
{
    uint32_t count = job->constraint_count;
    if ((count & (count - 1)) == 0) { /* full: 0, 1, 2, 4, 8 ... */
        struct dirfield_constraint *grown;
        HATCH_TRY(HATCH_ALLOC(&args->keep, &grown, count ? 2 * (size_t)count : 1, err));
        if (count)
            memcpy(grown, job->constraints, count * sizeof *grown);
        job->constraints = grown;
    }
    job->constraints[job->constraint_count++] = constraint;
    return HATCH_OK;
}

static enum hatch_status add_row(struct cmd_args *args, const struct targets *targets, const double values[KEYS],
                                 uint32_t row, struct hatch_err *err)
{
    uint32_t job = 0, at = 0;
    const struct dirfield_pose *pose = NULL;
    struct dirfield_constraint made = {.line = row, .weight = values[WEIGHT]};
    hatch_vec_copy(&values[DX], made.direction);
    if (!targets->points) {
        HATCH_TRY(find_vertex(targets, values[VERTEX], row, &job, &at, err));
    } else {
        if (!find_nearest(targets, &values[X], &job, &pose, &at))
            return hatch_fail(
                err, HATCH_BAD_INPUT,
                "line %u: no node of the scene shows a mesh in its size; use the column vertex instead of x y z", row);
        made.pose = pose;
        at = targets->groups[job].group[at];
    }
    made.points = &targets->groups[job].points[targets->groups[job].first[at]];
    made.point_count = targets->groups[job].first[at + 1] - targets->groups[job].first[at];
    return add(args, &targets->jobs[job], made, err);
}

static enum hatch_status map_vertices(struct cmd_args *args, struct targets *targets, struct hatch_err *err)
{
    HATCH_TRY(HATCH_ALLOC(&args->scratch, &targets->groups, targets->job_count, err));
    for (uint32_t i = 0; i < targets->job_count; i++) {
        const struct hatch_scene_mesh *mesh = targets->jobs[i].mesh;
        HATCH_TRY(hatch_surface_group_points(targets->jobs[i].surface, mesh->numbers, dirfield_vertex_count(mesh),
                                             &args->keep, &targets->groups[i], err));
    }
    return HATCH_OK;
}

static enum hatch_status index_points(struct cmd_args *args, struct targets *targets, struct hatch_err *err)
{
    HATCH_TRY(HATCH_ALLOC(&args->scratch, &targets->points, targets->job_count, err));
    HATCH_TRY(HATCH_ALLOC(&args->scratch, &targets->groups, targets->job_count, err));
    for (uint32_t i = 0; i < targets->job_count; i++) {
        const struct dirfield_job *job = &targets->jobs[i];
        const struct hatch_mesh *mesh = &job->mesh->mesh;
        uint32_t *position_of, positions;
        if (job->pose_count == 0)
            continue;
        HATCH_TRY(hatch_surface_points_make(job->surface, &args->scratch, &targets->points[i], err));
        HATCH_TRY(HATCH_ALLOC_UNSET(&args->scratch, &position_of, mesh->vertex_count, err));
        HATCH_TRY(hatch_mesh_weld(mesh, &args->scratch, position_of, &positions, err));
        HATCH_TRY(
            hatch_surface_group_points(job->surface, position_of, positions, &args->keep, &targets->groups[i], err));
    }
    return HATCH_OK;
}

static enum hatch_status parse(struct cmd_args *args, struct hatch_bytes text, struct targets *targets,
                               struct hatch_err *err)
{
    struct hatch_text rest = hatch_text_of(text), line;
    struct header header = {.columns = 0};
    for (uint32_t row = 1; hatch_text_line(&rest, &line); row++) {
        double values[KEYS] = {0};
        if (line.length == 0 || line.at[0] == '#')
            continue;
        if (header.columns == 0) {
            HATCH_TRY(parse_header(line, &header, err));
            if (header.column_of[VERTEX] >= 0 && targets->vertices == 0)
                return hatch_fail(
                    err, HATCH_BAD_INPUT,
                    "line %u: --needs gives vertices other numbers: use x y z instead of the column vertex", row);
            HATCH_TRY((header.column_of[VERTEX] >= 0 ? map_vertices : index_points)(args, targets, err));
            continue;
        }
        HATCH_TRY(parse_row(line, &header, row, values, err));
        HATCH_TRY(add_row(args, targets, values, row, err));
    }
    return header.columns ? HATCH_OK : hatch_fail(err, HATCH_BAD_INPUT, "no header line; " WANTED_COLUMNS);
}

void dirfield_read_constraints(struct cmd_args *args, const char *path, uint64_t vertices, struct dirfield_job *jobs,
                               uint32_t count)
{
    struct hatch_err err;
    struct targets targets = {.jobs = jobs, .job_count = count, .vertices = vertices};
    struct hatch_arena_mark mark = hatch_arena_mark(&args->scratch);
    cmd_check(parse(args, cmd_read(args, path), &targets, &err), cmd_input_name(path), &err);
    hatch_arena_rewind(&args->scratch, mark);
}
