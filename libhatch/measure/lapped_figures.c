#include "measure/lapped_figures.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/random.h"
#include "math/percentile.h"
#include "math/vector.h"
#include "measure/stretch.h"

/* Smallest opacity that counts as 1, to allow for the rounding of bilinear interpolation. */
#define OPAQUE (1 - 1e-6)
#define REPORT_STEP 1024 /* samples from one report of progress to the next */
#define DEGREES (180 / 3.14159265358979323846)

static const double shares[HATCH_LAPPED_SHARES] = {0.5, 0.95, 0.99, 1};

/* A face of a patch. Two of them lie on the same face of the surface when their groups and points are equal. */
struct face {
    uint32_t group;       /* first mesh of the node that uses the patch */
    uint32_t point[3];    /* numbers of the corners' positions, ascending */
    uint32_t patch, face; /* index of the patch; index of the face in it */
    uint8_t corner[3];    /* the face's corner at point[i] */
};

struct faces {
    uint32_t count;         /* number of the patches' faces */
    struct face *list;      /* grouped by faces of the surface, in drawing order within each */
    uint32_t surface_count; /* number of the surface's faces */
    uint32_t *first;        /* surface_count + 1: per face of the surface, the first entry in list */
    const struct hatch_scene_mesh **patches;
    const struct hatch_image **masks; /* per patch */
    uint32_t patch_count;
};

/* Returns whether two faces lie on the same face of the surface. */
static bool coincide(const struct face *a, const struct face *b)
{
    return a->group == b->group && memcmp(a->point, b->point, sizeof a->point) == 0;
}

static int compare(const void *pa, const void *pb)
{
    const struct face *a = pa, *b = pb;
    const uint32_t keys[][2] = {{a->group, b->group},       {a->point[0], b->point[0]}, {a->point[1], b->point[1]},
                                {a->point[2], b->point[2]}, {a->patch, b->patch},       {a->face, b->face}};
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++)
        if (keys[i][0] != keys[i][1])
            return keys[i][0] < keys[i][1] ? -1 : 1;
    return 0;
}

/* Collects the patches.
 *   group  out: per mesh, the first mesh of its node; HATCH_NONE if it is not a patch that a node uses */
static enum hatch_status find_patches(const struct hatch_scene *scene, const struct hatch_image *masks, uint32_t *group,
                                      struct faces *faces, struct hatch_err *err)
{
    memset(group, 0xff, scene->mesh_count * sizeof *group);
    for (uint32_t n = 0; n < scene->node_count; n++) {
        const struct hatch_node *node = &scene->nodes[n];
        for (uint32_t m = node->first_mesh; m < node->first_mesh + node->mesh_count; m++)
            if (scene->meshes[m].material != HATCH_NONE && scene->materials[scene->meshes[m].material].outline)
                group[m] = node->first_mesh;
    }
    for (uint32_t m = 0; m < scene->mesh_count; m++) {
        if (group[m] == HATCH_NONE)
            continue;
        const struct hatch_scene_mesh *patch = &scene->meshes[m];
        uint32_t texture = scene->materials[patch->material].base.texture;
        if (!hatch_mesh_find(&patch->mesh, "TEXCOORD_0", 2) || !hatch_mesh_find(&patch->mesh, "TEXCOORD_1", 2))
            return hatch_fail(err, HATCH_BAD_INPUT, "patch %u: no TEXCOORD_0 or no TEXCOORD_1", m);
        if (texture == HATCH_NONE || !masks[texture].pixels)
            return hatch_fail(err, HATCH_BAD_INPUT, "patch %u: no outline (alpha mask)", m);
        faces->masks[faces->patch_count] = &masks[texture];
        faces->patches[faces->patch_count++] = patch;
    }
    if (faces->patch_count == 0)
        return hatch_fail(err, HATCH_BAD_INPUT, "no patches; add them with lapped-param");
    return HATCH_OK;
}

/* Joins all patches' positions into one mesh.
 *   first  out: per patch, its first vertex */
static enum hatch_status gather(const struct faces *faces, struct hatch_arena *scratch, struct hatch_mesh *all,
                                size_t *first, struct hatch_err *err)
{
    size_t vertices = 0, face_count = 0;
    for (uint32_t p = 0; p < faces->patch_count; p++) {
        first[p] = vertices;
        vertices += faces->patches[p]->mesh.vertex_count;
        face_count += faces->patches[p]->mesh.face_count;
    }
    if (vertices >= UINT32_MAX || face_count >= UINT32_MAX)
        return hatch_fail(err, HATCH_LIMIT, "%zu vertices and %zu faces are too many", vertices, face_count);
    HATCH_TRY(hatch_mesh_make(scratch, (uint32_t)vertices, 1, all, err));
    for (uint32_t p = 0; p < faces->patch_count; p++)
        memcpy(&all->attributes[0].data[3 * first[p]], faces->patches[p]->mesh.attributes[0].data,
               (size_t)faces->patches[p]->mesh.vertex_count * 3 * sizeof(float));
    return HATCH_OK;
}

/* Sorts the three points of a face and records their corners. */
static void set_points(const uint32_t points[3], struct face *face)
{
    for (uint8_t c = 0; c < 3; c++) {
        int rank = 0;
        for (uint8_t other = 0; other < 3; other++)
            rank += points[other] < points[c] || (points[other] == points[c] && other < c);
        face->point[rank] = points[c];
        face->corner[rank] = c;
    }
}

static enum hatch_status fill(const struct hatch_scene *scene, const uint32_t *group, struct hatch_arena *scratch,
                              struct faces *faces, struct hatch_err *err)
{
    struct hatch_mesh all;
    uint32_t points;
    size_t *first = HATCH_NEW(scratch, size_t, faces->patch_count, err), total = 0;
    if (!first)
        return HATCH_LIMIT;
    HATCH_TRY(gather(faces, scratch, &all, first, err));
    uint32_t *point;
    HATCH_TRY(HATCH_ALLOC(scratch, &point, all.vertex_count, err));
    HATCH_TRY(hatch_mesh_weld(&all, scratch, point, &points, err));
    for (uint32_t p = 0; p < faces->patch_count; p++)
        total += faces->patches[p]->mesh.face_count;
    HATCH_TRY(HATCH_ALLOC(scratch, &faces->list, total, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &faces->first, total + 1, err));
    for (uint32_t p = 0; p < faces->patch_count; p++) {
        const struct hatch_mesh *mesh = &faces->patches[p]->mesh;
        for (uint32_t f = 0; f < mesh->face_count; f++) {
            struct face *face = &faces->list[faces->count++];
            uint32_t corners[3];
            for (size_t c = 0; c < 3; c++)
                corners[c] = point[first[p] + mesh->indices[3 * (size_t)f + c]];
            *face = (struct face){.group = group[faces->patches[p] - scene->meshes], .patch = p, .face = f};
            set_points(corners, face);
        }
    }
    return HATCH_OK;
}

/* Finds the faces of all patches that nodes of the scene use.
 *   masks  per texture, as for hatch_measure_lapped
 *   faces  out: in scratch
 * HATCH_BAD_INPUT when there is no patch, or one has no texture coordinates or outline. */
static enum hatch_status find_faces(const struct hatch_scene *scene, const struct hatch_image *masks,
                                    struct hatch_arena *scratch, struct faces *faces, struct hatch_err *err)
{
    struct faces made = {.count = 0};
    uint32_t *group;
    HATCH_TRY(HATCH_ALLOC(scratch, &group, scene->mesh_count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &made.patches, scene->mesh_count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &made.masks, scene->mesh_count, err));
    HATCH_TRY(find_patches(scene, masks, group, &made, err));
    HATCH_TRY(fill(scene, group, scratch, &made, err));
    qsort(made.list, made.count, sizeof *made.list, compare);
    for (uint32_t s = 0; s < made.count; s++)
        if (s == 0 || !coincide(&made.list[s - 1], &made.list[s]))
            made.first[made.surface_count++] = s;
    made.first[made.surface_count] = made.count;
    *faces = made;
    return HATCH_OK;
}

struct work {
    struct faces faces;
    struct hatch_arena *scratch;
    struct hatch_lapped_figures *out;
};

static double texel(const struct hatch_image *mask, int channel, double x, double y)
{
    size_t column = (size_t)fmin(fmax(x, 0), (double)mask->width - 1);
    size_t row = (size_t)fmin(fmax(y, 0), (double)mask->height - 1);
    return (double)mask->pixels[(row * mask->width + column) * mask->channel_count + (size_t)channel];
}

/* Returns the opacity at uv, bilinear between texel centres and clamped to the edge, as in a texture unit. */
static double opacity_at(const struct hatch_image *mask, const double uv[2])
{
    int channel = hatch_image_channel(mask, "A");
    if (channel < 0)
        return 1;
    double x = uv[0] * mask->width - 0.5, y = uv[1] * mask->height - 0.5;
    double left = floor(x), top = floor(y), fx = x - left, fy = y - top;
    double above = (1 - fx) * texel(mask, channel, left, top) + fx * texel(mask, channel, left + 1, top);
    double below = (1 - fx) * texel(mask, channel, left, top + 1) + fx * texel(mask, channel, left + 1, top + 1);
    return (1 - fy) * above + fy * below;
}

/* Returns the opacity of a patch at a point of one of its faces.
 *   weights  barycentric, in the order of the face's points */
static double face_opacity(const struct faces *faces, const struct face *face, const double weights[3])
{
    const struct hatch_mesh *mesh = &faces->patches[face->patch]->mesh;
    const float *texcoords = hatch_mesh_find(mesh, "TEXCOORD_1", 2);
    double uv[2] = {0, 0};
    for (int i = 0; i < 3; i++) {
        size_t vertex = mesh->indices[3 * (size_t)face->face + face->corner[i]];
        for (size_t k = 0; k < 2; k++)
            uv[k] += weights[i] * (double)texcoords[2 * vertex + k];
    }
    return opacity_at(faces->masks[face->patch], uv);
}

/* Takes a sample: looks at the patches there from the last drawn to the first, until one is opaque.
 *   seen     in and out: per patch, 1 once it has been visible at a sample
 *   covered  in and out: number of samples at which a patch is opaque */
static void take_sample(struct work *w, uint32_t surface_face, const double weights[3], uint8_t *seen,
                        uint32_t *covered)
{
    double transparency = 1;
    bool opaque = false;
    for (uint32_t s = w->faces.first[surface_face + 1]; s > w->faces.first[surface_face] && !opaque; s--) {
        const struct face *face = &w->faces.list[s - 1];
        double opacity = face_opacity(&w->faces, face, weights);
        opaque = opacity >= OPAQUE;
        transparency *= opaque ? 0 : 1 - opacity;
        if (opacity > 0)
            seen[face->patch] = 1;
    }
    *covered += opaque;
    w->out->opacity_min = fmin(w->out->opacity_min, 1 - transparency);
}

/* Computes random barycentric weights, uniformly distributed over a triangle. */
static void random_weights(uint64_t seed, uint64_t index, double weights[3])
{
    double root = sqrt((double)(hatch_random_u64(seed, 1, index) >> 11) * 0x1p-53);
    double t = (double)(hatch_random_u64(seed, 2, index) >> 11) * 0x1p-53;
    weights[0] = 1 - root;
    weights[1] = root * (1 - t);
    weights[2] = root * t;
}

/* Returns the first face whose cumulative area exceeds area. */
static uint32_t find_face(const double *area_up_to, uint32_t count, double area)
{
    uint32_t low = 0, high = count - 1;
    while (low < high) {
        uint32_t middle = low + (high - low) / 2;
        if (area_up_to[middle] > area)
            high = middle;
        else
            low = middle + 1;
    }
    return low;
}

static enum hatch_status measure_cover(struct work *w, uint32_t samples, uint64_t seed,
                                       const struct hatch_progress *progress, struct hatch_err *err)
{
    const struct faces *faces = &w->faces;
    double *area_up_to = HATCH_NEW(w->scratch, double, faces->surface_count, err), area = 0;
    uint8_t *seen = area_up_to ? HATCH_NEW(w->scratch, uint8_t, faces->patch_count, err) : NULL;
    uint32_t covered = 0;
    if (!seen)
        return HATCH_LIMIT;
    for (uint32_t f = 0; f < faces->surface_count; f++) {
        const struct face *face = &faces->list[faces->first[f]];
        double p[3][3], normal[3];
        hatch_mesh_corners(&faces->patches[face->patch]->mesh, face->face, p);
        hatch_vec_triangle(p[0], p[1], p[2], normal);
        area_up_to[f] = area += hatch_vec_length(normal);
    }
    w->out->opacity_min = 1;
    for (uint32_t i = 0; i < samples; i++) {
        if (i % REPORT_STEP == 0)
            hatch_progress_report(progress, (double)i / samples);
        double weights[3], at = (double)(hatch_random_u64(seed, 0, i) >> 11) * 0x1p-53 * area;
        random_weights(seed, i, weights);
        take_sample(w, find_face(area_up_to, faces->surface_count, at), weights, seen, &covered);
    }
    w->out->samples = samples;
    w->out->covered = (double)covered / samples;
    for (uint32_t p = 0; p < faces->patch_count; p++)
        w->out->hidden += !seen[p];
    return HATCH_OK;
}

/* Computes the mean of the corners' directions, without their sign, in the face's plane: as complex numbers with axes u
 * and v, their squares are summed. Returns false when they cancel.
 *   line  out: the sum of the squares */
static bool face_line(const struct hatch_mesh *mesh, const float *directions, uint32_t face, const double u[3],
                      const double v[3], double line[2])
{
    line[0] = line[1] = 0;
    for (size_t c = 0; c < 3; c++) {
        double d[3];
        hatch_vec_of(&directions[4 * (size_t)mesh->indices[3 * (size_t)face + c]], d);
        double x = hatch_vec_dot(d, u), y = hatch_vec_dot(d, v), square = x * x + y * y;
        if (square > 0) {
            line[0] += (x * x - y * y) / square;
            line[1] += 2 * x * y / square;
        }
    }
    return hypot(line[0], line[1]) > 1e-6;
}

/* Returns the angle between the direction in which u rises and the field, 0 .. 90 degrees; -1 without a field. */
static double angle_to_field(const struct hatch_mesh *mesh, uint32_t face, const double u[3])
{
    const float *directions = hatch_mesh_find(mesh, "_HATCH_DIR", 4);
    double p[3][3], normal[3], v[3], line[2];
    if (!directions || !(hatch_vec_length(u) > 0))
        return -1;
    hatch_mesh_corners(mesh, face, p);
    hatch_vec_triangle(p[0], p[1], p[2], normal);
    hatch_vec_normalize(normal);
    hatch_vec_cross(normal, u, v);
    if (!face_line(mesh, directions, face, u, v, line))
        return -1;
    return fabs(atan2(line[1], line[0])) / 2 * DEGREES;
}

/* Values for percentiles, one per patch face that has them. */
struct lists {
    struct hatch_weighted *stretch, *area, *angle;
    uint32_t stretches, angles;
};

/* Measures the faces begin .. end - 1 of the list, which form one group, relative to the group's mean texture area. */
static void measure_group(struct work *w, uint32_t begin, uint32_t end, struct lists *lists)
{
    double area = 0, uv_area = 0;
    uint32_t first = lists->stretches;
    for (uint32_t s = begin; s < end; s++) {
        const struct face *face = &w->faces.list[s];
        const struct hatch_mesh *mesh = &w->faces.patches[face->patch]->mesh;
        struct hatch_stretch stretch;
        if (!hatch_measure_stretch(mesh, hatch_mesh_find(mesh, "TEXCOORD_0", 2), face->face, &stretch))
            continue;
        w->out->flipped += !(stretch.uv_area < 0);
        double angle = angle_to_field(mesh, face->face, stretch.u);
        if (angle >= 0)
            lists->angle[lists->angles++] = (struct hatch_weighted){angle, stretch.area};
        if (!isfinite(stretch.ratio))
            continue;
        area += stretch.area;
        uv_area += fabs(stretch.uv_area);
        lists->stretch[lists->stretches] = (struct hatch_weighted){stretch.ratio, 1};
        lists->area[lists->stretches++] = (struct hatch_weighted){fabs(stretch.uv_area) / stretch.area, 1};
    }
    for (uint32_t i = first; i < lists->stretches; i++) {
        double relative = lists->area[i].value * (area / uv_area);
        lists->area[i].value = fmax(relative, 1 / relative);
    }
}

static enum hatch_status measure_stretch(struct work *w, struct hatch_err *err)
{
    struct lists lists = {.angles = 0};
    HATCH_TRY(HATCH_ALLOC(w->scratch, &lists.stretch, w->faces.count, err));
    HATCH_TRY(HATCH_ALLOC(w->scratch, &lists.area, w->faces.count, err));
    HATCH_TRY(HATCH_ALLOC(w->scratch, &lists.angle, w->faces.count, err));
    for (uint32_t begin = 0, end; begin < w->faces.count; begin = end) {
        for (end = begin; end < w->faces.count && w->faces.list[end].group == w->faces.list[begin].group;)
            end++;
        measure_group(w, begin, end, &lists);
    }
    hatch_percentiles(lists.stretch, lists.stretches, shares, HATCH_LAPPED_SHARES, w->out->stretch);
    hatch_percentiles(lists.area, lists.stretches, shares, HATCH_LAPPED_SHARES, w->out->area);
    hatch_percentiles(lists.angle, lists.angles, shares, HATCH_LAPPED_SHARES, w->out->angle_area_deg);
    for (uint32_t i = 0; i < lists.angles; i++)
        lists.angle[i].weight = 1;
    hatch_percentiles(lists.angle, lists.angles, shares, HATCH_LAPPED_SHARES, w->out->angle_deg);
    return HATCH_OK;
}

enum hatch_status hatch_measure_lapped(const struct hatch_scene *scene, const struct hatch_image *masks,
                                       uint32_t samples, uint64_t seed, const struct hatch_progress *progress,
                                       struct hatch_arena *scratch, struct hatch_lapped_figures *figures,
                                       struct hatch_err *err)
{
    assert(samples > 0);
    struct hatch_lapped_figures made = {.patches = 0};
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct work w = {.scratch = scratch, .out = &made};
    enum hatch_status status = find_faces(scene, masks, scratch, &w.faces, err);
    if (status == HATCH_OK) {
        made.patches = w.faces.patch_count;
        made.faces = w.faces.surface_count;
        made.patch_faces = w.faces.count;
        made.overlap = (double)made.patch_faces / made.faces;
        status = measure_cover(&w, samples, seed, progress, err);
    }
    if (status == HATCH_OK)
        status = measure_stretch(&w, err);
    if (status == HATCH_OK)
        *figures = made;
    hatch_arena_rewind(scratch, mark);
    return status;
}
