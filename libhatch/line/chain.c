#include "line/chain.h"

#include "math/vector.h"

#define OPEN UINT32_MAX
#define PAIRED_ENDS_MAX 16u /* at nodes with more ends, every chain ends: the time to pair them would be cubic */

/* Ends of segments are numbered: end e of segment s is 2 * s + e. */
struct work {
    const struct hatch_line_graph *graph;
    uint32_t *first;   /* node_count + 2 items; per node: its range in ends_at */
    uint32_t *ends_at; /* ends, by node */
    uint32_t *link;    /* per end: the end with which the chain continues, or OPEN */
    uint8_t *taken;    /* per segment: 1: it is in a chain */
};

/* Sorts ends by node (a counting sort). Meanwhile first[node + 1] is the position for the node's next end. */
static void list_ends(struct work *w)
{
    const struct hatch_line_graph *graph = w->graph;
    uint32_t ends = 2 * graph->segment_count;
    for (uint32_t end = 0; end < ends; end++)
        w->first[graph->ends[end] + 2]++;
    for (uint32_t node = 0; node < graph->node_count; node++)
        w->first[node + 2] += w->first[node + 1];
    for (uint32_t end = 0; end < ends; end++) {
        w->ends_at[w->first[graph->ends[end] + 1]++] = end;
        w->link[end] = OPEN;
    }
}

/* Returns the cosine of the angle between two segments at a common node: -1 if one continues the other straight. */
static double cosine(const struct hatch_line_graph *graph, uint32_t a, uint32_t b)
{
    double away[2][3];
    const uint32_t ends[2] = {a, b};
    for (int i = 0; i < 2; i++) {
        const double *near = &graph->nodes[3 * (size_t)graph->ends[ends[i]]];
        const double *far = &graph->nodes[3 * (size_t)graph->ends[ends[i] ^ 1]];
        hatch_vec_sub(far, near, away[i]);
        hatch_vec_normalize(away[i]);
    }
    return hatch_vec_dot(away[0], away[1]);
}

/* Pairs the ends at a node, the straightest pair first. */
static void link_node(struct work *w, uint32_t node)
{
    const uint32_t *ends = &w->ends_at[w->first[node]];
    uint32_t count = w->first[node + 1] - w->first[node];
    for (uint32_t pairs = count / 2; pairs > 0 && (count == 2 || count <= PAIRED_ENDS_MAX); pairs--) {
        uint32_t best[2] = {OPEN, OPEN};
        double least = 2;
        for (uint32_t i = 0; i < count; i++)
            for (uint32_t j = i + 1; j < count; j++) {
                if (w->link[ends[i]] != OPEN || w->link[ends[j]] != OPEN)
                    continue;
                double bend = cosine(w->graph, ends[i], ends[j]);
                if (bend < least) {
                    least = bend;
                    best[0] = ends[i];
                    best[1] = ends[j];
                }
            }
        if (best[0] == OPEN)
            return;
        w->link[best[0]] = best[1];
        w->link[best[1]] = best[0];
    }
}

/* Returns whether other segments meet the node of an end. */
static bool is_joined(const struct work *w, uint32_t end)
{
    uint32_t node = w->graph->ends[end];
    return w->first[node + 1] - w->first[node] > 1;
}

/* Writes the chain that starts at an end. */
static void walk(struct work *w, uint32_t begin, uint32_t first, struct hatch_line_chains *chains)
{
    struct hatch_line_chain *chain = &chains->chains[chains->count];
    uint32_t *nodes = &chains->nodes[first + chains->count], end = begin;
    *chain = (struct hatch_line_chain){.first = first};
    nodes[0] = w->graph->ends[begin];
    for (;;) {
        uint32_t segment = end / 2;
        w->taken[segment] = 1;
        chains->segments[first + chain->segment_count++] = segment;
        nodes[chain->segment_count] = w->graph->ends[end ^ 1];
        uint32_t next = w->link[end ^ 1];
        if (next == OPEN || w->taken[next / 2]) {
            chain->closed = next == begin;
            break;
        }
        end = next;
    }
    chain->joined[0] = is_joined(w, begin);
    chain->joined[1] = is_joined(w, end ^ 1);
    chains->count++;
}

static enum hatch_status find(struct work *w, struct hatch_arena *arena, struct hatch_arena *scratch,
                              struct hatch_line_chains *chains, struct hatch_err *err)
{
    const struct hatch_line_graph *graph = w->graph;
    size_t segments = graph->segment_count, nodes = graph->node_count;
    struct hatch_line_chains made = {.count = 0};
    HATCH_TRY(HATCH_ALLOC(arena, &made.chains, segments, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.nodes, 2 * segments, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.segments, segments, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &w->first, nodes + 2, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &w->ends_at, 2 * segments, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &w->link, 2 * segments, err));
    HATCH_TRY(HATCH_ALLOC(scratch, &w->taken, segments, err));
    list_ends(w);
    for (uint32_t node = 0; node < nodes; node++)
        link_node(w, node);
    uint32_t used = 0;
    for (int closed = 0; closed < 2; closed++)
        for (uint32_t end = 0; end < 2 * segments; end++)
            if (!w->taken[end / 2] && (closed || w->link[end] == OPEN)) {
                walk(w, end, used, &made);
                used += made.chains[made.count - 1].segment_count;
            }
    *chains = made;
    return HATCH_OK;
}

enum hatch_status hatch_line_chains_make(const struct hatch_line_graph *graph, struct hatch_arena *arena,
                                         struct hatch_arena *scratch, struct hatch_line_chains *chains,
                                         struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    struct work work = {.graph = graph};
    enum hatch_status status = find(&work, arena, scratch, chains, err);
    hatch_arena_rewind(scratch, mark);
    return status;
}
