#include <math.h>
#include <string.h>

#include "field/system.h"

#define HISTORY 8u /* steps kept */
#define HALVINGS_MAX 20
#define ARMIJO 1e-4

/* A descent over the angles of z. */
struct descent {
    const struct hatch_field_system *system;
    uint32_t count;                 /* nodes */
    double *z, *trial, *applied;    /* 2 per node; applied: A z */
    double *gradient, *next, *step; /* per node; next: gradient at trial */
    /* Differences of angles and of gradients over the last steps, and their dot products; step s in s % HISTORY. */
    double *moved[HISTORY], *changed[HISTORY], product[HISTORY];
    uint32_t stored; /* steps since the last restart */
};

static double dot(const double *a, const double *b, uint32_t count)
{
    double sum = 0;
    for (uint32_t i = 0; i < count; i++)
        sum += a[i] * b[i];
    return sum;
}

/* Returns E of unit z, less its constant.
 *   gradient  out: derivatives by the angles of z */
static double measure(struct descent *d, const double *z, double *gradient)
{
    const double *rhs = d->system->rhs;
    double sum = 0;
    hatch_field_apply(d->system, z, d->applied);
    for (size_t n = 0; n < d->count; n++) {
        const double *own = &z[2 * n], *a = &d->applied[2 * n], *b = &rhs[2 * n];
        sum += own[0] * (a[0] - 2 * b[0]) + own[1] * (a[1] - 2 * b[1]);
        gradient[n] = 2 * (own[0] * (a[1] - b[1]) - own[1] * (a[0] - b[0]));
    }
    return sum;
}

/* Sets step = -H gradient by the two-loop recursion of L-BFGS. The initial H is the inverse of the system's
 * diagonal. */
static void find_step(struct descent *d)
{
    double factor[HISTORY] = {0};
    memcpy(d->step, d->gradient, d->count * sizeof *d->step);
    uint32_t kept = d->stored < HISTORY ? d->stored : HISTORY;
    for (uint32_t k = 0; k < kept; k++) {
        uint32_t slot = (d->stored - 1 - k) % HISTORY;
        factor[slot] = dot(d->moved[slot], d->step, d->count) / d->product[slot];
        for (uint32_t n = 0; n < d->count; n++)
            d->step[n] -= factor[slot] * d->changed[slot][n];
    }
    for (uint32_t n = 0; n < d->count; n++)
        d->step[n] /= -2 * d->system->diagonal[n];
    for (uint32_t k = kept; k-- > 0;) {
        uint32_t slot = (d->stored - 1 - k) % HISTORY;
        double other = dot(d->changed[slot], d->step, d->count) / d->product[slot];
        for (uint32_t n = 0; n < d->count; n++)
            d->step[n] -= (other + factor[slot]) * d->moved[slot][n];
    }
}

static void rotate_all(const struct descent *d, double length)
{
    for (size_t n = 0; n < d->count; n++) {
        double c = cos(length * d->step[n]), s = sin(length * d->step[n]);
        d->trial[2 * n] = c * d->z[2 * n] - s * d->z[2 * n + 1];
        d->trial[2 * n + 1] = c * d->z[2 * n + 1] + s * d->z[2 * n];
    }
}

/* Moves along the step by backtracking line search. Returns false when it does not lower the energy. */
static bool step_downhill(struct descent *d, double *energy)
{
    double slope = dot(d->step, d->gradient, d->count), length = 1;
    if (!(slope < 0))
        return false;
    for (int i = 0; i < HALVINGS_MAX; i++, length /= 2) {
        rotate_all(d, length);
        double trial_energy = measure(d, d->trial, d->next);
        if (!(trial_energy <= *energy + ARMIJO * length * slope))
            continue;
        uint32_t slot = d->stored % HISTORY;
        for (uint32_t n = 0; n < d->count; n++) {
            d->moved[slot][n] = length * d->step[n];
            d->changed[slot][n] = d->next[n] - d->gradient[n];
        }
        d->product[slot] = dot(d->moved[slot], d->changed[slot], d->count);
        d->stored = d->product[slot] > 0 ? d->stored + 1 : 0;
        double *z = d->z, *gradient = d->gradient;
        d->z = d->trial;
        d->trial = z;
        d->gradient = d->next;
        d->next = gradient;
        *energy = trial_energy;
        return true;
    }
    return false;
}

static enum hatch_status allocate(struct descent *d, struct hatch_arena *scratch, struct hatch_err *err)
{
    double **pairs[] = {&d->z, &d->trial, &d->applied};
    double **singles[] = {&d->gradient, &d->next, &d->step};
    for (size_t i = 0; i < 3; i++) {
        HATCH_TRY(HATCH_ALLOC(scratch, pairs[i], (size_t)d->count * 2, err));
        HATCH_TRY(HATCH_ALLOC(scratch, singles[i], d->count, err));
    }
    for (size_t i = 0; i < HISTORY; i++) {
        HATCH_TRY(HATCH_ALLOC(scratch, &d->moved[i], d->count, err));
        HATCH_TRY(HATCH_ALLOC(scratch, &d->changed[i], d->count, err));
    }
    return HATCH_OK;
}

/* Returns the root mean square angle from z to its local optimum on the component where it is largest. Nodes have the
 * weight of their edges times the share of the edges in the diagonal. */
static double gradient_norm(const struct descent *d)
{
    const struct hatch_field_system *system = d->system;
    double largest = 0;
    for (uint32_t c = 0; c < system->component_count; c++) {
        double sum = 0, scale = 0;
        for (uint32_t n = system->component_first[c]; n < system->component_first[c + 1]; n++) {
            double edges = system->diagonal[n] - system->data_weight[n], weight = edges * edges / system->diagonal[n];
            double angle = d->gradient[n] / (2 * system->diagonal[n]);
            sum += weight * angle * angle;
            scale += weight;
        }
        largest = fmax(largest, scale > 0 ? sqrt(sum / scale) : 0);
    }
    return largest;
}

enum hatch_status hatch_field_descend(const struct hatch_field_system *system, double tolerance,
                                      uint32_t iterations_max, struct hatch_arena *scratch, double *z,
                                      struct hatch_field_convergence *convergence, struct hatch_err *err)
{
    struct descent d = {.system = system, .count = system->count};
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    enum hatch_status status = allocate(&d, scratch, err);
    if (status == HATCH_OK) {
        memcpy(d.z, z, (size_t)d.count * 2 * sizeof *z);
        double energy = measure(&d, d.z, d.gradient);
        uint32_t done = 0;
        for (; done < iterations_max && gradient_norm(&d) > tolerance; done++) {
            find_step(&d);
            if (!step_downhill(&d, &energy)) {
                if (d.stored == 0)
                    break;
                d.stored = 0;
            }
        }
        convergence->iterations += done;
        convergence->residual = gradient_norm(&d);
        for (size_t n = 0; n < d.count; n++) {
            double length = hypot(d.z[2 * n], d.z[2 * n + 1]);
            z[2 * n] = d.z[2 * n] / length;
            z[2 * n + 1] = d.z[2 * n + 1] / length;
        }
    }
    hatch_arena_rewind(scratch, mark);
    return status;
}
