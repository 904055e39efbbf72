/* Principal curvatures from a polynomial fitted to the points around a point (osculating jets:
 * Cazals & Pouget, "Estimating differential quantities using polynomial fitting of osculating
 * jets", SGP 2003), solved by small normal equations. The support is a geodesic-like ball measured
 * in length, not in rings; in the adaptive method it grows until the fit's residual no longer says
 * noise. Real-Time Hatching §6 gives the measure of confidence: the fit's residual and the ratio
 * of the curvatures. */
#ifndef HATCH_TOPO_CURVATURE_H
#define HATCH_TOPO_CURVATURE_H

#include "base/parallel.h"
#include "surface/frames.h"

#define HATCH_CURVATURE_EVEN_RAD 0.005 /* the standard error of axes of confidence 1/2 */

/* Per point. Curvatures are in 1 / unit of the surface (the mean edge), positive where the surface
 * bends away from the normal (sphere: both positive). The first is that of larger absolute value
 * (so that a valley is hatched like a ridge, and no side matters); the deviation grows where that
 * order is a tie: a sphere, and also a saddle of equal and opposite curvatures. */
struct hatch_curvature {
    double *direction;     /* 3: unit, tangent, 180° symmetric: of the first curvature; any where confidence is 0 */
    double *value;         /* 2: first, second */
    double *confidence;    /* 0 .. 1: its odds c / (1 - c) are (0.005 / e)², an inverse variance, with e the standard
                              error of the principal axes in radians; they fall to half where the curvatures' absolute
                              values differ by .005 of their sum, and to 0 at e = 0.5, where the surface has no
                              direction (plane, sphere) or the fit has failed. That the axes may be swapped (a saddle
                              of equal and opposite curvatures) does not count: neighbours know no better */
    double *deviation_rad; /* the standard error expected of the direction, 0 .. π/4, the danger that the axes are
                              swapped included */
    double *radius;        /* of the support that was used, in mean edges */
    double *normal;        /* 3: unit; of the fit, on the side of the frames': where points are noisy, nearer to
                              the surface's than any mean of faces' */
};

struct hatch_curvature_options {
    double radius;   /* 0: adaptive; else a fixed support in mean edges, 0.5 .. 100, larger where it holds too
                        few points for the degree */
    uint32_t degree; /* 0: chosen with the support (4 for a fixed one); else 2 .. 4 */
};

/* Estimates curvature at every point; the arrays of *curvature live in arena. pool: NULL is one thread; the result is
 * the same. */
enum hatch_status hatch_curvature_estimate(const struct hatch_surface *surface, const struct hatch_frames *frames,
                                           const struct hatch_curvature_options *options, struct hatch_pool *pool,
                                           struct hatch_arena *arena, struct hatch_arena *scratch,
                                           struct hatch_curvature *curvature, struct hatch_err *err) HATCH_MUST_USE;

/* The paper's way (Real-Time Hatching §6): per face of a simplified mesh a quadric through the
 * vertices adjacent to any of the face's, its principal directions, carried to the nearest points
 * of the full surface. coarse: the simplified mesh, in the units of the mesh that the surface came
 * from. */
enum hatch_status hatch_curvature_coarse(const struct hatch_surface *surface, const struct hatch_frames *frames,
                                         const struct hatch_mesh *coarse, struct hatch_arena *arena,
                                         struct hatch_arena *scratch, struct hatch_curvature *curvature,
                                         struct hatch_err *err) HATCH_MUST_USE;

/* Sets confidence to 0 at the ends of edges whose faces turn by more than crease_rad: a hard edge is where
 * two surfaces end, and tells of neither how it bends. A box would be torn between its twelve.
 * crease_rad: under π/2. */
void hatch_curvature_doubt_creases(const struct hatch_surface *surface, double crease_rad,
                                   struct hatch_curvature *curvature);

#endif
