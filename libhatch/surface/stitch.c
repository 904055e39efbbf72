/* Edges with more than two faces (Guéziec, Taubin, Lazarus, Horn, "Cutting and stitching", TVCG 2001): all their faces
 * are cut apart, then stitched in pairs, each of which continues one sheet. */
#include "math/vector.h"
#include "surface/work.h"

#define FACES_MAX 8u /* largest number of faces for which all pairs are tried; edges with more faces stay cut */

/* A face at an edge. */
struct wing {
    uint32_t side;
    uint32_t component;
    bool forward;        /* whether the side, once its face is oriented, starts at the lower point */
    double direction[3]; /* unit, in the face, perpendicular to the edge */
};

/* Finds the two wings that best form one sheet: they are oriented consistently; they preferably lie in one component,
 * as the orientations of two components are independent; and they are as flat as possible. */
static bool find_pair(const struct wing *wings, uint32_t count, uint32_t *a, uint32_t *b)
{
    const double other_component = 4, none = 8; /* more than any difference of cosines; more than any cost */
    double least = none;
    for (uint32_t i = 0; i < count; i++)
        for (uint32_t k = i + 1; k < count; k++) {
            double cost = hatch_vec_dot(wings[i].direction, wings[k].direction);
            if (wings[i].component != wings[k].component)
                cost += other_component;
            if (wings[i].forward != wings[k].forward && cost < least) {
                least = cost;
                *a = i;
                *b = k;
            }
        }
    return least < none;
}

static uint32_t join_edge(const struct hatch_surface_work *w, const uint32_t *sides, uint32_t count)
{
    struct wing wings[FACES_MAX];
    uint32_t pairs = 0, a = 0, b = 0;
    for (uint32_t i = 0; i < count; i++) {
        wings[i].side = sides[i];
        wings[i].component = w->component[sides[i] / 3];
        wings[i].forward = (w->point[sides[i]] < w->point[hatch_side_end(sides[i])]) != (w->flipped[sides[i] / 3] != 0);
        hatch_side_direction(w->mesh, sides[i], wings[i].direction);
    }
    for (; find_pair(wings, count, &a, &b); pairs++) {
        w->partner[wings[a].side] = wings[b].side;
        w->partner[wings[b].side] = wings[a].side;
        wings[b] = wings[--count]; /* b is removed first, because b > a */
        wings[a] = wings[--count];
    }
    return pairs;
}

uint32_t hatch_surface_stitch_edges(const struct hatch_surface_work *w)
{
    uint32_t pairs = 0;
    for (uint32_t e = 0; e < w->edges.count; e++) {
        uint32_t count = w->edges.first[e + 1] - w->edges.first[e];
        if (count > 2 && count <= FACES_MAX)
            pairs += join_edge(w, &w->edges.sides[w->edges.first[e]], count);
    }
    return pairs;
}
