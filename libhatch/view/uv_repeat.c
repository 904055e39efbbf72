#include "view/uv_repeat.h"

#include <stdlib.h>

#include "mesh/fans.h"
#include "scene/uv_charts.h"

/* A connected part of a surface in texture space. */
struct chart {
    double area;         /* in the unit scene */
    double log_u, log_v; /* sums over faces of area times log2 of the length of a unit of u, of v, in the unit scene */
};

/* Measurements of an item. */
struct survey {
    const struct hatch_mesh *mesh;
    const float *texcoord;
    double *positions;            /* in the unit scene */
    uint32_t *parent;             /* per vertex: disjoint sets of vertices, one per chart */
    struct chart *charts;         /* per vertex: the chart whose set has its root at this vertex */
    float *repeats;               /* 2 per vertex */
    double seen_weight, seen_log; /* over visible faces: sums of weight, and of weight times log2 of pixels per unit */
    double all_weight, all_log;   /* the same sums over all faces */
};

/* Measures a face; returns false if its texture coordinates or its corners are collinear.
 *   p     positions of its corners
 *   t     texture coordinates of its corners
 *   step  out: length of a unit of u, of v */
static bool measure_face(const double *const p[3], const float *const t[3], double step[2], double *area)
{
    double e[2][3], d[2][2], normal = 0;
    for (int i = 0; i < 2; i++) {
        for (int k = 0; k < 3; k++)
            e[i][k] = p[i + 1][k] - p[0][k];
        for (int k = 0; k < 2; k++)
            d[i][k] = (double)t[i + 1][k] - (double)t[0][k];
    }
    double det = fabs(d[0][0] * d[1][1] - d[1][0] * d[0][1]);
    step[0] = step[1] = 0;
    for (int k = 0; k < 3; k++) {
        int k1 = (k + 1) % 3, k2 = (k + 2) % 3;
        double along_u = e[0][k] * d[1][1] - e[1][k] * d[0][1];
        double along_v = e[1][k] * d[0][0] - e[0][k] * d[1][0];
        double n = e[0][k1] * e[1][k2] - e[0][k2] * e[1][k1];
        step[0] += along_u * along_u;
        step[1] += along_v * along_v;
        normal += n * n;
    }
    for (int axis = 0; axis < 2; axis++)
        step[axis] = sqrt(step[axis]) / det;
    *area = 0.5 * sqrt(normal);
    return *area > 0 && step[0] > 0 && step[1] > 0 && isfinite(step[0]) && isfinite(step[1]) && isfinite(*area);
}

static void add_face(struct survey *survey, size_t face, const struct hatch_uv_repeat *how)
{
    const double *p[3];
    const float *t[3];
    double center[3] = {0, 0, 0}, step[2], area;
    for (size_t i = 0; i < 3; i++) {
        size_t vertex = survey->mesh->indices[3 * face + i];
        p[i] = survey->positions + 3 * vertex;
        t[i] = survey->texcoord + 2 * vertex;
        for (int k = 0; k < 3; k++)
            center[k] += p[i][k] / 3;
    }
    if (!measure_face(p, t, step, &area))
        return;
    struct chart *chart = &survey->charts[hatch_sets_find(survey->parent, survey->mesh->indices[3 * face])];
    chart->area += area;
    chart->log_u += area * log2(step[0]);
    chart->log_v += area * log2(step[1]);
    double scale = hatch_view_pixels_per_unit(how->view, center, how->height_px);
    double weight = area * scale * scale;
    if (!(scale > 0) || !isfinite(weight))
        return;
    survey->all_weight += weight;
    survey->all_log += weight * log2(scale);
    if (hatch_view_sees(how->view, center)) {
        survey->seen_weight += weight;
        survey->seen_log += weight * log2(scale);
    }
}

/* Chooses the repeats of a chart. The direction, u or v, with fewer pixels per unit is chosen first; the other one then
 * repeats more often, so that strokes are not stretched. Repeats below 1 make the seams of closed surfaces visible, so
 * they are used only where no stroke would be drawn otherwise.
 *   target  log2 of the repeats at which a texel of level 0 is as large as a pixel */
static void choose(const double target[2], uint32_t levels, float repeat[2])
{
    int fewer = target[1] < target[0];
    double room = levels > 1 ? (double)levels - 2 : 0, power = 0;
    if (target[fewer] > 0)
        power = ceil(target[fewer] - 0.25);
    else if (target[fewer] + room < 0)
        power = floor(target[fewer] + room);
    repeat[fewer] = (float)exp2(power);
    repeat[!fewer] = (float)exp2(power + round(target[!fewer] - target[fewer]));
}

/* Returns the weighted mean of log2 of the pixels per unit of the unit scene: over visible faces, or over all faces if
 * none is visible. */
static double log_pixels_of(const struct survey *survey)
{
    return survey->seen_weight > 0 ? survey->seen_log / survey->seen_weight : survey->all_log / survey->all_weight;
}

/* Chooses the repeats of all charts of an item. All charts use the same number of pixels per unit, so that charts of
 * equal size have equal repeats whatever their distances from the camera. */
static void choose_all(struct survey *survey, const struct hatch_uv_repeat *how, struct hatch_item *item)
{
    double log_pixels = log_pixels_of(survey), largest = 0;
    for (uint32_t v = 0; v < survey->mesh->vertex_count; v++) {
        uint32_t root = hatch_sets_find(survey->parent, v);
        const struct chart *chart = &survey->charts[root];
        float *repeat = survey->repeats + 2 * (size_t)v;
        repeat[0] = repeat[1] = 1.0f;
        if (root != v) { /* a root has the lowest number of its set, so its repeats are known */
            repeat[0] = survey->repeats[2 * (size_t)root];
            repeat[1] = survey->repeats[2 * (size_t)root + 1];
            continue;
        }
        if (!(chart->area > 0))
            continue;
        double target[2] = {chart->log_u / chart->area + log_pixels - log2(how->size_px),
                            chart->log_v / chart->area + log_pixels - log2(how->size_px)};
        choose(target, how->levels, repeat);
        item->chart_count++;
        if (chart->area > largest) {
            largest = chart->area;
            item->repeat[0] = repeat[0];
            item->repeat[1] = repeat[1];
        }
    }
}

static enum hatch_status make_survey(struct hatch_unit_scene *scene, const struct hatch_item *item,
                                     struct hatch_arena *scratch, struct survey *survey, struct hatch_err *err)
{
    const struct hatch_mesh *mesh = scene->meshes[item->mesh].mesh;
    size_t count = mesh->vertex_count;
    *survey = (struct survey){.mesh = mesh, .texcoord = hatch_mesh_find(mesh, "TEXCOORD_0", 2)};
    HATCH_TRY(HATCH_ALLOC(scratch, &survey->positions, 3 * count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &survey->parent, count, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &survey->charts, count, err));
    hatch_pose_vertices(&scene->pose, item->node, item->mesh, survey->positions, NULL);
    for (size_t v = 0; v < count; v++)
        hatch_bounds_to_unit(&scene->bounds, survey->positions + 3 * v, survey->positions + 3 * v);
    return HATCH_OK;
}

static enum hatch_status set_item(struct hatch_unit_scene *scene, const struct hatch_uv_repeat *how,
                                  struct hatch_item *item, struct hatch_arena *arena, struct hatch_arena *scratch,
                                  struct hatch_err *err)
{
    struct survey survey;
    HATCH_TRY(make_survey(scene, item, scratch, &survey, err));
    if (!survey.texcoord)
        return HATCH_OK;
    HATCH_TRY(hatch_uv_charts_join(survey.mesh, survey.texcoord, scratch, survey.parent, err));
    for (size_t face = 0; face < survey.mesh->face_count; face++)
        add_face(&survey, face, how);
    if (!(survey.all_weight > 0))
        return HATCH_OK;
    HATCH_TRY(HATCH_ALLOC(arena, &survey.repeats, 2 * (size_t)survey.mesh->vertex_count, err));
    choose_all(&survey, how, item);
    item->repeats = survey.repeats;
    return HATCH_OK;
}

/* Returns log2 of the length of a unit of texture coordinates in the unit scene, as a mean of u and v. */
static double log_step_of(const struct chart *chart)
{
    return 0.5 * (chart->log_u + chart->log_v) / chart->area;
}

/* Sets the repeats of all lapped textures so that strokes have the same size everywhere in the scene, whatever the
 * scales of nodes: the size at which texels of level 0 are on average as large as pixels on visible faces. */
static enum hatch_status set_patches(struct hatch_unit_scene *scene, const struct hatch_uv_repeat *how,
                                     struct hatch_arena *scratch, struct hatch_err *err)
{
    struct survey all = {.mesh = NULL};
    /* Per item: length of a unit of texture coordinates in the unit scene; 0: no patches. */
    double *steps;
    HATCH_TRY(HATCH_ALLOC(scratch, &steps, scene->item_count, err));
    for (uint32_t i = 0; i < scene->item_count; i++) {
        const struct hatch_item *item = &scene->items[i];
        struct hatch_arena_mark mark = hatch_arena_mark(scratch);
        struct survey survey;
        if (!scene->meshes[item->mesh].patches)
            continue;
        HATCH_TRY(make_survey(scene, item, scratch, &survey, err));
        /* parent is zeroed, so all faces belong to chart 0. */
        for (size_t face = 0; face < survey.mesh->face_count; face++)
            add_face(&survey, face, how);
        if (survey.charts[0].area > 0)
            steps[i] = exp2(log_step_of(&survey.charts[0]));
        all.seen_weight += survey.seen_weight;
        all.seen_log += survey.seen_log;
        all.all_weight += survey.all_weight;
        all.all_log += survey.all_log;
        hatch_arena_rewind(scratch, mark);
    }
    for (uint32_t i = 0; i < scene->item_count && all.all_weight > 0; i++)
        if (steps[i] > 0) {
            double repeat = steps[i] * exp2(log_pixels_of(&all)) / how->size_px;
            scene->items[i].repeat[0] = scene->items[i].repeat[1] = (float)repeat;
            scene->items[i].chart_count = 1;
        }
    return HATCH_OK;
}

enum hatch_status hatch_uv_repeat_set(struct hatch_unit_scene *scene, const struct hatch_uv_repeat *how,
                                      struct hatch_arena *arena, struct hatch_arena *scratch, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    enum hatch_status status = HATCH_OK;
    for (uint32_t i = 0; i < scene->item_count && status == HATCH_OK; i++) {
        struct hatch_item *item = &scene->items[i];
        item->repeat[0] = item->repeat[1] = how->repeat > 0 ? (float)how->repeat : 1.0f;
        item->repeats = NULL;
        item->chart_count = 0;
        if (!(how->repeat > 0) && !scene->meshes[item->mesh].patches)
            status = set_item(scene, how, item, arena, scratch, err);
        hatch_arena_rewind(scratch, mark);
    }
    if (status == HATCH_OK && !(how->repeat > 0))
        status = set_patches(scene, how, scratch, err);
    hatch_arena_rewind(scratch, mark);
    return status;
}
