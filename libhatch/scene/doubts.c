/* Finds what is allowed in a scene, but hardly ever meant. */
#include <math.h>
#include <string.h>

#include "base/random.h"
#include "math/vector.h"
#include "scene/scene.h"

#define UNIT_ERROR 0.01   /* largest error of a length, or of a sum of weights, that rounding explains */
#define VOLUME_SHARE 1e-5 /* of the area to the power of 3/2: smaller volumes have no side */
#define ACROSS 0.5        /* cosine of the angle up to which a normal lies across a face, and tells no side */
#define INWARD_SHARE 0.01 /* smooth normals may point inwards at the tip of a fold: share of the vertices allowed */

/* Returns a hash of a position. */
static uint64_t hash_of(const double p[3])
{
    uint64_t hash = 0, bits;
    for (int k = 0; k < 3; k++) {
        double value = p[k] + 0.0; /* -0 equals 0 */
        memcpy(&bits, &value, sizeof bits);
        hash = hatch_random_mix(hash + bits);
    }
    return hash;
}

/* Returns a hash of the way from one position to another; that of the way back is the same, negated. */
static uint64_t hash_of_way(uint64_t from, uint64_t to)
{
    return from < to ? hatch_random_mix(hatch_random_mix(from) + to)
                     : 0 - hatch_random_mix(hatch_random_mix(to) + from);
}

static void doubt_faces(const struct hatch_mesh *mesh, struct hatch_mesh_notes *notes)
{
    double area = 0, volume = 0, middle[3] = {0, 0, 0}, p[3][3], normal[3];
    uint64_t open = 0; /* 0 where each side has another one the opposite way: closed, and all faces agree */
    bool any = false;
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        if (!hatch_mesh_corners(mesh, f, p))
            continue;
        if (!any)
            hatch_vec_copy(p[0], middle);
        any = true;
        hatch_vec_triangle(p[0], p[1], p[2], normal);
        double twice = hatch_vec_length(normal), longest = 0, arm[3];
        const uint64_t corner[3] = {hash_of(p[0]), hash_of(p[1]), hash_of(p[2])};
        for (int c = 0; c < 3; c++) {
            longest = fmax(longest, hatch_vec_distance(p[c], p[(c + 1) % 3]));
            open += hash_of_way(corner[c], corner[(c + 1) % 3]);
        }
        notes->needles += longest * longest > HATCH_NEEDLE * twice;
        hatch_vec_sub(p[0], middle, arm);
        volume += hatch_vec_dot(arm, normal) / 6;
        area += twice / 2;
    }
    notes->meshes_inside_out += open == 0 && volume < -VOLUME_SHARE * area * sqrt(area);
}

static void doubt_normals(const struct hatch_mesh *mesh, struct hatch_arena *scratch, struct hatch_mesh_notes *notes)
{
    const float *normals = hatch_mesh_find(mesh, "NORMAL", 3);
    struct hatch_err err;
    uint8_t *sides = normals ? HATCH_NEW(scratch, uint8_t, mesh->vertex_count, &err) : NULL;
    double p[3][3], face[3], normal[3];
    uint32_t inward = 0;
    for (uint32_t f = 0; f < mesh->face_count && sides; f++) {
        if (!hatch_mesh_corners(mesh, f, p))
            continue;
        hatch_vec_triangle(p[0], p[1], p[2], face);
        for (int c = 0; c < 3; c++) {
            uint32_t v = mesh->indices[3 * (size_t)f + (size_t)c];
            hatch_vec_of(&normals[3 * (size_t)v], normal);
            double cosine = hatch_vec_dot(normal, face) / (hatch_vec_length(normal) * hatch_vec_length(face));
            sides[v] |= cosine < -ACROSS ? 1 : cosine > ACROSS ? 2 : 0;
        }
    }
    for (uint32_t v = 0; v < mesh->vertex_count && sides; v++) {
        hatch_vec_of(&normals[3 * (size_t)v], normal);
        notes->normals_not_unit += !(fabs(hatch_vec_length(normal) - 1) <= UNIT_ERROR);
        inward += sides[v] == 1;
    }
    notes->normals_inward += inward > INWARD_SHARE * mesh->vertex_count ? inward : 0;
}

static void doubt_texcoords(const struct hatch_mesh *mesh, struct hatch_mesh_notes *notes)
{
    const float *uv = hatch_mesh_find(mesh, "TEXCOORD_0", 2);
    bool same = uv && mesh->vertex_count > 0;
    for (size_t i = 2; same && i < 2 * (size_t)mesh->vertex_count; i++)
        same = !(uv[i] < uv[i % 2]) && !(uv[i] > uv[i % 2]);
    notes->texcoords_flat += same;
}

static void doubt_weights(const struct hatch_mesh *mesh, struct hatch_mesh_notes *notes)
{
    const float *weights = hatch_mesh_find(mesh, "WEIGHTS_0", 4);
    for (size_t v = 0; v < mesh->vertex_count && weights; v++) {
        double sum = 0;
        for (size_t k = 0; k < 4; k++)
            sum += (double)weights[4 * v + k];
        notes->weights_wrong += !(fabs(sum - 1) <= UNIT_ERROR);
    }
}

static bool is_flat(const struct hatch_node *node)
{
    double column[3][3], normal[3];
    if (!node->has_matrix)
        return node->scale[0] == 0 || node->scale[1] == 0 || node->scale[2] == 0;
    for (int k = 0; k < 3; k++)
        hatch_vec_copy(&node->matrix[4 * k], column[k]);
    hatch_vec_cross(column[0], column[1], normal);
    return hatch_vec_dot(normal, column[2]) == 0;
}

void hatch_scene_doubt(const struct hatch_scene *scene, struct hatch_arena *scratch, struct hatch_mesh_notes *notes)
{
    for (uint32_t i = 0; i < scene->mesh_count; i++) {
        const struct hatch_scene_mesh *from = &scene->meshes[i];
        struct hatch_arena_mark mark = hatch_arena_mark(scratch);
        doubt_faces(&from->mesh, notes);
        /* A patch has only some of the faces around its vertices. */
        bool is_patch = from->material != HATCH_NONE && scene->materials[from->material].outline;
        if (from->had_normals && !is_patch)
            doubt_normals(&from->mesh, scratch, notes);
        hatch_arena_rewind(scratch, mark);
        doubt_texcoords(&from->mesh, notes);
        doubt_weights(&from->mesh, notes);
    }
    for (uint32_t i = 0; i < scene->node_count; i++)
        notes->nodes_flat += scene->nodes[i].mesh_count > 0 && is_flat(&scene->nodes[i]);
}
