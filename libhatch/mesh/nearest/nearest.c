#include "mesh/nearest/nearest.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "math/triangle.h"
#include "math/vector.h"

#define LEAF_FACES 4u
#define DEPTH_MAX 32
#define SLENDER 8.0   /* length of a capsule's segment in radii from which the capsule is used */
#define SPANS_MIN 32u /* leaves with capsules from which they are worth their tests */
#define SAFETY 1e-9   /* share of lengths by which bounds are loosened: roundings are smaller */

/* A face and the cell of its centre, on a curve that keeps neighbours together. */
struct located {
    uint64_t cell;
    uint32_t face;
};

static int compare(const void *a, const void *b)
{
    const struct located *x = a, *y = b;
    return x->cell != y->cell ? (x->cell < y->cell ? -1 : 1) : x->face < y->face ? -1 : x->face > y->face;
}

/* Interleaves the bits of the coordinates of a face's centre (Morton order). */
static uint64_t cell_of(double corners[3][3], const float low[3], const float high[3])
{
    uint64_t cell = 0;
    for (int k = 0; k < 3; k++) {
        double size = (double)high[k] - (double)low[k], sum = corners[0][k] + corners[1][k] + corners[2][k];
        double at = size > 0 ? (sum / 3 - (double)low[k]) / size : 0;
        uint64_t whole = (uint64_t)(fmin(fmax(at, 0), 1) * 0xfffff);
        for (int bit = 0; bit < 20; bit++)
            cell |= (whole >> bit & 1) << (3 * bit + k);
    }
    return cell;
}

static uint32_t leaf_begin(const struct hatch_nearest *nearest, uint32_t leaf)
{
    return (uint32_t)((uint64_t)leaf * nearest->face_count / nearest->leaf_count);
}

static void box_faces(const struct hatch_nearest *nearest, uint32_t leaf, float *box)
{
    for (size_t i = 3 * (size_t)leaf_begin(nearest, leaf); i < 3 * (size_t)leaf_begin(nearest, leaf + 1); i++)
        for (size_t k = 0; k < 3; k++) {
            box[k] = fminf(box[k], nearest->corners[3 * i + k]);
            box[3 + k] = fmaxf(box[3 + k], nearest->corners[3 * i + k]);
        }
}

static void make_boxes(const struct hatch_nearest *nearest)
{
    for (uint32_t node = 2 * nearest->leaf_count; node-- > 1;) {
        float *box = &nearest->boxes[6 * (size_t)node];
        for (int k = 0; k < 3; k++) {
            box[k] = INFINITY;
            box[3 + k] = -INFINITY;
        }
        if (node >= nearest->leaf_count) {
            box_faces(nearest, node - nearest->leaf_count, box);
            continue;
        }
        for (size_t child = 2 * (size_t)node; child < 2 * (size_t)node + 2; child++)
            for (size_t k = 0; k < 3; k++) {
                box[k] = fminf(box[k], nearest->boxes[6 * child + k]);
                box[3 + k] = fmaxf(box[3 + k], nearest->boxes[6 * child + 3 + k]);
            }
    }
}

/* Stores a capsule, or none if it is not slender. The radius covers what rounding its ends has moved. */
static void set_span(float *span, const double from[3], const double to[3], double radius)
{
    double size = 0, length = hatch_vec_distance(from, to);
    for (size_t k = 0; k < 3; k++) {
        span[k] = (float)from[k];
        span[3 + k] = (float)to[k];
        size = fmax(size, fmax(fabs(from[k]), fabs(to[k])));
    }
    radius = radius * (1 + FLT_EPSILON) + size * FLT_EPSILON;
    span[6] = length > SLENDER * radius ? (float)radius * (1 + FLT_EPSILON) : INFINITY;
}

static double span_ends(const float *span, double from[3], double to[3])
{
    hatch_vec_of(span, from);
    hatch_vec_of(span + 3, to);
    return (double)span[6];
}

/* Finds the capsule of a leaf: its ends are the corners that are farthest apart, or nearly. */
static void span_faces(const struct hatch_nearest *nearest, uint32_t leaf, float *span)
{
    size_t begin = 3 * (size_t)leaf_begin(nearest, leaf), end = 3 * (size_t)leaf_begin(nearest, leaf + 1);
    double ends[3][3], corner[3], share, radius_squared = 0; /* each end is the corner farthest from the one before */
    span[6] = INFINITY;
    if (begin == end)
        return;
    hatch_vec_of(&nearest->corners[3 * begin], ends[0]);
    for (int k = 1; k < 3; k++) {
        double farthest = -1;
        for (size_t i = begin; i < end; i++) {
            hatch_vec_of(&nearest->corners[3 * i], corner);
            double distance = hatch_vec_distance(ends[k - 1], corner);
            if (distance > farthest) {
                farthest = distance;
                hatch_vec_copy(corner, ends[k]);
            }
        }
    }
    for (size_t i = begin; i < end; i++) {
        hatch_vec_of(&nearest->corners[3 * i], corner);
        radius_squared = fmax(radius_squared, hatch_segment_distance_squared(ends[1], ends[2], corner, &share));
    }
    set_span(span, ends[1], ends[2], sqrt(radius_squared));
}

/* Finds a capsule around those of two children: its ends lie in the middle of theirs. */
static void span_children(const float *children, float *span)
{
    double ends[2][2][3], radius[2], from[3], to[3], largest = 0, share;
    span[6] = INFINITY;
    for (int child = 0; child < 2; child++)
        radius[child] = span_ends(children + 7 * child, ends[child][0], ends[child][1]);
    if (isinf(radius[0]) || isinf(radius[1]))
        return;
    int turned = hatch_vec_distance(ends[0][0], ends[1][0]) > hatch_vec_distance(ends[0][0], ends[1][1]);
    for (int k = 0; k < 3; k++) {
        from[k] = (ends[0][0][k] + ends[1][turned][k]) / 2;
        to[k] = (ends[0][1][k] + ends[1][!turned][k]) / 2;
    }
    for (int child = 0; child < 2; child++)
        for (int end = 0; end < 2; end++)
            largest =
                fmax(largest, radius[child] + sqrt(hatch_segment_distance_squared(from, to, ends[child][end], &share)));
    set_span(span, from, to, largest);
}

/* Makes the capsules; leaves them out where few leaves have one. */
static void make_spans(struct hatch_nearest *nearest)
{
    uint32_t leaves = 0;
    for (uint32_t node = 2 * nearest->leaf_count; node-- > 1;) {
        float *span = &nearest->spans[7 * (size_t)node];
        if (node >= nearest->leaf_count)
            span_faces(nearest, node - nearest->leaf_count, span);
        else
            span_children(&nearest->spans[14 * (size_t)node], span);
        leaves += node >= nearest->leaf_count && !isinf(span[6]);
    }
    if (leaves < SPANS_MIN)
        nearest->spans = NULL;
}

/* Puts the faces in the order of their cells. */
static enum hatch_status sort_faces(const struct hatch_mesh *mesh, struct hatch_arena *scratch,
                                    struct hatch_nearest *nearest, struct hatch_err *err)
{
    struct located *located;
    float low[3], high[3];
    HATCH_TRY(HATCH_ALLOC(scratch, &located, mesh->face_count, err));
    hatch_mesh_bounds(mesh, low, high);
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        double corners[3][3];
        hatch_mesh_corners(mesh, f, corners);
        located[f] = (struct located){cell_of(corners, low, high), f};
    }
    qsort(located, mesh->face_count, sizeof *located, compare);
    for (uint32_t i = 0; i < mesh->face_count; i++) {
        nearest->faces[i] = located[i].face;
        nearest->place[located[i].face] = i;
        for (size_t c = 0; c < 3; c++)
            memcpy(&nearest->corners[9 * (size_t)i + 3 * c],
                   &mesh->attributes[0].data[3 * (size_t)mesh->indices[3 * (size_t)located[i].face + c]],
                   3 * sizeof(float));
    }
    return HATCH_OK;
}

enum hatch_status hatch_nearest_make(const struct hatch_mesh *mesh, struct hatch_arena *arena,
                                     struct hatch_arena *scratch, struct hatch_nearest *nearest, struct hatch_err *err)
{
    struct hatch_nearest made = {.face_count = mesh->face_count, .leaf_count = 1};
    while (made.leaf_count < UINT32_MAX / 16 && made.leaf_count * LEAF_FACES < mesh->face_count)
        made.leaf_count *= 2;
    HATCH_TRY(HATCH_ALLOC(arena, &made.faces, mesh->face_count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.place, mesh->face_count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.corners, 9 * (size_t)mesh->face_count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.boxes, 12 * (size_t)made.leaf_count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &made.spans, 14 * (size_t)made.leaf_count, err));
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    enum hatch_status status = sort_faces(mesh, scratch, &made, err);
    if (arena != scratch)
        hatch_arena_rewind(scratch, mark);
    if (status != HATCH_OK)
        return status;
    make_boxes(&made);
    make_spans(&made);
    *nearest = made;
    return HATCH_OK;
}

/* Returns the squared distance of a point from a node's box. */
static double box_distance(const struct hatch_nearest *nearest, uint32_t node, const double point[3])
{
    const float *box = &nearest->boxes[6 * (size_t)node];
    double sum = 0;
    for (int k = 0; k < 3; k++) {
        double below = (double)box[k] - point[k], above = point[k] - (double)box[3 + k];
        double outside = below > 0 ? below : above > 0 ? above : 0; /* fmax is slow */
        sum += outside * outside;
    }
    return sum;
}

/* Returns whether a node's capsule shows that all its faces are at least a distance from a point, whose square is
 * given. */
static bool is_beyond(const struct hatch_nearest *nearest, uint32_t node, const double point[3], double limit_squared)
{
    double from[3], to[3], share;
    if (!nearest->spans || isinf(nearest->spans[7 * (size_t)node + 6]))
        return false;
    double radius = span_ends(&nearest->spans[7 * (size_t)node], from, to);
    double reach = radius + sqrt(limit_squared);
    return hatch_segment_distance_squared(from, to, point, &share) > reach * reach;
}

/* Takes a face if it is nearer than the best place so far, whose distance is squared. */
static void test_face(const struct hatch_nearest *nearest, uint32_t place, const double point[3],
                      struct hatch_nearest_place *best)
{
    double corners[3][3], share[3];
    for (size_t c = 0; c < 3; c++)
        hatch_vec_of(&nearest->corners[9 * (size_t)place + 3 * c], corners[c]);
    double distance = hatch_triangle_distance_squared(corners[0], corners[1], corners[2], point, share);
    if (distance < best->distance)
        *best = (struct hatch_nearest_place){distance, nearest->faces[place], {share[0], share[1], share[2]}};
}

/* Searches the tree for a place nearer than the best so far. Ends when one is found that is at most `enough` from the
 * point. Distances are squared. */
static void search(const struct hatch_nearest *nearest, const double point[3], double enough,
                   struct hatch_nearest_place *best)
{
    struct {
        double distance;
        uint32_t node;
    } stack[DEPTH_MAX + 1] = {{0, 1}};
    int depth = 1;
    while (depth > 0 && best->distance > enough) {
        uint32_t node = stack[--depth].node;
        if (!(stack[depth].distance < best->distance) || is_beyond(nearest, node, point, best->distance))
            continue;
        if (node >= nearest->leaf_count) {
            uint32_t leaf = node - nearest->leaf_count;
            for (uint32_t i = leaf_begin(nearest, leaf); i < leaf_begin(nearest, leaf + 1); i++)
                test_face(nearest, i, point, best);
            continue;
        }
        double first = box_distance(nearest, 2 * node, point), second = box_distance(nearest, 2 * node + 1, point);
        uint32_t swap = second < first ? 1 : 0; /* the nearer child is put last and read first */
        stack[depth].node = 2 * node + 1 - swap;
        stack[depth++].distance = swap ? first : second;
        stack[depth].node = 2 * node + swap;
        stack[depth++].distance = swap ? second : first;
    }
}

void hatch_nearest_find(const struct hatch_nearest *nearest, const double point[3], uint32_t hint,
                        struct hatch_nearest_place *place)
{
    *place = (struct hatch_nearest_place){.distance = INFINITY};
    test_face(nearest, nearest->place[hint], point, place);
    search(nearest, point, 0, place);
    place->distance = sqrt(place->distance);
}

bool hatch_nearest_within(const struct hatch_nearest *nearest, const double point[3], double distance, uint32_t *hint)
{
    /* Places farther than the limit are not searched. */
    struct hatch_nearest_place best = {.distance = nextafter(distance * distance, INFINITY), .face = *hint};
    test_face(nearest, nearest->place[*hint], point, &best);
    search(nearest, point, distance * distance, &best);
    *hint = best.face;
    return best.distance <= distance * distance;
}

bool hatch_nearest_is_near(const struct hatch_nearest *nearest, uint32_t face, const double point[3], double distance)
{
    struct hatch_nearest_place place = {.distance = INFINITY};
    test_face(nearest, nearest->place[face], point, &place);
    return place.distance <= distance * distance;
}

/* Adds a face to a list in the order of distances; returns false when the list is full. */
static bool add_item(struct hatch_nearest_list *list, double distance, uint32_t place)
{
    uint32_t i = list->count;
    if (i == HATCH_NEAREST_LIST_MAX)
        return false;
    for (; i > 0 && list->items[i - 1].distance > distance; i--)
        list->items[i] = list->items[i - 1];
    list->items[i].distance = distance;
    list->items[i].place = place;
    list->count++;
    return true;
}

bool hatch_nearest_gather(const struct hatch_nearest *nearest, const double center[3], double radius, uint32_t hint,
                          struct hatch_nearest_list *list)
{
    struct hatch_nearest_place best;
    uint32_t stack[DEPTH_MAX + 1] = {1};
    int depth = 1;
    hatch_nearest_find(nearest, center, hint, &best);
    /* The nearest face to the centre is at most best + radius from any point of the ball, and a nearer one at most
     * another radius farther from the centre. */
    double limit = (best.distance + 2 * radius) * (1 + SAFETY), limit_squared = limit * limit;
    list->count = 0;
    hatch_vec_copy(center, list->center);
    while (depth > 0) {
        uint32_t node = stack[--depth], leaf = node - nearest->leaf_count;
        if (box_distance(nearest, node, center) > limit_squared || is_beyond(nearest, node, center, limit_squared))
            continue;
        if (node < nearest->leaf_count) {
            stack[depth++] = 2 * node + 1;
            stack[depth++] = 2 * node;
            continue;
        }
        for (uint32_t i = leaf_begin(nearest, leaf); i < leaf_begin(nearest, leaf + 1); i++) {
            struct hatch_nearest_place found = {.distance = INFINITY};
            test_face(nearest, i, center, &found);
            if (found.distance <= limit_squared && !add_item(list, sqrt(found.distance), i))
                return false;
        }
    }
    return true;
}

void hatch_nearest_find_listed(const struct hatch_nearest *nearest, const struct hatch_nearest_list *list,
                               const double point[3], struct hatch_nearest_place *place)
{
    double offset = hatch_vec_distance(point, list->center) * (1 + SAFETY);
    *place = (struct hatch_nearest_place){.distance = INFINITY};
    for (uint32_t i = 0; i < list->count; i++) {
        double least = list->items[i].distance * (1 - SAFETY) - offset;
        if (least > 0 && least * least > place->distance)
            break;
        test_face(nearest, list->items[i].place, point, place);
    }
    place->distance = sqrt(place->distance);
}
