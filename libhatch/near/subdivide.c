#include "near/subdivide.h"

#include <stddef.h>

#include "math/vector.h"

#define DEPTH_MAX 250 /* of the recursion: more halvings than any scene and view need */

struct cutting {
    const struct hatch_piece_view *view;
    double least_distance; /* distances of edges below this are raised to it */
    hatch_piece_visit visit;
    void *context;
};

/* Returns the distance of a segment from the origin, in the first `axes` coordinates. */
static double segment_distance(const double a[3], const double b[3], int axes)
{
    double along = 0, square = 0, sum = 0;
    for (int k = 0; k < axes; k++) {
        along -= a[k] * (b[k] - a[k]);
        square += (b[k] - a[k]) * (b[k] - a[k]);
    }
    double share = square > 0 ? fmin(fmax(along / square, 0), 1) : 0;
    for (int k = 0; k < axes; k++) {
        double at = a[k] + share * (b[k] - a[k]);
        sum += at * at;
    }
    return sqrt(sum);
}

/* Rounds the position of a corner to doubles. */
static void rounded(const struct hatch_piece_corner *corner, double at[3])
{
    for (int k = 0; k < 3; k++)
        at[k] = corner->at[k].high;
}

static bool comes_first(const double a[3], const double b[3])
{
    for (int k = 0; k < 3; k++)
        if (a[k] < b[k] || a[k] > b[k])
            return a[k] < b[k];
    return true;
}

/* Returns whether an edge must be cut. The result does not depend on the order of its ends, so that both faces at the
 * edge agree. */
static bool is_long(const struct cutting *c, const struct hatch_piece_corner *a, const struct hatch_piece_corner *b)
{
    double p[2][3];
    rounded(a, p[0]);
    rounded(b, p[1]);
    int first = comes_first(p[0], p[1]) ? 0 : 1;
    double distance = segment_distance(p[first], p[1 - first], c->view->orthographic ? 2 : 3);
    return hatch_vec_distance(p[first], p[1 - first]) > c->view->ratio * fmax(distance, c->least_distance);
}

/* Returns whether all three corners are outside one side of the visible region. */
static bool is_outside(const struct cutting *c, const struct hatch_piece_corner *const corner[3])
{
    const struct hatch_piece_view *view = c->view;
    bool outside[5] = {true, true, true, true, true};
    for (int i = 0; i < 3; i++) {
        double at[3];
        rounded(corner[i], at);
        double depth = view->orthographic ? 1.0 : -at[2];
        for (int k = 0; k < 2; k++) {
            outside[2 * k] = outside[2 * k] && at[k] < view->low[k] * depth;
            outside[2 * k + 1] = outside[2 * k + 1] && at[k] > view->high[k] * depth;
        }
        outside[4] = outside[4] && depth < view->near;
    }
    bool behind = outside[4] && !view->orthographic;
    return outside[0] || outside[1] || outside[2] || outside[3] || behind;
}

static void set_middle(const struct hatch_piece_corner *a, const struct hatch_piece_corner *b,
                       struct hatch_piece_corner *middle)
{
    for (int k = 0; k < 3; k++) {
        middle->at[k] = hatch_pair_half(hatch_pair_add(a->at[k], b->at[k]));
        middle->place[k] = hatch_pair_half(hatch_pair_add(a->place[k], b->place[k]));
        middle->weight[k] = 0.5 * (a->weight[k] + b->weight[k]);
    }
}

static double corner_distance(const struct hatch_piece_corner *a, const struct hatch_piece_corner *b)
{
    double p[2][3];
    rounded(a, p[0]);
    rounded(b, p[1]);
    return hatch_vec_distance(p[0], p[1]);
}

typedef const struct hatch_piece_corner *piece[3];

static void put(piece *out, const struct hatch_piece_corner *a, const struct hatch_piece_corner *b,
                const struct hatch_piece_corner *c)
{
    (*out)[0] = a;
    (*out)[1] = b;
    (*out)[2] = c;
}

static int longest_edge(const piece p)
{
    int longest = 0;
    for (int k = 1; k < 3; k++)
        if (corner_distance(p[k], p[(k + 1) % 3]) > corner_distance(p[longest], p[(longest + 1) % 3]))
            longest = k;
    return longest;
}

/* Lists the pieces of a triangle and returns their number. If all edges are cut, the triangle is bisected at its
 * longest edge, and then each half at its other cut edge (Rivara 1984). Four similar triangles would instead keep a
 * thin triangle thin, and its pieces would double in number with each step.
 *   p  corners
 *   m  midpoints of the edges from each corner to the next, NULL for an uncut edge; at least one is not NULL */
static int list_pieces(const piece p, const piece m, piece out[4])
{
    int cut = !!m[0] + !!m[1] + !!m[2], k = cut == 3 ? longest_edge(p) : 0;
    while (cut == 1 ? !m[k] : cut == 2 && m[k])
        k++;
    int next = (k + 1) % 3, last = (k + 2) % 3;
    if (cut == 1) {
        put(&out[0], p[k], m[k], p[last]);
        put(&out[1], m[k], p[next], p[last]);
        return 2;
    }
    if (cut == 3) {
        put(&out[0], p[k], m[k], m[last]);
        put(&out[1], m[k], p[last], m[last]);
        put(&out[2], m[k], m[next], p[last]);
        put(&out[3], m[k], p[next], m[next]);
        return 4;
    }
    bool first_shorter = corner_distance(p[k], m[next]) <= corner_distance(p[next], m[last]);
    put(&out[0], p[last], m[last], m[next]);
    put(&out[1], p[k], p[next], first_shorter ? m[next] : m[last]);
    put(&out[2], first_shorter ? p[k] : p[next], m[next], m[last]);
    return 3;
}

static enum hatch_status cut(const struct cutting *c, const piece corner, int depth_left, struct hatch_err *err)
{
    struct hatch_piece_corner middle[3];
    piece middles = {NULL, NULL, NULL}, pieces[4];
    bool whole = true;
    if (is_outside(c, corner))
        return HATCH_OK;
    for (int k = 0; k < 3 && depth_left > 0; k++) {
        const struct hatch_piece_corner *next = corner[(k + 1) % 3];
        if (!is_long(c, corner[k], next))
            continue;
        set_middle(corner[k], next, &middle[k]);
        middles[k] = &middle[k];
        whole = false;
    }
    if (whole)
        return c->visit(c->context, corner, err);
    int count = list_pieces(corner, middles, pieces);
    for (int i = 0; i < count; i++)
        HATCH_TRY(cut(c, pieces[i], depth_left - 1, err));
    return HATCH_OK;
}

enum hatch_status hatch_pieces_cut(const struct hatch_piece_corner face[3], const struct hatch_piece_view *view,
                                   hatch_piece_visit visit, void *context, struct hatch_err *err)
{
    struct cutting c = {.view = view, .least_distance = view->near, .visit = visit, .context = context};
    if (view->orthographic)
        c.least_distance =
            fmax(fmax(fabs(view->low[0]), fabs(view->high[0])), fmax(fabs(view->low[1]), fabs(view->high[1])));
    const piece corner = {&face[0], &face[1], &face[2]};
    return cut(&c, corner, DEPTH_MAX, err);
}

double hatch_piece_distance(const double corner[3][3])
{
    double normal[3], side[3], least = INFINITY;
    hatch_vec_triangle(corner[0], corner[1], corner[2], normal);
    double size = hatch_vec_length(normal);
    bool within = size > 0;
    for (int k = 0; k < 3; k++) {
        const double *a = corner[k], *b = corner[(k + 1) % 3];
        least = fmin(least, segment_distance(a, b, 3));
        hatch_vec_cross(a, b, side);
        within = within && hatch_vec_dot(side, normal) > 0;
    }
    return within ? fmin(least, fabs(hatch_vec_dot(corner[0], normal)) / size) : least;
}

struct hatch_pair hatch_piece_fixed(struct hatch_pair a, uint32_t words[4])
{
    struct hatch_pair rest = {a.high * 0x1p-32, a.low * 0x1p-32};
    for (int i = 3; i >= 0; i--) {
        struct hatch_pair whole = hatch_pair_floor(rest);
        words[i] = (uint32_t)(int64_t)hatch_pair_round(whole);
        rest = hatch_pair_sub(rest, whole);
        rest = (struct hatch_pair){rest.high * 0x1p32, rest.low * 0x1p32};
    }
    return (struct hatch_pair){rest.high * 0x1p-96, rest.low * 0x1p-96};
}
