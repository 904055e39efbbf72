#include "render-gl/repeat.h"

#include <math.h>

/* Areas by the logarithm of pixels per unit of a texture coordinate, in eighths of an octave. */
#define STEPS 8
#define OCTAVES 64
#define BINS (OCTAVES * STEPS)

struct density {
    double area[2][BINS]; /* along u, along v */
    double total;
};

static void add(struct density *density, int axis, double pixels, double area)
{
    double bin = floor((log2(pixels) + OCTAVES / 2) * STEPS);
    if (bin >= 0 && bin < BINS)
        density->area[axis][(int)bin] += area;
}

/* The logarithm that half of the area is below. */
static double median(const struct density *density, int axis)
{
    double sum = 0;
    int bin = 0;
    while (bin < BINS - 1 && (sum += density->area[axis][bin]) < 0.5 * density->total)
        bin++;
    return (bin + 0.5) / STEPS - OCTAVES / 2;
}

/* How long the steps of u and of v are on a face, by the inverse of its map from edges. */
static void add_face(struct density *density, const double *const p[3], const float *const t[3],
                     const struct view *view, double height_px, bool only_seen)
{
    double e[2][3], d[2][2], center[3], step[2] = {0, 0}, n[3], area = 0;
    for (int i = 0; i < 2; i++) {
        for (int k = 0; k < 3; k++)
            e[i][k] = p[i + 1][k] - p[0][k];
        for (int k = 0; k < 2; k++)
            d[i][k] = (double)t[i + 1][k] - (double)t[0][k];
    }
    double det = d[0][0] * d[1][1] - d[1][0] * d[0][1];
    for (int k = 0; k < 3; k++) {
        int k1 = (k + 1) % 3, k2 = (k + 2) % 3;
        double along_u = e[0][k] * d[1][1] - e[1][k] * d[0][1];
        double along_v = e[1][k] * d[0][0] - e[0][k] * d[1][0];
        n[k] = e[0][k1] * e[1][k2] - e[0][k2] * e[1][k1];
        center[k] = (p[0][k] + p[1][k] + p[2][k]) / 3;
        step[0] += along_u * along_u;
        step[1] += along_v * along_v;
        area += n[k] * n[k];
    }
    if (only_seen && !view_sees(view, center))
        return;
    double scale = view_pixels_per_unit(view, center, height_px);
    area = 0.5 * sqrt(area) * scale * scale;
    if (!(area > 0) || !isfinite(area) || !(fabs(det) > 0) || !(step[0] > 0) || !(step[1] > 0))
        return;
    for (int axis = 0; axis < 2; axis++)
        add(density, axis, sqrt(step[axis]) / fabs(det) * scale, area);
    density->total += area;
}

static enum hatch_status measure(struct gpu_scene *scene, const struct gpu_item *item,
                                 const struct view *view, double height_px,
                                 struct hatch_arena *scratch, struct density *density,
                                 struct hatch_err *err)
{
    const struct hatch_mesh *mesh = &scene->scene->meshes[item->mesh].mesh;
    const float *texcoord = hatch_mesh_find(mesh, "TEXCOORD_0", 2);
    double *positions = HATCH_NEW(scratch, double, 3 * (size_t)mesh->vertex_count, err);
    if (!positions)
        return HATCH_LIMIT;
    pose_vertices(&scene->pose, item->node, item->mesh, positions, NULL);
    for (size_t v = 0; v < mesh->vertex_count; v++)
        for (size_t k = 0; k < 3; k++)
            positions[3 * v + k] =
                (positions[3 * v + k] - scene->bounds.center[k]) / scene->bounds.radius;
    /* What the picture shows decides; a surface that comes into it later goes by its distance. */
    for (int only_seen = 1; only_seen >= 0 && !(density->total > 0); only_seen--)
        for (size_t face = 0; texcoord && face < mesh->face_count; face++) {
            const double *p[3];
            const float *t[3];
            for (size_t i = 0; i < 3; i++) {
                size_t vertex = mesh->indices[3 * face + i];
                p[i] = positions + 3 * vertex;
                t[i] = texcoord + 2 * vertex;
            }
            add_face(density, p, t, view, height_px, only_seen);
        }
    return HATCH_OK;
}

/* The direction with fewer pixels decides, and the other one repeats more often, so that strokes are
 * not stretched. Repeats below 1 cut a closed surface's seam: they are only used where otherwise no
 * stroke would be left. */
static void choose(const struct density *density, uint32_t size_px, uint32_t levels,
                   float repeat[2])
{
    double want[2] = {median(density, 0) - log2(size_px), median(density, 1) - log2(size_px)};
    int fewer = want[1] < want[0];
    double room = levels > 1 ? (double)levels - 2 : 0, power = 0;
    if (want[fewer] > 0)
        power = ceil(want[fewer] - 0.25);
    else if (want[fewer] + room < 0)
        power = floor(want[fewer] + room);
    repeat[fewer] = (float)exp2(power);
    repeat[!fewer] = (float)exp2(power + round(want[!fewer] - want[fewer]));
}

enum hatch_status repeat_set(struct gpu_scene *scene, double repeat, const struct view *view,
                             double height_px, uint32_t size_px, uint32_t levels,
                             struct hatch_arena *scratch, struct hatch_err *err)
{
    for (uint32_t i = 0; i < scene->item_count; i++) {
        struct gpu_item *item = &scene->items[i];
        item->repeat[0] = item->repeat[1] = repeat > 0 ? (float)repeat : 1.0f;
        if (repeat > 0)
            continue;
        struct hatch_arena_mark mark = hatch_arena_mark(scratch);
        struct density *density = HATCH_NEW(scratch, struct density, 1, err);
        if (!density)
            return HATCH_LIMIT;
        enum hatch_status status = measure(scene, item, view, height_px, scratch, density, err);
        if (status == HATCH_OK && density->total > 0)
            choose(density, size_px, levels, item->repeat);
        hatch_arena_rewind(scratch, mark);
        HATCH_TRY(status);
    }
    return HATCH_OK;
}
