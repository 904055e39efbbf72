#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "lapped/work.h"

/* How much more a turning of the strokes costs than a stretch along or between them. */
#define TURN_WEIGHT 5.0
/* A patch may be larger here and smaller there than its faces: strokes that run apart, and a surface
 * that cannot be flattened, then cost neither angle nor shape. Within which bounds, in how many
 * rounds, and by how much of what is wanted in each. */
#define SCALE_MIN 0.6
#define SCALE_MAX 1.6
#define SCALE_ROUNDS 4
#define SCALE_STEP 1.7
/* Mean change of the scales that is not worth a round. */
#define SCALE_SETTLED 0.005
/* Other orders are tried where the envelope is larger than this times vertices to the power of 1.5. */
#define ENVELOPE_FAIR 1.5
/* Strips for each vertex in which they are numbered. */
#define STRIPS 4u
/* How much a face may weigh in one entry: a needle would drown its neighbours in rounding. */
#define STEEP_MAX 1e7
/* The share of a diagonal that is left at least. */
#define PIVOT_MIN 1e-12
/* Weight of a face that is not asked to follow the field. */
#define FREE_WEIGHT 1e-3

static enum hatch_status make_room(struct hatch_solver *of, const struct hatch_patch *patch, struct hatch_err *err)
{
    uint32_t count = patch->vertex_count;
    void *array = of->gradients;
    HATCH_TRY(
        hatch_heap_reserve(of->arena, &array, &of->gradient_room, 8 * patch->face_count, sizeof *of->gradients, err));
    of->gradients = array;
    array = of->places;
    HATCH_TRY(hatch_heap_reserve(of->arena, &array, &of->places_room, STRIPS * count, sizeof *of->places, err));
    of->places = array;
    array = of->rank;
    HATCH_TRY(hatch_heap_reserve(of->arena, &array, &of->rank_room, count, sizeof *of->rank, err));
    of->rank = array;
    array = of->first;
    HATCH_TRY(hatch_heap_reserve(of->arena, &array, &of->first_room, count, sizeof *of->first, err));
    of->first = array;
    array = of->start;
    HATCH_TRY(hatch_heap_reserve(of->arena, &array, &of->start_room, count, sizeof *of->start, err));
    of->start = array;
    array = of->right;
    HATCH_TRY(hatch_heap_reserve(of->arena, &array, &of->right_room, count, sizeof *of->right, err));
    of->right = array;
    return HATCH_OK;
}

/* The box around the vertices; returns its longer axis. */
static uint32_t find_box(const struct hatch_patch *patch, double low[2], double high[2])
{
    low[0] = low[1] = HUGE_VAL;
    high[0] = high[1] = -HUGE_VAL;
    for (uint32_t v = 0; v < patch->vertex_count; v++) {
        for (uint32_t i = 0; i < 2; i++) {
            double at = patch->place[2 * v + i];
            low[i] = at < low[i] ? at : low[i];
            high[i] = at > high[i] ? at : high[i];
        }
    }
    return high[1] - low[1] > high[0] - low[0];
}

/* Numbers the vertices by a sweep along an axis of the plane, in strips of which each holds about none or one:
 * the envelope is then about as wide as the patch is across. Without an axis (2) against the order of growth,
 * which is better where long faces lie across each other. */
static void number(struct hatch_solver *of, const struct hatch_patch *patch, uint32_t axis, const double low[2],
                   const double high[2])
{
    uint32_t count = patch->vertex_count, strips = STRIPS * count, *rank = of->rank, next = 0;
    for (uint32_t v = 0; v < count && axis == 2; v++)
        rank[v] = count - 1 - v;
    if (axis == 2)
        return;
    double scale = strips / (high[axis] - low[axis]);
    memset(of->places, 0, strips * sizeof *of->places);
    for (uint32_t v = 0; v < count; v++) {
        double strip = scale * (patch->place[2 * v + axis] - low[axis]);
        rank[v] = strip < strips ? (uint32_t)strip : strips - 1;
        of->places[rank[v]]++;
    }
    for (uint32_t i = 0; i < strips; i++) {
        uint32_t here = of->places[i];
        of->places[i] = next;
        next += here;
    }
    for (uint32_t v = 0; v < count; v++)
        rank[v] = of->places[rank[v]]++;
}

/* The first column of each row; returns how many entries lie within. */
static uint64_t find_envelope(struct hatch_solver *of, const struct hatch_patch *patch)
{
    for (uint32_t i = 0; i < patch->vertex_count; i++)
        of->first[i] = i;
    for (uint32_t i = 0; i < 3 * patch->face_count; i++) {
        uint32_t a = of->rank[patch->corners[i]];
        uint32_t b = of->rank[patch->corners[i % 3 == 2 ? i - 2 : i + 1]];
        uint32_t low = a < b ? a : b, high = a < b ? b : a;
        if (low < of->first[high])
            of->first[high] = low;
    }
    uint64_t size = 0;
    for (uint32_t i = 0; i < patch->vertex_count; i++)
        size += i - of->first[i] + 1;
    return size;
}

static enum hatch_status shape_envelope(struct hatch_solver *of, const struct hatch_patch *patch, struct hatch_err *err)
{
    double low[2], high[2];
    uint32_t axis = find_box(patch, low, high), best = axis;
    double count = patch->vertex_count;
    number(of, patch, axis, low, high);
    uint64_t least = find_envelope(of, patch);
    for (uint32_t other = 0; other < 3 && (double)least > ENVELOPE_FAIR * count * sqrt(count); other++) {
        if (other == axis)
            continue;
        number(of, patch, other, low, high);
        uint64_t found = find_envelope(of, patch);
        if (found < least) {
            least = found;
            best = other;
        }
        axis = other;
    }
    if (best != axis) {
        number(of, patch, best, low, high);
        find_envelope(of, patch);
    }
    uint32_t size = 0;
    for (uint32_t i = 0; i < patch->vertex_count; i++) {
        of->start[i] = size - of->first[i];
        size += i - of->first[i] + 1;
    }
    void *array = of->matrix;
    HATCH_TRY(hatch_heap_reserve(of->arena, &array, &of->matrix_room, size, sizeof *of->matrix, err));
    of->matrix = array;
    memset(of->matrix, 0, size * sizeof *of->matrix);
    return HATCH_OK;
}

/* Gradients of a face's three hat functions in the frame of its signed line; returns its area. */
static double hat_gradients(const struct hatch_ground *ground, uint32_t face, int8_t sign, double gradient[3][2])
{
    const double *flat = &ground->flat[(size_t)face * 4];
    double least = HATCH_LAPPED_THIN * (flat[0] * flat[0] + flat[1] * flat[1] + flat[2] * flat[2] + flat[3] * flat[3]);
    double doubled = flat[0] * flat[3] - flat[2] * flat[1];
    doubled = doubled > least ? doubled : least;
    gradient[1][0] = sign * flat[3] / doubled;
    gradient[1][1] = -sign * flat[2] / doubled;
    gradient[2][0] = -sign * flat[1] / doubled;
    gradient[2][1] = sign * flat[0] / doubled;
    for (int i = 0; i < 2; i++)
        gradient[0][i] = -gradient[1][i] - gradient[2][i];
    return doubled / 2;
}

static void find_gradients(struct hatch_solver *of, const struct hatch_ground *ground, const struct hatch_patch *patch)
{
    for (uint32_t f = 0; f < patch->face_count; f++) {
        uint32_t face = patch->faces[f];
        double *to = &of->gradients[8 * f];
        double area = hat_gradients(ground, face, patch->sign[f], (double(*)[2])to);
        double steep = 0;
        for (int i = 0; i < 6; i += 2) {
            double own = area * (to[i] * to[i] + to[i + 1] * to[i + 1]);
            steep = own > steep ? own : steep;
        }
        area *= steep > STEEP_MAX ? STEEP_MAX / steep : 1;
        to[6] = ground->singular[face] ? FREE_WEIGHT * area : area;
        to[7] = 1;
    }
}

/* Adds a face's part of the normal equations. The first vertex stays where it is, at the origin: its
 * row and column are left out. */
static void add_matrix(struct hatch_solver *of, const struct hatch_patch *patch, uint32_t local)
{
    const uint32_t *corner = &patch->corners[3 * local];
    const double *gradient = &of->gradients[8 * local], weight = gradient[6];
    for (uint32_t a = 0; a < 3; a++) {
        if (corner[a] == 0)
            continue;
        uint32_t row = of->rank[corner[a]];
        for (uint32_t b = 0; b < 3; b++) {
            uint32_t column = of->rank[corner[b]];
            if (corner[b] == 0 || column > row)
                continue;
            double along = weight * gradient[2 * a] * gradient[2 * b];
            double over = weight * gradient[2 * a + 1] * gradient[2 * b + 1];
            double *entry = of->matrix[(uint32_t)(of->start[row] + column)];
            entry[0] += along + TURN_WEIGHT * over;
            entry[1] += TURN_WEIGHT * along + over;
        }
    }
}

/* How much larger a face lies in the plane than it is. */
static double scale_of(const struct hatch_solver *of, const struct hatch_patch *patch, uint32_t local)
{
    const double *gradient = &of->gradients[8 * local];
    double sum = 0;
    for (uint32_t c = 0; c < 3; c++) {
        const double *at = &patch->place[2 * patch->corners[3 * local + c]];
        sum += at[0] * gradient[2 * c] + at[1] * gradient[2 * c + 1];
    }
    return sum / 2;
}

static void add_right(struct hatch_solver *of, const struct hatch_patch *patch, uint32_t local)
{
    const uint32_t *corner = &patch->corners[3 * local];
    const double *gradient = &of->gradients[8 * local], weight = gradient[7] * gradient[6];
    for (uint32_t a = 0; a < 3; a++) {
        if (corner[a] == 0)
            continue;
        double *right = of->right[of->rank[corner[a]]];
        right[0] += weight * gradient[2 * a];
        right[1] += weight * gradient[2 * a + 1];
    }
}

/* What is left of a value without the sum of products, for x and y side by side; in four chains, a fixed
 * order in which the processor need not wait for each sum. */
static void subtract_dot(double (*a)[2], double (*b)[2], uint32_t count, double left[2])
{
    double sum[4][2] = {{0, 0}, {0, 0}, {0, 0}, {0, 0}};
    size_t i = 0, fours = count & ~3u;
    for (; i < fours; i += 4) {
        for (size_t k = 0; k < 4; k++) {
            sum[k][0] += a[i + k][0] * b[i + k][0];
            sum[k][1] += a[i + k][1] * b[i + k][1];
        }
    }
    for (; i < count; i++) {
        sum[0][0] += a[i][0] * b[i][0];
        sum[0][1] += a[i][1] * b[i][1];
    }
    left[0] -= sum[0][0] + sum[1][0] + (sum[2][0] + sum[3][0]);
    left[1] -= sum[0][1] + sum[1][1] + (sum[2][1] + sum[3][1]);
}

static double (*row_of(const struct hatch_solver *of, uint32_t row))[2]
{
    return &of->matrix[(uint32_t)(of->start[row] + of->first[row])];
}

/* Cholesky's factors in place of the matrices; on the diagonal stands its inverse. */
static void factor(const struct hatch_solver *of, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        uint32_t low = of->first[i];
        double(*row)[2] = row_of(of, i);
        for (uint32_t j = low; j < i; j++) {
            uint32_t from = of->first[j] > low ? of->first[j] : low;
            double(*other)[2] = &row_of(of, j)[from - of->first[j]];
            double value[2] = {row[j - low][0], row[j - low][1]};
            subtract_dot(&row[from - low], other, j - from, value);
            row[j - low][0] = value[0] * other[j - from][0];
            row[j - low][1] = value[1] * other[j - from][1];
        }
        double *pivot = row[i - low];
        const double least[2] = {PIVOT_MIN * pivot[0], PIVOT_MIN * pivot[1]};
        subtract_dot(row, row, i - low, pivot);
        pivot[0] = 1 / sqrt(fmax(pivot[0], least[0]));
        pivot[1] = 1 / sqrt(fmax(pivot[1], least[1]));
    }
}

/* Solutions in place of the right sides. */
static void substitute(const struct hatch_solver *of, uint32_t count)
{
    double(*restrict right)[2] = of->right;
    for (uint32_t i = 0; i < count; i++) {
        uint32_t low = of->first[i];
        double(*row)[2] = row_of(of, i);
        subtract_dot(row, &right[low], i - low, right[i]);
        right[i][0] *= row[i - low][0];
        right[i][1] *= row[i - low][1];
    }
    for (uint32_t i = count; i-- > 0;) {
        uint32_t low = of->first[i];
        double(*restrict row)[2] = row_of(of, i);
        double x = right[i][0] *= row[i - low][0], y = right[i][1] *= row[i - low][1];
        for (uint32_t j = low; j < i; j++) {
            right[j][0] -= row[j - low][0] * x;
            right[j][1] -= row[j - low][1] * y;
        }
    }
}

/* Gives the faces the scales that they have now; false when hardly any changes. */
static bool rescale(struct hatch_solver *of, const struct hatch_patch *patch)
{
    double change = 0, whole = 0;
    for (uint32_t f = 0; f < patch->face_count; f++) {
        double *scale = &of->gradients[8 * f + 7], weight = of->gradients[8 * f + 6];
        double next = *scale + SCALE_STEP * (scale_of(of, patch, f) - *scale);
        next = next < SCALE_MIN ? SCALE_MIN : next > SCALE_MAX ? SCALE_MAX : next;
        change += weight * fabs(next - *scale);
        whole += weight;
        *scale = next;
    }
    return change > SCALE_SETTLED * whole;
}

/* Places the vertices for the faces' scales. */
static void place(struct hatch_solver *of, struct hatch_patch *patch)
{
    memset(of->right, 0, patch->vertex_count * sizeof *of->right);
    for (uint32_t f = 0; f < patch->face_count; f++)
        add_right(of, patch, f);
    substitute(of, patch->vertex_count);
    for (uint32_t v = 0; v < patch->vertex_count; v++)
        memcpy(&patch->place[2 * v], of->right[of->rank[v]], sizeof *of->right);
}

enum hatch_status hatch_solver_solve(struct hatch_solver *of, const struct hatch_ground *ground,
                                     struct hatch_patch *patch, struct hatch_err *err)
{
    HATCH_TRY(make_room(of, patch, err));
    HATCH_TRY(shape_envelope(of, patch, err));
    find_gradients(of, ground, patch);
    for (uint32_t f = 0; f < patch->face_count; f++)
        add_matrix(of, patch, f);
    uint32_t fixed = of->rank[0];
    double *pivot = of->matrix[(uint32_t)(of->start[fixed] + fixed)];
    pivot[0] = pivot[1] = 1;
    factor(of, patch->vertex_count);
    place(of, patch);
    for (int round = 1; round < SCALE_ROUNDS && rescale(of, patch); round++)
        place(of, patch);
    return HATCH_OK;
}

void hatch_patch_fit(const struct hatch_ground *ground, const struct hatch_patch *patch, uint32_t local,
                     struct hatch_fit *fit)
{
    double gradient[3][2], jacobian[2][2] = {{0, 0}, {0, 0}};
    hat_gradients(ground, patch->faces[local], patch->sign[local], gradient);
    for (uint32_t c = 0; c < 3; c++) {
        const double *at = &patch->place[2 * patch->corners[3 * local + c]];
        for (int i = 0; i < 2; i++)
            for (int j = 0; j < 2; j++)
                jacobian[i][j] += at[i] * gradient[c][j];
    }
    double half = (jacobian[0][0] * jacobian[0][0] + jacobian[0][1] * jacobian[0][1] + jacobian[1][0] * jacobian[1][0] +
                   jacobian[1][1] * jacobian[1][1]) /
                  2;
    fit->determinant = jacobian[0][0] * jacobian[1][1] - jacobian[0][1] * jacobian[1][0];
    double squared = half * half - fit->determinant * fit->determinant;
    fit->stretch = fit->determinant > 0 ? (half + sqrt(fmax(0, squared))) / fit->determinant : HUGE_VAL;
    fit->turn = fit->determinant > 0 && jacobian[1][1] > 0 ? fabs(jacobian[1][0]) / jacobian[1][1] : HUGE_VAL;
}
