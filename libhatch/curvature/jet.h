/* Private to the curvature: polynomials over a tangent plane, fitted to points by least squares. */
#ifndef HATCH_CURVATURE_JET_H
#define HATCH_CURVATURE_JET_H

#include <stdbool.h>
#include <stdint.h>

#define HATCH_JET_DEGREE_MAX 4u
#define HATCH_JET_TERMS 15u   /* x^i y^k with i + k <= 4, by rising degree i + k, then by rising k */
#define HATCH_JET_MOMENTS 45u /* the same up to degree 8 */

/* A point at offset d from the origin has coordinates x, y, z = d · axes[0..2] / radius; z is the height. */
struct hatch_jet_frame {
    double origin[3], axes[3][3]; /* axes: orthonormal; [2] is the normal */
    double radius;                /* in surface units */
};

/* Sums over the points added, with weights w. */
struct hatch_jet_sums {
    double moments[HATCH_JET_MOMENTS]; /* Σ w x^i y^k */
    double products[HATCH_JET_TERMS];  /* Σ w x^i y^k z */
    double squares;                    /* Σ w z² */
    uint32_t count;
};

/* Factorised normal equations. Terms are ordered by degree, so that the fits of all degrees up to `degree` share the
 * leading rows of one factorisation. */
struct hatch_jet_system {
    double lower[HATCH_JET_TERMS][HATCH_JET_TERMS]; /* Cholesky factor; the diagonal inverted */
    double reduced[HATCH_JET_TERMS];                /* lower⁻¹ · products */
    double squares;
    uint32_t count;
    uint32_t degree; /* highest that the points determine, 2 .. 4; 0: none */
};

/* Returns the number of coefficients of a polynomial of a degree in two variables. */
uint32_t hatch_jet_terms(uint32_t degree);

/* Adds count points.
 *   weight  inverse variance of each z; NULL: 1 each */
void hatch_jet_add(struct hatch_jet_sums *sums, uint32_t count, const double *x, const double *y, const double *z,
                   const double *weight);

/* Factorises the normal equations.
 *   degree  2 .. 4: the highest tried; system->degree is lower where the points do not determine it */
void hatch_jet_factorise(const struct hatch_jet_sums *sums, uint32_t degree, struct hatch_jet_system *system);

/* Computes the coefficients of the fit of a degree, 2 .. system->degree. */
void hatch_jet_solve(const struct hatch_jet_system *system, uint32_t degree, double coefficients[HATCH_JET_TERMS]);

/* Returns the weighted sum of squared residuals of the fit of a degree, in units of the frame. */
double hatch_jet_residual(const struct hatch_jet_system *system, uint32_t degree);

/* Variances of combinations of the second-degree coefficients, when each z has variance 1 / weight. */
struct hatch_jet_variance {
    double skew;  /* of c_xx - c_yy */
    double mixed; /* of c_xy */
    double mean;  /* of c_xx + c_yy */
};

/* Computes the variances of the fits of degrees 2 .. system->degree; entries of other degrees are not written. */
void hatch_jet_variances(const struct hatch_jet_system *system,
                         struct hatch_jet_variance variance[HATCH_JET_DEGREE_MAX + 1]);

#endif
