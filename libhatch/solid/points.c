#include "solid/points.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "base/random.h"

#define ROUNDS 12
#define REACH 1.5f /* of the repulsion, in mean distances count^(-1/3) */
#define PUSH 0.25f /* of a pair at distance 0, in mean distances */
#define TASK_CELLS 64u

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
    float spacing;
    float (*moved)[3]; /* by number */
};

/* Adds the push of the points of a cell to that of a point.
 *   offset  of the cell's copy from the cell itself */
static void push(const struct repelling *r, uint32_t cell, const float offset[3], uint32_t point, float sum[3])
{
    const struct hatch_solid_points *points = r->points;
    float reach = REACH * r->spacing;
    for (uint32_t other = points->first[cell]; other < points->first[cell + 1]; other++) {
        float away[3], squared = 0;
        for (int c = 0; c < 3; c++) {
            away[c] = points->at[point][c] - points->at[other][c] - offset[c];
            squared += away[c] * away[c];
        }
        if (!(squared > 0 && squared < reach * reach))
            continue;
        float distance = sqrtf(squared), left = 1 - distance / reach;
        for (int c = 0; c < 3; c++)
            sum[c] += away[c] / distance * (left * left * PUSH * r->spacing);
    }
}

/* Wraps a coordinate of a cell into 0 .. cells - 1 and returns how many cubes lie between. */
static float wrap_cell(int32_t *cell, int32_t cells)
{
    int32_t turn = *cell < 0 ? -((cells - 1 - *cell) / cells) : *cell / cells;
    *cell -= turn * cells;
    return (float)turn;
}

static void repel_point(const struct repelling *r, const int32_t cell[3], uint32_t point)
{
    int32_t cells = (int32_t)r->points->cells, reach = (int32_t)ceilf(REACH * r->spacing * (float)cells);
    float sum[3] = {0, 0, 0}, offset[3];
    for (int32_t dz = -reach; dz <= reach; dz++) {
        int32_t z = cell[2] + dz;
        offset[2] = wrap_cell(&z, cells);
        for (int32_t dy = -reach; dy <= reach; dy++) {
            int32_t y = cell[1] + dy;
            offset[1] = wrap_cell(&y, cells);
            for (int32_t dx = -reach; dx <= reach; dx++) {
                int32_t x = cell[0] + dx;
                offset[0] = wrap_cell(&x, cells);
                push(r, (uint32_t)((z * cells + y) * cells + x), offset, point, sum);
            }
        }
    }
    for (int c = 0; c < 3; c++)
        r->moved[r->points->numbers[point]][c] = wrapped(r->points->at[point][c] + sum[c]);
}

static void repel(void *context, uint32_t task)
{
    const struct repelling *r = context;
    uint32_t cells = r->points->cells, count = cells * cells * cells;
    for (uint32_t cell = task * TASK_CELLS; cell < (task + 1) * TASK_CELLS && cell < count; cell++) {
        const int32_t at[3] = {(int32_t)(cell % cells), (int32_t)(cell / cells % cells),
                               (int32_t)(cell / cells / cells)};
        for (uint32_t point = r->points->first[cell]; point < r->points->first[cell + 1]; point++)
            repel_point(r, at, point);
    }
}

static enum hatch_status spread(uint32_t count, uint64_t seed, struct hatch_pool *pool,
                                const struct hatch_progress *progress, struct hatch_arena *scratch,
                                struct hatch_solid_points *points, struct hatch_err *err)
{
    struct repelling r = {.points = points, .spacing = (float)(1 / cbrt(count))};
    HATCH_TRY(HATCH_ALLOC(scratch, &r.moved, count, err));
    start(count, r.spacing, seed, r.moved);
    for (int round = 0; round < ROUNDS; round++) {
        sort(r.moved, points);
        uint32_t cell_count = points->cells * points->cells * points->cells;
        hatch_parallel_for(pool, (cell_count + TASK_CELLS - 1) / TASK_CELLS, repel, &r);
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
