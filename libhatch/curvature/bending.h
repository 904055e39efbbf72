/* How a surface bends at a point, from the dihedral angles of its edges (Cohen-Steiner & Morvan, "Restricted Delaunay
 * triangulations and normal cycle", SoCG 2003): less accurate than fits, but needs no points beyond the edges. */
#ifndef HATCH_CURVATURE_BENDING_H
#define HATCH_CURVATURE_BENDING_H

#include "surface/frames.h"

/* Dihedral angle that halves the odds of the confidence; flatter edges do not count as bent. */
#define HATCH_BENDING_HALF_RAD 0.02

/* The bending over the edges at a point that are neither creases nor left out. */
struct hatch_bending {
    bool on_crease;
    double mean_rad;    /* dihedral angle, weighted by length, of the bending in the direction below; 0: none */
    double largest_rad; /* dihedral angle */
    double angle_rad;   /* of the direction in which the surface bends most (hatch_frames_angle) */
};

/* Computes the unit normal of a face, or of its back. Returns twice the area. */
double hatch_bending_face_normal(const struct hatch_surface *surface, uint32_t face, bool back, double normal[3]);

/* Computes the bending at a point.
 *   crease_rad  smallest dihedral angle of a crease, over 0 and under π/2
 *   left_out    per ring entry of the surface: whether its edge does not count; or NULL */
struct hatch_bending hatch_bending_at(const struct hatch_surface *surface, const struct hatch_frames *frames,
                                      uint32_t point, double crease_rad, const bool *left_out);

/* Returns the confidence of the direction, 0 .. 0.01, as that of struct hatch_curvature: dihedral angles tell a
 * direction to 0.05 radians at best. */
double hatch_bending_confidence(const struct hatch_bending *bending);

#endif
