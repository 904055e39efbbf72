#include <math.h>
#include <string.h>

#include "lapped/work.h"

/* Rounds over the faces that rounding has turned over, and how far a vertex is moved, in doublings of the
 * distance between the floats of its patch. */
#define ROUNDS 12
#define REACHES 6
/* Directions of a vertex's way. */
#define WAYS 8

struct rounding {
    const uint32_t *corners; /* 3 a face */
    uint32_t face_count, vertex_count;
    float *at;               /* 2 a vertex */
    uint32_t *first, *faces; /* of each vertex: its faces */
    double step;             /* between the floats where they are sparsest */
};

/* v falls: seen from outside a face runs clockwise. Floats' differences and products hold in doubles. */
static bool turned_over(const struct rounding *of, uint32_t face)
{
    const uint32_t *corner = &of->corners[3 * (size_t)face];
    const float *a = &of->at[2 * (size_t)corner[0]], *b = &of->at[2 * (size_t)corner[1]];
    const float *c = &of->at[2 * (size_t)corner[2]];
    double bx = (double)b[0] - (double)a[0], by = (double)b[1] - (double)a[1];
    double cx = (double)c[0] - (double)a[0], cy = (double)c[1] - (double)a[1];
    return !(bx * cy - by * cx < 0);
}

static uint32_t count_turned(const struct rounding *of, uint32_t vertex)
{
    uint32_t count = 0;
    for (uint32_t i = of->first[vertex]; i < of->first[vertex + 1]; i++)
        count += turned_over(of, of->faces[i]);
    return count;
}

/* Moves a vertex no further than is needed for the fewest of its faces to be turned over; false where it
 * stays. */
static bool move(const struct rounding *of, uint32_t vertex)
{
    static const int way[WAYS][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
    float *at = &of->at[2 * (size_t)vertex], best[2] = {at[0], at[1]};
    const float from[2] = {at[0], at[1]};
    uint32_t before = count_turned(of, vertex), least = before;
    for (int i = 0; i < WAYS * REACHES && least > 0; i++) {
        for (int k = 0; k < 2; k++)
            at[k] = (float)((double)from[k] + of->step * ldexp(way[i % WAYS][k], i / WAYS));
        uint32_t now = count_turned(of, vertex);
        if (now < least) {
            least = now;
            memcpy(best, at, sizeof best);
        }
    }
    memcpy(at, best, sizeof best);
    return least < before;
}

static enum hatch_status list_faces(struct rounding *of, struct hatch_arena *scratch, struct hatch_err *err)
{
    of->first = HATCH_NEW(scratch, uint32_t, (size_t)of->vertex_count + 1, err);
    of->faces = of->first ? HATCH_NEW_UNSET(scratch, uint32_t, 3 * (size_t)of->face_count, err) : NULL;
    if (!of->faces)
        return HATCH_LIMIT;
    for (uint32_t i = 0; i < 3 * of->face_count; i++)
        of->first[of->corners[i]]++;
    for (uint32_t v = 0; v < of->vertex_count; v++)
        of->first[v + 1] += of->first[v];
    /* Filled from behind: each vertex's place falls to where it begins. */
    for (uint32_t i = 3 * of->face_count; i-- > 0;)
        of->faces[--of->first[of->corners[i]]] = i / 3;
    return HATCH_OK;
}

static void mend(const struct rounding *of)
{
    bool moved = true;
    for (int round = 0; round < ROUNDS && moved; round++) {
        moved = false;
        for (uint32_t f = 0; f < of->face_count; f++)
            for (uint32_t c = 0; c < 3 && turned_over(of, f); c++)
                moved = move(of, of->corners[3 * (size_t)f + c]) || moved;
    }
}

enum hatch_status hatch_lapped_round(const struct hatch_lapped *lapped, const struct hatch_lapped_patch *patch,
                                     double tile, struct hatch_arena *scratch, float *hatch, struct hatch_err *err)
{
    struct rounding of = {.corners = &lapped->corners[3 * (size_t)patch->first_face],
                          .face_count = patch->face_count,
                          .vertex_count = patch->vertex_count,
                          .at = hatch};
    float most = 0;
    for (size_t i = 0; i < 2 * (size_t)patch->vertex_count; i++) {
        double along = lapped->vertices[patch->first_vertex + i / 2].hatch[i % 2];
        hatch[i] = (float)(along / tile + patch->shift[i % 2]);
        most = fmaxf(most, fabsf(hatch[i]));
    }
    of.step = (double)(nextafterf(most, HUGE_VALF) - most);
    uint32_t face = 0;
    while (face < of.face_count && !turned_over(&of, face))
        face++;
    if (face < of.face_count) {
        HATCH_TRY(list_faces(&of, scratch, err));
        mend(&of);
    }
    return HATCH_OK;
}
