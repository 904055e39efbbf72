#include "solid/points.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "base/random.h"

#define ROUNDS 12
#define REACH 1.5f /* of the repulsion, in mean distances count^(-1/3) */
#define PUSH 0.25f /* of a pair at distance 0, in mean distances */
#define TASK_POINTS 64u

enum { STREAM_JITTER = 0x706f6974, STREAM_START, STREAM_SHAKE, STREAM_FACTOR };

static enum hatch_status allocate(struct hatch_solid_points *points, struct hatch_arena *arena, struct hatch_err *err)
{
    uint32_t cells = points->cells, count = points->count;
    HATCH_TRY(HATCH_ALLOC(arena, &points->first, (size_t)cells * cells * cells + 1, err));
    HATCH_TRY(HATCH_ALLOC(arena, &points->at, count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &points->factors, count, err));
    return HATCH_ALLOC(arena, &points->numbers, count, err);
}

/* Sorts points into cells, those of one cell by number.
 *   at  by number */
static void sort(float (*at)[3], struct hatch_solid_points *points)
{
    uint32_t cells = points->cells, *first = points->first, cell_count = cells * cells * cells;
    memset(first, 0, ((size_t)cell_count + 1) * sizeof *first);
    for (int pass = 0; pass < 2; pass++) {
        for (uint32_t i = points->count; i-- > 0;) {
            uint32_t x = hatch_solid_cell(at[i][0], cells), y = hatch_solid_cell(at[i][1], cells),
                     cell = (hatch_solid_cell(at[i][2], cells) * cells + y) * cells + x;
            if (pass == 0) {
                first[cell]++;
                continue;
            }
            uint32_t place = --first[cell];
            memcpy(points->at[place], at[i], sizeof *at);
            points->numbers[place] = i;
        }
        for (uint32_t cell = 1; cell <= cell_count && pass == 0; cell++)
            first[cell] += first[cell - 1];
    }
}

enum hatch_status hatch_solid_points_jitter(uint32_t side, float jitter, uint64_t seed, struct hatch_arena *arena,
                                            struct hatch_solid_points *points, struct hatch_err *err)
{
    struct hatch_solid_points made = {.count = side * side * side, .cells = side, .factor_min = 1};
    HATCH_TRY(allocate(&made, arena, err));
    for (uint32_t i = 0; i < made.count; i++) {
        const uint32_t cell[3] = {i % side, i / side % side, i / side / side};
        for (uint32_t c = 0; c < 3; c++) {
            float within = 0.5f + jitter * (hatch_random_unit(seed, STREAM_JITTER, 3 * (uint64_t)i + c) - 0.5f);
            made.at[i][c] = ((float)cell[c] + within) / (float)side;
        }
        made.factors[i] = 1;
        made.numbers[i] = made.first[i] = i;
    }
    made.first[made.count] = made.count;
    *points = made;
    return HATCH_OK;
}

static float wrapped(float coordinate)
{
    coordinate -= floorf(coordinate);
    return coordinate < 1 ? coordinate : 0;
}

/* The recurrence of Roberts: multiples of powers of the root of x^4 = x + 1, in 32 bits of a turn, each shaken. */
static void start(uint32_t count, float spacing, uint64_t seed, float (*at)[3])
{
    static const uint32_t steps[3] = {0xd1b54a33u, 0xabc98389u, 0x8cb92ba7u};
    for (uint32_t i = 0; i < count; i++)
        for (uint32_t c = 0; c < 3; c++) {
            uint32_t turn = (uint32_t)hatch_random_u64(seed, STREAM_START, c) + i * steps[c];
            float shake = hatch_random_unit(seed, STREAM_SHAKE, 3 * (uint64_t)i + c) - 0.5f;
            at[i][c] = wrapped((float)(turn >> 8) * 0x1p-24f + shake * spacing);
        }
}

/* State of the repulsion. */
struct repelling {
    const struct hatch_solid_points *points; /* at present */
    float spacing, reach;
    float (*moved)[3]; /* by number */
};

/* Adds the pushes of a run of points, first .. end - 1, to that of a point.
 *   offset  of the cube to which this copy of the run belongs */
static void push(const struct repelling *r, uint32_t first, uint32_t end, const float at[3], const float offset[3],
                 float sum[3])
{
    const float reach = r->reach;
    for (uint32_t other = first; other < end; other++) {
        const float *from = r->points->at[other];
        float x = at[0] - from[0] - offset[0], y = at[1] - from[1] - offset[1], z = at[2] - from[2] - offset[2];
        float squared = x * x + y * y + z * z;
        if (!(squared > 0 && squared < reach * reach))
            continue;
        float distance = sqrtf(squared), left = 1 - distance / reach, factor = left * left * PUSH * r->spacing;
        sum[0] += x / distance * factor;
        sum[1] += y / distance * factor;
        sum[2] += z / distance * factor;
    }
}

/* Wraps a coordinate of a cell into 0 .. cells - 1 and returns how many cubes lie between. */
static float wrap_cell(int32_t *cell, int32_t cells)
{
    int32_t turn = *cell < 0 ? -((cells - 1 - *cell) / cells) : *cell / cells;
    *cell -= turn * cells;
    return (float)turn;
}

/* Cells along an axis, not wrapped. */
struct range {
    int32_t low, high;
};

/* Returns the cells with places that are at most `reach` from a coordinate. */
static struct range cells_within(float coordinate, float reach, int32_t cells)
{
    float margin = reach + 1e-3f / (float)cells; /* points on the border of two cells may be in either */
    return (struct range){(int32_t)floorf((coordinate - margin) * (float)cells),
                          (int32_t)floorf((coordinate + margin) * (float)cells)};
}

/* Returns the least distance along an axis from a coordinate to a cell. */
static float distance_to(int32_t cell, float coordinate, int32_t cells)
{
    float low = (float)cell / (float)cells, high = (float)(cell + 1) / (float)cells;
    return coordinate < low ? low - coordinate : coordinate > high ? coordinate - high : 0;
}

/* Adds the pushes of a row of cells, those of one cube after the other.
 *   row     number of its first cell
 *   x       cells of the row, not wrapped
 *   offset  as in push; along the row, it is set here */
static void push_row(const struct repelling *r, int32_t row, struct range x, const float at[3], float offset[3],
                     float sum[3])
{
    int32_t cells = (int32_t)r->points->cells;
    while (x.low <= x.high) {
        int32_t first = x.low;
        offset[0] = wrap_cell(&first, cells);
        int32_t count = first + x.high - x.low < cells ? x.high - x.low + 1 : cells - first;
        push(r, r->points->first[row + first], r->points->first[row + first + count], at, offset, sum);
        x.low += count;
    }
}

static void repel_point(const struct repelling *r, uint32_t point)
{
    const float *at = r->points->at[point], squared = r->reach * r->reach;
    int32_t cells = (int32_t)r->points->cells;
    struct range layers = cells_within(at[2], r->reach, cells), rows = cells_within(at[1], r->reach, cells);
    float sum[3] = {0, 0, 0}, offset[3];
    for (int32_t layer = layers.low; layer <= layers.high; layer++) {
        float above = distance_to(layer, at[2], cells);
        int32_t z = layer;
        offset[2] = wrap_cell(&z, cells);
        for (int32_t row = rows.low; row <= rows.high; row++) {
            float beside = distance_to(row, at[1], cells), left = squared - above * above - beside * beside;
            int32_t y = row;
            offset[1] = wrap_cell(&y, cells);
            if (left > 0)
                push_row(r, (z * cells + y) * cells, cells_within(at[0], sqrtf(left), cells), at, offset, sum);
        }
    }
    for (int c = 0; c < 3; c++)
        r->moved[r->points->numbers[point]][c] = wrapped(at[c] + sum[c]);
}

static void repel(void *context, uint32_t task)
{
    const struct repelling *r = context;
    for (uint32_t point = task * TASK_POINTS; point < (task + 1) * TASK_POINTS && point < r->points->count; point++)
        repel_point(r, point);
}

static enum hatch_status spread(uint32_t count, uint64_t seed, struct hatch_pool *pool,
                                const struct hatch_progress *progress, struct hatch_arena *scratch,
                                struct hatch_solid_points *points, struct hatch_err *err)
{
    struct repelling r = {.points = points, .spacing = (float)(1 / cbrt(count))};
    r.reach = REACH * r.spacing;
    HATCH_TRY(HATCH_ALLOC(scratch, &r.moved, count, err));
    start(count, r.spacing, seed, r.moved);
    for (int round = 0; round < ROUNDS; round++) {
        sort(r.moved, points);
        hatch_parallel_for(pool, (count + TASK_POINTS - 1) / TASK_POINTS, repel, &r);
        hatch_progress_report(progress, (round + 1.0) / ROUNDS);
    }
    sort(r.moved, points);
    return HATCH_OK;
}

enum hatch_status hatch_solid_points_spread(uint32_t count, float vary, uint64_t seed, struct hatch_pool *pool,
                                            const struct hatch_progress *progress, struct hatch_arena *arena,
                                            struct hatch_arena *scratch, struct hatch_solid_points *points,
                                            struct hatch_err *err)
{
    struct hatch_solid_points made = {.count = count, .cells = 1, .factor_min = 1 - vary / 2};
    while ((made.cells + 1) * (made.cells + 1) * (made.cells + 1) <= count)
        made.cells++;
    HATCH_TRY(allocate(&made, arena, err));
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    enum hatch_status status = spread(count, seed, pool, progress, scratch, &made, err);
    hatch_arena_rewind(scratch, mark);
    HATCH_TRY(status);
    for (uint32_t i = 0; i < count; i++)
        made.factors[i] = 1 + vary * (hatch_random_unit(seed, STREAM_FACTOR, made.numbers[i]) - 0.5f);
    *points = made;
    return HATCH_OK;
}

/* Takes the points of a cell into the two smallest distances.
 *   at  the place, seen from the cube to which this copy of the cell belongs */
static void look(const struct hatch_solid_points *points, uint32_t cell, const float at[3], float distances[2])
{
    for (uint32_t point = points->first[cell]; point < points->first[cell + 1]; point++) {
        const float *to = points->at[point], dx = at[0] - to[0], dy = at[1] - to[1], dz = at[2] - to[2];
        float distance = sqrtf(dx * dx + dy * dy + dz * dz) * points->factors[point];
        if (distance < distances[0]) {
            distances[1] = distances[0];
            distances[0] = distance;
        } else if (distance < distances[1])
            distances[1] = distance;
    }
}

/* Looks into all cells at a distance of `ring` cells, by the largest of the three coordinates. */
static void look_around(const struct hatch_solid_points *points, const int32_t cell[3], int32_t ring, const float at[3],
                        float distances[2])
{
    int32_t cells = (int32_t)points->cells;
    float place[3];
    for (int32_t dz = -ring; dz <= ring; dz++) {
        int32_t z = cell[2] + dz;
        place[2] = at[2] - wrap_cell(&z, cells);
        for (int32_t dy = -ring; dy <= ring; dy++) {
            int32_t y = cell[1] + dy;
            place[1] = at[1] - wrap_cell(&y, cells);
            bool face = dz == -ring || dz == ring || dy == -ring || dy == ring;
            for (int32_t dx = -ring; dx <= ring; dx += face ? 1 : 2 * ring) {
                int32_t x = cell[0] + dx;
                place[0] = at[0] - wrap_cell(&x, cells);
                look(points, (uint32_t)((z * cells + y) * cells + x), place, distances);
            }
        }
    }
}

void hatch_solid_points_nearest(const struct hatch_solid_points *points, const float at[3], float distances[2])
{
    int32_t cell[3];
    for (int c = 0; c < 3; c++)
        cell[c] = (int32_t)hatch_solid_cell(at[c], points->cells);
    distances[0] = distances[1] = FLT_MAX;
    float sure = 0; /* all points within this distance have been looked at */
    for (int32_t ring = 0; distances[1] > sure; ring++) {
        look_around(points, cell, ring, at, distances);
        sure = (float)ring / (float)points->cells * points->factor_min;
    }
}
