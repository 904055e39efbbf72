#include <assert.h>
#include <math.h>
#include <string.h>

#include "field/system.h"

/* Multigrid by unsmoothed aggregation (Vaněk, Mandel, Brezina, "Algebraic multigrid by smoothed aggregation", 1996): a
 * node and its strongly linked neighbours become one coarse node; its z, rotated along the links, is theirs. Coarse
 * systems are of the same kind. */

#define LEVELS_MAX 32u
#define COARSEST 12u /* nodes: systems of at most so many are left to the smoother */
#define STRONG 0.25  /* smallest length of a strong link, as a share of its node's longest */
#define SWEEPS_COARSEST 12
/* Factor of a coarse correction: piecewise constant corrections are too small (Braess, "Towards algebraic multigrid
 * for elliptic problems of second order", Computing 55, 1995). */
#define OVERCORRECTION 1.5

struct level {
    struct hatch_field_system system; /* on the finest level: the caller's arrays */
    uint32_t *middle;                 /* per node: its first link to a later node; those before lead to earlier ones */
    uint32_t *aggregate;              /* per node: its node on the next level; NULL on the last level */
    double *phase;                    /* 2 per node: its z when that of its coarse node is 1 */
    double *z, *rhs;                  /* 2 per node; NULL on the finest level */
    double *residual;                 /* 2 per node */
};

struct hatch_field_levels {
    uint32_t count;
    struct level level[LEVELS_MAX];
};

static double length_squared(const double z[2])
{
    return z[0] * z[0] + z[1] * z[1];
}

/* rotated = link / |link| * phase. */
static void rotate_phase(const double link[2], const double phase[2], double rotated[2])
{
    double length = sqrt(length_squared(link));
    double c = link[0] / length, s = link[1] / length;
    rotated[0] = c * phase[0] - s * phase[1];
    rotated[1] = c * phase[1] + s * phase[0];
}

/* Returns the smallest squared length of a strong link of a node. */
static double strong_squared(const struct hatch_field_system *system, uint32_t node)
{
    double longest = 0;
    for (uint32_t i = system->first[node]; i < system->first[node + 1]; i++)
        longest = fmax(longest, length_squared(&system->link[2 * (size_t)i]));
    return fmax(longest * STRONG * STRONG, 1e-300);
}

/* Makes an aggregate of a node and its strong neighbours unless one of them has an aggregate. */
static bool aggregate_neighbourhood(const struct level *level, uint32_t node, uint32_t number)
{
    const struct hatch_field_system *system = &level->system;
    double strong = strong_squared(system, node);
    for (uint32_t i = system->first[node]; i < system->first[node + 1]; i++)
        if (length_squared(&system->link[2 * (size_t)i]) >= strong && level->aggregate[system->to[i]] != HATCH_NO_SIDE)
            return false;
    level->aggregate[node] = number;
    level->phase[2 * (size_t)node] = 1;
    for (uint32_t i = system->first[node]; i < system->first[node + 1]; i++) {
        const double *link = &system->link[2 * (size_t)i];
        uint32_t to = system->to[i];
        if (!(length_squared(link) >= strong) || level->aggregate[to] != HATCH_NO_SIDE)
            continue;
        level->aggregate[to] = number;
        const double back[2] = {link[0], -link[1]};
        rotate_phase(back, &level->phase[2 * (size_t)node], &level->phase[2 * (size_t)to]);
    }
    return true;
}

/* Adds each remaining node to the aggregate of its most strongly linked neighbour of the first pass, of which there
 * are first_pass, or makes a new aggregate of it. Returns the number of aggregates. */
static uint32_t aggregate_rest(const struct level *level, uint32_t count, uint32_t first_pass)
{
    const struct hatch_field_system *system = &level->system;
    for (uint32_t n = 0; n < system->count; n++) {
        if (level->aggregate[n] != HATCH_NO_SIDE)
            continue;
        double longest = 0;
        uint32_t best = HATCH_NO_SIDE;
        for (uint32_t i = system->first[n]; i < system->first[n + 1]; i++) {
            double length = length_squared(&system->link[2 * (size_t)i]);
            if (level->aggregate[system->to[i]] < first_pass && length > longest) {
                longest = length;
                best = i;
            }
        }
        if (best == HATCH_NO_SIDE) {
            level->phase[2 * (size_t)n] = 1;
            level->aggregate[n] = count++;
            continue;
        }
        rotate_phase(&system->link[2 * (size_t)best], &level->phase[2 * (size_t)system->to[best]],
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
        if (level->aggregate[n] == HATCH_NO_SIDE && aggregate_neighbourhood(level, n, count))
            count++;
    return aggregate_rest(level, count, count);
}

/* The nodes grouped by aggregate. */
struct members {
    uint32_t *first, *node; /* aggregate a: node[first[a]] .. node[first[a + 1] - 1] */
    uint32_t *slot;         /* per aggregate: the link to it of the coarse node being built, plus 1 */
};

static enum hatch_status group(const struct level *level, uint32_t count, struct hatch_arena *arena,
                               struct members *members, struct hatch_err *err)
{
    uint32_t nodes = level->system.count;
    HATCH_TRY(HATCH_ALLOC(arena, &members->first, (size_t)count + 2, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &members->node, nodes, err));
    HATCH_TRY(HATCH_ALLOC(arena, &members->slot, count, err));
    for (uint32_t n = 0; n < nodes; n++)
        members->first[level->aggregate[n] + 2]++;
    for (uint32_t a = 0; a < count; a++)
        members->first[a + 2] += members->first[a + 1];
    for (uint32_t n = 0; n < nodes; n++)
        members->node[members->first[level->aggregate[n] + 1]++] = n;
    return HATCH_OK;
}

/* Sums the links and the diagonal of coarse node a, conj(phase) link phase over the links of its members, from link
 * `at` on. Returns the link after its last.
 *   coarse  NULL: only counts */
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
            const double *link = &fine->link[2 * (size_t)i], *other = &level->phase[2 * (size_t)fine->to[i]];
            z[0] = link[0] * other[0] - link[1] * other[1];
            z[1] = link[0] * other[1] + link[1] * other[0];
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
    HATCH_TRY(HATCH_ALLOC(arena, &coarse->first, (size_t)count + 1, err));
    for (uint32_t a = 0; a < count; a++)
        coarse->first[a + 1] = sum_links(level, members, a, coarse->first[a], NULL);
    uint32_t links = coarse->first[count];
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &coarse->to, links, err));
    HATCH_TRY(HATCH_ALLOC(arena, &coarse->link, (size_t)links * 2, err));
    HATCH_TRY(HATCH_ALLOC(arena, &coarse->diagonal, count, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &next->z, (size_t)count * 2, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &next->rhs, (size_t)count * 2, err));
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &next->residual, (size_t)count * 2, err));
    memset(members->slot, 0, count * sizeof *members->slot);
    for (uint32_t a = 0; a < count; a++)
        sum_links(level, members, a, coarse->first[a], coarse);
    return HATCH_OK;
}

/* Orders each row: links to earlier nodes first. A sweep that starts at zero needs only these, and its residual only
 * the others. */
static enum hatch_status partition_links(struct level *level, struct hatch_arena *arena, struct hatch_err *err)
{
    const struct hatch_field_system *system = &level->system;
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &level->middle, system->count, err));
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
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &level->aggregate, nodes, err));
    HATCH_TRY(HATCH_ALLOC(arena, &level->phase, (size_t)nodes * 2, err));
    uint32_t count = aggregate(level);
    /* Stops when nodes without links prevent coarsening. */
    *added = count <= nodes - nodes / 4;
    if (!*added) {
        level->aggregate = NULL;
        return HATCH_OK;
    }
    HATCH_TRY(group(level, count, arena, &members, err));
    levels->count++;
    HATCH_TRY(make_coarse(level, count, &members, arena, level + 1, err));
    return partition_links(level + 1, arena, err);
}

enum hatch_status hatch_field_coarsen(const struct hatch_field_system *system, struct hatch_arena *arena,
                                      struct hatch_field_levels **levels, struct hatch_err *err)
{
    struct hatch_field_levels *made;
    HATCH_TRY(HATCH_ALLOC(arena, &made, 1, err));
    made->count = 1;
    made->level[0].system = *system;
    HATCH_TRY(HATCH_ALLOC_UNSET(arena, &made->level[0].residual, (size_t)system->count * 2, err));
    HATCH_TRY(partition_links(&made->level[0], arena, err));
    bool added = true;
    while (added && made->count < LEVELS_MAX && made->level[made->count - 1].system.count > COARSEST)
        HATCH_TRY(add_level(made, arena, &added, err));
    *levels = made;
    return HATCH_OK;
}

/* sum += Σ link z over links from .. end - 1. */
static inline void add_links(const struct hatch_field_system *system, uint32_t from, uint32_t end, const double *z,
                             double sum[2])
{
    double x = sum[0], y = sum[1];
    for (uint32_t i = from; i < end; i++) {
        const double *link = &system->link[2 * (size_t)i], *other = &z[2 * (size_t)system->to[i]];
        x += link[0] * other[0] - link[1] * other[1];
        y += link[0] * other[1] + link[1] * other[0];
    }
    sum[0] = x;
    sum[1] = y;
}

/* z[n] = (rhs[n] + Σ link z) / diagonal, over all links; with from_zero over those to earlier nodes. */
static inline void relax(const struct level *level, const double *rhs, uint32_t n, bool from_zero, double *z)
{
    const struct hatch_field_system *system = &level->system;
    double sum[2] = {rhs[2 * (size_t)n], rhs[2 * (size_t)n + 1]}, diagonal = system->diagonal[n];
    add_links(system, system->first[n], from_zero ? level->middle[n] : system->first[n + 1], z, sum);
    z[2 * (size_t)n] = sum[0] / diagonal;
    z[2 * (size_t)n + 1] = sum[1] / diagonal;
}

static void sweep_forward(const struct level *level, const double *rhs, bool from_zero, double *z)
{
    for (uint32_t n = 0; n < level->system.count; n++)
        relax(level, rhs, n, from_zero, z);
}

static void sweep_backward(const struct level *level, const double *rhs, double *z)
{
    for (uint32_t n = level->system.count; n-- > 0;)
        relax(level, rhs, n, false, z);
}

static void subtract_from(const double *rhs, double *residual, uint32_t count)
{
    for (size_t i = 0; i < 2 * (size_t)count; i++)
        residual[i] = rhs[i] - residual[i];
}

static void restrict_residual(const struct level *fine, struct level *coarse)
{
    memset(coarse->rhs, 0, (size_t)coarse->system.count * 2 * sizeof *coarse->rhs);
    for (uint32_t n = 0; n < fine->system.count; n++) {
        const double *phase = &fine->phase[2 * (size_t)n], *r = &fine->residual[2 * (size_t)n];
        double *rhs = &coarse->rhs[2 * (size_t)fine->aggregate[n]];
        rhs[0] += phase[0] * r[0] + phase[1] * r[1];
        rhs[1] += phase[0] * r[1] - phase[1] * r[0];
    }
}

static void add_correction(const struct level *fine, const struct level *coarse, double *z)
{
    for (uint32_t n = 0; n < fine->system.count; n++) {
        const double *phase = &fine->phase[2 * (size_t)n];
        const double *c = &coarse->z[2 * (size_t)fine->aggregate[n]];
        z[2 * (size_t)n] += OVERCORRECTION * (phase[0] * c[0] - phase[1] * c[1]);
        z[2 * (size_t)n + 1] += OVERCORRECTION * (phase[0] * c[1] + phase[1] * c[0]);
    }
}

/* Computes the residual. After a forward sweep from zero only links to later nodes contribute: the equation of a node
 * held when it was set, with later nodes at zero. */
static void find_residual(const struct level *level, const double *rhs, bool from_zero, const double *z)
{
    const struct hatch_field_system *system = &level->system;
    if (!from_zero) {
        hatch_field_apply(system, z, level->residual);
        subtract_from(rhs, level->residual, system->count);
        return;
    }
    for (uint32_t n = 0; n < system->count; n++) {
        double *residual = &level->residual[2 * (size_t)n];
        residual[0] = residual[1] = 0;
        add_links(system, level->middle[n], system->first[n + 1], z, residual);
    }
}

/* A W cycle. Its forward sweep before and backward sweep after make it symmetric, as conjugate gradients require.
 *   from_zero  z counts as 0 on entry and need not be set */
static void cycle(const struct hatch_field_levels *levels, uint32_t depth, const double *rhs, bool from_zero, double *z)
{
    const struct level *fine = &levels->level[depth];
    if (!fine->aggregate) {
        for (int i = 0; i < SWEEPS_COARSEST; i++)
            sweep_forward(fine, rhs, from_zero && i == 0, z);
        for (int i = 0; i < SWEEPS_COARSEST; i++)
            sweep_backward(fine, rhs, z);
        return;
    }
    struct level coarse = levels->level[depth + 1];
    sweep_forward(fine, rhs, from_zero, z);
    find_residual(fine, rhs, from_zero, z);
    restrict_residual(fine, &coarse);
    cycle(levels, depth + 1, coarse.rhs, true, coarse.z);
    if (coarse.aggregate)
        cycle(levels, depth + 1, coarse.rhs, false, coarse.z);
    add_correction(fine, &coarse, z);
    sweep_backward(fine, rhs, z);
}

/* Conjugate gradients, in which each component has steps of its own. */
struct gradients {
    const struct hatch_field_levels *levels;
    const struct hatch_field_system *system;
    double *r, *s, *p, *q; /* 2 per node: residual, the same preconditioned, search direction, A p */
    double *rs, *goal;     /* per component: r · s, and where it ends */
};

static double component_dot(const struct hatch_field_system *system, uint32_t c, const double *a, const double *b)
{
    size_t first = system->component_first[c];
    return hatch_field_dot(&a[2 * first], &b[2 * first], system->component_first[c + 1] - (uint32_t)first);
}

/* Computes residual and r · s at z. */
static void restart(const struct gradients *g, const double *z)
{
    hatch_field_apply(g->system, z, g->r);
    subtract_from(g->system->rhs, g->r, g->system->count);
    cycle(g->levels, 0, g->r, true, g->s);
    for (uint32_t c = 0; c < g->system->component_count; c++)
        g->rs[c] = component_dot(g->system, c, g->r, g->s);
}

/* Finds the goals, and starts from z, or where that is 0 from b / diagonal. */
static void begin(const struct gradients *g, double tolerance, double *z)
{
    const struct hatch_field_system *system = g->system;
    size_t size = 2 * (size_t)system->count;
    for (size_t i = 0; i < size; i++)
        g->p[i] = system->rhs[i] / system->diagonal[i / 2];
    restart(g, g->p);
    for (uint32_t c = 0; c < system->component_count; c++)
        g->goal[c] = tolerance * tolerance * g->rs[c];
    if (hatch_field_dot(z, z, system->count) > 0)
        restart(g, z);
    else
        memcpy(z, g->p, size * sizeof *z);
    memcpy(g->p, g->s, size * sizeof *g->p);
}

static bool is_solved(const struct gradients *g)
{
    for (uint32_t c = 0; c < g->system->component_count; c++)
        if (g->rs[c] > g->goal[c])
            return false;
    return true;
}

static void step(const struct gradients *g, double *z)
{
    const uint32_t *first = g->system->component_first;
    hatch_field_apply(g->system, g->p, g->q);
    for (uint32_t c = 0; c < g->system->component_count; c++) {
        double length = g->rs[c] > g->goal[c] ? g->rs[c] / component_dot(g->system, c, g->p, g->q) : 0;
        for (size_t i = 2 * (size_t)first[c]; length > 0 && i < 2 * (size_t)first[c + 1]; i++) {
            z[i] += length * g->p[i];
            g->r[i] -= length * g->q[i];
        }
    }
    cycle(g->levels, 0, g->r, true, g->s);
    for (uint32_t c = 0; c < g->system->component_count; c++) {
        if (!(g->rs[c] > g->goal[c]))
            continue;
        double next = component_dot(g->system, c, g->r, g->s), keep = next / g->rs[c];
        for (size_t i = 2 * (size_t)first[c]; i < 2 * (size_t)first[c + 1]; i++)
            g->p[i] = g->s[i] + keep * g->p[i];
        g->rs[c] = next;
    }
}

static enum hatch_status allocate_gradients(struct gradients *g, struct hatch_arena *scratch, struct hatch_err *err)
{
    double **vectors[] = {&g->r, &g->s, &g->p, &g->q}, **sums[] = {&g->rs, &g->goal};
    for (int i = 0; i < 4; i++)
        HATCH_TRY(HATCH_ALLOC_UNSET(scratch, vectors[i], 2 * (size_t)g->system->count, err));
    for (int i = 0; i < 2; i++)
        HATCH_TRY(HATCH_ALLOC_UNSET(scratch, sums[i], g->system->component_count, err));
    return HATCH_OK;
}

enum hatch_status hatch_field_solve_multigrid(const struct hatch_field_levels *levels, double tolerance,
                                              uint32_t iterations_max, struct hatch_arena *scratch, double *z,
                                              struct hatch_field_convergence *convergence, struct hatch_err *err)
{
    struct gradients g = {.levels = levels, .system = &levels->level[0].system};
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    enum hatch_status status = allocate_gradients(&g, scratch, err);
    if (status == HATCH_OK) {
        begin(&g, tolerance, z);
        uint32_t done = 0;
        for (; done < iterations_max && !is_solved(&g); done++)
            step(&g, z);
        convergence->iterations += done;
        convergence->residual = 0;
        for (uint32_t c = 0; c < g.system->component_count; c++)
            if (g.goal[c] > 0)
                convergence->residual = fmax(convergence->residual, tolerance * sqrt(fmax(g.rs[c], 0) / g.goal[c]));
    }
    hatch_arena_rewind(scratch, mark);
    return status;
}
