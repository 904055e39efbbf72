#include "vector/project.h"

#include <stdlib.h>

#include "math/vector.h"
#include "vector/grid.h"

/* Computes the nearness of the plane through three points, as a function over the picture. Returns the orientation of
 * the points in the picture: over 0 counter-clockwise, 0 in one line.
 *   w  third homogeneous coordinates of the points */
static double plane_of(const struct hatch_occluders *occluders, const double p[3][3], double nearness[3])
{
    double normal[3];
    hatch_vec_triangle(p[0], p[1], p[2], normal);
    if (occluders->view.orthographic) {
        for (int k = 0; k < 2; k++)
            nearness[k] = normal[k] / normal[2];
        nearness[2] = -hatch_vec_dot(normal, p[0]) / normal[2];
        return normal[2];
    }
    double volume = hatch_vec_dot(normal, p[0]);
    for (int k = 0; k < 3; k++)
        nearness[k] = normal[k] / volume;
    return volume;
}

/* Computes an occluder from its corners. Returns its facing: 0 if it covers nothing. */
static int make_occluder(const struct hatch_occluders *occluders, const double p[3][3], struct hatch_occluder *made)
{
    bool flat = occluders->view.orthographic;
    double turn = plane_of(occluders, p, made->nearness);
    double sign = turn < 0 ? -1 : 1;
    made->nearest = -INFINITY;
    bool finite = isfinite(made->nearness[0]) && isfinite(made->nearness[1]) && isfinite(made->nearness[2]);
    for (int c = 0; c < 3; c++) {
        const double *a = p[c], *b = p[(c + 1) % 3];
        const double from[3] = {a[0], a[1], flat ? 1 : a[2]}, to[3] = {b[0], b[1], flat ? 1 : b[2]};
        hatch_vec_cross(from, to, made->sides[c]);
        double size = sqrt(made->sides[c][0] * made->sides[c][0] + made->sides[c][1] * made->sides[c][1]);
        finite = finite && size > 0;
        for (int k = 0; k < 3; k++)
            made->sides[c][k] *= sign / size;
        made->nearest = fmax(made->nearest, hatch_occluders_nearness(occluders, a[2]));
    }
    made->nearest = fmin(made->nearest, occluders->nearest);
    return !finite || !(fabs(turn) > 0) ? 0 : turn > 0 ? 1 : -1;
}

static enum hatch_status allocate(const struct hatch_unit_scene *scene, struct hatch_arena *arena,
                                  struct hatch_occluders *made, struct hatch_err *err)
{
    uint64_t faces = 0, vertices = 0;
    HATCH_TRY(HATCH_ALLOC(arena, &made->first_face, (size_t)scene->item_count + 1, err));
    for (uint32_t i = 0; i < scene->item_count; i++) {
        const struct hatch_mesh *surface = scene->meshes[scene->items[i].mesh].surface;
        made->first_face[i] = (uint32_t)faces;
        faces += surface->face_count;
        vertices += surface->vertex_count;
    }
    if (faces >= UINT32_MAX || vertices >= UINT32_MAX)
        return hatch_fail(err, HATCH_LIMIT, "the scene has too many faces: %llu", (unsigned long long)faces);
    made->first_face[scene->item_count] = (uint32_t)faces;
    HATCH_TRY(HATCH_ALLOC(arena, &made->corners, 3 * faces, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made->facing, faces, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made->points, 3 * vertices, err));
    return HATCH_ALLOC(arena, &made->at, faces, err);
}

/* Adds the occluders of an item.
 *   base  number of its first vertex */
static void add_item(const struct hatch_unit_scene *scene, uint32_t index, uint32_t base, struct hatch_occluders *made)
{
    const struct hatch_item *item = &scene->items[index];
    const struct hatch_mesh *surface = scene->meshes[item->mesh].surface;
    double *points = &made->points[3 * (size_t)base];
    uint32_t first = made->first_face[index];
    hatch_item_surface(scene, item, points, NULL);
    for (size_t v = 0; v < surface->vertex_count; v++) {
        double at[3];
        hatch_vec_copy(&points[3 * v], at);
        hatch_occluders_project(made, at, &points[3 * v]);
    }
    for (uint32_t f = 0; f < surface->face_count; f++) {
        struct hatch_occluder *occluder = &made->at[made->count];
        double p[3][3];
        double farthest = 0;
        for (size_t c = 0; c < 3; c++) {
            uint32_t vertex = surface->indices[3 * (size_t)f + c];
            made->corners[3 * (size_t)(first + f) + c] = base + vertex;
            hatch_vec_copy(&points[3 * (size_t)vertex], p[c]);
            farthest = c ? fmax(farthest, p[c][2]) : p[c][2];
        }
        int facing = make_occluder(made, (const double(*)[3])p, occluder) * (item->mirrored ? -1 : 1);
        occluder->face = first + f;
        if (facing == 0 || item->cut_out || (facing < 0 && !item->double_sided) ||
            !(hatch_occluders_nearness(made, farthest) < made->nearest))
            continue;
        made->facing[first + f] = (int8_t)facing;
        made->count++;
    }
}

static int compare(const void *a, const void *b)
{
    const struct hatch_occluder *x = a, *y = b;
    if (x->nearest > y->nearest || x->nearest < y->nearest)
        return x->nearest > y->nearest ? -1 : 1;
    return (x->face > y->face) - (x->face < y->face);
}

enum hatch_status hatch_occluders_make(const struct hatch_unit_scene *scene, const struct hatch_view *view,
                                       double width_px, double height_px, struct hatch_arena *arena,
                                       struct hatch_arena *scratch, struct hatch_occluders *occluders,
                                       struct hatch_err *err)
{
    struct hatch_occluders made = {.view = *view, .width_px = width_px, .height_px = height_px};
    double near = !view->orthographic && view->near_is_automatic ? HATCH_OCCLUDERS_DEPTH_LEAST : view->near;
    made.nearest = hatch_occluders_nearness(&made, near);
    made.focal_px[0] = 0.5 * width_px / (view->half_height * view->aspect);
    made.focal_px[1] = 0.5 * height_px / view->half_height;
    HATCH_TRY(allocate(scene, arena, &made, err));
    uint32_t base = 0;
    for (uint32_t i = 0; i < scene->item_count; i++) {
        add_item(scene, i, base, &made);
        base += scene->meshes[scene->items[i].mesh].surface->vertex_count;
    }
    qsort(made.at, made.count, sizeof *made.at, compare);
    HATCH_TRY(hatch_occluders_list(&made, arena, scratch, err));
    *occluders = made;
    return HATCH_OK;
}
