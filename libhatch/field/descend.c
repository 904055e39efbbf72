#include <math.h>
#include <string.h>

#include "field/system.h"

#define MEMORY 8u /* steps remembered */
#define HALVINGS_MAX 20
#define ARMIJO 1e-4

/* The state of a descent over the angles of the z's: E, its gradient, and the last steps. */
struct descent {
    const struct hatch_field_system *system;
    uint32_t count;                 /* nodes */
    double *z, *trial, *applied;    /* 2 a node */
    double *gradient, *next, *step; /* 1 a node */
    double *moved[MEMORY], *changed[MEMORY], product[MEMORY];
    uint32_t stored;
};

static double dot(const double *a, const double *b, uint32_t count)
{
    double sum = 0;
    for (uint32_t i = 0; i < count; i++)
        sum += a[i] * b[i];
    return sum;
}

/* E of unit z less its constant, and its derivatives by the angles of z. */
static double measure(struct descent *d, const double *z, double *gradient)
{
    const double *right = d->system->right;
    double sum = 0;
    hatch_field_apply(d->system, z, d->applied);
    for (size_t n = 0; n < d->count; n++) {
        const double *own = &z[2 * n], *a = &d->applied[2 * n], *b = &right[2 * n];
        sum += own[0] * (a[0] - 2 * b[0]) + own[1] * (a[1] - 2 * b[1]);
        gradient[n] = 2 * (own[0] * (a[1] - b[1]) - own[1] * (a[0] - b[0]));
    }
    return sum;
}

/* L-BFGS' two loops: step = -(inverse Hessian, as the last steps show it) gradient. The diagonal of the system
 * stands for the Hessian where nothing is known. */
static void find_step(struct descent *d)
{
    double share[MEMORY] = {0};
    memcpy(d->step, d->gradient, d->count * sizeof *d->step);
    uint32_t kept = d->stored < MEMORY ? d->stored : MEMORY;
    for (uint32_t k = 0; k < kept; k++) {
        uint32_t slot = (d->stored - 1 - k) % MEMORY;
        share[slot] = dot(d->moved[slot], d->step, d->count) / d->product[slot];
        for (uint32_t n = 0; n < d->count; n++)
            d->step[n] -= share[slot] * d->changed[slot][n];
    }
    for (uint32_t n = 0; n < d->count; n++)
        d->step[n] /= -2 * d->system->diagonal[n];
    for (uint32_t k = kept; k-- > 0;) {
        uint32_t slot = (d->stored - 1 - k) % MEMORY;
        double back = dot(d->changed[slot], d->step, d->count) / d->product[slot];
        for (uint32_t n = 0; n < d->count; n++)
            d->step[n] -= (back + share[slot]) * d->moved[slot][n];
    }
}

static void turn_all(const struct descent *d, double length)
{
    for (size_t n = 0; n < d->count; n++) {
        double c = cos(length * d->step[n]), s = sin(length * d->step[n]);
        d->trial[2 * n] = c * d->z[2 * n] - s * d->z[2 * n + 1];
        d->trial[2 * n + 1] = c * d->z[2 * n + 1] + s * d->z[2 * n];
    }
}

/* Moves downhill along the step; false when it leads nowhere. */
static bool walk(struct descent *d, double *energy)
{
    double slope = dot(d->step, d->gradient, d->count), length = 1;
    if (!(slope < 0))
        return false;
    for (int i = 0; i < HALVINGS_MAX; i++, length /= 2) {
        turn_all(d, length);
        double reached = measure(d, d->trial, d->next);
        if (!(reached <= *energy + ARMIJO * length * slope))
            continue;
        uint32_t slot = d->stored % MEMORY;
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
        *energy = reached;
        return true;
    }
    return false;
}

static enum hatch_status allocate(struct descent *d, struct hatch_arena *scratch, struct hatch_err *err)
{
    double **pairs[] = {&d->z, &d->trial, &d->applied};
    double **singles[] = {&d->gradient, &d->next, &d->step};
    for (size_t i = 0; i < 3; i++) {
        *pairs[i] = HATCH_NEW(scratch, double, (size_t)d->count * 2, err);
        *singles[i] = *pairs[i] ? HATCH_NEW(scratch, double, d->count, err) : NULL;
        if (!*singles[i])
            return HATCH_LIMIT;
    }
    for (size_t i = 0; i < MEMORY; i++) {
        d->moved[i] = HATCH_NEW(scratch, double, d->count, err);
        d->changed[i] = d->moved[i] ? HATCH_NEW(scratch, double, d->count, err) : NULL;
        if (!d->changed[i])
            return HATCH_LIMIT;
    }
    return HATCH_OK;
}

/* The largest gradient over the weights that pull there: the angle by which some z is off its neighbours' mean. */
static double steepest(const struct descent *d)
{
    double sum = 0, scale = 0;
    for (uint32_t n = 0; n < d->count; n++) {
        sum += d->gradient[n] * d->gradient[n] / d->system->diagonal[n];
        scale += 4 * d->system->diagonal[n];
    }
    return sqrt(sum / scale);
}

enum hatch_status hatch_field_descend(const struct hatch_field_system *system, double tolerance,
                                      uint32_t iterations_max, struct hatch_arena *scratch, double *z,
                                      struct hatch_field_progress *progress, struct hatch_err *err)
{
    struct descent d = {.system = system, .count = system->count};
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    enum hatch_status status = allocate(&d, scratch, err);
    if (status == HATCH_OK) {
        memcpy(d.z, z, (size_t)d.count * 2 * sizeof *z);
        double energy = measure(&d, d.z, d.gradient);
        uint32_t done = 0;
        for (; done < iterations_max && steepest(&d) > tolerance; done++) {
            find_step(&d);
            if (!walk(&d, &energy)) {
                if (d.stored == 0)
                    break;
                d.stored = 0;
            }
        }
        progress->iterations += done;
        progress->residual = steepest(&d);
        for (size_t n = 0; n < d.count; n++) {
            double length = hypot(d.z[2 * n], d.z[2 * n + 1]);
            z[2 * n] = d.z[2 * n] / length;
            z[2 * n + 1] = d.z[2 * n + 1] / length;
        }
    }
    hatch_arena_rewind(scratch, mark);
    return status;
}
