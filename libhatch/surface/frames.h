/* Tangent planes and the turning between them (Knöppel, Crane, Pinkall, Schröder, "Globally
 * optimal direction fields", SIGGRAPH 2013, §5.1 and 6.1): at each point the angles of its ring's
 * faces are scaled to sum to a full turn (on a border: to what they sum to, at most that), so that a tangent
 * direction is one angle, and going along an edge turns it by a fixed angle. */
#ifndef HATCH_TOPO_FRAMES_H
#define HATCH_TOPO_FRAMES_H

#include <stdbool.h>

#include "surface/surface.h"

struct hatch_frames {
    double *normal;    /* 3 a point: unit, of its ring's outside: angle-weighted mean of its faces' */
    double *axis;      /* 3 a point: unit, tangent; angle 0 */
    double *angle_rad; /* per ring entry: the scaled angle of that edge in the point's plane, 0 .. 2π */
    double *turn_rad;  /* per ring entry i of p with neighbour q: a direction at angle a in q's plane has in
                          p's plane the angle a + turn_rad[i], or, where ring_turned[i], turn_rad[i] - a */
    double *weight;    /* per ring entry: the edge's weight in the smoothness energy, over 0, the same from both
                          ends */
    double *area;      /* per point: a third of its faces' */
    bool *folded;      /* per point: its faces lie over one another in its plane, so that turns do not follow from its
                          angles (after hatch_frames_lean; before, none is) */
    uint32_t *mate;    /* per ring entry: the same edge's entry in the ring at its other end */
    uint32_t *entry;   /* per corner 3 * f + c: the entry of the corner's point whose ring_face is f */
};

/* Makes the frames of a surface; their arrays live in arena. */
enum hatch_status hatch_frames_make(const struct hatch_surface *surface, struct hatch_arena *arena,
                                    struct hatch_arena *scratch, struct hatch_frames *frames,
                                    struct hatch_err *err) HATCH_MUST_USE;

/* The same, of which hatch_frames_lean makes the rest: axes are any tangents, and turns are not there yet. */
enum hatch_status hatch_frames_begin(const struct hatch_surface *surface, struct hatch_arena *arena,
                                     struct hatch_arena *scratch, struct hatch_frames *frames,
                                     struct hatch_err *err) HATCH_MUST_USE;

/* Takes other normals, of a smoother surface than the faces', where points are noisy: angles are then those of
 * edges laid into the new planes, and turns the least that make one plane another, whatever the faces between them
 * look like. A point whose faces fold over one another in its new plane keeps its scaled angles, which say little.
 * The fields that are solved on such frames do not follow the noise. normal: 3 a point, unit, on the sides of the
 * frames' own; may not be frames->normal. */
enum hatch_status hatch_frames_lean(const struct hatch_surface *surface, const double *normal,
                                    struct hatch_arena *scratch, struct hatch_frames *frames,
                                    struct hatch_err *err) HATCH_MUST_USE;

/* By how much a direction that is carried around a face comes back turned: over all faces of a closed component 2π
 * times the Euler characteristic. */
double hatch_frames_excess(const struct hatch_surface *surface, const struct hatch_frames *frames, uint32_t face);

/* The steps that both share. The axis of a point is laid where its scaled angles agree best with the edges as they lie
 * in space, so that a direction in space keeps its meaning from point to point; turns follow from angles; an angle goes
 * into -π .. π; and around folded points turns are found from the normals, where that keeps the sum of indices. */
void hatch_frames_fit_axis(const struct hatch_surface *surface, uint32_t point, struct hatch_frames *frames);
void hatch_frames_find_turns(const struct hatch_surface *surface, struct hatch_frames *frames);
double hatch_frames_shortest(double angle_rad);
enum hatch_status hatch_frames_turn_folds(const struct hatch_surface *surface, struct hatch_arena *scratch,
                                          struct hatch_frames *frames, struct hatch_err *err) HATCH_MUST_USE;

/* What rounding leaves in the plane of a vector along the normal, as a share of it: counts as nothing. */
#define HATCH_FRAMES_ROUNDING 1e-14

/* The angle of a direction (any vector; its part in the plane counts) at a point, and back. A
 * vector along the normal has angle 0. */
double hatch_frames_angle(const struct hatch_frames *frames, uint32_t point, const double direction[3]);
void hatch_frames_direction(const struct hatch_frames *frames, uint32_t point, double angle_rad, double direction[3]);

/* The scaled angle of ring entry i's face at the point. i: an entry of the point's that has a face. */
double hatch_frames_corner(const struct hatch_surface *surface, const struct hatch_frames *frames, uint32_t point,
                           uint32_t i);

#endif
