/* The lists of wedges, points and faces, from the meshes. */
#include <math.h>
#include <string.h>

#include "base/keys.h"
#include "coarse/work.h"
#include "math/vector.h"

#define LARGE_TOLERANCES 4 /* edge length in tolerances above which a face is large */

/* Joins the positions of all parts in one mesh, to weld them. */
static enum hatch_status join_positions(const struct hatch_coarse_work *work, struct hatch_arena *scratch,
                                        struct hatch_mesh *joined, struct hatch_err *err)
{
    HATCH_TRY(hatch_mesh_make(scratch, work->wedge_count, work->face_count, joined, err));
    for (uint32_t part = 0; part < work->part_count; part++) {
        const struct hatch_mesh *mesh = work->parts[part].mesh;
        memcpy(&joined->attributes[0].data[3 * (size_t)work->first_wedge[part]], mesh->attributes[0].data,
               3 * (size_t)mesh->vertex_count * sizeof(float));
        for (size_t i = 0; i < 3 * (size_t)mesh->face_count; i++)
            joined->indices[3 * (size_t)work->first_face[part] + i] = work->first_wedge[part] + mesh->indices[i];
    }
    return HATCH_OK;
}

/* Numbers the vertices of a mesh so that those with the same point and equal attributes have the same number.
 *   number  in: the point of each vertex; out: from 0 in order of appearance */
static enum hatch_status number_equal(const struct hatch_mesh *mesh, struct hatch_arena *scratch, uint32_t *number,
                                      struct hatch_err *err)
{
    enum hatch_status status = HATCH_OK;
    for (uint32_t a = 0; a < mesh->attribute_count; a++) {
        const struct hatch_mesh_attribute *attribute = &mesh->attributes[a];
        for (uint32_t c = a == 0 ? 2 : 0; c < attribute->components && status == HATCH_OK; c++) {
            struct hatch_arena_mark mark = hatch_arena_mark(scratch);
            struct hatch_keys keys;
            status = hatch_keys_make(scratch, &keys, err);
            for (uint32_t v = 0; v < mesh->vertex_count && status == HATCH_OK; v++) {
                float value = a == 0 ? 0 : attribute->data[(size_t)attribute->components * v + c] + 0.0f; /* no -0 */
                uint32_t bits;
                memcpy(&bits, &value, sizeof bits);
                status = hatch_keys_number(&keys, (uint64_t)number[v] << 32 | bits, &number[v], err);
            }
            hatch_arena_rewind(scratch, mark);
        }
    }
    return status;
}

/* Finds the wedge of each vertex of a part: the first vertex that equals it.
 *   wedge  out: per vertex */
static enum hatch_status find_wedges(const struct hatch_coarse_work *work, uint32_t part, struct hatch_arena *scratch,
                                     uint32_t *wedge, struct hatch_err *err)
{
    const struct hatch_mesh *mesh = work->parts[part].mesh;
    uint32_t *number, *representative;
    HATCH_TRY(HATCH_ALLOC(scratch, &number, mesh->vertex_count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &representative, mesh->vertex_count, err));
    memcpy(number, &work->point_of[work->first_wedge[part]], mesh->vertex_count * sizeof *number);
    HATCH_TRY(number_equal(mesh, scratch, number, err));
    memset(representative, 0xff, mesh->vertex_count * sizeof *representative);
    for (uint32_t v = 0; v < mesh->vertex_count; v++) {
        if (representative[number[v]] == HATCH_COARSE_NONE)
            representative[number[v]] = v;
        wedge[v] = work->first_wedge[part] + representative[number[v]];
    }
    return HATCH_OK;
}

/* Lists the faces of a part; those with a repeated point are left out. */
static void add_faces(struct hatch_coarse_work *work, uint32_t part, const uint32_t *wedge)
{
    const struct hatch_mesh *mesh = work->parts[part].mesh;
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        uint32_t face = work->first_face[part] + f, points[3];
        work->part_of[face] = part;
        for (uint32_t c = 0; c < 3; c++) {
            work->corner[3 * face + c] = wedge[mesh->indices[3 * f + c]];
            points[c] = hatch_coarse_corner_point(work, 3 * face + c);
        }
        if (points[0] == points[1] || points[1] == points[2] || points[2] == points[0]) {
            work->corner[3 * face] = HATCH_COARSE_NONE;
            continue;
        }
        for (uint32_t c = 0; c < 3; c++) {
            work->next[3 * face + c] = work->first[points[c]];
            work->first[points[c]] = 3 * face + c;
        }
    }
}

/* Sets positions and tolerances of points. */
static void place_points(struct hatch_coarse_work *work, const struct hatch_mesh *joined)
{
    float low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
    hatch_mesh_bounds(joined, low, high);
    for (size_t k = 0; k < 3; k++)
        work->middle[k] = ((double)low[k] + (double)high[k]) / 2;
    for (uint32_t p = 0; p < work->point_count; p++)
        work->tolerance[p] = INFINITY;
    for (uint32_t part = 0; part < work->part_count; part++)
        for (uint32_t v = 0; v < work->parts[part].mesh->vertex_count; v++) {
            size_t wedge = work->first_wedge[part] + v, point = work->point_of[wedge];
            for (size_t k = 0; k < 3; k++)
                work->at[3 * point + k] = (double)joined->attributes[0].data[3 * wedge + k] - work->middle[k];
            work->tolerance[point] = fmin(work->tolerance[point], work->parts[part].tolerance[v]);
        }
}

static enum hatch_status allocate(struct hatch_coarse_work *work, struct hatch_arena *arena, struct hatch_err *err)
{
    size_t wedges = work->wedge_count, faces = work->face_count;
    HATCH_TRY(HATCH_ALLOC(arena, &work->corner, 3 * faces, err));
    HATCH_TRY(HATCH_ALLOC(arena, &work->next, 3 * faces, err));
    HATCH_TRY(HATCH_ALLOC(arena, &work->part_of, faces, err));
    HATCH_TRY(HATCH_ALLOC(arena, &work->first_sample, faces, err));
    HATCH_TRY(HATCH_ALLOC(arena, &work->point_of, wedges, err));
    HATCH_TRY(HATCH_ALLOC(arena, &work->line, 2 * wedges, err));
    memset(work->first_sample, 0xff, faces * sizeof *work->first_sample);
    memset(work->line, 0xff, 2 * wedges * sizeof *work->line);
    return HATCH_OK;
}

static enum hatch_status allocate_points(struct hatch_coarse_work *work, struct hatch_arena *arena,
                                         struct hatch_err *err)
{
    size_t points = work->point_count;
    HATCH_TRY(HATCH_ALLOC(arena, &work->at, 3 * points, err));
    HATCH_TRY(HATCH_ALLOC(arena, &work->tolerance, points, err));
    HATCH_TRY(HATCH_ALLOC(arena, &work->first, points, err));
    HATCH_TRY(HATCH_ALLOC(arena, &work->quadric, points, err));
    HATCH_TRY(HATCH_ALLOC(arena, &work->target, points, err));
    memset(work->first, 0xff, points * sizeof *work->first);
    return hatch_coarse_queue_make(work->point_count, arena, &work->queue, err);
}

/* Returns whether the centre of a face must be a sample: the distance of its corners from the surface tells little
 * about it where they are far apart. */
static bool is_large(const struct hatch_coarse_work *work, uint32_t face)
{
    double longest = 0, tolerance = INFINITY;
    for (uint32_t c = 0; c < 3; c++) {
        size_t a = hatch_coarse_corner_point(work, 3 * face + c),
               b = hatch_coarse_corner_point(work, 3 * face + (c + 1) % 3);
        longest = fmax(longest, hatch_vec_distance(&work->at[3 * a], &work->at[3 * b]));
        tolerance = fmin(tolerance, work->tolerance[a]);
    }
    return longest > LARGE_TOLERANCES * tolerance;
}

/* Makes the lists of samples, which hold the centres of large faces. */
static enum hatch_status add_centers(struct hatch_coarse_work *work, struct hatch_arena *arena, struct hatch_err *err)
{
    uint32_t count = 0;
    for (uint32_t f = 0; f < work->face_count; f++)
        count += work->corner[3 * f] != HATCH_COARSE_NONE && is_large(work, f);
    work->sample_count = work->wedge_count + count;
    HATCH_TRY(HATCH_ALLOC(arena, &work->next_sample, work->sample_count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &work->choice, work->sample_count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &work->center_of, count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &work->full_corner, 3 * (size_t)work->face_count, err));
    memcpy(work->full_corner, work->corner, 3 * (size_t)work->face_count * sizeof *work->corner);
    count = 0;
    for (uint32_t f = 0; f < work->face_count; f++)
        if (work->corner[3 * f] != HATCH_COARSE_NONE && is_large(work, f)) {
            work->center_of[count] = f;
            work->first_sample[f] = work->wedge_count + count;
            work->next_sample[work->wedge_count + count++] = HATCH_COARSE_NONE;
        }
    return HATCH_OK;
}

static enum hatch_status count(struct hatch_coarse_work *work, struct hatch_arena *arena, struct hatch_err *err)
{
    uint64_t vertices = 0, faces = 0;
    HATCH_TRY(HATCH_ALLOC(arena, &work->first_wedge, work->part_count + 1, err));
    HATCH_TRY(HATCH_ALLOC(arena, &work->first_face, work->part_count + 1, err));
    for (uint32_t part = 0; part < work->part_count; part++) {
        vertices += work->parts[part].mesh->vertex_count;
        faces += work->parts[part].mesh->face_count;
        if (vertices > UINT32_MAX / 4 || faces > UINT32_MAX / 4)
            return hatch_fail(err, HATCH_LIMIT, "%llu faces of one mesh are too many", (unsigned long long)faces);
        work->first_wedge[part + 1] = (uint32_t)vertices;
        work->first_face[part + 1] = (uint32_t)faces;
    }
    work->wedge_count = (uint32_t)vertices;
    work->face_count = (uint32_t)faces;
    return HATCH_OK;
}

enum hatch_status hatch_coarse_load(const struct hatch_coarse_part *parts, uint32_t part_count,
                                    struct hatch_arena *arena, struct hatch_arena *scratch,
                                    struct hatch_coarse_work *work, struct hatch_err *err)
{
    struct hatch_coarse_work made = {.parts = parts, .part_count = part_count};
    struct hatch_mesh joined;
    HATCH_TRY(count(&made, arena, err));
    HATCH_TRY(allocate(&made, arena, err));
    HATCH_TRY(join_positions(&made, scratch, &joined, err));
    HATCH_TRY(hatch_nearest_make(&joined, arena, scratch, &made.full, err));
    HATCH_TRY(hatch_mesh_weld(&joined, scratch, made.point_of, &made.point_count, err));
    HATCH_TRY(allocate_points(&made, arena, err));
    place_points(&made, &joined);
    for (uint32_t part = 0; part < part_count; part++) {
        uint32_t *wedge;
        HATCH_TRY(HATCH_ALLOC(scratch, &wedge, parts[part].mesh->vertex_count, err));
        HATCH_TRY(find_wedges(&made, part, scratch, wedge, err));
        add_faces(&made, part, wedge);
    }
    HATCH_TRY(add_centers(&made, arena, err));
    HATCH_TRY(hatch_coarse_checks_make(&made, arena, err));
    *work = made;
    return HATCH_OK;
}
