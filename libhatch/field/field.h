/* Smooth direction fields on a surface, of 180° symmetry: d and -d are the same direction.
 *
 * A direction at angle θ in the tangent plane of point p is the complex number z_p = e^(2iθ). Both methods minimise
 *     E(z) = Σ_edges w |z_p − T(z_q)|²  +  Σ_points m |z_p − d_p|²
 * with w the edge weights and T the transport of the frames, d the data, and m its weight,
 *     m = area c / (1 − c) / length²,  length = 0.0115 √(area of the component) (smooth / (1 − smooth))².
 * The odds of the confidence c act as an inverse variance: where c is 1/2 the field is smoothed over `length`, less
 * where the data is more certain, so that clean data is kept. `smooth` does not depend on scale or resolution.
 *
 * Linear leaves |z| free: E has one minimum, found by a sparse solve (Knöppel et al., "Globally optimal direction
 * fields", 2013, §4). Hz keeps |z| = 1: E is then, up to a constant, the non-linear energy of Hertzmann & Zorin
 * ("Illustrating smooth surfaces", SIGGRAPH 2000, §5.2; Real-Time Hatching §6), a sum of cosines of
 * 2(θ_p − transported θ_q) and 2(θ_p − data), with 180° in place of 90° symmetry; it descends from the data.
 *
 * The minimum of linear is never above that of hz. The energy of its unit field z / |z| may be: |z| is small where
 * data disagree and costs little there, so that certain data stays and noise is removed. Descent from it would lower
 * E, and lose both.
 *
 * The first principal direction jumps by a right angle where the absolute values of the curvatures cross, though both
 * axes are continuous: z changes its sign. Smoothing across such a jump would bend the axes on both sides. For data of
 * principal directions, therefore, a roughly smoothed field first decides which axis is meant where a few points
 * disagree with those around; then edges across which certain directions still differ by over 45° weigh a tenth. */
#ifndef HATCH_FIELD_FIELD_H
#define HATCH_FIELD_FIELD_H

#include "surface/frames.h"

enum hatch_field_method { HATCH_FIELD_LINEAR, HATCH_FIELD_HZ };
enum hatch_field_solver { HATCH_FIELD_MULTIGRID, HATCH_FIELD_CHOLESKY }; /* of linear; both find the minimum */

/* A surface and the data, per point, that its field should follow. */
struct hatch_field_problem {
    const struct hatch_surface *surface;
    const struct hatch_frames *frames;
    const double *direction;         /* 3: any length; the tangent component counts */
    const double *confidence;        /* 0 .. 1; 0: no data, 1: exact */
    const double *constraint_weight; /* NULL, or m in sums of the point's edge weights where `direction` is given by
                                        hand, whatever `smooth` and `confidence` are; 0: not given by hand */
    bool principal;                  /* directions are principal directions */
};

struct hatch_field_options {
    enum hatch_field_method method;
    enum hatch_field_solver solver;
    double smooth;    /* 0 .. 1; 0: the data as it is; 1: the smoothest field, oriented by the data */
    double tolerance; /* of the residual at which to stop, on each component; 1e-12 .. 1e-1; unused by Cholesky */
    uint32_t iterations_max; /* per solve */
};

struct hatch_field {
    double *direction;      /* 3 per point: unit tangent; sign arbitrary */
    double *confidence;     /* per point, 0 .. 1: how far the data around agrees, as the solution weighs it; 0 on
                               unconstrained components. Linear: |z| over that for data equal to the field, which is
                               its 90th percentile over the area of the component; hz: length of the weighted mean of
                               data and neighbours */
    uint32_t iterations;    /* of all solves */
    double residual;        /* of the last solve, on the component where it is largest: multigrid: relative to that of
                               z = data weighted by its share in each point; hz: root mean square angle in radians
                               between z and its local optimum */
    double energy[2];       /* of the unit field: smoothness and data term; reduced weights at jumps included */
    double solution_energy; /* E of z as solved; hz: of the unit field */
    uint32_t unconstrained; /* components without data: confidence of root mean square below 0.001, and no direction
                               given by hand; their field is the smoothest there is */
};

/* Solves for the field of least energy on all components.
 *   field  out: arrays in arena */
enum hatch_status hatch_field_solve(const struct hatch_field_problem *problem,
                                    const struct hatch_field_options *options, struct hatch_arena *arena,
                                    struct hatch_arena *scratch, struct hatch_field *field,
                                    struct hatch_err *err) HATCH_MUST_USE;

/* Adds data of low confidence to unconstrained components that are mostly round: at points on creases, the direction
 * in which the surface bends over the other edges there, from their dihedral angles (Cohen-Steiner & Morvan,
 * "Restricted Delaunay triangulations and normal cycle", SoCG 2003). A tube of long faces has all its points on
 * creases, where no curvature can be fitted. Mostly flat components, with holes or teeth, stay as they are. Call it
 * before hatch_field_fill_unconstrained.
 *   crease_rad         smallest dihedral angle of a crease, over 0 and under π/2
 *   constraint_weight  as in hatch_field_problem
 *   direction          of the data; changed
 *   confidence         of the data; changed */
void hatch_field_fill_from_dihedrals(const struct hatch_surface *surface, const struct hatch_frames *frames,
                                     double crease_rad, const double *constraint_weight, double *direction,
                                     double *confidence);

/* Gives unconstrained components (planes, spheres, boxes) directions across the longest side of their bounding box:
 * the smoothest field could lie any way, and swirls on a box.
 *   constraint_weight  as in hatch_field_problem
 *   direction          of the data; changed
 *   confidence         of the data; changed
 *   filled             out: per component, whether it was filled */
void hatch_field_fill_unconstrained(const struct hatch_surface *surface, const struct hatch_frames *frames,
                                    const double *constraint_weight, double *direction, double *confidence,
                                    bool *filled);

/* Sets the confidence of filled components to 0 and counts them as unconstrained. */
void hatch_field_clear_filled_confidence(const struct hatch_surface *surface, const bool *filled,
                                         struct hatch_field *field);

/* Sets the confidence of the points of planes to 0: their directions are a convention.
 *   confidence  of the data; where it is 0, the field is not that of the plane */
void hatch_field_clear_plane_confidence(const struct hatch_surface *surface, const double *confidence,
                                        struct hatch_field *field);

/* Computes energy[2], as in hatch_field, of a unit field, without reduced weights at jumps.
 *   direction  3 per point: the field */
void hatch_field_energy(const struct hatch_field_problem *problem, double smooth, const double *direction,
                        double energy[2]);

/* Returns the index of a face in half turns: how often the field turns around it. The index does not depend on the
 * orientation of the face.
 *   angle_rad  per point: hatch_frames_angle of the field */
int hatch_field_face_index(const struct hatch_surface *surface, const struct hatch_frames *frames,
                           const double *angle_rad, uint32_t face);

/* Reads the field of a mesh from its attribute _HATCH_DIR (direction x, y, z, and confidence): per point the mean over
 * the corners of its faces, weighted by confidence, in the tangent plane. Directions that are not finite or not
 * tangent have confidence 0. Returns false when the mesh has no such attribute.
 *   mesh        that the surface was made from
 *   direction   out: 3 per point
 *   confidence  out: per point */
bool hatch_field_of_mesh(const struct hatch_surface *surface, const struct hatch_frames *frames,
                         const struct hatch_mesh *mesh, double *direction, double *confidence);

/* Computes the direction of a face from those of its points.
 *   direction       3 per point: the field
 *   face_direction  out: unit, in the plane of the face
 *   spread_rad      out: largest angle to the direction of a point, 0 .. π/2; the face is incoherent over π/3 */
void hatch_field_face_direction(const struct hatch_surface *surface, const struct hatch_frames *frames,
                                const double *direction, uint32_t face, double face_direction[3], double *spread_rad);

/* Computes the directions at the corners of a face, in the plane of the face.
 *   direction  3 per point: the field
 *   z          out: per corner, cosine and sine of twice the angle from side 0 of the face, towards its third corner */
void hatch_field_corner_directions(const struct hatch_surface *surface, const struct hatch_frames *frames,
                                   const double *direction, uint32_t face, double z[3][2]);

/* Computes the mean of three directions in a plane.
 *   z              cosine and sine of twice each direction's angle from u towards v; 0, 0: no direction
 *   u, v           orthonormal axes of the plane
 *   mean           out: unit; u where the directions cancel
 *   cosine_min     out: cosine of twice the largest angle between the mean and one of the directions */
void hatch_field_mean_direction(const double z[3][2], const double u[3], const double v[3], double mean[3],
                                double *cosine_min);

/* The singularities of a field: faces whose index is not 0. */
struct hatch_singularities {
    uint32_t count;
    uint32_t *faces;               /* rising */
    int8_t *half_turns;            /* per singularity: its index, times 2 */
    int32_t *component_half_turns; /* per component: sum of the indices and of the turning along its borders, times 2;
                                      equals twice the Euler characteristic */
};

/* Finds the singularities of a field.
 *   direction  3 per point: unit
 *   found      out: arrays in arena */
enum hatch_status hatch_field_singularities(const struct hatch_surface *surface, const struct hatch_frames *frames,
                                            const double *direction, struct hatch_arena *arena,
                                            struct hatch_arena *scratch, struct hatch_singularities *found,
                                            struct hatch_err *err) HATCH_MUST_USE;

#endif
