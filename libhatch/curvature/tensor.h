/* Private to the curvature: the curvature tensor of a fit, and its variance. */
#ifndef HATCH_CURVATURE_TENSOR_H
#define HATCH_CURVATURE_TENSOR_H

#include "curvature/jet.h"

/* The shape operator as a symmetric matrix in space, so that the tensors of different fits can be averaged. */
struct hatch_curvature_tensor {
    double normal[3]; /* unit; null vector of the matrix */
    double matrix[6]; /* xx, xy, xz, yy, yz, zz, in 1 / surface unit */
};

struct hatch_principal_curvatures {
    double direction[3]; /* unit tangent of value[0]; sign arbitrary */
    double value[2];     /* |value[0]| >= |value[1]| */
};

/* Variances in (1 / surface unit)². */
struct hatch_curvature_variance {
    double off_diagonal; /* of the off-diagonal entry, averaged over all tangent frames: it rotates the axes */
    double mean;         /* of the mean curvature: its sign decides which axis is the first */
};

/* Computes the tensors of a fit at two positions (x[i], y[i]) of its frame. */
void hatch_curvature_tensors_of_jet(const struct hatch_jet_frame *frame, const double coefficients[HATCH_JET_TERMS],
                                    uint32_t degree, const double x[2], const double y[2],
                                    struct hatch_curvature_tensor tensors[2]);

/* Returns aᵀ M b. */
double hatch_curvature_tensor_form(const struct hatch_curvature_tensor *tensor, const double a[3], const double b[3]);

/* Computes the principal curvatures of a tensor in the plane of its normal. */
void hatch_curvature_tensor_principal(const struct hatch_curvature_tensor *tensor,
                                      struct hatch_principal_curvatures *principal);

/* Returns the variance of a fit at its origin, for heights of variance 1 / weight. */
struct hatch_curvature_variance hatch_curvature_variance_of_jet(const struct hatch_jet_frame *frame,
                                                                const struct hatch_jet_variance *variance);

static inline double hatch_curvature_variance_sum(const struct hatch_curvature_variance *variance)
{
    return variance->off_diagonal + variance->mean;
}

/* Computes tensor and variance, as above, of the fit of a given degree (2 .. system->degree) at its origin. */
void hatch_curvature_tensor_of_system(const struct hatch_jet_frame *frame, const struct hatch_jet_system *system,
                                      uint32_t degree, struct hatch_curvature_tensor *tensor,
                                      struct hatch_curvature_variance *variance);

/* Returns the standard error of the first principal direction in radians, 0 .. π/4, including the risk that the axes
 * are swapped. */
double hatch_curvature_direction_error(const struct hatch_principal_curvatures *principal,
                                       const struct hatch_curvature_variance *variance);

/* Returns the confidence, 0 .. 1, as defined at struct hatch_curvature. */
double hatch_curvature_confidence(const struct hatch_principal_curvatures *principal,
                                  const struct hatch_curvature_variance *variance);

#endif
