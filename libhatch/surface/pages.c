/* Edges of more than two faces, as Guéziec, Taubin, Lazarus and Horn ("Cutting and stitching", TVCG 2001) treat
 * them: all pages are cut from one another, then those that continue one another are stitched. */
#include "math/vector.h"
#include "surface/work.h"

#define PAGES_MAX 8u /* pairs are tried all against all; edges of more stay cut */

struct page {
    uint32_t side;
    uint32_t component;
    bool forward; /* runs from the lower point, as turned */
    double direction[3];
};

/* Two pages that are one bent sheet: of those that agree, two that hang together elsewhere if there are
 * such (parts that do not may each lie either way round), and of these as flat as can be. */
static bool find_pair(const struct page *pages, uint32_t count, uint32_t *a, uint32_t *b)
{
    const double apart = 4, none = 8; /* over any fold, and over any fold apart */
    double least = none;
    for (uint32_t i = 0; i < count; i++)
        for (uint32_t k = i + 1; k < count; k++) {
            double fold = hatch_vec_dot(pages[i].direction, pages[k].direction);
            if (pages[i].component != pages[k].component)
                fold += apart;
            if (pages[i].forward != pages[k].forward && fold < least) {
                least = fold;
                *a = i;
                *b = k;
            }
        }
    return least < none;
}

static uint32_t join_edge(const struct hatch_surface_work *w, const uint32_t *sides, uint32_t count)
{
    struct page pages[PAGES_MAX];
    uint32_t pairs = 0, a = 0, b = 0;
    for (uint32_t i = 0; i < count; i++) {
        pages[i].side = sides[i];
        pages[i].component = w->component[sides[i] / 3];
        pages[i].forward = (w->point[sides[i]] < w->point[hatch_side_end(sides[i])]) != (w->flipped[sides[i] / 3] != 0);
        hatch_side_direction(w->mesh, sides[i], pages[i].direction);
    }
    for (; find_pair(pages, count, &a, &b); pairs++) {
        w->partner[pages[a].side] = pages[b].side;
        w->partner[pages[b].side] = pages[a].side;
        pages[b] = pages[--count]; /* b first: it is the higher of the two */
        pages[a] = pages[--count];
    }
    return pairs;
}

uint32_t hatch_surface_join_pages(const struct hatch_surface_work *w)
{
    uint32_t pairs = 0;
    for (uint32_t e = 0; e < w->edges.count; e++) {
        uint32_t count = w->edges.first[e + 1] - w->edges.first[e];
        if (count > 2 && count <= PAGES_MAX)
            pairs += join_edge(w, &w->edges.sides[w->edges.first[e]], count);
    }
    return pairs;
}
