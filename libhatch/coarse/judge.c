/* Whether a collapse keeps the surface within its tolerances, and the collapse itself. */
#include <math.h>

#include "coarse/work.h"
#include "math/triangle.h"
#include "math/vector.h"

#define GRID_TOLERANCES 6 /* distance of places on a face that are tested, in tolerances */
#define GRID_MAX 64       /* rows of them */
#define BESIDE 0.05       /* in tolerances */

/* A sample's place and tolerance. */
struct place {
    double at[3], tolerance;
};

static struct place place_of(const struct hatch_coarse_work *work, uint32_t sample)
{
    struct place place = {{0, 0, 0}, INFINITY};
    if (sample < work->wedge_count) {
        hatch_vec_copy(&work->at[3 * (size_t)work->point_of[sample]], place.at);
        place.tolerance = work->tolerance[work->point_of[sample]];
        return place;
    }
    const uint32_t *wedges = &work->full_corner[3 * (size_t)work->center_of[sample - work->wedge_count]];
    for (int c = 0; c < 3; c++) {
        uint32_t point = work->point_of[wedges[c]];
        hatch_vec_add_scaled(place.at, 1.0 / 3, &work->at[3 * (size_t)point], place.at);
        place.tolerance = fmin(place.tolerance, work->tolerance[point]);
    }
    return place;
}

/* Returns the square of a place's distance to a face that is kept, as a share of its tolerance.
 *   share  out: weights of the corners at the nearest place on the face */
static double face_error(const struct hatch_coarse_collapse *collapse, uint32_t kept, const struct place *place,
                         double share[3])
{
    return hatch_triangle_distance_squared(collapse->corners[kept][0], collapse->corners[kept][1],
                                           collapse->corners[kept][2], place->at, share) /
           (place->tolerance * place->tolerance);
}

/* Finds the best face for a sample among those that are kept. Returns the square of its error as a share of its
 * tolerance: the distance to the face, or an attribute's error, whichever is larger. Attributes are compared on the
 * nearest face, and on others that are farther by at most BESIDE. */
static double best_face(struct hatch_coarse_work *work, const struct hatch_coarse_collapse *collapse, uint32_t sample,
                        uint32_t part)
{
    const struct place place = place_of(work, sample);
    double nearest = INFINITY, best = INFINITY, share[3];
    for (uint32_t i = 0; i < collapse->kept_count; i++) {
        uint32_t face = collapse->ring->faces[collapse->kept[i]];
        double error = work->part_of[face] == part ? face_error(collapse, i, &place, share) : INFINITY;
        if (error < nearest) {
            nearest = error;
            work->choice[sample] = face;
        }
    }
    if (nearest > 1 || work->checks[part].count == 0 || sample >= work->wedge_count)
        return nearest;
    double most = fmin(1, (sqrt(nearest) + BESIDE) * (sqrt(nearest) + BESIDE));
    for (uint32_t i = 0; i < collapse->kept_count; i++) {
        uint32_t face = collapse->ring->faces[collapse->kept[i]];
        double error = work->part_of[face] == part ? face_error(collapse, i, &place, share) : INFINITY;
        if (error > most || error >= best)
            continue;
        error = fmax(error, hatch_coarse_attribute_error(work, part, sample, collapse->wedges[i], share));
        if (error < best) {
            best = error;
            work->choice[sample] = face;
        }
    }
    return best;
}

/* Returns whether the border edge that stands for a sample is shortened by the collapse. */
static bool is_on_border(const struct hatch_coarse_work *work, const struct hatch_coarse_collapse *collapse,
                         uint32_t sample)
{
    if (collapse->other == HATCH_COARSE_NONE || sample >= work->wedge_count)
        return false;
    uint32_t point = collapse->ring->point, a = work->line[2 * (size_t)sample], b = work->line[2 * (size_t)sample + 1];
    if (work->point_of[sample] == point)
        return true;
    uint32_t end = a == point ? b : b == point ? a : HATCH_COARSE_NONE;
    return end != HATCH_COARSE_NONE && (end == collapse->other || end == collapse->spoke->point);
}

/* Returns the squared distance of a sample from the shortened border, as a share of its tolerance. */
static double border_error(const struct hatch_coarse_work *work, const struct hatch_coarse_collapse *collapse,
                           uint32_t sample)
{
    const double *from = &work->at[3 * (size_t)collapse->spoke->point], *to = &work->at[3 * (size_t)collapse->other];
    uint32_t point = work->point_of[sample];
    double share, tolerance = work->tolerance[point];
    return hatch_segment_distance_squared(from, to, &work->at[3 * (size_t)point], &share) / (tolerance * tolerance);
}

static bool allows(struct hatch_coarse_work *work, const struct hatch_coarse_collapse *collapse, uint32_t sample,
                   uint32_t part)
{
    if (is_on_border(work, collapse, sample) && border_error(work, collapse, sample) > 1)
        return false;
    return best_face(work, collapse, sample, part) <= 1;
}

/* Tests the samples of a face. One that refuses the collapse becomes the first, since it will likely refuse the next
 * collapse, too. */
static bool face_allows(struct hatch_coarse_work *work, const struct hatch_coarse_collapse *collapse, uint32_t face)
{
    uint32_t before = HATCH_COARSE_NONE;
    for (uint32_t s = work->first_sample[face]; s != HATCH_COARSE_NONE; before = s, s = work->next_sample[s]) {
        if (allows(work, collapse, s, work->part_of[face]))
            continue;
        if (before != HATCH_COARSE_NONE) {
            work->next_sample[before] = work->next_sample[s];
            work->next_sample[s] = work->first_sample[face];
            work->first_sample[face] = s;
        }
        return false;
    }
    return true;
}

/* Returns the smallest tolerance at the corners of a face of the full meshes. A face with a repeated point has no wedge
 * at its first corner. */
static double full_tolerance(const struct hatch_coarse_work *work, uint32_t face)
{
    double tolerance = INFINITY;
    for (size_t c = 0; c < 3; c++) {
        uint32_t wedge = work->full_corner[3 * (size_t)face + c];
        if (wedge != HATCH_COARSE_NONE)
            tolerance = fmin(tolerance, work->tolerance[work->point_of[wedge]]);
    }
    return tolerance;
}

/* A row of places on a new face, with numbers from first to last. */
struct row {
    double from[3], along[3]; /* place 0, and the vector from one to the next */
    double first, last;
};

static void place_on(const struct row *row, double number, double at[3])
{
    hatch_vec_add_scaled(row->from, number, row->along, at);
}

/* Returns the last of the places after one that are all near a full face, as that one is. Two places are enough to show
 * it for those between them, since a face is convex. */
static double last_near(const struct hatch_coarse_work *work, const struct row *row, double number, double distance,
                        uint32_t face)
{
    bool grows = true;
    for (double step = 1; step >= 1; step *= grows ? 2 : 0.5) {
        double at[3];
        place_on(row, number + step, at);
        if (number + step <= row->last && hatch_nearest_is_near(&work->full, face, at, distance))
            number += step;
        else
            grows = false;
    }
    return number;
}

static bool row_lies_near(const struct hatch_coarse_work *work, const struct row *row, double tolerance, uint32_t *hint)
{
    uint32_t before = HATCH_COARSE_NONE;
    for (double number = row->first; number <= row->last; number++) {
        double at[3];
        place_on(row, number, at);
        if (!hatch_nearest_within(&work->full, at, tolerance, hint) ||
            !hatch_nearest_within(&work->full, at, full_tolerance(work, *hint), hint))
            return false;
        if (*hint == before)
            number = last_near(work, row, number, fmin(tolerance, full_tolerance(work, *hint)), *hint);
        before = *hint;
    }
    return true;
}

/* Tests that a face lies near the full surface: at places in rows along its longest side. The samples alone do not see
 * a face that stands out between them.
 *   hint  in, out: a face of the full meshes that may be near */
static bool lies_near(const struct hatch_coarse_work *work, double corners[3][3], double tolerance, uint32_t *hint)
{
    double base = 0, normal[3], step = GRID_TOLERANCES * tolerance;
    int first = 0;
    for (int c = 0; c < 3; c++) {
        double length = hatch_vec_distance(corners[c], corners[(c + 1) % 3]);
        first = length > base ? c : first;
        base = fmax(base, length);
    }
    hatch_vec_triangle(corners[0], corners[1], corners[2], normal);
    double rows = fmin(fmax(ceil(hatch_vec_length(normal) / (base * step)), 2), GRID_MAX);
    const double *a = corners[first], *b = corners[(first + 1) % 3], *apex = corners[(first + 2) % 3];
    for (double i = 0; i < rows; i++) {
        double columns = fmin(fmax(ceil(base * (1 - i / rows) / step), 2), GRID_MAX);
        struct row row = {.first = i == 0, .last = columns - (i == 0)};
        for (int k = 0; k < 3; k++) {
            row.from[k] = work->middle[k] + a[k] + i / rows * (apex[k] - a[k]);
            row.along[k] = (1 - i / rows) / columns * (b[k] - a[k]);
        }
        if (!row_lies_near(work, &row, tolerance, hint))
            return false;
    }
    return true;
}

static bool faces_lie_near(const struct hatch_coarse_work *work, struct hatch_coarse_collapse *collapse)
{
    uint32_t hint = collapse->ring->faces[0];
    for (uint32_t i = 0; i < collapse->kept_count; i++) {
        double tolerance = INFINITY;
        for (int c = 0; c < 3; c++)
            tolerance = fmin(tolerance, work->tolerance[work->point_of[collapse->wedges[i][c]]]);
        if (!lies_near(work, collapse->corners[i], tolerance, &hint))
            return false;
    }
    return true;
}

bool hatch_coarse_judge(struct hatch_coarse_work *work, struct hatch_coarse_collapse *collapse)
{
    const struct hatch_coarse_ring *ring = collapse->ring;
    if (work->loose && !hatch_coarse_is_cheap(work, collapse))
        return false;
    for (uint32_t i = 0; i < collapse->pair_count; i++)
        for (uint32_t f = 0, tested = 0; f < ring->face_count && !tested; f++)
            if (work->corner[3 * ring->faces[f] + ring->sides[f]] == collapse->from[i]) {
                tested = 1;
                if (!allows(work, collapse, collapse->from[i], work->part_of[ring->faces[f]]))
                    return false;
            }
    if (work->loose)
        return true;
    for (uint32_t f = 0; f < ring->face_count; f++) {
        uint32_t first = work->first_sample[ring->faces[f]];
        if (first != HATCH_COARSE_NONE && !allows(work, collapse, first, work->part_of[ring->faces[f]]))
            return false;
    }
    for (uint32_t f = 0; f < ring->face_count; f++)
        if (!face_allows(work, collapse, ring->faces[f]))
            return false;
    return faces_lie_near(work, collapse);
}

static void attach(struct hatch_coarse_work *work, const struct hatch_coarse_collapse *collapse, uint32_t sample)
{
    uint32_t face = work->choice[sample];
    if (is_on_border(work, collapse, sample)) {
        work->line[2 * (size_t)sample] = collapse->spoke->point;
        work->line[2 * (size_t)sample + 1] = collapse->other;
    }
    work->next_sample[sample] = work->first_sample[face];
    work->first_sample[face] = sample;
}

/* Takes all samples from the faces of the ring; returns them as a list. */
static uint32_t detach(struct hatch_coarse_work *work, const struct hatch_coarse_ring *ring)
{
    uint32_t list = HATCH_COARSE_NONE;
    for (uint32_t f = 0; f < ring->face_count; f++) {
        uint32_t *first = &work->first_sample[ring->faces[f]];
        while (*first != HATCH_COARSE_NONE) {
            uint32_t sample = *first;
            *first = work->next_sample[sample];
            work->next_sample[sample] = list;
            list = sample;
        }
    }
    return list;
}

void hatch_coarse_apply(struct hatch_coarse_work *work, const struct hatch_coarse_collapse *collapse)
{
    const struct hatch_coarse_ring *ring = collapse->ring;
    uint32_t onto = collapse->spoke->point, list = detach(work, ring);
    while (list != HATCH_COARSE_NONE) {
        uint32_t next = work->next_sample[list];
        attach(work, collapse, list);
        list = next;
    }
    for (uint32_t i = 0; i < collapse->pair_count && !work->loose; i++)
        attach(work, collapse, collapse->from[i]);
    for (uint32_t i = 0, kept = 0; i < ring->face_count; i++) {
        uint32_t face = ring->faces[i], corner = 3 * face + ring->sides[i];
        if (kept == collapse->kept_count || collapse->kept[kept] != i) {
            work->corner[3 * face] = HATCH_COARSE_NONE;
            continue;
        }
        work->corner[corner] = collapse->wedges[kept++][ring->sides[i]];
        work->next[corner] = work->first[onto];
        work->first[onto] = corner;
    }
    work->first[ring->point] = HATCH_COARSE_NONE;
    for (int term = 0; term < 10; term++)
        work->quadric[onto].terms[term] += work->quadric[ring->point].terms[term];
    work->quadric[onto].weight += work->quadric[ring->point].weight;
}
