/* Principal curvatures from polynomials fitted to the points around each point (osculating jets: Cazals & Pouget,
 * "Estimating differential quantities using polynomial fitting of osculating jets", SGP 2003), by normal equations.
 * The support of a fit is grown over edges to a radius measured in length. The adaptive method adds, where noise leaves
 * the direction uncertain, fits over the largest supports whose residual is no more than the noise, smoothed by least
 * squares of second order (curvature/smooth/net.h). Confidence combines the residual and the ratio of the curvatures
 * (Praun et al., "Real-Time Hatching", SIGGRAPH 2001, §6). */
#ifndef HATCH_CURVATURE_CURVATURE_H
#define HATCH_CURVATURE_CURVATURE_H

#include "base/parallel.h"
#include "surface/frames.h"

/* Standard error of the principal axes at confidence 1/2. */
#define HATCH_CURVATURE_HALF_CONFIDENCE_RAD 0.005

/* Per point. Curvatures are in 1 / surface unit (the mean edge length), positive where the surface bends away from the
 * normal: both on a sphere. The first is that of larger absolute value, so that valleys are hatched like ridges and
 * the orientation does not matter.
 *
 * Confidence c acts as an inverse variance: its odds c / (1 - c) are (0.005 / e)², with e the standard error of the
 * principal axes in radians. The odds are halved where the curvatures differ by 0.005 of the sum of their absolute
 * values, and are 0 for e >= 0.5: the surface has no direction (plane, sphere) or the fit failed. Confidence does not
 * say which axis is the first: on a saddle with equal and opposite curvatures both axes are well known. */
struct hatch_curvature {
    double *direction;          /* 3: unit tangent of the first curvature; sign arbitrary; any where confidence is 0 */
    double *value;              /* 2: first and second curvature */
    double *confidence;         /* 0 .. 1 */
    double *standard_error_rad; /* of the direction, including the risk of swapped axes: 0 .. π/4 */
    double *radius;             /* mean of the supports used, in mean edges */
    double *normal;             /* 3: unit, of the fit, on the side of the frames' normal; less noisy than those */
};

struct hatch_curvature_options {
    double radius;   /* fixed support in mean edges, 0.5 .. 100, enlarged where it holds too few points for the
                        degree; 0: adaptive */
    uint32_t degree; /* of the polynomials, 2 .. 4; 0: 4 for fixed and smallest supports, 3 or 4 for larger ones */
    struct hatch_pool *pool; /* NULL: one thread; the result is the same */
};

/* Estimates the curvature at every point. Deterministic for any number of threads.
 *   curvature  out: arrays in arena */
enum hatch_status hatch_curvature_estimate(const struct hatch_surface *surface, const struct hatch_frames *frames,
                                           const struct hatch_curvature_options *options, struct hatch_arena *arena,
                                           struct hatch_arena *scratch, struct hatch_curvature *curvature,
                                           struct hatch_err *err) HATCH_MUST_USE;

/* Estimates curvature by the method of Real-Time Hatching §6: fits a quadric to the neighbourhood of each face of a
 * simplified mesh; each point of the surface takes the curvature of the nearest such face.
 *   coarse     the simplified mesh, in the units of the mesh that the surface was made from
 *   curvature  out: arrays in arena
 * HATCH_BAD_INPUT when coarse has no face with an area. */
enum hatch_status hatch_curvature_coarse(const struct hatch_surface *surface, const struct hatch_frames *frames,
                                         const struct hatch_mesh *coarse, struct hatch_arena *arena,
                                         struct hatch_arena *scratch, struct hatch_curvature *curvature,
                                         struct hatch_err *err) HATCH_MUST_USE;

/* Gives the points of planes the direction of their plane with confidence 1, as if the plane were bent a little across
 * it: a convention, since a plane has no principal direction.
 *   curvature  changed: normal, direction, value (1 and 0), confidence, standard_error_rad */
void hatch_curvature_set_planes(const struct hatch_surface *surface, struct hatch_curvature *curvature);

/* Lets the first direction go on where the absolute values of the curvatures cross: it would turn by a right angle
 * there although both axes are continuous. Regions whose directions continue each other keep one axis as long as the
 * jumps around them cost more than the excess of the larger curvature over their area gains. With k1 and k2 the
 * curvatures, a jump costs 0.15 √(area of the component) for each unit of its length, and the other axis costs
 * (|k1| - |k2|) / (|k1| + |k2|) for each unit of area, both where the axes are known. Where nothing decides (a minimal
 * surface, noise), a component has one axis.
 *   frames     with the normals of curvature
 *   curvature  changed: direction and value, the first of which is then smaller in absolute value at some points */
enum hatch_status hatch_curvature_continue_axes(const struct hatch_surface *surface, const struct hatch_frames *frames,
                                                struct hatch_arena *scratch, struct hatch_curvature *curvature,
                                                struct hatch_err *err) HATCH_MUST_USE;

/* Sets the confidence to 0 at both ends of edges with a dihedral angle over crease_rad: two smooth surfaces meet there,
 * and a fit across the edge describes neither.
 *   crease_rad  under π/2 */
void hatch_curvature_clear_crease_confidence(const struct hatch_surface *surface, double crease_rad,
                                             struct hatch_curvature *curvature);

/* Replaces results at the ends of long faces by the direction in which these bend, from dihedral angles, with low
 * confidence: around on the side of a cylinder with chamfers. A rim is a line of at least 8 points at which the surface
 * turns by over 5 degrees, and from which the plane part on one side reaches 2.75 times as far as that on the other.
 * Points whose faces all have a corner on a rim are replaced. Where the long faces are flat, the faces between two rims
 * count instead; where they lead to further ones, as in a fillet beside a plane, the confidence becomes 0.
 *   frames      of hatch_frames_begin
 *   crease_rad  under π/2; edges with larger dihedral angles do not count as bent
 *   curvature   changed: normal (that of frames), direction, value (1 and 0), confidence */
enum hatch_status hatch_curvature_follow_rims(const struct hatch_surface *surface, const struct hatch_frames *frames,
                                              double crease_rad, struct hatch_arena *scratch,
                                              struct hatch_curvature *curvature, struct hatch_err *err) HATCH_MUST_USE;

#endif
