#include <math.h>
#include <string.h>

#include "lapped/work.h"

/* Weight of turning strokes relative to stretching them lengthwise or sideways. */
#define TURN_WEIGHT 5.0
/* Bounds of the scale of a face in the plane, number of solutions, and over-relaxation of the change of scales between
 * two solutions. The scale may vary over a patch, so that diverging strokes, and a surface that cannot be flattened,
 * need neither turning nor stretching. */
#define SCALE_MIN 0.6
#define SCALE_MAX 1.6
#define SCALE_ROUNDS 4
#define SCALE_STEP 1.7
/* The rounds end when the mean change of the scales is below this. */
#define SCALE_SETTLED 0.005
/* Other numberings are tried where the envelope has more entries than this factor times the number of vertices to the
 * power of 1.5. */
#define ENVELOPE_FAIR 1.5
/* A hub is a vertex with more faces than this factor times the square root of the number of vertices. */
#define HUB_FACTOR 4.0
/* Number of strips of the plane per vertex, for sorting. */
#define STRIPS 4u
/* Largest entry that a face adds to the matrix; beside a larger one, that of a needle, the entries of its neighbours
 * would be lost to rounding. */
#define ENTRY_MAX 1e7
/* Least pivot as a share of the diagonal entry. */
#define PIVOT_MIN 1e-12
/* Largest number of multiplications of a factorization within the envelope. Beyond it, sparse factors are faster. */
#define COST_MAX 1e9
/* Relative weight of a face in which the field has an index; such a face need not follow the field. */
#define SINGULAR_WEIGHT 1e-3

static enum hatch_status reserve_arrays(struct hatch_solver *solver, const struct hatch_patch *patch,
                                        struct hatch_err *err)
{
    uint32_t count = patch->vertex_count;
    void *array = solver->gradients;
    HATCH_TRY(hatch_lapped_reserve(solver->arena, &array, &solver->gradient_capacity, 8 * patch->face_count,
                                   sizeof *solver->gradients, err));
    solver->gradients = array;
    array = solver->strip_rank;
    HATCH_TRY(hatch_lapped_reserve(solver->arena, &array, &solver->strip_capacity, STRIPS * count,
                                   sizeof *solver->strip_rank, err));
    solver->strip_rank = array;
    array = solver->rank;
    HATCH_TRY(hatch_lapped_reserve(solver->arena, &array, &solver->rank_capacity, count, sizeof *solver->rank, err));
    solver->rank = array;
    array = solver->first_column;
    HATCH_TRY(hatch_lapped_reserve(solver->arena, &array, &solver->column_capacity, count, sizeof *solver->first_column,
                                   err));
    solver->first_column = array;
    array = solver->row_start;
    HATCH_TRY(
        hatch_lapped_reserve(solver->arena, &array, &solver->start_capacity, count, sizeof *solver->row_start, err));
    solver->row_start = array;
    array = solver->right_side;
    HATCH_TRY(
        hatch_lapped_reserve(solver->arena, &array, &solver->right_capacity, count, sizeof *solver->right_side, err));
    solver->right_side = array;
    return HATCH_OK;
}

/* Finds the bounding box of the vertices. Returns its longer axis. */
static uint32_t find_box(const struct hatch_patch *patch, double low[2], double high[2])
{
    low[0] = low[1] = HUGE_VAL;
    high[0] = high[1] = -HUGE_VAL;
    for (uint32_t v = 0; v < patch->vertex_count; v++) {
        for (uint32_t i = 0; i < 2; i++) {
            double at = patch->xy[2 * v + i];
            low[i] = at < low[i] ? at : low[i];
            high[i] = at > high[i] ? at : high[i];
        }
    }
    return high[1] - low[1] > high[0] - low[0];
}

/* Moves the hubs to the end of the order of ranks, where only their own rows are long. Elsewhere, the rows of all their
 * neighbours behind them would reach back to them. Returns false when there is no hub. */
static bool move_hubs(struct hatch_solver *solver, const struct hatch_patch *patch)
{
    /* Two arrays that are set later, first_column by find_envelope. */
    uint32_t *faces = solver->row_start, *vertex_at = solver->first_column, count = patch->vertex_count, hubs = 0;
    double most = HUB_FACTOR * sqrt(count);
    memset(faces, 0, count * sizeof *faces);
    for (uint32_t i = 0; i < 3 * patch->face_count; i++)
        faces[patch->corners[i]]++;
    for (uint32_t v = 0; v < count; v++)
        hubs += faces[v] > most;
    if (hubs == 0)
        return false;
    for (uint32_t v = 0; v < count; v++)
        vertex_at[solver->rank[v]] = v;
    for (uint32_t i = 0, next = 0, last = count - hubs; i < count; i++)
        solver->rank[vertex_at[i]] = faces[vertex_at[i]] > most ? last++ : next++;
    return true;
}

/* Ranks the vertices in the order of a sweep along an axis, by strips that contain less than one vertex on average; the
 * envelope is then about as wide as the patch. Axis 2 stands for the reverse order of growth, which is better where
 * long faces lie across each other. */
static void number_vertices(struct hatch_solver *solver, const struct hatch_patch *patch, uint32_t axis,
                            const double low[2], const double high[2])
{
    uint32_t count = patch->vertex_count, strips = STRIPS * count, *rank = solver->rank, next = 0;
    for (uint32_t v = 0; v < count && axis == 2; v++)
        rank[v] = count - 1 - v;
    if (axis == 2)
        return;
    double scale = strips / (high[axis] - low[axis]);
    memset(solver->strip_rank, 0, strips * sizeof *solver->strip_rank);
    for (uint32_t v = 0; v < count; v++) {
        double strip = scale * (patch->xy[2 * v + axis] - low[axis]);
        rank[v] = strip < strips ? (uint32_t)strip : strips - 1;
        solver->strip_rank[rank[v]]++;
    }
    for (uint32_t i = 0; i < strips; i++) {
        uint32_t here = solver->strip_rank[i];
        solver->strip_rank[i] = next;
        next += here;
    }
    for (uint32_t v = 0; v < count; v++)
        rank[v] = solver->strip_rank[rank[v]]++;
}

/* Finds the first column of each row. Returns the number of entries in the envelope. */
static uint64_t find_envelope(struct hatch_solver *solver, const struct hatch_patch *patch)
{
    for (uint32_t i = 0; i < patch->vertex_count; i++)
        solver->first_column[i] = i;
    for (uint32_t i = 0; i < 3 * patch->face_count; i++) {
        uint32_t a = solver->rank[patch->corners[i]];
        uint32_t b = solver->rank[patch->corners[i % 3 == 2 ? i - 2 : i + 1]];
        uint32_t low = a < b ? a : b, high = a < b ? b : a;
        if (low < solver->first_column[high])
            solver->first_column[high] = low;
    }
    uint64_t size = 0;
    for (uint32_t i = 0; i < patch->vertex_count; i++)
        size += i - solver->first_column[i] + 1;
    return size;
}

/* Numbers the vertices along an axis, and with the hubs last where that shortens the envelope. Returns the number of
 * its entries. */
static uint64_t number_along(struct hatch_solver *solver, const struct hatch_patch *patch, uint32_t axis,
                             const double low[2], const double high[2])
{
    double count = patch->vertex_count;
    number_vertices(solver, patch, axis, low, high);
    uint64_t size = find_envelope(solver, patch);
    if ((double)size > ENVELOPE_FAIR * count * sqrt(count) && move_hubs(solver, patch))
        size = find_envelope(solver, patch);
    return size;
}

/* Numbers the vertices so that the envelope is short. */
static void choose_numbering(struct hatch_solver *solver, const struct hatch_patch *patch)
{
    double low[2], high[2], count = patch->vertex_count, fair = ENVELOPE_FAIR * count * sqrt(count);
    uint32_t longer = find_box(patch, low, high), tried = 0, best = 0;
    const uint32_t axes[3] = {longer, 1 - longer, 2};
    uint64_t least = UINT64_MAX;
    for (; tried < 3 && (double)least > fair; tried++) {
        uint64_t found = number_along(solver, patch, axes[tried], low, high);
        if (found < least) {
            least = found;
            best = tried;
        }
    }
    if (best + 1 != tried)
        number_along(solver, patch, axes[best], low, high);
}

static enum hatch_status reserve_matrix(struct hatch_solver *solver, const struct hatch_patch *patch,
                                        struct hatch_err *err)
{
    uint32_t size = 0;
    for (uint32_t i = 0; i < patch->vertex_count; i++) {
        solver->row_start[i] = size - solver->first_column[i];
        size += i - solver->first_column[i] + 1;
    }
    void *array = solver->matrix;
    HATCH_TRY(hatch_lapped_reserve(solver->arena, &array, &solver->matrix_capacity, size, sizeof *solver->matrix, err));
    solver->matrix = array;
    memset(solver->matrix, 0, size * sizeof *solver->matrix);
    return HATCH_OK;
}

/* Computes the gradients of a face's three hat functions in the face's plane, with x along its signed direction.
 * Returns its area. */
static double hat_gradients(const struct hatch_patch_domain *domain, uint32_t face, int8_t sign, double gradient[3][2])
{
    const double *flat = &domain->flattened[(size_t)face * 4];
    double least =
        HATCH_LAPPED_AREA_FLOOR * (flat[0] * flat[0] + flat[1] * flat[1] + flat[2] * flat[2] + flat[3] * flat[3]);
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

static void find_gradients(struct hatch_solver *solver, const struct hatch_patch_domain *domain,
                           const struct hatch_patch *patch)
{
    for (uint32_t f = 0; f < patch->face_count; f++) {
        uint32_t face = patch->faces[f];
        double *to = &solver->gradients[8 * f];
        double area = hat_gradients(domain, face, patch->sign[f], (double(*)[2])to);
        double largest = 0;
        for (int i = 0; i < 6; i += 2) {
            double own = area * (to[i] * to[i] + to[i + 1] * to[i + 1]);
            largest = own > largest ? own : largest;
        }
        area *= largest > ENTRY_MAX ? ENTRY_MAX / largest : 1;
        to[6] = domain->singular[face] ? SINGULAR_WEIGHT * area : area;
        to[7] = 1;
    }
}

void hatch_solver_entry(const struct hatch_solver *solver, uint32_t local, uint32_t row, uint32_t column,
                        double entry[2])
{
    const double *gradient = &solver->gradients[8 * local], weight = gradient[6];
    double along = weight * gradient[2 * row] * gradient[2 * column];
    double across = weight * gradient[2 * row + 1] * gradient[2 * column + 1];
    entry[0] = along + TURN_WEIGHT * across;
    entry[1] = TURN_WEIGHT * along + across;
}

/* Adds a face's part of the normal equations. Vertex 0 is fixed at the origin: its row and column are left out. */
static void add_matrix(struct hatch_solver *solver, const struct hatch_patch *patch, uint32_t local)
{
    const uint32_t *corner = &patch->corners[3 * local];
    for (uint32_t a = 0; a < 3; a++) {
        if (corner[a] == 0)
            continue;
        uint32_t row = solver->rank[corner[a]];
        for (uint32_t b = 0; b < 3; b++) {
            uint32_t column = solver->rank[corner[b]];
            if (corner[b] == 0 || column > row)
                continue;
            double own[2], *entry = solver->matrix[(uint32_t)(solver->row_start[row] + column)];
            hatch_solver_entry(solver, local, a, b, own);
            entry[0] += own[0];
            entry[1] += own[1];
        }
    }
}

/* Returns the mean of a face's scales along x and y in the plane. */
static double scale_of(const struct hatch_solver *solver, const struct hatch_patch *patch, uint32_t local)
{
    const double *gradient = &solver->gradients[8 * local];
    double sum = 0;
    for (uint32_t c = 0; c < 3; c++) {
        const double *at = &patch->xy[2 * patch->corners[3 * local + c]];
        sum += at[0] * gradient[2 * c] + at[1] * gradient[2 * c + 1];
    }
    return sum / 2;
}

static void add_right_side(struct hatch_solver *solver, const struct hatch_patch *patch, uint32_t local)
{
    const uint32_t *corner = &patch->corners[3 * local];
    const double *gradient = &solver->gradients[8 * local], weight = gradient[7] * gradient[6];
    for (uint32_t a = 0; a < 3; a++) {
        if (corner[a] == 0)
            continue;
        double *right = solver->right_side[solver->rank[corner[a]]];
        right[0] += weight * gradient[2 * a];
        right[1] += weight * gradient[2 * a + 1];
    }
}

/* Subtracts the dot product of a and b from value, for x and for y. Four partial sums hide the processor's latency; the
 * order of summation is fixed. */
static void subtract_dot(double (*a)[2], double (*b)[2], uint32_t count, double value[2])
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
    value[0] -= sum[0][0] + sum[1][0] + (sum[2][0] + sum[3][0]);
    value[1] -= sum[0][1] + sum[1][1] + (sum[2][1] + sum[3][1]);
}

static double (*row_of(const struct hatch_solver *solver, uint32_t row))[2]
{
    return &solver->matrix[(uint32_t)(solver->row_start[row] + solver->first_column[row])];
}

/* Replaces the matrices by their Cholesky factors, with inverted diagonals. */
static void factorize(const struct hatch_solver *solver, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        uint32_t low = solver->first_column[i];
        double(*row)[2] = row_of(solver, i);
        for (uint32_t j = low; j < i; j++) {
            uint32_t from = solver->first_column[j] > low ? solver->first_column[j] : low;
            double(*other)[2] = &row_of(solver, j)[from - solver->first_column[j]];
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

/* Replaces the right-hand sides by the solutions. */
static void substitute(const struct hatch_solver *solver, uint32_t count)
{
    double(*restrict right)[2] = solver->right_side;
    for (uint32_t i = 0; i < count; i++) {
        uint32_t low = solver->first_column[i];
        double(*row)[2] = row_of(solver, i);
        subtract_dot(row, &right[low], i - low, right[i]);
        right[i][0] *= row[i - low][0];
        right[i][1] *= row[i - low][1];
    }
    for (uint32_t i = count; i-- > 0;) {
        uint32_t low = solver->first_column[i];
        double(*restrict row)[2] = row_of(solver, i);
        double x = right[i][0] *= row[i - low][0], y = right[i][1] *= row[i - low][1];
        for (uint32_t j = low; j < i; j++) {
            right[j][0] -= row[j - low][0] * x;
            right[j][1] -= row[j - low][1] * y;
        }
    }
}

/* Moves the faces' target scales towards those of the solution. Returns false when they hardly change. */
static bool update_scales(struct hatch_solver *solver, const struct hatch_patch *patch)
{
    double change = 0, whole = 0;
    for (uint32_t f = 0; f < patch->face_count; f++) {
        double *scale = &solver->gradients[8 * f + 7], weight = solver->gradients[8 * f + 6];
        double next = *scale + SCALE_STEP * (scale_of(solver, patch, f) - *scale);
        next = next < SCALE_MIN ? SCALE_MIN : next > SCALE_MAX ? SCALE_MAX : next;
        change += weight * fabs(next - *scale);
        whole += weight;
        *scale = next;
    }
    return change > SCALE_SETTLED * whole;
}

/* Solves for the positions with the faces' present target scales.
 *   sparse  NULL: the factors are those within the envelope */
static enum hatch_status solve_positions(struct hatch_solver *solver, const struct hatch_sparse_solver *sparse,
                                         struct hatch_patch *patch, struct hatch_err *err)
{
    memset(solver->right_side, 0, patch->vertex_count * sizeof *solver->right_side);
    for (uint32_t f = 0; f < patch->face_count; f++)
        add_right_side(solver, patch, f);
    if (sparse)
        HATCH_TRY(hatch_sparse_solver_solve(sparse, solver->right_side, patch->vertex_count, err));
    else
        substitute(solver, patch->vertex_count);
    for (uint32_t v = 0; v < patch->vertex_count; v++)
        memcpy(&patch->xy[2 * v], solver->right_side[solver->rank[v]], sizeof *solver->right_side);
    return HATCH_OK;
}

static enum hatch_status solve_in_rounds(struct hatch_solver *solver, const struct hatch_sparse_solver *sparse,
                                         struct hatch_patch *patch, struct hatch_err *err)
{
    HATCH_TRY(solve_positions(solver, sparse, patch, err));
    for (int round = 1; round < SCALE_ROUNDS && update_scales(solver, patch); round++)
        HATCH_TRY(solve_positions(solver, sparse, patch, err));
    return HATCH_OK;
}

static enum hatch_status solve_sparse(struct hatch_solver *solver, struct hatch_patch *patch, struct hatch_err *err)
{
    struct hatch_sparse_solver sparse = {.column = NULL};
    struct hatch_arena_mark mark = hatch_arena_mark(solver->arena);
    for (uint32_t v = 0; v < patch->vertex_count; v++)
        solver->rank[v] = v;
    enum hatch_status status = hatch_sparse_solver_make(solver, patch, &sparse, err);
    if (status == HATCH_OK)
        status = solve_in_rounds(solver, &sparse, patch, err);
    hatch_sparse_solver_free(&sparse);
    hatch_arena_rewind(solver->arena, mark);
    return status;
}

/* Returns the number of multiplications of the factorization within the envelope. */
static double cost_of(const struct hatch_solver *solver, uint32_t count)
{
    double cost = 0;
    for (uint32_t i = 0; i < count; i++) {
        double length = i - solver->first_column[i] + 1;
        cost += length * length;
    }
    return cost;
}

enum hatch_status hatch_solver_solve(struct hatch_solver *solver, const struct hatch_patch_domain *domain,
                                     struct hatch_patch *patch, struct hatch_err *err)
{
    HATCH_TRY(reserve_arrays(solver, patch, err));
    choose_numbering(solver, patch);
    find_gradients(solver, domain, patch);
    if (cost_of(solver, patch->vertex_count) > COST_MAX)
        return solve_sparse(solver, patch, err);
    HATCH_TRY(reserve_matrix(solver, patch, err));
    for (uint32_t f = 0; f < patch->face_count; f++)
        add_matrix(solver, patch, f);
    uint32_t fixed = solver->rank[0];
    double *pivot = solver->matrix[(uint32_t)(solver->row_start[fixed] + fixed)];
    pivot[0] = pivot[1] = 1;
    factorize(solver, patch->vertex_count);
    return solve_in_rounds(solver, NULL, patch, err);
}

void hatch_patch_fit(const struct hatch_patch_domain *domain, const struct hatch_patch *patch, uint32_t local,
                     struct hatch_fit *fit)
{
    double gradient[3][2], jacobian[2][2] = {{0, 0}, {0, 0}};
    hat_gradients(domain, patch->faces[local], patch->sign[local], gradient);
    for (uint32_t c = 0; c < 3; c++) {
        const double *at = &patch->xy[2 * patch->corners[3 * local + c]];
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
    fit->angle_tan = fit->determinant > 0 && jacobian[1][1] > 0 ? fabs(jacobian[1][0]) / jacobian[1][1] : HUGE_VAL;
}
