/* The ground that strokes are traced on: the faces of a surface, each laid out in a plane of its own, with the
 * direction of the strokes. */
#ifndef HATCH_TRACE_GROUND_H
#define HATCH_TRACE_GROUND_H

#include <stdbool.h>

#include "surface/frames.h"

/* A face laid out in a plane: corner 0 at the origin, corner 1 on the x axis, corner 2 above it. */
struct hatch_trace_face {
    float x1, x2, y2;
    uint32_t
        beyond[3]; /* per side: the side of the next face that is the same edge; HATCH_NO_SIDE: strokes end there */
    float turn[3]
              [2]; /* per side: cosine and sine of the angle that headings turn by there; contrary: after mirroring */
    uint8_t contrary; /* bit c: that side runs in the same direction */
};

/* Where a face is in space, and its strokes. */
struct hatch_trace_pose {
    float z[3][2];           /* cosine and sine of twice the stroke's angle from the x axis: at corner 0, and their
                                change along x and along y */
    float u[3], v[3], at[3]; /* axes x and y, and corner 0 */
};

/* The ends of the ground, its borders and hard edges, seen from a point. Distances are along edges. */
struct hatch_trace_end {
    float distance; /* to the nearest; HUGE_VALF: there is none */
    float length;   /* the greatest length of an end and of all that are connected with it, less the distance to it; 0:
                       none is longer than that */
};

/* Arrays have an entry for each face of the surface, but for ends. Its faces have numbers of their own, which are close
 * for faces that are close in space; those of a component are the same range as on the surface. */
struct hatch_trace_ground {
    const struct hatch_surface *surface;
    uint32_t *source; /* the face of the surface */
    struct hatch_trace_face *faces;
    struct hatch_trace_pose *poses;
    struct hatch_trace_end *ends; /* per point of the surface */
    double calm; /* how near to a singularity there is no direction, at least, in surface units; 0 when the faces are
                    laid out */
};

/* A place on the ground, and a heading of length 1 in the plane of its face. */
struct hatch_trace_place {
    uint32_t face;
    double x, y, heading[2];
};

/* Lays out the faces.
 *   direction  3 per point of the surface
 *   angle_rad  from the direction to the strokes
 *   hard_rad   strokes end at edges with an angle that is larger by more than rounding; 0 .. pi
 *   ground     out: faces in arena */
enum hatch_status hatch_trace_lay_out(const struct hatch_surface *surface, const struct hatch_frames *frames,
                                      const double *direction, double angle_rad, double hard_rad,
                                      struct hatch_arena *arena, struct hatch_trace_ground *ground,
                                      struct hatch_err *err) HATCH_MUST_USE;

/* Finds the ends of ground whose faces are joined.
 *   ends  out: per point of the surface, in arena */
enum hatch_status hatch_trace_find_ends(const struct hatch_trace_ground *ground, struct hatch_arena *arena,
                                        struct hatch_trace_end **ends, struct hatch_err *err) HATCH_MUST_USE;

/* Returns the least distance and the greatest length at the corners of a face. */
struct hatch_trace_end hatch_trace_end_near(const struct hatch_trace_ground *ground, uint32_t face);

/* Computes the direction of strokes at a place, with the sign nearest to the heading. Returns false where there is
 * none: nearer to a singularity than `calm`, and than a share of a small face. */
bool hatch_trace_direction(const struct hatch_trace_ground *ground, const struct hatch_trace_place *place,
                           double direction[2]);

/* A straight part of a walk within a face. */
struct hatch_trace_leg {
    uint32_t face;
    double from[2], to[2], length;
    uint32_t side; /* that it ends at, 0 .. 2; 3: none */
};

enum hatch_trace_way { HATCH_TRACE_ALONG, HATCH_TRACE_STRAIGHT }; /* along the field; straight on */

/* Walks on within a face, and to the border of the next face where that is reached.
 *   place   in, out: its heading becomes that of the leg
 *   length  greatest length of the leg, in surface units, over 0
 *   leg     out
 * Returns false where the walk ends: at a border, a hard edge or a singularity. */
bool hatch_trace_walk(const struct hatch_trace_ground *ground, struct hatch_trace_place *place, double length,
                      enum hatch_trace_way way, struct hatch_trace_leg *leg);

/* Returns the sine of the angle between a leg that has reached a side and that side. */
double hatch_trace_steepness(const struct hatch_trace_ground *ground, const struct hatch_trace_leg *leg,
                             const double heading[2]);

/* Turns the heading by a right angle, counter-clockwise where sign is 1, clockwise where it is -1. */
void hatch_trace_turn(struct hatch_trace_place *place, double sign);

/* Compute the position, and a vector in the plane of the face, in surface units. */
void hatch_trace_position(const struct hatch_trace_pose *pose, double x, double y, double position[3]);
void hatch_trace_vector(const struct hatch_trace_pose *pose, const double plane[2], float vector[3]);

/* Computes the normal of a face. */
void hatch_trace_normal(const struct hatch_trace_pose *pose, float normal[3]);

/* Computes the corners of a face in its plane. */
void hatch_trace_corners(const struct hatch_trace_face *face, double corner[3][2]);

/* Computes the barycentric coordinates of a place. */
void hatch_trace_shares(const struct hatch_trace_face *face, double x, double y, double share[3]);

#endif
