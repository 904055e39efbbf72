#include "mesh/skin/influences.h"

#include <stdio.h>
#include <string.h>

void hatch_influences_add(struct hatch_influences *influences, float joint, float weight)
{
    uint32_t at = 0;
    while (at < influences->count && influences->joint[at] != joint)
        at++;
    if (at == influences->count) {
        influences->joint[at] = joint;
        influences->weight[at] = 0;
        influences->count++;
    }
    influences->weight[at] += weight;
}

/* Returns the index of the heaviest influence that is not taken; count if none weighs over 0. */
static uint32_t heaviest(const struct hatch_influences *influences, const bool *taken)
{
    uint32_t best = influences->count;
    for (uint32_t i = 0; i < influences->count; i++)
        if (!taken[i] && influences->weight[i] > (best < influences->count ? influences->weight[best] : 0))
            best = i;
    return best;
}

bool hatch_influences_keep(const struct hatch_influences *influences, float joints[HATCH_INFLUENCES],
                           float weights[HATCH_INFLUENCES])
{
    bool taken[HATCH_INFLUENCES_MAX] = {false};
    for (uint32_t i = 0; i < HATCH_INFLUENCES; i++) {
        uint32_t best = heaviest(influences, taken);
        bool any = best < influences->count;
        joints[i] = any ? influences->joint[best] : 0;
        weights[i] = any ? influences->weight[best] : 0;
        if (any)
            taken[best] = true;
    }
    return heaviest(influences, taken) < influences->count;
}

/* The sets of a mesh. */
struct sets {
    uint32_t count;
    float *joints[HATCH_INFLUENCE_SETS], *weights[HATCH_INFLUENCE_SETS];
};

/* Keeps the heaviest influences of a vertex in its first set. Returns whether others are left out. */
static bool keep_of_vertex(const struct sets *sets, size_t vertex)
{
    struct hatch_influences all = {.count = 0};
    float joints[HATCH_INFLUENCES], weights[HATCH_INFLUENCES], total = 0, kept = 0;
    const size_t first = HATCH_INFLUENCES * vertex;
    for (uint32_t set = 0; set < sets->count; set++)
        for (size_t i = first; i < first + HATCH_INFLUENCES; i++)
            if (sets->weights[set][i] > 0) {
                hatch_influences_add(&all, sets->joints[set][i], sets->weights[set][i]);
                total += sets->weights[set][i];
            }
    if (all.count == 0)
        return false;
    bool left_out = hatch_influences_keep(&all, joints, weights);
    for (uint32_t i = 0; i < HATCH_INFLUENCES; i++)
        kept += weights[i];
    for (uint32_t i = 0; i < HATCH_INFLUENCES; i++) {
        sets->joints[0][first + i] = joints[i];
        sets->weights[0][first + i] = left_out ? weights[i] * (total / kept) : weights[i];
    }
    return left_out;
}

static void remove_attribute(struct hatch_mesh *mesh, const char *name)
{
    uint32_t at = 0;
    while (strcmp(mesh->attributes[at].name, name) != 0)
        at++;
    mesh->attribute_count--;
    memmove(&mesh->attributes[at], &mesh->attributes[at + 1], (mesh->attribute_count - at) * sizeof *mesh->attributes);
}

uint32_t hatch_mesh_keep_influences(struct hatch_mesh *mesh)
{
    struct sets sets = {.count = 0};
    char joints[HATCH_MESH_NAME_MAX], weights[HATCH_MESH_NAME_MAX];
    uint32_t crowded = 0;
    for (uint32_t set = 0; set < HATCH_INFLUENCE_SETS; set++) {
        snprintf(joints, sizeof joints, "JOINTS_%u", set);
        snprintf(weights, sizeof weights, "WEIGHTS_%u", set);
        sets.joints[set] = hatch_mesh_find(mesh, joints, HATCH_INFLUENCES);
        sets.weights[set] = hatch_mesh_find(mesh, weights, HATCH_INFLUENCES);
        if (!sets.joints[set] || !sets.weights[set])
            break;
        sets.count++;
        if (set > 0) {
            remove_attribute(mesh, joints);
            remove_attribute(mesh, weights);
        }
    }
    for (uint32_t v = 0; sets.count > 1 && v < mesh->vertex_count; v++)
        crowded += keep_of_vertex(&sets, v);
    return crowded;
}
