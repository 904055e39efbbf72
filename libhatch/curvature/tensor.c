#include "curvature/tensor.h"

#include "math/vector.h"
#include "curvature/curvature.h"

#define PI 3.14159265358979323846

/* Two positions side by side; the fixed width gives sums the same order on every processor. */
typedef double lanes __attribute__((vector_size(2 * sizeof(double))));

/* First and second derivatives of a polynomial at two positions, in units of the frame's radius. */
struct derivatives {
    lanes fx, fy, fxx, fxy, fyy;
};

/* Adds the terms of one degree d, given their second derivatives: by Euler's theorem on homogeneous functions the
 * first derivatives follow from those, with share = 1 / (d - 1). */
static inline void add_terms(lanes x, lanes y, lanes fxx, lanes fxy, lanes fyy, double share, struct derivatives *at)
{
    at->fxx += fxx;
    at->fxy += fxy;
    at->fyy += fyy;
    at->fx += share * (x * fxx + y * fxy);
    at->fy += share * (x * fxy + y * fyy);
}

static inline void differentiate(const double c[HATCH_JET_TERMS], uint32_t degree, lanes x, lanes y,
                                 struct derivatives *at)
{
    const lanes zero = {0};
    *at = (struct derivatives){.fx = zero + c[1], .fy = zero + c[2]};
    add_terms(x, y, zero + 2 * c[3], zero + c[4], zero + 2 * c[5], 1, at);
    if (degree >= 3)
        add_terms(x, y, 6 * c[6] * x + 2 * c[7] * y, 2 * (c[7] * x + c[8] * y), 2 * c[8] * x + 6 * c[9] * y, 0.5, at);
    lanes xx = x * x, xy = x * y, yy = y * y;
    if (degree >= 4)
        add_terms(x, y, 12 * c[10] * xx + 6 * c[11] * xy + 2 * c[12] * yy,
                  3 * c[11] * xx + 4 * c[12] * xy + 3 * c[13] * yy, 2 * c[12] * xx + 6 * c[13] * xy + 12 * c[14] * yy,
                  1.0 / 3, at);
}

/* The second fundamental form h_ij as a matrix in space: Σ h_ij g_i g_j, with g_i the basis dual to the tangents. The
 * sign makes curvature positive where the height falls away from the normal. */
void hatch_curvature_tensors_of_jet(const struct hatch_jet_frame *frame, const double coefficients[HATCH_JET_TERMS],
                                    uint32_t degree, const double x[2], const double y[2],
                                    struct hatch_curvature_tensor tensors[2])
{
    struct derivatives at;
    differentiate(coefficients, degree, (lanes){x[0], x[1]}, (lanes){y[0], y[1]}, &at);
    lanes square = 1 / (1 + at.fx * at.fx + at.fy * at.fy), slope = {sqrt(square[0]), sqrt(square[1])};
    lanes unit = -slope / frame->radius, xx = unit * at.fxx, xy = unit * at.fxy, yy = unit * at.fyy;
    lanes a = square * (1 + at.fy * at.fy), b = -square * at.fx * at.fy, c = square * (1 + at.fx * at.fx);
    lanes d = square * at.fx, e = square * at.fy, first[3], second[3], p[3], q[3];
    for (int i = 0; i < 3; i++) {
        double u = frame->axes[0][i], v = frame->axes[1][i], n = frame->axes[2][i];
        lanes normal = slope * (n - at.fx * u - at.fy * v);
        tensors[0].normal[i] = normal[0];
        tensors[1].normal[i] = normal[1];
        first[i] = a * u + b * v + d * n;
        second[i] = b * u + c * v + e * n;
        p[i] = xx * first[i] + xy * second[i];
        q[i] = xy * first[i] + yy * second[i];
    }
    for (int row = 0, entry = 0; row < 3; row++)
        for (int column = row; column < 3; column++, entry++) {
            lanes sum = first[row] * p[column] + second[row] * q[column];
            tensors[0].matrix[entry] = sum[0];
            tensors[1].matrix[entry] = sum[1];
        }
}

double hatch_curvature_tensor_form(const struct hatch_curvature_tensor *tensor, const double a[3], const double b[3])
{
    const double *matrix = tensor->matrix;
    return matrix[0] * a[0] * b[0] + matrix[3] * a[1] * b[1] + matrix[5] * a[2] * b[2] +
           matrix[1] * (a[0] * b[1] + a[1] * b[0]) + matrix[2] * (a[0] * b[2] + a[2] * b[0]) +
           matrix[4] * (a[1] * b[2] + a[2] * b[1]);
}

void hatch_curvature_tensor_principal(const struct hatch_curvature_tensor *tensor,
                                      struct hatch_principal_curvatures *principal)
{
    double s[3], t[3];
    hatch_vec_any_orthogonal(tensor->normal, s);
    hatch_vec_cross(tensor->normal, s, t);
    double a = hatch_curvature_tensor_form(tensor, s, s), b = hatch_curvature_tensor_form(tensor, s, t),
           c = hatch_curvature_tensor_form(tensor, t, t);
    double mean = (a + c) / 2, spread = sqrt((a - c) * (a - c) / 4 + b * b), sign = mean < 0 ? -1 : 1;
    principal->value[0] = mean + sign * spread;
    principal->value[1] = mean - sign * spread;
    /* The eigenvector of value[0]: of its two formulas the one with the longer result, to avoid cancellation. */
    double half = sign * (a - c) / 2, off_diagonal = sign * b;
    double u = half >= 0 ? spread + half : off_diagonal, v = half >= 0 ? off_diagonal : spread - half;
    double length = sqrt(u * u + v * v);
    u = length > 0 ? u / length : 1;
    v = length > 0 ? v / length : 0;
    for (int i = 0; i < 3; i++)
        principal->direction[i] = u * s[i] + v * t[i];
    hatch_vec_normalize(principal->direction);
}

struct hatch_curvature_variance hatch_curvature_variance_of_jet(const struct hatch_jet_frame *frame,
                                                                const struct hatch_jet_variance *variance)
{
    double square = frame->radius * frame->radius, unit = 1 / (square * square);
    return (struct hatch_curvature_variance){unit * (variance->skew + variance->mixed) / 2, unit * variance->mean};
}

void hatch_curvature_tensor_of_system(const struct hatch_jet_frame *frame, const struct hatch_jet_system *system,
                                      uint32_t degree, struct hatch_curvature_tensor *tensor,
                                      struct hatch_curvature_variance *variance)
{
    double coefficients[HATCH_JET_TERMS];
    struct hatch_jet_variance variances[HATCH_JET_DEGREE_MAX + 1];
    struct hatch_curvature_tensor tensors[2];
    static const double zero[2] = {0, 0};
    hatch_jet_solve(system, degree, coefficients);
    hatch_curvature_tensors_of_jet(frame, coefficients, degree, zero, zero, tensors);
    *tensor = tensors[0];
    hatch_jet_variances(system, variances);
    *variance = hatch_curvature_variance_of_jet(frame, &variances[degree]);
}

/* Returns the squared standard error of the principal axes, swapped or not. */
static double axes_error(const struct hatch_principal_curvatures *principal,
                         const struct hatch_curvature_variance *variance)
{
    double spread = fabs(principal->value[0] - principal->value[1]);
    return spread > 0 ? variance->off_diagonal / (spread * spread) : INFINITY;
}

double hatch_curvature_direction_error(const struct hatch_principal_curvatures *principal,
                                       const struct hatch_curvature_variance *variance)
{
    double mean = fabs(principal->value[0] + principal->value[1]) / 2;
    double swapped = variance->mean > 0 ? erfc(mean / sqrt(2 * variance->mean)) / 2 : 0; /* probability */
    return fmin(sqrt(axes_error(principal, variance) + swapped * PI * PI / 4), PI / 4);
}

#define STANDARD_ERROR_MAX 0.5 /* radians: confidence is 0 from here on */
#define ANISOTROPY_HALF 0.005  /* halves the odds */

double hatch_curvature_confidence(const struct hatch_principal_curvatures *principal,
                                  const struct hatch_curvature_variance *variance)
{
    double standard_error_rad = sqrt(axes_error(principal, variance));
    double first = fabs(principal->value[0]), second = fabs(principal->value[1]);
    if (!(first + second > 0) || !(standard_error_rad < STANDARD_ERROR_MAX))
        return 0;
    double anisotropy = fabs(principal->value[0] - principal->value[1]) / (first + second) / ANISOTROPY_HALF;
    double error = standard_error_rad / HATCH_CURVATURE_HALF_CONFIDENCE_RAD;
    double share = standard_error_rad / STANDARD_ERROR_MAX;
    anisotropy *= anisotropy;
    double odds = anisotropy / (1 + anisotropy) * (1 - share * share);
    return odds / (odds + error * error);
}
