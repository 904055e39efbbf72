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

/* Σ x^i y^k, Σ x^i y^k z, Σ z² over the points added. */
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

/* f(x, y) at a place: slopes and second derivatives, in units of the frame's radius. */
struct hatch_jet_point {
    double fx, fy, fxx, fxy, fyy;
};

uint32_t hatch_jet_terms(uint32_t degree);

/* Adds points. count: any. */
void hatch_jet_add(struct hatch_jet_sums *sums, uint32_t count, const double *x, const double *y,
                   const double *z);

/* degree: 2 .. 4, the highest wanted. The system's is lower where the points do not determine it. */
void hatch_jet_factorise(const struct hatch_jet_sums *sums, uint32_t degree,
                         struct hatch_jet_system *system);

/* The coefficients of the fit of a degree, 2 .. system->degree. */
void hatch_jet_solve(const struct hatch_jet_system *system, uint32_t degree,
                     double coefficients[HATCH_JET_TERMS]);

/* The squares of the residuals, summed, in the frame's unit. */
double hatch_jet_residual(const struct hatch_jet_system *system, uint32_t degree);

/* The variance of Σ functional · coefficients when each z has variance 1. */
double hatch_jet_variance(const struct hatch_jet_system *system, uint32_t degree,
                          const double functional[HATCH_JET_TERMS]);

void hatch_jet_at(const double coefficients[HATCH_JET_TERMS], uint32_t degree, double x, double y,
                  struct hatch_jet_point *point);

/* The functional that gives a·fxx + b·fxy + c·fyy at the origin. */
void hatch_jet_second(uint32_t degree, double a, double b, double c,
                      double functional[HATCH_JET_TERMS]);

#endif
