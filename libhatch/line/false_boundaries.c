/* Finds boundaries within other faces. Quadrangles are sometimes stored as overlapping triangles. A diagonal is then
 * the side of one triangle only, but it is not a boundary of the surface. */
#include <math.h>

#include "math/vector.h"
#include "line/prune.h"

#define FLAT 0.01   /* sine of the largest angle between an edge and a face that contains it */
#define WITHIN 0.02 /* sine of the least angle between an edge and the sides of a face that contains it */
/* Largest number of corners at a point for which edges there are tested: quadrangles have fewer, and each edge would
 * test all of them. */
#define CORNERS_MAX 1000u

/* Face corners by point: those at point p are corners[first[p]] .. corners[first[p + 1] - 1]. */
struct around {
    uint32_t *first, *corners;
};

static enum hatch_status list_around(const struct hatch_line_edges *edges, uint32_t corner_count,
                                     struct hatch_arena *scratch, struct around *around, struct hatch_err *err)
{
    HATCH_TRY(HATCH_ALLOC(scratch, &around->first, (size_t)edges->point_count + 2, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &around->corners, corner_count, err));
    for (uint32_t i = 0; i < corner_count; i++)
        around->first[edges->point[i] + 2]++;
    for (uint32_t p = 0; p < edges->point_count; p++)
        around->first[p + 2] += around->first[p + 1];
    for (uint32_t i = 0; i < corner_count; i++)
        around->corners[around->first[edges->point[i] + 1]++] = i;
    return HATCH_OK;
}

/* Returns whether a direction from a corner of a face points into the face. */
static bool runs_within(const struct hatch_mesh *mesh, uint32_t corner, const double direction[3])
{
    double p[3][3], sides[2][3], normal[3], cross[2][3];
    uint32_t c = corner % 3;
    if (!hatch_mesh_corners(mesh, corner / 3, p))
        return false;
    hatch_vec_sub(p[(c + 1) % 3], p[c], sides[0]);
    hatch_vec_sub(p[(c + 2) % 3], p[c], sides[1]);
    hatch_vec_normalize(sides[0]);
    hatch_vec_normalize(sides[1]);
    hatch_vec_cross(sides[0], sides[1], normal);
    hatch_vec_normalize(normal);
    hatch_vec_cross(sides[0], direction, cross[0]);
    hatch_vec_cross(direction, sides[1], cross[1]);
    return fabs(hatch_vec_dot(direction, normal)) < FLAT && hatch_vec_dot(cross[0], normal) > WITHIN &&
           hatch_vec_dot(cross[1], normal) > WITHIN;
}

/* Returns whether a face around corner `from` contains the start of the edge to corner `to`. */
static bool covered_from(const struct hatch_mesh *mesh, const struct hatch_line_edges *edges,
                         const struct around *around, uint32_t from, uint32_t to)
{
    const float *positions = mesh->attributes[0].data;
    double a[3], b[3], direction[3];
    hatch_vec_of(&positions[3 * (size_t)mesh->indices[from]], a);
    hatch_vec_of(&positions[3 * (size_t)mesh->indices[to]], b);
    hatch_vec_sub(b, a, direction);
    hatch_vec_normalize(direction);
    uint32_t point = edges->point[from];
    if (around->first[point + 1] - around->first[point] > CORNERS_MAX)
        return false;
    for (uint32_t i = around->first[point]; i < around->first[point + 1]; i++)
        if (runs_within(mesh, around->corners[i], direction))
            return true;
    return false;
}

enum hatch_status hatch_line_drop_covered(const struct hatch_mesh *mesh, struct hatch_arena *scratch,
                                          struct hatch_line_edges *edges, struct hatch_err *err)
{
    uint32_t e = 0;
    while (e < edges->edges.count && edges->kinds[e] != HATCH_EDGE_BOUNDARY)
        e++;
    if (e == edges->edges.count)
        return HATCH_OK;
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct around around;
    enum hatch_status status = list_around(edges, 3 * mesh->face_count, scratch, &around, err);
    for (; e < edges->edges.count && status == HATCH_OK; e++) {
        uint32_t begin = edges->edges.sides[edges->edges.first[e]], end = hatch_side_end(begin);
        if (edges->kinds[e] == HATCH_EDGE_BOUNDARY && covered_from(mesh, edges, &around, begin, end) &&
            covered_from(mesh, edges, &around, end, begin))
            edges->kinds[e] = HATCH_EDGE_SMOOTH;
    }
    hatch_arena_rewind(scratch, mark);
    return status;
}
