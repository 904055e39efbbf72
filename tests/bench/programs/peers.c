/* Computes a direction field by one of three other methods, for comparison with dirfield:
 *     peers quadric RINGS IN OUT
 *     peers tensor RINGS MU IN OUT
 *     peers smoothest STRENGTH IN OUT
 * OUT is IN with the attribute _HATCH_DIR. Standard output gets the seconds spent, without reading, repairing and
 * writing, on one thread. Of libhatch it uses surfaces, their tangent planes and their transport, neither curvature nor
 * field. Surfaces with one side are refused. */
#include <complex.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "shared/field.h"
#include "shared/surface.h"
#include "base/text.h"
#include "io/glb/glb.h"
#include "math/vector.h"
#include "surface/frames.h"

enum { TERMS = 6, RINGS_MAX = 20, SUPPORT_MAX = 4096, STEPS_MAX = 20000, VALENCE_MAX = 512 };

#define TOLERANCE 1e-3 /* of the residual; 1e-6 gives the same figures in hatchstat, in twice the time */

static struct cmd_args args;
static struct hatch_err err;

/* A mesh and the result. Curvature is positive where the surface bends away from the normal. */
struct peer {
    const struct hatch_surface *surface;
    struct hatch_frames frames;
    double *normal;     /* 3 per point */
    double *direction;  /* 3 per point: of curvature[0] */
    double *curvature;  /* 2 per point: |[0]| >= |[1]| */
    double *confidence; /* per point, 0 .. 1: (|k1| - |k2|) / (|k1| + |k2|); smoothest: |u|, at most 1 */
};

static void *allocate(size_t count, size_t size)
{
    void *array = hatch_arena_array(&args.keep, count, size, &err);
    cmd_check(array ? HATCH_OK : HATCH_LIMIT, NULL, &err);
    return array;
}

/* Stores a tensor with mean curvature `mean` and Q = (k1 - k2) e^(2iθ), θ the angle of k1 >= k2 from x to y. */
static void store(struct peer *peer, size_t p, const double x[3], const double y[3], double mean, double complex q)
{
    double half = cabs(q) / 2, sign = mean < 0 ? -1 : 1, turn = carg(q) / 2 + (mean < 0 ? acos(0) : 0);
    for (int k = 0; k < 3; k++)
        peer->direction[3 * p + (size_t)k] = cos(turn) * x[k] + sin(turn) * y[k];
    peer->curvature[2 * p] = mean + sign * half;
    peer->curvature[2 * p + 1] = mean - sign * half;
    double first = fabs(peer->curvature[2 * p]), second = fabs(peer->curvature[2 * p + 1]);
    peer->confidence[p] = first + second > 0 ? (first - second) / (first + second) : 0;
}

/* Area-weighted normals. */
static void find_normals(struct peer *peer)
{
    const struct hatch_surface *s = peer->surface;
    for (size_t f = 0; f < s->face_count; f++) {
        const uint32_t *c = &s->corners[3 * f];
        double normal[3];
        hatch_vec_triangle(&s->points[3 * (size_t)c[0]], &s->points[3 * (size_t)c[1]], &s->points[3 * (size_t)c[2]],
                           normal);
        for (int i = 0; i < 3; i++)
            hatch_vec_add_scaled(&peer->normal[3 * (size_t)c[i]], 1, normal, &peer->normal[3 * (size_t)c[i]]);
    }
    for (size_t p = 0; p < s->point_count; p++)
        hatch_vec_normalize(&peer->normal[3 * p]);
}

/* Lists a point and those at most `rings` edges away; returns their number. */
static uint32_t gather(const struct hatch_surface *s, uint32_t center, uint32_t rings, uint32_t *seen,
                       uint32_t points[SUPPORT_MAX])
{
    uint32_t count = 1, begin = 0;
    points[0] = center;
    seen[center] = center + 1;
    for (uint32_t ring = 0; ring < rings; ring++) {
        uint32_t end = count;
        for (; begin < end; begin++)
            for (uint32_t i = s->ring_first[points[begin]]; i < s->ring_first[points[begin] + 1]; i++) {
                uint32_t q = s->ring_point[i];
                if (seen[q] == center + 1 || count == SUPPORT_MAX)
                    continue;
                seen[q] = center + 1;
                points[count++] = q;
            }
    }
    return count;
}

/* Solves a positive definite system of n <= TERMS unknowns in place by Cholesky; false where it is singular. */
static bool solve_dense(int n, double m[TERMS][TERMS], double right[TERMS])
{
    for (int i = 0; i < n; i++)
        for (int k = 0; k <= i; k++) {
            double sum = m[i][k], size = m[i][i];
            for (int j = 0; j < k; j++)
                sum -= m[i][j] * m[k][j];
            if (i == k && !(sum > 1e-12 * size))
                return false;
            m[i][k] = i == k ? sqrt(sum) : sum / m[k][k];
        }
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < i; j++)
            right[i] -= m[i][j] * right[j];
        right[i] /= m[i][i];
    }
    for (int i = n; i-- > 0;) {
        for (int j = i + 1; j < n; j++)
            right[i] -= m[j][i] * right[j];
        right[i] /= m[i][i];
    }
    return true;
}

/* Fits z = ax² + bxy + cy² + dx + ey + f to the points in the axes' coordinates; c: a .. f. */
static bool fit_quadric(const struct hatch_surface *s, const uint32_t *points, uint32_t count, double axes[3][3],
                        double c[TERMS])
{
    double m[TERMS][TERMS] = {{0}};
    memset(c, 0, TERMS * sizeof *c);
    for (uint32_t i = 0; i < count; i++) {
        double d[3], at[3];
        hatch_vec_sub(&s->points[3 * (size_t)points[i]], &s->points[3 * (size_t)points[0]], d);
        for (int k = 0; k < 3; k++)
            at[k] = hatch_vec_dot(d, axes[k]);
        const double term[TERMS] = {at[0] * at[0], at[0] * at[1], at[1] * at[1], at[0], at[1], 1};
        for (int k = 0; k < TERMS; k++) {
            c[k] += term[k] * at[2];
            for (int j = 0; j <= k; j++)
                m[k][j] += term[k] * term[j];
        }
    }
    return count >= TERMS && solve_dense(TERMS, m, c);
}

/* The shape operator of the fit at its origin, in orthonormal tangents of the fit. */
static void store_quadric(struct peer *peer, size_t p, double axes[3][3], const double c[TERMS])
{
    double *normal = &peer->normal[3 * p], x[3], y[3], local[2][2], b[2][2],
           up = 1 / sqrt(1 + c[3] * c[3] + c[4] * c[4]);
    for (int k = 0; k < 3; k++) {
        normal[k] = up * (axes[2][k] - c[3] * axes[0][k] - c[4] * axes[1][k]);
        x[k] = axes[0][k] + c[3] * axes[2][k];
    }
    hatch_vec_normalize(x);
    hatch_vec_cross(normal, x, y);
    for (int k = 0; k < 2; k++) {
        local[0][k] = hatch_vec_dot(x, axes[k]);
        local[1][k] = hatch_vec_dot(y, axes[k]);
    }
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 2; k++)
            b[i][k] = -up * (2 * c[0] * local[i][0] * local[k][0] + 2 * c[2] * local[i][1] * local[k][1] +
                             c[1] * (local[i][0] * local[k][1] + local[i][1] * local[k][0]));
    store(peer, p, x, y, (b[0][0] + b[1][1]) / 2, b[0][0] - b[1][1] + 2 * I * b[0][1]);
}

/* quadric: least squares over all points at most `rings` edges away, in the plane of the area-weighted normal. Where
 * they do not determine the fit, the confidence is 0. */
static void run_quadric(struct peer *peer, uint32_t rings)
{
    static uint32_t points[SUPPORT_MAX];
    uint32_t *seen = allocate(peer->surface->point_count, sizeof *seen);
    find_normals(peer);
    for (uint32_t p = 0; p < peer->surface->point_count; p++) {
        double axes[3][3], c[TERMS];
        hatch_vec_copy(&peer->normal[3 * (size_t)p], axes[2]);
        hatch_vec_any_orthogonal(axes[2], axes[0]);
        hatch_vec_cross(axes[2], axes[0], axes[1]);
        uint32_t count = gather(peer->surface, p, rings, seen, points);
        if (fit_quadric(peer->surface, points, count, axes, c))
            store_quadric(peer, p, axes, c);
        else
            hatch_vec_copy(axes[0], &peer->direction[3 * (size_t)p]);
    }
}

/* A linear system A z = right with a Hermitian positive definite A of one complex unknown per point. `turns` is false
 * for numbers, which transport does not rotate. */
struct system {
    const struct peer *peer;
    bool turns;
    double mu;            /* of tensor */
    double lambda;        /* of smoothest */
    double *weight;       /* of tensor: per ring entry, of the neighbour in the linear fit at the point */
    bool *fitted;         /* of tensor: per point, whether its neighbours determine the linear fit */
    double complex *turn; /* per ring entry: transport of z */
    void (*apply)(const struct system *, const double complex *z, double complex *out);
    double *diagonal;
};

static double complex inner(size_t count, const double complex *a, const double complex *b)
{
    double complex sum = 0;
    for (size_t i = 0; i < count; i++)
        sum += conj(a[i]) * b[i];
    return sum;
}

/* Conjugate gradients from z = 0, with the diagonal as preconditioner. */
static double complex *solve(const struct system *system, const double complex *right)
{
    size_t n = system->peer->surface->point_count;
    double complex *z = allocate(n, sizeof *z), *r = allocate(n, sizeof *r), *d = allocate(n, sizeof *d);
    double complex *ad = allocate(n, sizeof *ad), *s = allocate(n, sizeof *s);
    double size = creal(inner(n, right, right)), old = 1;
    memcpy(r, right, n * sizeof *r);
    for (int step = 0; step < STEPS_MAX && creal(inner(n, r, r)) > TOLERANCE * TOLERANCE * size; step++) {
        for (size_t i = 0; i < n; i++)
            s[i] = r[i] / system->diagonal[i];
        double now = creal(inner(n, r, s));
        for (size_t i = 0; i < n; i++)
            d[i] = s[i] + (step ? now / old : 0) * d[i];
        system->apply(system, d, ad);
        double length = now / creal(inner(n, d, ad));
        for (size_t i = 0; i < n; i++) {
            z[i] += length * d[i];
            r[i] -= length * ad[i];
        }
        old = now;
    }
    return z;
}

static struct system make_system(struct peer *peer)
{
    const struct hatch_surface *s = peer->surface;
    size_t entries = s->ring_first[s->point_count];
    struct system system = {.peer = peer};
    system.weight = allocate(entries, sizeof *system.weight);
    system.turn = allocate(entries, sizeof *system.turn);
    system.fitted = allocate(s->point_count, sizeof *system.fitted);
    system.diagonal = allocate(s->point_count, sizeof *system.diagonal);
    for (size_t i = 0; i < entries; i++)
        system.turn[i] = cexp(2 * I * peer->frames.transport_rad[i]);
    return system;
}

/* Finds the weights of the neighbours' values in the linear fit to them, evaluated at the point. The second difference
 * at the point is its value less that of the fit; there is none where the neighbours do not determine one. */
static void set_plane_weights(struct system *system, uint32_t p)
{
    const struct hatch_surface *s = system->peer->surface;
    const struct hatch_frames *frames = &system->peer->frames;
    double m[TERMS][TERMS] = {{0}}, right[TERMS] = {1}, at[VALENCE_MAX][3];
    uint32_t first = s->ring_first[p], count = s->ring_first[p + 1] - first;
    if (count > VALENCE_MAX)
        return;
    for (uint32_t i = 0; i < count; i++) {
        const double *q = &s->points[3 * (size_t)s->ring_point[first + i]];
        double offset[3], angle_rad = frames->angle_rad[first + i];
        hatch_vec_sub(q, &s->points[3 * (size_t)p], offset);
        double length = hatch_vec_length(offset);
        at[i][0] = 1;
        at[i][1] = length * cos(angle_rad);
        at[i][2] = length * sin(angle_rad);
        for (int k = 0; k < 3; k++)
            for (int j = 0; j <= k; j++)
                m[k][j] += at[i][k] * at[i][j];
    }
    for (int k = 1; k < 3; k++)
        m[k][k] += 1e-3; /* keeps the weights small where the neighbours lie nearly on a line */
    system->fitted[p] = count >= 3 && solve_dense(3, m, right);
    if (!system->fitted[p])
        return;
    system->diagonal[p] += system->mu;
    for (uint32_t i = 0; i < count; i++) {
        double weight = right[0] + right[1] * at[i][1] + right[2] * at[i][2];
        system->weight[first + i] = weight;
        system->diagonal[s->ring_point[first + i]] += system->mu * weight * weight;
    }
}

/* out = z + mu DᴴD z with the second differences D. */
static void apply_tensor(const struct system *system, const double complex *z, double complex *out)
{
    const struct hatch_surface *s = system->peer->surface;
    memcpy(out, z, s->point_count * sizeof *out);
    for (uint32_t p = 0; p < s->point_count; p++) {
        double complex sum = 0;
        uint32_t first = s->ring_first[p], end = s->ring_first[p + 1];
        for (uint32_t i = first; i < end; i++)
            sum += system->weight[i] * (system->turns ? system->turn[i] : 1) * z[s->ring_point[i]];
        double complex difference = system->fitted[p] ? system->mu * (z[p] - sum) : 0;
        out[p] += difference;
        for (uint32_t i = first; i < end; i++)
            out[s->ring_point[i]] -= system->weight[i] * (system->turns ? conj(system->turn[i]) : 1) * difference;
    }
}

/* tensor: the quadrics' tensors, smoothed: minimises Σ |Q - Q_fit|² + mu Σ |D Q|² and the same for the mean
 * curvature. */
static void run_tensor(struct peer *peer, uint32_t rings, double mu)
{
    size_t n = peer->surface->point_count;
    run_quadric(peer, rings);
    cmd_check(hatch_frames_begin(peer->surface, &args.keep, &args.scratch, &peer->frames, &err), NULL, &err);
    cmd_check(hatch_frames_set_normals(peer->surface, peer->normal, &args.scratch, &peer->frames, &err), NULL, &err);
    double complex *q = allocate(n, sizeof *q), *mean = allocate(n, sizeof *mean);
    struct system system = make_system(peer);
    system.apply = apply_tensor;
    system.mu = mu;
    for (uint32_t p = 0; p < n; p++) {
        const double *k = &peer->curvature[2 * (size_t)p];
        mean[p] = (k[0] + k[1]) / 2;
        q[p] = (k[0] - k[1]) * cexp(2 * I * hatch_frames_angle(&peer->frames, p, &peer->direction[3 * (size_t)p]));
        system.diagonal[p] += 1;
        set_plane_weights(&system, p);
    }
    mean = solve(&system, mean);
    system.turns = true;
    q = solve(&system, q);
    for (size_t p = 0; p < n; p++) {
        double y[3];
        hatch_vec_cross(&peer->frames.normal[3 * p], &peer->frames.axis[3 * p], y);
        store(peer, p, &peer->frames.axis[3 * p], y, creal(mean[p]), q[p]);
    }
}

/* out = (A - lambda M) z with cotangent weights and lumped areas. */
static void apply_smoothest(const struct system *system, const double complex *z, double complex *out)
{
    const struct hatch_surface *s = system->peer->surface;
    for (uint32_t p = 0; p < s->point_count; p++) {
        out[p] = -system->lambda * system->peer->frames.area[p] * z[p];
        for (uint32_t i = s->ring_first[p]; i < s->ring_first[p + 1]; i++)
            out[p] +=
                system->peer->frames.weight[i] * (z[p] - (system->turns ? system->turn[i] : 1) * z[s->ring_point[i]]);
    }
}

static void face_normal(const struct hatch_surface *s, uint32_t face, double normal[3])
{
    const uint32_t *c = &s->corners[3 * (size_t)face];
    hatch_vec_triangle(&s->points[3 * (size_t)c[0]], &s->points[3 * (size_t)c[1]], &s->points[3 * (size_t)c[2]],
                       normal);
    hatch_vec_normalize(normal);
}

/* The integrals of Q and of the mean curvature over the cell of a point, from the dihedral angles of its edges. */
static void integrate_dihedrals(const struct peer *peer, uint32_t p, double complex *q, double complex *mean)
{
    const struct hatch_surface *s = peer->surface;
    uint32_t first = s->ring_first[p], end = s->ring_first[p + 1];
    for (uint32_t i = first; i < end; i++) {
        uint32_t right = s->ring_face[i > first ? i - 1 : end - 1];
        double n[2][3], across[3], edge[3];
        if (s->ring_face[i] == HATCH_NO_SIDE || right == HATCH_NO_SIDE)
            continue;
        face_normal(s, s->ring_face[i], n[0]);
        face_normal(s, right, n[1]);
        hatch_vec_cross(n[0], n[1], across);
        hatch_vec_sub(&s->points[3 * (size_t)s->ring_point[i]], &s->points[3 * (size_t)p], edge);
        double length = hatch_vec_normalize(edge);
        double bend = length * atan2(hatch_vec_dot(across, edge), hatch_vec_dot(n[0], n[1]));
        *q -= bend / 4 * cexp(2 * I * peer->frames.angle_rad[i]);
        *mean += bend / 8;
    }
}

/* smoothest: (A - lambda M) u = q of Knöppel et al. ("Globally optimal direction fields", 2013, §4), with the
 * cotangent connection Laplacian and lumped areas in place of their finite elements, and lambda = -strength / area of
 * the surface. As there, u follows the direction of greater signed curvature. Where the mean curvature, smoothed in the
 * same way, is negative, the result is turned by 90° to the direction of larger absolute value. */
static void run_smoothest(struct peer *peer, double strength)
{
    size_t n = peer->surface->point_count;
    cmd_check(hatch_frames_make(peer->surface, &args.keep, &args.scratch, &peer->frames, &err), NULL, &err);
    double complex *q = allocate(n, sizeof *q), *mean = allocate(n, sizeof *mean);
    struct system system = make_system(peer);
    double area = 0, largest = 0;
    for (size_t p = 0; p < n; p++)
        area += peer->frames.area[p];
    system.apply = apply_smoothest;
    system.lambda = -strength / area;
    for (uint32_t p = 0; p < n; p++) {
        integrate_dihedrals(peer, p, &q[p], &mean[p]);
        system.diagonal[p] = -system.lambda * peer->frames.area[p];
        for (uint32_t i = peer->surface->ring_first[p]; i < peer->surface->ring_first[p + 1]; i++)
            system.diagonal[p] += peer->frames.weight[i];
    }
    mean = solve(&system, mean);
    system.turns = true;
    q = solve(&system, q);
    for (size_t p = 0; p < n; p++)
        largest = fmax(largest, cabs(q[p]));
    for (size_t p = 0; p < n; p++) {
        double y[3];
        hatch_vec_cross(&peer->frames.normal[3 * p], &peer->frames.axis[3 * p], y);
        store(peer, p, &peer->frames.axis[3 * p], y, creal(mean[p]), q[p]);
        peer->confidence[p] = largest > 0 ? cabs(q[p]) / largest : 0;
    }
}

static double number_of(const char *text, double low, double high)
{
    double number;
    if (!hatch_text_number((struct hatch_text){text, strlen(text)}, &number) || !(number >= low && number <= high))
        cmd_usage("'%s' is not a number from %g to %g", text, low, high);
    return number;
}

/* Computes the field of one mesh by the method that the operands name; returns the seconds spent. */
static double run(const struct hatch_surface *surface, char **operands, struct peer *peer)
{
    size_t n = surface->point_count;
    *peer = (struct peer){.surface = surface};
    peer->normal = allocate(3 * n, sizeof *peer->normal);
    peer->direction = allocate(3 * n, sizeof *peer->direction);
    peer->curvature = allocate(2 * n, sizeof *peer->curvature);
    peer->confidence = allocate(n, sizeof *peer->confidence);
    double begun_ms = cmd_elapsed_ms();
    if (strcmp(operands[0], "quadric") == 0)
        run_quadric(peer, (uint32_t)number_of(operands[1], 1, RINGS_MAX));
    else if (strcmp(operands[0], "tensor") == 0)
        run_tensor(peer, (uint32_t)number_of(operands[1], 1, RINGS_MAX), number_of(operands[2], 0, 1e9));
    else
        run_smoothest(peer, number_of(operands[1], 0, 1e9));
    return (cmd_elapsed_ms() - begun_ms) / 1000;
}

int main(int argc, char **argv)
{
    static const struct cmd_option options[] = {{0}};
    static const char *const examples[] = {"peers tensor 5 100 in.glb out.glb", NULL};
    static const struct cmd_program program = {
        .name = "peers",
        .operands = "quadric RINGS IN OUT\ntensor RINGS MU IN OUT\nsmoothest STRENGTH IN OUT",
        .summary = "compute a direction field as other programs do",
        .examples = examples,
        .options = options,
        .operands_min = 4,
        .operands_max = 5,
    };
    cmd_begin(&program, argc, argv, &args);
    const char *method = args.operands[0], *input = args.operands[args.operand_count - 2];
    bool tensor = strcmp(method, "tensor") == 0;
    if ((!tensor && strcmp(method, "quadric") != 0 && strcmp(method, "smoothest") != 0) ||
        args.operand_count != (tensor ? 5 : 4))
        cmd_usage("the methods are quadric RINGS, tensor RINGS MU and smoothest STRENGTH");
    struct cmd_output *output = cmd_open_output(args.operands[args.operand_count - 1], "glb", true);
    struct hatch_buffer glb = {.arena = &args.keep};
    struct hatch_scene scene;
    double seconds = 0;
    cmd_read_scene(&args, input, CMD_SCENE_AS_IS, &scene);
    const struct hatch_surface *surfaces = cmd_make_surfaces(&args, input, &scene);
    for (uint32_t i = 0; i < scene.mesh_count; i++) {
        struct peer peer;
        for (uint32_t c = 0; c < surfaces[i].component_count; c++)
            if (!surfaces[i].components[c].orientable)
                cmd_usage("%s: a surface with one side", input);
        seconds += run(&surfaces[i], args.operands, &peer);
        cmd_attach_field(&args, input, &surfaces[i], peer.direction, peer.confidence, &scene.meshes[i]);
    }
    cmd_check(hatch_glb_write_scene(&scene, NULL, &args.scratch, &glb, &err), input, &err);
    cmd_write(output, glb.data, glb.size);
    printf("%.4f\n", seconds);
    return cmd_end(&args, HATCH_OK);
}
