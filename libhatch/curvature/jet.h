/* Private to the curvature: a polynomial over a tangent plane, fitted to points by least squares. */
#ifndef HATCH_TOPO_CURVATURE_JET_H
#define HATCH_TOPO_CURVATURE_JET_H

#include <stdbool.h>
#include <stdint.h>

#define HATCH_JET_DEGREE_MAX 4u
#define HATCH_JET_TERMS 15u   /* x^i y^k with i + k at most 4, by rising degree, then rising k */
#define HATCH_JET_MOMENTS 45u /* the same up to degree 8 */

/* Axes and unit of a fit: a point at offset d from the origin has x = d·axes[0] / radius, y and, along
 * the normal axes[2], z likewise. */
struct hatch_jet_frame {
    double origin[3], axes[3][3];
    double radius;
};

/* Σ w x^i y^k, Σ w x^i y^k z, Σ w z² over the points added. */
struct hatch_jet_sums {
    double moments[HATCH_JET_MOMENTS], products[HATCH_JET_TERMS], squares;
    uint32_t count;
};

/* The factorised normal equations. Those of a lower degree are the first rows of those of a higher one, so
 * that one factorisation holds the fits of all degrees up to `degree`. */
struct hatch_jet_system {
    double lower[HATCH_JET_TERMS][HATCH_JET_TERMS]; /* Cholesky's factor; the diagonal inverted */
    double reduced[HATCH_JET_TERMS];                /* lower⁻¹ · products */
    double squares;
    uint32_t count;
    uint32_t degree; /* 0 when there are too few points even for degree 2, or they lie badly */
};

/* How many coefficients a polynomial of that degree in two variables has. */
uint32_t hatch_jet_terms(uint32_t degree);

/* Adds points. count: any. weight: the inverse of a z's variance, or NULL: all 1. */
void hatch_jet_add(struct hatch_jet_sums *sums, uint32_t count, const double *x, const double *y, const double *z,
                   const double *weight);

/* degree: 2 .. 4, the highest wanted. The system's is lower where the points do not determine it. */
void hatch_jet_factorise(const struct hatch_jet_sums *sums, uint32_t degree, struct hatch_jet_system *system);

/* The coefficients of the fit of a degree, 2 .. system->degree. */
void hatch_jet_solve(const struct hatch_jet_system *system, uint32_t degree, double coefficients[HATCH_JET_TERMS]);

/* The squares of the residuals, summed, in the frame's unit. */
double hatch_jet_residual(const struct hatch_jet_system *system, uint32_t degree);

/* Variances of c_xx - c_yy, c_xy and c_xx + c_yy (half the second derivatives, but for c_xy) of a fit when each z has
 * variance 1 / its weight. */
struct hatch_jet_variance {
    double skew, mixed, mean;
};

/* Those of the fits of degree 2 .. system->degree; others are left alone. */
void hatch_jet_variances(const struct hatch_jet_system *system,
                         struct hatch_jet_variance variance[HATCH_JET_DEGREE_MAX + 1]);

#endif
