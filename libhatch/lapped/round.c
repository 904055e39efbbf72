#include <math.h>
#include <string.h>

#include "lapped/work.h"

#define FACES_MAX 128u /* at a vertex that moves: to move the hub of a fan takes the square of their number */
/* Number of rounds over the faces that rounding has turned over, and number of distances by which a vertex may be
 * moved: 1, 2, 4 .. times the distance between floats. */
#define ROUNDS 12
#define DOUBLINGS 6
/* Number of directions in which a vertex may be moved. */
#define DIRECTIONS 8

struct rounding {
    const uint32_t *corners; /* 3 per face */
    uint32_t face_count, vertex_count;
    float *uv;               /* 2 per vertex */
    uint32_t *first, *faces; /* faces of vertex v: faces[first[v]] .. faces[first[v + 1] - 1] */
    double step;             /* distance between floats at the largest coordinate */
};

/* Returns whether a face is turned over. Because v points down, a face that is not turned over has a negative area in u
 * and v. Differences and products of floats are exact in doubles. */
static bool turned_over(const struct rounding *rounding, uint32_t face)
{
    const uint32_t *corner = &rounding->corners[3 * (size_t)face];
    const float *a = &rounding->uv[2 * (size_t)corner[0]], *b = &rounding->uv[2 * (size_t)corner[1]];
    const float *c = &rounding->uv[2 * (size_t)corner[2]];
    double bx = (double)b[0] - (double)a[0], by = (double)b[1] - (double)a[1];
    double cx = (double)c[0] - (double)a[0], cy = (double)c[1] - (double)a[1];
    return !(bx * cy - by * cx < 0);
}

static uint32_t count_turned(const struct rounding *rounding, uint32_t vertex)
{
    uint32_t count = 0;
    for (uint32_t i = rounding->first[vertex]; i < rounding->first[vertex + 1]; i++)
        count += turned_over(rounding, rounding->faces[i]);
    return count;
}

/* Moves a vertex to where the fewest of its faces are turned over, by the shortest move that achieves this. Returns
 * false if no move helps. */
static bool move_vertex(const struct rounding *rounding, uint32_t vertex)
{
    static const int direction[DIRECTIONS][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
    float *uv = &rounding->uv[2 * (size_t)vertex], best[2] = {uv[0], uv[1]};
    const float from[2] = {uv[0], uv[1]};
    if (rounding->first[vertex + 1] - rounding->first[vertex] > FACES_MAX)
        return false;
    uint32_t before = count_turned(rounding, vertex), least = before;
    for (int i = 0; i < DIRECTIONS * DOUBLINGS && least > 0; i++) {
        for (int k = 0; k < 2; k++)
            uv[k] = (float)((double)from[k] + rounding->step * ldexp(direction[i % DIRECTIONS][k], i / DIRECTIONS));
        uint32_t now = count_turned(rounding, vertex);
        if (now < least) {
            least = now;
            memcpy(best, uv, sizeof best);
        }
    }
    memcpy(uv, best, sizeof best);
    return least < before;
}

static enum hatch_status list_faces(struct rounding *rounding, struct hatch_arena *scratch, struct hatch_err *err)
{
    HATCH_TRY(HATCH_ALLOC(scratch, &rounding->first, (size_t)rounding->vertex_count + 1, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(scratch, &rounding->faces, 3 * (size_t)rounding->face_count, err));
    for (uint32_t i = 0; i < 3 * rounding->face_count; i++)
        rounding->first[rounding->corners[i]]++;
    for (uint32_t v = 0; v < rounding->vertex_count; v++)
        rounding->first[v + 1] += rounding->first[v];
    /* Filled from the end: first[v] falls to the start of vertex v. */
    for (uint32_t i = 3 * rounding->face_count; i-- > 0;)
        rounding->faces[--rounding->first[rounding->corners[i]]] = i / 3;
    return HATCH_OK;
}

static void repair(const struct rounding *rounding)
{
    bool moved = true;
    for (int round = 0; round < ROUNDS && moved; round++) {
        moved = false;
        for (uint32_t f = 0; f < rounding->face_count; f++)
            for (uint32_t c = 0; c < 3 && turned_over(rounding, f); c++)
                moved = move_vertex(rounding, rounding->corners[3 * (size_t)f + c]) || moved;
    }
}

enum hatch_status hatch_lapped_round(const struct hatch_lapped *lapped, const struct hatch_lapped_patch *patch,
                                     double tile, struct hatch_arena *scratch, float *hatch, struct hatch_err *err)
{
    struct rounding rounding = {.corners = &lapped->corners[3 * (size_t)patch->first_face],
                                .face_count = patch->face_count,
                                .vertex_count = patch->vertex_count,
                                .uv = hatch};
    float largest = 0;
    for (size_t i = 0; i < 2 * (size_t)patch->vertex_count; i++) {
        double along = lapped->vertices[patch->first_vertex + i / 2].hatch[i % 2];
        hatch[i] = (float)(along / tile + patch->shift[i % 2]);
        largest = fmaxf(largest, fabsf(hatch[i]));
    }
    rounding.step = (double)(nextafterf(largest, HUGE_VALF) - largest);
    uint32_t face = 0;
    while (face < rounding.face_count && !turned_over(&rounding, face))
        face++;
    if (face < rounding.face_count) {
        HATCH_TRY(list_faces(&rounding, scratch, err));
        repair(&rounding);
    }
    return HATCH_OK;
}
