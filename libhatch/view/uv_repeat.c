#include "view/uv_repeat.h"

#include <math.h>
#include <stdlib.h>

#include "mesh/fans.h"

/* A part of a surface that hangs together in the texture's plane. Sums over its faces, weighted by
 * their area: of the logarithms of the lengths that a unit of u and of v has in the unit scene. */
struct chart {
    double area, log_u, log_v;
};

struct survey {
    const struct hatch_mesh *mesh;
    const float *texcoord;
    double *positions;            /* in the unit scene */
    uint32_t *parent;             /* of each vertex, in the forest of charts */
    struct chart *charts;         /* of each vertex; those of roots count */
    float *repeats;               /* two for each vertex */
    double seen_weight, seen_log; /* of pixels per unit, where the picture shows the surface */
    double all_weight, all_log;   /* everywhere */
};

struct place {
    uint32_t point, vertex;
    float u, v;
};

static int compare_places(const void *a, const void *b)
{
    const struct place *x = a, *y = b;
    if (x->point != y->point)
        return x->point < y->point ? -1 : 1;
    if (x->u < y->u || x->u > y->u)
        return x->u < y->u ? -1 : 1;
    return (x->v > y->v) - (x->v < y->v);
}

/* Vertices that differ in nothing but their normal are one to the texture. */
static enum hatch_status join_charts(struct survey *survey, struct hatch_arena *scratch, struct hatch_err *err)
{
    const struct hatch_mesh *mesh = survey->mesh;
    uint32_t point_count;
    uint32_t *points = HATCH_NEW(scratch, uint32_t, mesh->vertex_count, err);
    struct place *places = HATCH_NEW(scratch, struct place, mesh->vertex_count, err);
    if (!points || !places)
        return HATCH_LIMIT;
    HATCH_TRY(hatch_mesh_weld(mesh, scratch, points, &point_count, err));
    hatch_sets_init(survey->parent, mesh->vertex_count);
    for (uint32_t v = 0; v < mesh->vertex_count; v++) {
        places[v] = (struct place){points[v], v, survey->texcoord[2 * (size_t)v], survey->texcoord[2 * (size_t)v + 1]};
    }
    qsort(places, mesh->vertex_count, sizeof *places, compare_places);
    for (uint32_t i = 1; i < mesh->vertex_count; i++)
        if (compare_places(&places[i - 1], &places[i]) == 0)
            hatch_sets_join(survey->parent, places[i - 1].vertex, places[i].vertex);
    for (size_t i = 0; i < 3 * (size_t)mesh->face_count; i += 3) {
        hatch_sets_join(survey->parent, mesh->indices[i], mesh->indices[i + 1]);
        hatch_sets_join(survey->parent, mesh->indices[i], mesh->indices[i + 2]);
    }
    return HATCH_OK;
}

/* How long the steps of u and of v are on a face, by the inverse of its map from edges. false where
 * its texture coordinates or its corners are on a line. */
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

/* want: logarithms of the repeats by which texels are pixels. The direction with fewer pixels decides,
 * and the other one repeats more often, so that strokes are not stretched. Repeats below 1 cut a closed
 * surface's seam: they are only used where otherwise no stroke would be left. */
static void choose(const double want[2], uint32_t levels, float repeat[2])
{
    int fewer = want[1] < want[0];
    double room = levels > 1 ? (double)levels - 2 : 0, power = 0;
    if (want[fewer] > 0)
        power = ceil(want[fewer] - 0.25);
    else if (want[fewer] + room < 0)
        power = floor(want[fewer] + room);
    repeat[fewer] = (float)exp2(power);
    repeat[!fewer] = (float)exp2(power + round(want[!fewer] - want[fewer]));
}

/* The mean logarithm of the pixels that a unit is long. */
static double pixels_of(const struct survey *survey)
{
    return survey->seen_weight > 0 ? survey->seen_log / survey->seen_weight : survey->all_log / survey->all_weight;
}

/* All charts of an item go by one scale, so that equal charts repeat equally, near or far. What the
 * picture shows decides it; a surface that comes into it later goes by its distance. */
static void choose_all(struct survey *survey, const struct hatch_uv_repeat *how, struct hatch_item *item)
{
    double pixels = pixels_of(survey), largest = 0;
    item->chart_count = 0;
    for (uint32_t v = 0; v < survey->mesh->vertex_count; v++) {
        uint32_t root = hatch_sets_find(survey->parent, v);
        const struct chart *chart = &survey->charts[root];
        float *repeat = survey->repeats + 2 * (size_t)v;
        repeat[0] = repeat[1] = 1.0f;
        if (root != v) { /* roots come first */
            repeat[0] = survey->repeats[2 * (size_t)root];
            repeat[1] = survey->repeats[2 * (size_t)root + 1];
            continue;
        }
        if (!(chart->area > 0))
            continue;
        double want[2] = {chart->log_u / chart->area + pixels - log2(how->size_px),
                          chart->log_v / chart->area + pixels - log2(how->size_px)};
        choose(want, how->levels, repeat);
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
    survey->positions = HATCH_NEW(scratch, double, 3 * count, err);
    survey->parent = HATCH_NEW(scratch, uint32_t, count, err);
    survey->charts = HATCH_NEW(scratch, struct chart, count, err);
    if (!survey->positions || !survey->parent || !survey->charts)
        return HATCH_LIMIT;
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
    HATCH_TRY(join_charts(&survey, scratch, err));
    for (size_t face = 0; face < survey.mesh->face_count; face++)
        add_face(&survey, face, how);
    if (!(survey.all_weight > 0))
        return HATCH_OK;
    survey.repeats = HATCH_NEW(arena, float, 2 * (size_t)survey.mesh->vertex_count, err);
    if (!survey.repeats)
        return HATCH_LIMIT;
    choose_all(&survey, how, item);
    item->repeats = survey.repeats;
    return HATCH_OK;
}

/* The logarithm of the length in the unit scene of a unit of an item's texture coordinates. */
static double step_of(const struct chart *chart)
{
    return 0.5 * (chart->log_u + chart->log_v) / chart->area;
}

/* Gives all surfaces that patches cover strokes of one size, whatever their nodes' scales: the size at which the part
 * of them that the picture shows has texels as large as pixels. */
static enum hatch_status set_patches(struct hatch_unit_scene *scene, const struct hatch_uv_repeat *how,
                                     struct hatch_arena *scratch, struct hatch_err *err)
{
    struct survey all = {.mesh = NULL};
    double *steps = HATCH_NEW(scratch, double, scene->item_count, err); /* 0: no patches */
    if (!steps)
        return HATCH_LIMIT;
    for (uint32_t i = 0; i < scene->item_count; i++) {
        const struct hatch_item *item = &scene->items[i];
        struct hatch_arena_mark mark = hatch_arena_mark(scratch);
        struct survey survey;
        if (!scene->meshes[item->mesh].patches)
            continue;
        HATCH_TRY(make_survey(scene, item, scratch, &survey, err));
        /* All vertices have the parent 0 here: one chart. */
        for (size_t face = 0; face < survey.mesh->face_count; face++)
            add_face(&survey, face, how);
        if (survey.charts[0].area > 0)
            steps[i] = exp2(step_of(&survey.charts[0]));
        all.seen_weight += survey.seen_weight;
        all.seen_log += survey.seen_log;
        all.all_weight += survey.all_weight;
        all.all_log += survey.all_log;
        hatch_arena_rewind(scratch, mark);
    }
    for (uint32_t i = 0; i < scene->item_count && all.all_weight > 0; i++)
        if (steps[i] > 0) {
            double repeat = steps[i] * exp2(pixels_of(&all)) / how->size_px;
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
        if (!(how->repeat > 0) && !scene->meshes[item->mesh].patches)
            status = set_item(scene, how, item, arena, scratch, err);
        hatch_arena_rewind(scratch, mark);
    }
    if (status == HATCH_OK && !(how->repeat > 0))
        status = set_patches(scene, how, scratch, err);
    hatch_arena_rewind(scratch, mark);
    return status;
}
