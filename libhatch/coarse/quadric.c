/* Quadrics (Garland & Heckbert 1997), which give the order of collapses. */
#include "coarse/work.h"
#include "math/vector.h"

#define NEEDLE 0.1        /* height of a face over its longest side, below which it is a needle */
#define TURN_COSINE 0.9   /* of the greatest angle by which a collapse turns a face */
#define BORDER_WEIGHT 4.0 /* of a plane across a border, times the square of the border edge's length */
#define EVENNESS                                                                                                       \
    1e-6 /* share of a squared edge length that counts as squared distance: where nothing else differs,                \
            short edges collapse first */

/* Adds the plane through a point.
 *   normal  of length 1 */
static void add_plane(struct hatch_coarse_quadric *quadric, const double normal[3], const double through[3],
                      double weight)
{
    double plane[4] = {normal[0], normal[1], normal[2], -hatch_vec_dot(normal, through)};
    for (int i = 0, term = 0; i < 4; i++)
        for (int j = i; j < 4; j++)
            quadric->terms[term++] += weight * plane[i] * plane[j];
    quadric->weight += weight;
}

static double evaluate(const struct hatch_coarse_quadric *quadric, const double at[3])
{
    double place[4] = {at[0], at[1], at[2], 1}, sum = 0;
    for (int i = 0, term = 0; i < 4; i++)
        for (int j = i; j < 4; j++, term++)
            sum += (i == j ? 1 : 2) * quadric->terms[term] * place[i] * place[j];
    return fmax(sum, 0);
}

static const double *corner_at(const struct hatch_coarse_work *work, uint32_t corner)
{
    return &work->at[3 * (size_t)hatch_coarse_corner_point(work, corner)];
}

/* Adds a face's plane to its points; returns its normal and twice its area. */
static double add_face(struct hatch_coarse_work *work, uint32_t face, double normal[3])
{
    hatch_vec_triangle(corner_at(work, 3 * face), corner_at(work, 3 * face + 1), corner_at(work, 3 * face + 2), normal);
    double area = hatch_vec_normalize(normal);
    for (uint32_t c = 0; c < 3 && area > 0; c++)
        add_plane(&work->quadric[hatch_coarse_corner_point(work, 3 * face + c)], normal, corner_at(work, 3 * face),
                  area);
    return area;
}

/* Adds planes across the borders at a point: through the edge, perpendicular to the face. */
static void add_borders(struct hatch_coarse_work *work, const struct hatch_coarse_ring *ring)
{
    for (uint32_t i = 0; i < ring->face_count; i++)
        for (uint32_t k = 1; k < 3; k++) {
            uint32_t face = ring->faces[i], end = work->point_of[work->corner[3 * face + (ring->sides[i] + k) % 3]],
                     s = 0;
            while (ring->spokes[s].point != end)
                s++;
            if (!ring->spokes[s].border)
                continue;
            double along[3], normal[3], across[3];
            hatch_vec_sub(&work->at[3 * (size_t)end], &work->at[3 * (size_t)ring->point], along);
            hatch_vec_triangle(corner_at(work, 3 * face), corner_at(work, 3 * face + 1), corner_at(work, 3 * face + 2),
                               normal);
            hatch_vec_cross(along, normal, across);
            if (hatch_vec_normalize(across) > 0)
                add_plane(&work->quadric[ring->point], across, &work->at[3 * (size_t)end],
                          BORDER_WEIGHT * hatch_vec_dot(along, along));
        }
}

void hatch_coarse_quadrics_make(struct hatch_coarse_work *work)
{
    struct hatch_coarse_ring ring;
    double normal[3];
    for (uint32_t face = 0; face < work->face_count; face++)
        if (work->corner[3 * face] != HATCH_COARSE_NONE)
            add_face(work, face, normal);
    for (uint32_t point = 0; point < work->point_count; point++)
        if (hatch_coarse_ring_find(work, point, &ring) && ring.border_count > 0)
            add_borders(work, &ring);
}

double hatch_coarse_cost(const struct hatch_coarse_work *work, uint32_t point, uint32_t onto)
{
    const double *from = &work->at[3 * (size_t)point], *to = &work->at[3 * (size_t)onto];
    double length = hatch_vec_distance(from, to), tolerance = work->tolerance[onto];
    double sum = evaluate(&work->quadric[point], to) + evaluate(&work->quadric[onto], to) +
                 EVENNESS * length * length * work->quadric[point].weight;
    return sum / (tolerance * tolerance);
}

/* Returns the height of a face over its longest side, as a share of that.
 *   normal  out: unit length */
static double flatness(const double a[3], const double b[3], const double c[3], double normal[3])
{
    double longest = fmax(hatch_vec_distance(a, b), fmax(hatch_vec_distance(b, c), hatch_vec_distance(c, a)));
    hatch_vec_triangle(a, b, c, normal);
    double area = hatch_vec_normalize(normal);
    return longest > 0 ? area / (longest * longest) : 0;
}

/* Returns by how much the cosine of the angle between a normal and those of three vertices is too small at most. */
static double shade_error(const struct hatch_coarse_work *work, uint32_t part, const uint32_t wedges[3],
                          const double normal[3])
{
    const float *normals = work->checks[part].normals, *least = work->parts[part].normal_cosine;
    double most = -2;
    for (int c = 0; c < 3 && normals && least; c++) {
        uint32_t vertex = wedges[c] - work->first_wedge[part];
        double at[3];
        hatch_vec_of(&normals[3 * (size_t)vertex], at);
        most = fmax(most, (double)least[vertex] - hatch_vec_dot(at, normal));
    }
    return most;
}

/* Returns whether the faces that remain stay about parallel to what they were and to the normals of their corners, and
 * none becomes a needle. */
static bool keeps_shapes(const struct hatch_coarse_work *work, const struct hatch_coarse_collapse *collapse)
{
    for (uint32_t i = 0; i < collapse->kept_count; i++) {
        uint32_t face = collapse->ring->faces[collapse->kept[i]];
        const double(*now)[3] = (const double(*)[3])collapse->corners[i];
        double before[3], after[3];
        double was =
            flatness(corner_at(work, 3 * face), corner_at(work, 3 * face + 1), corner_at(work, 3 * face + 2), before);
        double flat = flatness(now[0], now[1], now[2], after);
        if ((flat < NEEDLE && flat < was) || hatch_vec_dot(before, after) < TURN_COSINE)
            return false;
        uint32_t part = work->part_of[face];
        double error = shade_error(work, part, collapse->wedges[i], after);
        if (error > 0 && error > shade_error(work, part, &work->corner[3 * (size_t)face], before))
            return false;
    }
    return true;
}

bool hatch_coarse_is_cheap(const struct hatch_coarse_work *work, const struct hatch_coarse_collapse *collapse)
{
    uint32_t point = collapse->ring->point, onto = collapse->spoke->point;
    double weight = work->quadric[point].weight + work->quadric[onto].weight;
    return hatch_coarse_cost(work, point, onto) <= weight && keeps_shapes(work, collapse);
}
