#include <assert.h>
#include <math.h>
#include <string.h>

#include "field/system.h"

/* Aggregation multigrid (Vaněk, Mandel, Brezina 1996, without smoothing the aggregates): a point and its strong
 * neighbours become one, whose z turned along the links is theirs. Coarser systems are of the same kind. */

#define LEVELS_MAX 32u
#define COARSEST 12u /* nodes: fewer are left to the smoother */
#define STRONG 0.25  /* of a node's strongest link */
#define SWEEPS_COARSEST 12
#define CORRECTION                                                                                                     \
    1.5 /* of a coarse correction: what is constant on aggregates is stiffer than the error, which                     \
           is not (Braess, "Towards algebraic multigrid for elliptic problems of second order",                        \
           Computing 55, 1995) */

struct level {
    struct hatch_field_system system; /* of the finest: the caller's arrays */
    uint32_t *middle;                 /* per node: its links before this one lead to earlier nodes, others to later */
    uint32_t *aggregate;              /* per node: its node on the next level; NULL on the last */
    double *phase;                    /* 2 a node: its z for 1 there */
    double *z, *right;                /* 2 a node; the finest has none */
    double *residual;                 /* 2 a node */
};

struct hatch_field_levels {
    uint32_t count;
    struct level level[LEVELS_MAX];
};

static double length_squared(const double z[2])
{
    return z[0] * z[0] + z[1] * z[1];
}

/* phase = unit(link) * of. */
static void turn_phase(const double link[2], const double of[2], double phase[2])
{
    double length = sqrt(length_squared(link));
    double c = link[0] / length, s = link[1] / length;
    phase[0] = c * of[0] - s * of[1];
    phase[1] = c * of[1] + s * of[0];
}

/* Square of the least length that counts as a strong link of a node. */
static double strong_squared(const struct hatch_field_system *system, uint32_t node)
{
    double most = 0;
    for (uint32_t i = system->first[node]; i < system->first[node + 1]; i++)
        most = fmax(most, length_squared(&system->link[2 * (size_t)i]));
    return fmax(most * STRONG * STRONG, 1e-300);
}

/* Takes a node and its strong neighbours, when all of them are free. */
static bool take_neighbourhood(const struct level *level, uint32_t node, uint32_t number)
{
    const struct hatch_field_system *system = &level->system;
    double least = strong_squared(system, node);
    for (uint32_t i = system->first[node]; i < system->first[node + 1]; i++)
        if (length_squared(&system->link[2 * (size_t)i]) >= least && level->aggregate[system->to[i]] != HATCH_NO_SIDE)
            return false;
    level->aggregate[node] = number;
    level->phase[2 * (size_t)node] = 1;
    for (uint32_t i = system->first[node]; i < system->first[node + 1]; i++) {
        const double *link = &system->link[2 * (size_t)i];
        uint32_t to = system->to[i];
        if (!(length_squared(link) >= least) || level->aggregate[to] != HATCH_NO_SIDE)
            continue;
        level->aggregate[to] = number;
        /* The link leads from `to` here: the way back is its conjugate. */
        const double back[2] = {link[0], -link[1]};
        turn_phase(back, &level->phase[2 * (size_t)node], &level->phase[2 * (size_t)to]);
    }
    return true;
}

/* Puts what is left with its strongest neighbour that the first pass placed; alone where there is none. */
static uint32_t place_rest(const struct level *level, uint32_t count, uint32_t placed)
{
    const struct hatch_field_system *system = &level->system;
    for (uint32_t n = 0; n < system->count; n++) {
        if (level->aggregate[n] != HATCH_NO_SIDE)
            continue;
        double most = 0;
        uint32_t best = HATCH_NO_SIDE;
        for (uint32_t i = system->first[n]; i < system->first[n + 1]; i++) {
            double length = length_squared(&system->link[2 * (size_t)i]);
            if (level->aggregate[system->to[i]] < placed && length > most) {
                most = length;
                best = i;
            }
        }
        if (best == HATCH_NO_SIDE) {
            level->phase[2 * (size_t)n] = 1;
            level->aggregate[n] = count++;
            continue;
        }
        turn_phase(&system->link[2 * (size_t)best], &level->phase[2 * (size_t)system->to[best]],
                   &level->phase[2 * (size_t)n]);
        level->aggregate[n] = level->aggregate[system->to[best]];
    }
    return count;
}

static uint32_t aggregate(const struct level *level)
{
    uint32_t count = 0;
    for (uint32_t n = 0; n < level->system.count; n++)
        level->aggregate[n] = HATCH_NO_SIDE;
    for (uint32_t n = 0; n < level->system.count; n++)
        if (level->aggregate[n] == HATCH_NO_SIDE && take_neighbourhood(level, n, count))
            count++;
    return place_rest(level, count, count);
}

/* The nodes grouped by aggregate. */
struct members {
    uint32_t *first, *node; /* aggregates + 1, nodes */
    uint32_t *slot;         /* per aggregate: where the coarse node in work has its link to it, plus 1 */
};

static enum hatch_status group(const struct level *level, uint32_t count, struct hatch_arena *arena,
                               struct members *members, struct hatch_err *err)
{
    uint32_t nodes = level->system.count;
    members->first = HATCH_NEW(arena, uint32_t, (size_t)count + 2, err);
    members->node = members->first ? HATCH_NEW_UNSET(arena, uint32_t, nodes, err) : NULL;
    members->slot = members->node ? HATCH_NEW(arena, uint32_t, count, err) : NULL;
    if (!members->slot)
        return HATCH_LIMIT;
    for (uint32_t n = 0; n < nodes; n++)
        members->first[level->aggregate[n] + 2]++;
    for (uint32_t a = 0; a < count; a++)
        members->first[a + 2] += members->first[a + 1];
    for (uint32_t n = 0; n < nodes; n++)
        members->node[members->first[level->aggregate[n] + 1]++] = n;
    return HATCH_OK;
}

/* One coarse node's links and diagonal: Σ conj(phase) link phase over its members' links. Returns how many; with
 * coarse NULL it only counts. */
static uint32_t sum_links(const struct level *level, const struct members *members, uint32_t a, uint32_t at,
                          struct hatch_field_system *coarse)
{
    const struct hatch_field_system *fine = &level->system;
    uint32_t begin = at;
    for (uint32_t m = members->first[a]; m < members->first[a + 1]; m++) {
        uint32_t n = members->node[m];
        const double *own = &level->phase[2 * (size_t)n];
        if (coarse)
            coarse->diagonal[a] += fine->diagonal[n];
        for (uint32_t i = fine->first[n]; i < fine->first[n + 1]; i++) {
            uint32_t to = level->aggregate[fine->to[i]];
            uint32_t *slot = &members->slot[to];
            if (to != a && (*slot <= begin || *slot > at))
                *slot = ++at;
            if (!coarse)
                continue;
            double z[2], sum[2];
            const double *link = &fine->link[2 * (size_t)i], *far = &level->phase[2 * (size_t)fine->to[i]];
            z[0] = link[0] * far[0] - link[1] * far[1];
            z[1] = link[0] * far[1] + link[1] * far[0];
            sum[0] = own[0] * z[0] + own[1] * z[1];
            sum[1] = own[0] * z[1] - own[1] * z[0];
            if (to == a) {
                coarse->diagonal[a] -= sum[0];
                continue;
            }
            coarse->to[*slot - 1] = to;
            coarse->link[2 * (size_t)(*slot - 1)] += sum[0];
            coarse->link[2 * (size_t)(*slot - 1) + 1] += sum[1];
        }
    }
    return at;
}

static enum hatch_status make_coarse(const struct level *level, uint32_t count, const struct members *members,
                                     struct hatch_arena *arena, struct level *next, struct hatch_err *err)
{
    struct hatch_field_system *coarse = &next->system;
    coarse->count = count;
    coarse->first = HATCH_NEW(arena, uint32_t, (size_t)count + 1, err);
    if (!coarse->first)
        return HATCH_LIMIT;
    for (uint32_t a = 0; a < count; a++)
        coarse->first[a + 1] = sum_links(level, members, a, coarse->first[a], NULL);
    uint32_t links = coarse->first[count];
    coarse->to = HATCH_NEW_UNSET(arena, uint32_t, links, err);
    coarse->link = coarse->to ? HATCH_NEW(arena, double, (size_t)links * 2, err) : NULL;
    coarse->diagonal = coarse->link ? HATCH_NEW(arena, double, count, err) : NULL;
    next->z = coarse->diagonal ? HATCH_NEW_UNSET(arena, double, (size_t)count * 2, err) : NULL;
    next->right = next->z ? HATCH_NEW_UNSET(arena, double, (size_t)count * 2, err) : NULL;
    next->residual = next->right ? HATCH_NEW_UNSET(arena, double, (size_t)count * 2, err) : NULL;
    if (!next->residual)
        return HATCH_LIMIT;
    memset(members->slot, 0, count * sizeof *members->slot);
    for (uint32_t a = 0; a < count; a++)
        sum_links(level, members, a, coarse->first[a], coarse);
    return HATCH_OK;
}

/* A sweep that begins at zero then needs but the first part of each row, and its residual but the second. */
static enum hatch_status part_links(struct level *level, struct hatch_arena *arena, struct hatch_err *err)
{
    const struct hatch_field_system *system = &level->system;
    level->middle = HATCH_NEW_UNSET(arena, uint32_t, system->count, err);
    if (!level->middle)
        return HATCH_LIMIT;
    for (uint32_t n = 0; n < system->count; n++) {
        uint32_t low = system->first[n];
        for (uint32_t i = low; i < system->first[n + 1]; i++) {
            if (system->to[i] > n)
                continue;
            double *here = &system->link[2 * (size_t)i], *there = &system->link[2 * (size_t)low];
            const double link[2] = {here[0], here[1]};
            uint32_t to = system->to[i];
            memcpy(here, there, sizeof link);
            memcpy(there, link, sizeof link);
            system->to[i] = system->to[low];
            system->to[low++] = to;
        }
        level->middle[n] = low;
    }
    return HATCH_OK;
}

static enum hatch_status add_level(struct hatch_field_levels *levels, struct hatch_arena *arena, bool *added,
                                   struct hatch_err *err)
{
    struct level *level = &levels->level[levels->count - 1];
    uint32_t nodes = level->system.count;
    struct members members = {0};
    level->aggregate = HATCH_NEW_UNSET(arena, uint32_t, nodes, err);
    level->phase = level->aggregate ? HATCH_NEW(arena, double, (size_t)nodes * 2, err) : NULL;
    if (!level->phase)
        return HATCH_LIMIT;
    uint32_t count = aggregate(level);
    /* Nodes without links stay as many as they are. */
    *added = count <= nodes - nodes / 4;
    if (!*added) {
        level->aggregate = NULL;
        return HATCH_OK;
    }
    HATCH_TRY(group(level, count, arena, &members, err));
    levels->count++;
    HATCH_TRY(make_coarse(level, count, &members, arena, level + 1, err));
    return part_links(level + 1, arena, err);
}

enum hatch_status hatch_field_coarsen(const struct hatch_field_system *system, struct hatch_arena *arena,
                                      struct hatch_field_levels **levels, struct hatch_err *err)
{
    struct hatch_field_levels *made = HATCH_NEW(arena, struct hatch_field_levels, 1, err);
    if (!made)
        return HATCH_LIMIT;
    made->count = 1;
    made->level[0].system = *system;
    made->level[0].residual = HATCH_NEW_UNSET(arena, double, (size_t)system->count * 2, err);
    if (!made->level[0].residual)
        return HATCH_LIMIT;
    HATCH_TRY(part_links(&made->level[0], arena, err));
    bool added = true;
    while (added && made->count < LEVELS_MAX && made->level[made->count - 1].system.count > COARSEST)
        HATCH_TRY(add_level(made, arena, &added, err));
    *levels = made;
    return HATCH_OK;
}

/* sum += Σ link z over a part of a row. */
static inline void add_links(const struct hatch_field_system *system, uint32_t from, uint32_t end, const double *z,
                             double sum[2])
{
    double x = sum[0], y = sum[1];
    for (uint32_t i = from; i < end; i++) {
        const double *link = &system->link[2 * (size_t)i], *far = &z[2 * (size_t)system->to[i]];
        x += link[0] * far[0] - link[1] * far[1];
        y += link[0] * far[1] + link[1] * far[0];
    }
    sum[0] = x;
    sum[1] = y;
}

/* z[n] = (right[n] + Σ link z) / diagonal, over all links or, z after n being zero, those to earlier nodes. */
static inline void relax(const struct level *level, const double *right, uint32_t n, bool from_zero, double *z)
{
    const struct hatch_field_system *system = &level->system;
    double sum[2] = {right[2 * (size_t)n], right[2 * (size_t)n + 1]}, diagonal = system->diagonal[n];
    add_links(system, system->first[n], from_zero ? level->middle[n] : system->first[n + 1], z, sum);
    z[2 * (size_t)n] = sum[0] / diagonal;
    z[2 * (size_t)n + 1] = sum[1] / diagonal;
}

static void sweep_forward(const struct level *level, const double *right, bool from_zero, double *z)
{
    for (uint32_t n = 0; n < level->system.count; n++)
        relax(level, right, n, from_zero, z);
}

static void sweep_backward(const struct level *level, const double *right, double *z)
{
    for (uint32_t n = level->system.count; n-- > 0;)
        relax(level, right, n, false, z);
}

static void subtract_from(const double *right, double *residual, uint32_t count)
{
    for (size_t i = 0; i < 2 * (size_t)count; i++)
        residual[i] = right[i] - residual[i];
}

static void restrict_residual(const struct level *fine, struct level *coarse)
{
    memset(coarse->right, 0, (size_t)coarse->system.count * 2 * sizeof *coarse->right);
    for (uint32_t n = 0; n < fine->system.count; n++) {
        const double *phase = &fine->phase[2 * (size_t)n], *r = &fine->residual[2 * (size_t)n];
        double *right = &coarse->right[2 * (size_t)fine->aggregate[n]];
        right[0] += phase[0] * r[0] + phase[1] * r[1];
        right[1] += phase[0] * r[1] - phase[1] * r[0];
    }
}

static void add_correction(const struct level *fine, const struct level *coarse, double *z)
{
    for (uint32_t n = 0; n < fine->system.count; n++) {
        const double *phase = &fine->phase[2 * (size_t)n];
        const double *c = &coarse->z[2 * (size_t)fine->aggregate[n]];
        z[2 * (size_t)n] += CORRECTION * (phase[0] * c[0] - phase[1] * c[1]);
        z[2 * (size_t)n + 1] += CORRECTION * (phase[0] * c[1] + phase[1] * c[0]);
    }
}

/* What a forward sweep from zero has left: each node was right when it was set, and later ones have moved since. */
static void find_residual(const struct level *level, const double *right, bool from_zero, const double *z)
{
    const struct hatch_field_system *system = &level->system;
    if (!from_zero) {
        hatch_field_apply(system, z, level->residual);
        subtract_from(right, level->residual, system->count);
        return;
    }
    for (uint32_t n = 0; n < system->count; n++) {
        double *left = &level->residual[2 * (size_t)n];
        left[0] = left[1] = 0;
        add_links(system, level->middle[n], system->first[n + 1], z, left);
    }
}

/* A W cycle, forward sweep before and backward sweep after: symmetric, so that conjugate gradients may use it.
 * from_zero: z begins as zero, whatever it holds. */
static void cycle(const struct hatch_field_levels *levels, uint32_t depth, const double *right, bool from_zero,
                  double *z)
{
    const struct level *fine = &levels->level[depth];
    if (!fine->aggregate) {
        for (int i = 0; i < SWEEPS_COARSEST; i++)
            sweep_forward(fine, right, from_zero && i == 0, z);
        for (int i = 0; i < SWEEPS_COARSEST; i++)
            sweep_backward(fine, right, z);
        return;
    }
    struct level coarse = levels->level[depth + 1];
    sweep_forward(fine, right, from_zero, z);
    find_residual(fine, right, from_zero, z);
    restrict_residual(fine, &coarse);
    cycle(levels, depth + 1, coarse.right, true, coarse.z);
    if (coarse.aggregate)
        cycle(levels, depth + 1, coarse.right, false, coarse.z);
    add_correction(fine, &coarse, z);
    sweep_backward(fine, right, z);
}

enum hatch_status hatch_field_iterate(const struct hatch_field_system *system, const struct hatch_field_levels *levels,
                                      const double *right, double tolerance, uint32_t iterations_max,
                                      struct hatch_arena *scratch, double *z, struct hatch_field_progress *progress,
                                      struct hatch_err *err)
{
    size_t size = (size_t)system->count * 2;
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    double *r = HATCH_NEW_UNSET(scratch, double, size, err);
    double *s = r ? HATCH_NEW_UNSET(scratch, double, size, err) : NULL;
    double *p = s ? HATCH_NEW_UNSET(scratch, double, size, err) : NULL;
    double *q = p ? HATCH_NEW_UNSET(scratch, double, size, err) : NULL;
    if (!q) {
        hatch_arena_rewind(scratch, mark);
        return HATCH_LIMIT;
    }
    cycle(levels, 0, right, true, s);
    double rs = hatch_field_dot(s, right, system->count), goal = tolerance * tolerance * rs;
    memcpy(r, right, size * sizeof *r);
    if (hatch_field_dot(z, z, system->count) > 0) {
        hatch_field_apply(system, z, r);
        subtract_from(right, r, system->count);
        cycle(levels, 0, r, true, s);
        rs = hatch_field_dot(r, s, system->count);
    }
    memcpy(p, s, size * sizeof *p);
    uint32_t done = 0;
    for (; done < iterations_max && rs > goal; done++) {
        hatch_field_apply(system, p, q);
        double step = rs / hatch_field_dot(p, q, system->count);
        for (size_t i = 0; i < size; i++) {
            z[i] += step * p[i];
            r[i] -= step * q[i];
        }
        cycle(levels, 0, r, true, s);
        double next = hatch_field_dot(r, s, system->count), keep = next / rs;
        for (size_t i = 0; i < size; i++)
            p[i] = s[i] + keep * p[i];
        rs = next;
    }
    progress->iterations += done;
    progress->residual = goal > 0 ? tolerance * sqrt(fmax(rs, 0) / goal) : 0;
    hatch_arena_rewind(scratch, mark);
    return HATCH_OK;
}
