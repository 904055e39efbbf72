/* Tangent planes at the points of a surface and parallel transport between them (Knöppel, Crane, Pinkall, Schröder,
 * "Globally optimal direction fields", SIGGRAPH 2013, §5.1 and §6.1). The face angles around a point are scaled to
 * sum to 2π (at a border point only if they sum to more). A tangent direction is then one angle from the axis of the
 * point, and transport along an edge adds a fixed angle. */
#ifndef HATCH_SURFACE_FRAMES_H
#define HATCH_SURFACE_FRAMES_H

#include <stdbool.h>

#include "surface/surface.h"

/* Rings and corners are those of surface/surface.h. */
struct hatch_frames {
    double *normal;        /* 3 per point: unit, on the ring's outside; mean of the faces' normals, weighted by angle */
    double *axis;          /* 3 per point: unit tangent of angle 0 */
    double *angle_rad;     /* per ring entry: scaled angle of the edge in the point's plane, 0 .. 2π */
    double *transport_rad; /* per ring entry i from p to its neighbour q: angle a at q is a + transport_rad[i] at p,
                              or transport_rad[i] - a where ring_turned[i]; -π .. π */
    double *weight; /* per ring entry: cotangent weight of the edge, clamped, greater than 0; the same from both ends */
    double *area;   /* per point: a third of the area of its faces */
    bool *folded;   /* per point: faces overlap in its plane, so that transport follows from the normals and
                       not from angle_rad; set by hatch_frames_set_normals, false before */
    uint32_t *twin; /* per ring entry: the entry of the same edge in the ring at its other end */
    uint32_t *corner_entry; /* per corner 3 * f + c: the entry of the corner's point whose ring_face is f */
};

/* Computes the frames of a surface.
 *   frames  out: arrays in arena */
enum hatch_status hatch_frames_make(const struct hatch_surface *surface, struct hatch_arena *arena,
                                    struct hatch_arena *scratch, struct hatch_frames *frames,
                                    struct hatch_err *err) HATCH_MUST_USE;

/* Computes incomplete frames, for hatch_frames_set_normals to complete: axes are arbitrary tangents, transport_rad is
 * unset. */
enum hatch_status hatch_frames_begin(const struct hatch_surface *surface, struct hatch_arena *arena,
                                     struct hatch_arena *scratch, struct hatch_frames *frames,
                                     struct hatch_err *err) HATCH_MUST_USE;

/* Replaces the normals, so that a direction field does not follow the noise of the faces. Angles become those of the
 * edges projected into the new planes; transport becomes the smallest rotation between the planes. Points whose faces
 * overlap in the new plane keep their scaled angles and are marked as folded.
 *   normal  3 per point, unit, on the side of the present normals; must not be frames->normal */
enum hatch_status hatch_frames_set_normals(const struct hatch_surface *surface, const double *normal,
                                           struct hatch_arena *scratch, struct hatch_frames *frames,
                                           struct hatch_err *err) HATCH_MUST_USE;

/* Returns the angle in radians by which a direction turns when it is transported around a face: the face's integrated
 * Gaussian curvature. Over the faces of a closed component it sums to 2π times the Euler characteristic. */
double hatch_frames_face_holonomy(const struct hatch_surface *surface, const struct hatch_frames *frames,
                                  uint32_t face);

/* Tangent components below this share of the normal component are rounding errors and count as 0. */
#define HATCH_FRAMES_ROUNDING 1e-14

/* Returns the angle of a direction at a point, -π .. π; 0 for a direction along the normal.
 *   direction  any length; its tangent component counts */
double hatch_frames_angle(const struct hatch_frames *frames, uint32_t point, const double direction[3]);

/* Computes the unit tangent of an angle at a point. */
void hatch_frames_direction(const struct hatch_frames *frames, uint32_t point, double angle_rad, double direction[3]);

/* Returns the scaled angle in radians that ring_face[i] has at the point.
 *   i  ring entry of the point, with a face */
double hatch_frames_corner_angle(const struct hatch_surface *surface, const struct hatch_frames *frames, uint32_t point,
                                 uint32_t i);

/* Steps shared by frames.c, frames_normals.c and frames_folds.c. */

/* Sets the axis of a point so that the scaled angles of its edges fit their directions in space in the least-squares
 * sense. A direction in space then hardly changes when it is transported to a neighbouring point. */
void hatch_frames_fit_axis(const struct hatch_surface *surface, uint32_t point, struct hatch_frames *frames);

/* Sets transport_rad from angle_rad. */
void hatch_frames_find_transport(const struct hatch_surface *surface, struct hatch_frames *frames);

/* Returns the equivalent angle in -π .. π, which differs by a multiple of 2π. */
double hatch_frames_wrap_angle(double angle_rad);

/* Sets transport_rad at folded points from the normals. Where that would change the sum of the indices of a direction
 * field, the points are no longer marked as folded and keep the transport that follows from their angles. */
enum hatch_status hatch_frames_transport_folded(const struct hatch_surface *surface, struct hatch_arena *scratch,
                                                struct hatch_frames *frames, struct hatch_err *err) HATCH_MUST_USE;

#endif
