#include "scene/unit_scene.h"

#include <math.h>
#include <string.h>

#include "math/vector.h"
#include "scene/extent.h"

static void set_box(const struct hatch_mesh *mesh, struct hatch_unit_mesh *unit)
{
    float low[3], high[3];
    bool any = hatch_mesh_bounds(mesh, low, high);
    for (int k = 0; k < 3; k++) {
        unit->origin[k] = any ? 0.5 * (double)low[k] + 0.5 * (double)high[k] : 0.0;
        unit->half[k] = any ? 0.5 * (double)high[k] - 0.5 * (double)low[k] : 0.0;
    }
}

static struct hatch_item item_of(const struct hatch_scene *scene, uint32_t node, uint32_t mesh)
{
    const struct hatch_scene_mesh *from = &scene->meshes[mesh];
    struct hatch_item item = {.mesh = mesh,
                              .node = node,
                              .repeat = {1.0f, 1.0f},
                              .double_sided = true,
                              .deformed = hatch_pose_deforms(scene, node, &from->mesh)};
    if (from->material != HATCH_NONE) {
        const struct hatch_material *material = &scene->materials[from->material];
        item.double_sided = material->double_sided;
        /* The base colour's alpha multiplies the texture's, so the cutoff of the texture is divided by it. */
        item.alpha_cutoff = material->alpha_cutoff / fmaxf(material->base_color[3], 1e-6f);
    }
    return item;
}

enum hatch_status hatch_unit_scene_make(const struct hatch_scene *scene, const struct hatch_patch_mesh *patches,
                                        const struct hatch_bounds *bounds, struct hatch_arena *arena,
                                        struct hatch_unit_scene *unit, struct hatch_err *err)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < scene->node_count; i++)
        count += scene->nodes[i].mesh_count;
    static const double aligned[3] = {0, 0, 0};
    struct hatch_unit_scene made = {.scene = scene, .bounds = *bounds};
    hatch_unit_scene_turn_rest(&made, aligned);
    HATCH_TRY(hatch_pose_make(scene, arena, &made.pose, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.meshes, scene->mesh_count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.items, count, err));
    for (uint32_t i = 0; i < scene->mesh_count; i++) {
        struct hatch_unit_mesh *mesh = &made.meshes[i];
        mesh->mesh = &scene->meshes[i].mesh;
        mesh->patches = patches && patches[i].patch_count ? &patches[i] : NULL;
        mesh->surface = mesh->patches ? &patches[i].surface : mesh->mesh;
        set_box(mesh->mesh, mesh);
        hatch_mesh_sum_areas(mesh->surface, mesh->areas);
    }
    for (uint32_t node = 0; node < scene->node_count; node++)
        for (uint32_t i = 0; i < scene->nodes[node].mesh_count; i++)
            made.items[made.item_count++] = item_of(scene, node, scene->nodes[node].first_mesh + i);
    *unit = made;
    return HATCH_OK;
}

/* Computes an item's bounding box from that of its mesh. */
static void box_item(const struct hatch_unit_scene *unit, struct hatch_item *item)
{
    const double *half = unit->meshes[item->mesh].half;
    for (int r = 0; r < 3; r++) {
        double reach = 0;
        for (int c = 0; c < 3; c++)
            reach += fabs((double)item->to_unit[4 * c + r]) * half[c];
        item->low[r] = (double)item->to_unit[12 + r] - reach;
        item->high[r] = (double)item->to_unit[12 + r] + reach;
    }
}

/* Sets an item's matrices and box. Both the mesh's origin and the scene's centre may be large, so they are subtracted
 * in doubles. */
static void place_item(const struct hatch_unit_scene *unit, struct hatch_item *item)
{
    const double *origin = unit->meshes[item->mesh].origin;
    double world[16], normal[9], largest = 0;
    hatch_pose_matrix(&unit->pose, item->node, world);
    item->mirrored = hatch_pose_normal_matrix(world, normal);
    for (int c = 0; c < 3; c++)
        for (int r = 0; r < 3; r++) {
            item->to_unit[4 * c + r] = (float)(world[4 * c + r] / unit->bounds.radius);
            largest = fmax(largest, fabs(normal[3 * c + r]));
        }
    for (int i = 0; i < 9; i++)
        item->normal[i] = largest > 0 ? (float)(normal[i] / largest) : 0.0f;
    for (int r = 0; r < 3; r++) {
        double at = world[12 + r] - unit->bounds.center[r];
        for (int c = 0; c < 3; c++)
            at += world[4 * c + r] * origin[c];
        item->to_unit[12 + r] = (float)(at / unit->bounds.radius);
        item->to_unit[4 * r + 3] = 0.0f;
    }
    item->to_unit[15] = 1.0f;
    box_item(unit, item);
}

/* Finds the matrices that take a posed item to the world: that of its node or, of a skinned item, the first joint's
 * inverse bind matrix and the joint's matrix. Returns their number. */
static int matrices_of(const struct hatch_unit_scene *unit, const struct hatch_item *item, double matrices[2][16])
{
    uint32_t skin = unit->scene->nodes[item->node].skin;
    if (skin == HATCH_NONE || unit->scene->skins[skin].joint_count == 0) {
        hatch_pose_matrix(&unit->pose, item->node, matrices[0]);
        return 1;
    }
    for (int i = 0; i < 16; i++)
        matrices[0][i] = (double)unit->scene->skins[skin].inverse_bind[i];
    hatch_pose_matrix(&unit->pose, unit->scene->skins[skin].joints[0], matrices[1]);
    return 2;
}

static bool is_mirrored(const struct hatch_unit_scene *unit, const struct hatch_item *item)
{
    double matrices[2][16], normal[9];
    bool mirrored = false;
    for (int i = 0, count = matrices_of(unit, item, matrices); i < count; i++)
        mirrored ^= hatch_pose_normal_matrix(matrices[i], normal);
    return mirrored;
}

/* Replaces F by N F N^T. F is symmetric; N is column-major. */
static void transform_facing(const double n[9], double f[9])
{
    double product[9];
    for (int i = 0; i < 9; i++)
        product[i] = n[i / 3] * f[i % 3] + n[3 + i / 3] * f[3 + i % 3] + n[6 + i / 3] * f[6 + i % 3];
    for (int i = 0; i < 9; i++)
        f[i] = product[i / 3 * 3] * n[i % 3] + product[i / 3 * 3 + 1] * n[3 + i % 3] +
               product[i / 3 * 3 + 2] * n[6 + i % 3];
}

/* Returns the factor by which a posed item's matrices scale lengths on the meshes of its node: the root of that of
 * areas, as a quadratic mean. */
static double length_factor(const struct hatch_unit_scene *unit, const struct hatch_item *item)
{
    const struct hatch_node *node = &unit->scene->nodes[item->node];
    double matrices[2][16], normal[9], facing[9] = {0};
    for (uint32_t mesh = 0; mesh < node->mesh_count; mesh++)
        for (int i = 0; i < 9; i++)
            facing[i] += unit->meshes[node->first_mesh + mesh].areas[i / 3][i % 3];
    double before = facing[0] + facing[4] + facing[8];
    for (int i = 0, count = matrices_of(unit, item, matrices); i < count; i++) {
        hatch_pose_normal_matrix(matrices[i], normal);
        transform_facing(normal, facing);
    }
    return sqrt(sqrt((facing[0] + facing[4] + facing[8]) / before));
}

/* Sets the matrices of a deformed item, whose vertices are computed directly in the unit scene. */
static void place_deformed(const struct hatch_unit_scene *unit, struct hatch_item *item)
{
    static const float identity[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    static const float normal_identity[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    memcpy(item->to_unit, identity, sizeof identity);
    memcpy(item->normal, normal_identity, sizeof normal_identity);
    item->mirrored = is_mirrored(unit, item);
}

void hatch_unit_scene_pose(struct hatch_unit_scene *unit, uint32_t animation, double time_s)
{
    if (!unit->pose_number || animation != unit->animation || time_s < unit->time_s || time_s > unit->time_s)
        unit->pose_number++;
    unit->animation = animation;
    unit->time_s = time_s;
    hatch_pose_set(&unit->pose, animation, time_s);
    for (uint32_t i = 0; i < unit->item_count; i++) {
        struct hatch_item *item = &unit->items[i];
        if (item->deformed)
            place_deformed(unit, item);
        else
            place_item(unit, item);
    }
}

void hatch_item_deform(struct hatch_unit_scene *unit, struct hatch_item *item, double *positions, float *normals)
{
    size_t count = unit->meshes[item->mesh].mesh->vertex_count;
    hatch_pose_vertices(&unit->pose, item->node, item->mesh, positions, normals);
    for (size_t v = 0; v < count; v++) {
        double at[3];
        hatch_bounds_to_unit(&unit->bounds, positions + 3 * v, at);
        for (int k = 0; k < 3; k++) {
            item->low[k] = v ? fmin(item->low[k], at[k]) : at[k];
            item->high[k] = v ? fmax(item->high[k], at[k]) : at[k];
        }
    }
}

void hatch_item_surface(const struct hatch_unit_scene *unit, const struct hatch_item *item, double *positions,
                        float *normals)
{
    const struct hatch_mesh *surface = unit->meshes[item->mesh].surface;
    struct hatch_pose pose = unit->pose; /* hatch_pose_mesh writes to its scratch arrays only */
    hatch_pose_mesh(&pose, item->node, surface, positions, normals);
    for (size_t v = 0; v < surface->vertex_count; v++)
        hatch_bounds_to_unit(&unit->bounds, positions + 3 * v, positions + 3 * v);
}

void hatch_unit_scene_turn_rest(struct hatch_unit_scene *unit, const double turn_rad[3])
{
    for (int axis = 0; axis < 3; axis++)
        for (int k = 0; k < 3; k++)
            unit->rest_axes[axis][k] = axis == k;
    /* The axes of the texture turn as vectors of the mesh. */
    for (int around = 0; around < 3; around++)
        for (int axis = 0; axis < 3; axis++) {
            double *v = unit->rest_axes[axis], *a = &v[(around + 1) % 3], *b = &v[(around + 2) % 3];
            const double c = cos(turn_rad[around]), s = sin(turn_rad[around]), before = *a;
            *a = c * before - s * *b;
            *b = s * before + c * *b;
        }
}

struct hatch_item_rest hatch_item_rest(const struct hatch_unit_scene *unit, uint32_t index)
{
    static const double away[3] = {0.8191725133961645, 0.6710436067037893, 0.5497004779019703}; /* on no grid */
    const struct hatch_item *item = &unit->items[index];
    const struct hatch_node *node = &unit->scene->nodes[item->node];
    double half = 0, factor = length_factor(unit, item);
    for (uint32_t i = 0; i < node->mesh_count; i++)
        for (int k = 0; k < 3; k++)
            half = fmax(half, unit->meshes[node->first_mesh + i].half[k]);
    struct hatch_item_rest rest = {.unit = half > 0 ? exp2(floor(log2(half))) : 1};
    memcpy(rest.axes, unit->rest_axes, sizeof rest.axes);
    for (int k = 0; k < 3; k++)
        rest.offset[k] = fmod(hatch_vec_dot(rest.axes[k], unit->meshes[item->mesh].origin) / rest.unit, 64) + away[k];
    rest.scale = (factor > 0 && factor < INFINITY ? factor : 1) * rest.unit / unit->bounds.radius;
    return rest;
}

uint32_t hatch_unit_scene_vertices_max(const struct hatch_unit_scene *unit)
{
    uint32_t most = 0;
    for (uint32_t i = 0; i < unit->item_count; i++) {
        uint32_t count = unit->meshes[unit->items[i].mesh].surface->vertex_count;
        most = count > most ? count : most;
    }
    return most;
}
