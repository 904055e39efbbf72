#include <assert.h>
#include <math.h>
#include <string.h>

#include "base/random.h"
#include "math/vector.h"
#include "field/system.h"

/* The smoothest field of components without data: least eigenvector of A against areas, by inverse iteration
 * (Knöppel et al. 2013 §4, algorithm 1). */
#define POWER_STEPS_MAX 30
#define POWER_CHANGE 1e-3
#define POWER_TOLERANCE 1e-3
#define POWER_SHIFT 0.1 /* over the component's area: keeps A regular where a field without turning exists */

struct work {
    const struct hatch_surface *surface;
    const struct hatch_frames *frames;
    const struct hatch_field_data *data;
    const struct hatch_field_options *options;
    struct hatch_arena *scratch;
    struct hatch_field_scale *scales; /* per component */
    bool *include;
    struct hatch_field_progress progress;
};

static double length_of(const double z[2])
{
    return sqrt(z[0] * z[0] + z[1] * z[1]);
}

static void make_unit(double *z, uint32_t count)
{
    for (size_t n = 0; n < count; n++) {
        double length = length_of(&z[2 * n]);
        if (length > 0) {
            z[2 * n] /= length;
            z[2 * n + 1] /= length;
        } else {
            z[2 * n] = 1;
        }
    }
}

static enum hatch_status solve_linear(struct work *w, const struct hatch_field_system *system, double *z,
                                      struct hatch_err *err)
{
    struct hatch_field_levels *levels;
    if (w->options->solver == HATCH_FIELD_CHOLESKY)
        return hatch_field_factor_solve(system, w->scratch->limit_bytes, w->scratch, z, err);
    HATCH_TRY(hatch_field_coarsen(system, w->scratch, &levels, err));
    return hatch_field_iterate(system, levels, system->right, w->options->tolerance, w->options->iterations_max,
                               w->scratch, z, &w->progress, err);
}

/* Where data has no weight its direction is a start, too. */
static void start_from_data(const struct work *w, const struct hatch_field_system *system, double *z)
{
    for (uint32_t p = 0; p < w->surface->point_count; p++) {
        uint32_t n = system->node[p];
        if (n == HATCH_NO_SIDE)
            continue;
        double *own = &z[2 * (size_t)n];
        const double *right = &system->right[2 * (size_t)n];
        hatch_field_square(w->frames, p, &w->data->direction[(size_t)p * 3], own);
        if (own[0] * right[0] + own[1] * right[1] < 0)
            memcpy(own, right, 2 * sizeof *own);
        if (!w->surface->components[w->surface->point_component[p]].orientable) {
            own[2] = own[0];
            own[3] = -own[1];
        }
    }
    make_unit(z, system->count);
}

/* Nodes of a component: they follow one another. */
static uint32_t component_nodes(const struct work *w, const struct hatch_field_system *system, uint32_t component,
                                uint32_t *first)
{
    const struct hatch_component *of = &w->surface->components[component];
    *first = system->node[of->first_point];
    return *first == HATCH_NO_SIDE ? 0 : of->point_count * (of->orientable ? 1 : 2);
}

/* right = mass z / |z|, |z| by the areas, per component; returns the sum of |z|: near the end that of 1 / eigenvalue.
 * z keeps its length: it is what the next step's solution will be like. */
static double next_right(const struct work *w, const struct hatch_field_system *system, const double *z)
{
    double sum = 0;
    for (uint32_t c = 0; c < w->surface->component_count; c++) {
        uint32_t first, count = component_nodes(w, system, c, &first);
        double square = 0;
        for (size_t n = first; n < (size_t)first + count; n++)
            square += system->mass[n] * (z[2 * n] * z[2 * n] + z[2 * n + 1] * z[2 * n + 1]);
        double length = sqrt(square);
        sum += count > 0 ? length : 0;
        for (size_t n = first; n < (size_t)first + count; n++)
            for (size_t i = 2 * n; i < 2 * n + 2; i++)
                system->right[i] = system->mass[n] * z[i] / length;
    }
    return sum;
}

/* Gives each node its share of its component's area as mass, so that the shift is POWER_SHIFT over the area; and
 * a start that is not orthogonal to anything. */
static void start_power(const struct work *w, const struct hatch_field_system *system, double *z)
{
    for (uint32_t c = 0; c < w->surface->component_count; c++) {
        const struct hatch_component *of = &w->surface->components[c];
        double area = 0;
        for (uint32_t p = of->first_point; p < of->first_point + of->point_count; p++)
            area += w->frames->area[p];
        for (uint32_t p = of->first_point; p < of->first_point + of->point_count; p++) {
            uint32_t n = system->node[p];
            for (uint32_t side = 0; n != HATCH_NO_SIDE && side < (of->orientable ? 1 : 2); side++, n++) {
                system->mass[n] = w->frames->area[p] / area * POWER_SHIFT;
                system->diagonal[n] += system->mass[n];
                z[2 * (size_t)n] = (double)hatch_random_unit(0, 1, p - of->first_point) - 0.5;
                z[2 * (size_t)n + 1] = (double)hatch_random_unit(0, 2, p - of->first_point) - 0.5;
                z[2 * (size_t)n + 1] *= side ? -1 : 1;
            }
        }
    }
}

static enum hatch_status solve_smoothest(struct work *w, struct hatch_field_system *system, double *z,
                                         struct hatch_err *err)
{
    struct hatch_field_levels *levels;
    start_power(w, system, z);
    next_right(w, system, z);
    HATCH_TRY(hatch_field_coarsen(system, w->scratch, &levels, err));
    double before = 0;
    for (int i = 0; i < POWER_STEPS_MAX; i++) {
        HATCH_TRY(hatch_field_iterate(system, levels, system->right, POWER_TOLERANCE, w->options->iterations_max,
                                      w->scratch, z, &w->progress, err));
        double now = next_right(w, system, z);
        if (fabs(now - before) <= POWER_CHANGE * now)
            break;
        before = now;
    }
    /* Only the start and the iteration were in need of masses: the field has no data. */
    for (uint32_t n = 0; n < system->count; n++) {
        system->diagonal[n] -= system->mass[n];
        system->mass[n] = 0;
    }
    memset(system->right, 0, (size_t)system->count * 2 * sizeof *system->right);
    return HATCH_OK;
}

/* |z|, or at unit z's how far data and neighbours pull one way. */
static double agreement(const struct work *w, const struct hatch_field_system *system, const double *z,
                        const double *applied, uint32_t n)
{
    if (w->options->method == HATCH_FIELD_LINEAR)
        return fmin(length_of(&z[2 * (size_t)n]), 1);
    double pull[2];
    for (size_t i = 0; i < 2; i++)
        pull[i] =
            system->diagonal[n] * z[2 * (size_t)n + i] - applied[2 * (size_t)n + i] + system->right[2 * (size_t)n + i];
    return fmin(length_of(pull) / system->diagonal[n], 1);
}

static void give_out(const struct work *w, const struct hatch_field_system *system, const double *z,
                     const double *applied, bool directed, struct hatch_field *field)
{
    for (uint32_t p = 0; p < w->surface->point_count; p++) {
        uint32_t n = system->node[p];
        if (n == HATCH_NO_SIDE)
            continue;
        field->confidence[p] = directed ? agreement(w, system, z, applied, n) : 0;
        hatch_frames_direction(w->frames, p, atan2(z[2 * (size_t)n + 1], z[2 * (size_t)n]) / 2,
                               &field->direction[(size_t)p * 3]);
    }
}

/* Solves for the components that have data, or for those that have none. */
static enum hatch_status solve_part(struct work *w, bool directed, struct hatch_field *field, struct hatch_err *err)
{
    struct hatch_field_system system;
    double energy[2];
    for (uint32_t c = 0; c < w->surface->component_count; c++)
        w->include[c] = w->scales[c].directed == directed;
    HATCH_TRY(hatch_field_assemble(w->surface, w->frames, w->data, w->scales, w->include, w->scratch, &system, err));
    double *z = HATCH_NEW(w->scratch, double, (size_t)system.count * 2, err);
    double *applied = z ? HATCH_NEW(w->scratch, double, (size_t)system.count * 2, err) : NULL;
    if (!applied)
        return HATCH_LIMIT;
    if (directed && w->data->principal)
        HATCH_TRY(hatch_field_loosen_jumps(w->surface, w->data, w->options->iterations_max, w->scratch, &system, z,
                                           &w->progress, err));
    if (!directed)
        HATCH_TRY(solve_smoothest(w, &system, z, err));
    else if (w->options->method == HATCH_FIELD_LINEAR)
        HATCH_TRY(solve_linear(w, &system, z, err));
    if (w->options->method == HATCH_FIELD_HZ) {
        if (directed)
            start_from_data(w, &system, z);
        make_unit(z, system.count);
        HATCH_TRY(hatch_field_descend(&system, w->options->tolerance, w->options->iterations_max, w->scratch, z,
                                      &w->progress, err));
        hatch_field_apply(&system, z, applied);
    }
    give_out(w, &system, z, applied, directed, field);
    hatch_field_system_energy(w->surface, &system, z, energy);
    field->solved += directed ? energy[0] + energy[1] : 0;
    make_unit(z, system.count);
    hatch_field_system_energy(w->surface, &system, z, energy);
    field->solved += directed ? 0 : energy[0];
    for (int i = 0; i < 2; i++)
        field->energy[i] += energy[i];
    return HATCH_OK;
}

static enum hatch_status solve(struct work *w, struct hatch_field *field, struct hatch_err *err)
{
    uint32_t components = w->surface->component_count;
    w->scales = HATCH_NEW(w->scratch, struct hatch_field_scale, components, err);
    w->include = w->scales ? HATCH_NEW(w->scratch, bool, components, err) : NULL;
    if (!w->include)
        return HATCH_LIMIT;
    for (uint32_t c = 0; c < components; c++) {
        w->scales[c] = hatch_field_scale_of(w->surface, w->frames, w->data, w->options->smooth, c);
        field->undirected += !w->scales[c].directed;
    }
    for (int directed = 0; directed < 2; directed++) {
        struct hatch_arena_mark mark = hatch_arena_mark(w->scratch);
        enum hatch_status status = HATCH_OK;
        if (directed ? field->undirected < components : field->undirected > 0)
            status = solve_part(w, directed, field, err);
        hatch_arena_rewind(w->scratch, mark);
        HATCH_TRY(status);
    }
    field->iterations = w->progress.iterations;
    field->residual = w->progress.residual;
    return HATCH_OK;
}

enum hatch_status hatch_field_solve(const struct hatch_surface *surface, const struct hatch_frames *frames,
                                    const struct hatch_field_data *data, const struct hatch_field_options *options,
                                    struct hatch_pool *pool, struct hatch_arena *arena, struct hatch_arena *scratch,
                                    struct hatch_field *field, struct hatch_err *err)
{
    assert(options->smooth >= 0 && options->smooth <= 1);
    assert(options->tolerance >= 1e-12 && options->tolerance <= 1e-1);
    (void)pool;
    struct hatch_field made = {0};
    made.direction = HATCH_NEW(arena, double, (size_t)surface->point_count * 3, err);
    made.confidence = made.direction ? HATCH_NEW(arena, double, surface->point_count, err) : NULL;
    if (!made.confidence)
        return HATCH_LIMIT;
    struct work work = {.surface = surface, .frames = frames, .data = data, .options = options, .scratch = scratch};
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    enum hatch_status status = solve(&work, &made, err);
    hatch_arena_rewind(scratch, mark);
    if (status == HATCH_OK)
        *field = made;
    return status;
}
