/* Private to the curvature: how a surface bends at a point, and how well that is known. */
#ifndef HATCH_TOPO_CURVATURE_BEND_H
#define HATCH_TOPO_CURVATURE_BEND_H

#include "curvature/jet.h"

/* The shape operator as a symmetric matrix in space: xx, xy, xz, yy, yz, zz, in 1 / unit of the surface, with
 * the normal as its null vector. Matrices of neighbours can be averaged. */
struct hatch_bend {
    double normal[3];
    double matrix[6];
};

struct hatch_principal {
    double direction[3]; /* unit, tangent; of the first value */
    double value[2];     /* the first is that of larger absolute value */
};

/* Bending of the fit at two places (x, y) of its frame. */
void hatch_bends_of_jet(const struct hatch_jet_frame *frame, const double coefficients[HATCH_JET_TERMS],
                        uint32_t degree, const double x[2], const double y[2], struct hatch_bend bends[2]);

/* Principal curvatures: of bend's matrix in the plane of its normal. */
void hatch_bend_principal(const struct hatch_bend *bend, struct hatch_principal *principal);

/* Variances of the curvature across a direction, which turns the principal axes (the mean over all
 * directions), and of the mean curvature, which says which of them is first. In (1 / unit of the surface)². */
struct hatch_bend_variance {
    double across, mean;
};

/* Those of a fit at its middle, for points whose heights have variance 1 / their weight. */
struct hatch_bend_variance hatch_bend_variance_of_jet(const struct hatch_jet_frame *frame,
                                                      const struct hatch_jet_variance *variance);

/* The fit of a system by one of its degrees (2 or more), at its middle: its bend, and what that varies by for
 * points whose heights have variance 1 / their weight. */
void hatch_bend_of_system(const struct hatch_jet_frame *frame, const struct hatch_jet_system *system, uint32_t degree,
                          struct hatch_bend *bend, struct hatch_bend_variance *variance);

/* The standard error of the direction, 0 .. π/4: the axes' own, and that of taking the second for the
 * first. */
double hatch_bend_deviation(const struct hatch_principal *principal, const struct hatch_bend_variance *variance);

/* 0 .. 1: see hatch_curvature. */
double hatch_bend_confidence(const struct hatch_principal *principal, const struct hatch_bend_variance *variance);

#endif
