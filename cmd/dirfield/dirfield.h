/* Shared by the files of dirfield. */
#ifndef DIRFIELD_DIRFIELD_H
#define DIRFIELD_DIRFIELD_H

#include "shared/field.h"
#include "shared/report.h"
#include "math/percentile.h"
#include "scene/scene.h"
#include "curvature/curvature.h"
#include "field/field.h"

struct dirfield_options {
    double turn_deg;         /* rotation of the first principal direction, counter-clockwise seen from outside */
    const char *constraints; /* path of the table, or NULL */
    const char *needs;       /* path of needs that the meshes shall not exceed, or NULL */
    double coarse_faces;     /* faces of all simplified meshes together; 0: curvature of the meshes themselves */
    struct hatch_curvature_options curvature; /* without pool */
    struct hatch_field_options field;
    char comment[160]; /* for the output file */
};

/* The outputs. Those that are not wanted have no output open. */
enum dirfield_file { DIRFIELD_MESH, DIRFIELD_REPORT, DIRFIELD_ARROWS, DIRFIELD_FILES };

/* Reads the input and fills the files. Dies on failure. */
void dirfield_run(struct cmd_args *args, const struct dirfield_options *options, const char *input,
                  struct cmd_file files[DIRFIELD_FILES]);

enum dirfield_phase { PHASE_SURFACES, PHASE_FRAMES, PHASE_CURVATURE, PHASE_FIELD, PHASE_COUNT };

/* An instance of a mesh in the scene: the point m of the mesh is at matrix m + offset. */
struct dirfield_pose {
    double matrix[3][3], offset[3];
};

/* A direction given by hand. */
struct dirfield_constraint {
    const uint32_t *points; /* the points there: several where the surface is cut; some may be repeated */
    uint32_t point_count;
    uint32_t line;                    /* of the table */
    double direction[3];              /* not 0 */
    const struct dirfield_pose *pose; /* that the direction is given in; NULL: it is in mesh coordinates */
    double weight;                    /* over 0 */
};

/* The work on one mesh of the scene. */
struct dirfield_job {
    const char *name; /* of the input, for messages */
    uint32_t number;  /* of the mesh */
    struct hatch_scene_mesh *mesh;
    const struct hatch_surface *surface;
    double share;        /* of the faces of all meshes */
    uint32_t pose_count; /* 0: the scene does not show the mesh */
    struct dirfield_pose *poses;
    uint32_t constraint_count;
    struct dirfield_constraint *constraints; /* in the order of the table */
    struct hatch_arena work;                 /* holds what follows; freed when the mesh is done */
    struct hatch_frames frames;
    struct hatch_field field;
    struct hatch_singularities singular;
    double ms[PHASE_COUNT]; /* 0 for PHASE_SURFACES, which is measured for all meshes together */
};

/* Finds the poses of all meshes at rest; skinned meshes in their bind pose. */
void dirfield_find_poses(struct cmd_args *args, const struct hatch_scene *scene, struct dirfield_job *jobs);

/* Transforms a point from mesh to scene coordinates. */
void dirfield_to_scene(const struct dirfield_pose *pose, const double mesh[3], double scene[3]);

/* Transforms a vector (a direction, or a point less the pose's offset) from scene to mesh coordinates. Returns false
 * when the matrix is singular. */
bool dirfield_to_mesh(const struct dirfield_pose *pose, const double vector[3], double mesh[3]);

/* Returns whether a pose scales all lengths by the same factor, apart from the rounding of floats. */
bool dirfield_is_similarity(const struct dirfield_pose *pose);

/* Returns how much farther from each other two points are in the scene than in the mesh, at least; 0 when the matrix is
 * singular. */
double dirfield_least_scale(const struct dirfield_pose *pose);

/* Computes the component of a direction in the scene that is tangent to a posed surface, there.
 *   normal   of the surface, in mesh coordinates
 *   tangent  out: in mesh coordinates, unit
 * Returns its length in the scene, as a share of the direction's. */
double dirfield_to_tangent(const struct dirfield_pose *pose, const double direction[3], const double normal[3],
                           double tangent[3]);

/* Returns the number of vertices that a mesh has in its file. */
uint32_t dirfield_vertex_count(const struct hatch_scene_mesh *mesh);

/* Reads a table of constraints and adds each to its job. Dies on failure.
 *   vertices  that all meshes of the file have; 0: vertices have other numbers than there, and rows that name some are
 *             refused */
void dirfield_read_constraints(struct cmd_args *args, const char *path, uint64_t vertices, struct dirfield_job *jobs,
                               uint32_t count);

/* Computes the field and the singularities of a mesh. Dies on failure. */
void dirfield_solve(struct cmd_args *args, const struct dirfield_options *options, struct dirfield_job *job);

#define DIRFIELD_REPORT_COLUMNS 25

/* A report being written. */
struct dirfield_report {
    struct cmd_args *args;
    struct cmd_report table;
    double all[DIRFIELD_REPORT_COLUMNS]; /* the last row so far: sums over the meshes */
    struct hatch_weighted *confidence;   /* of the points so far */
    uint32_t points;                     /* so far */
};

/* Begins a report.
 *   points  of all meshes */
void dirfield_report_begin(struct dirfield_report *report, struct cmd_args *args, uint32_t points);
void dirfield_report_add(struct dirfield_report *report, const struct dirfield_job *job);
struct hatch_bytes dirfield_report_end(struct dirfield_report *report, double surfaces_ms);

/* A PLY with a thin rhombus along the field at each point of each instance of a mesh, in scene coordinates. */
struct dirfield_arrows {
    struct hatch_buffer vertices; /* encoded */
    uint32_t count;               /* of rhombi */
};

void dirfield_arrows_begin(struct dirfield_arrows *arrows, struct cmd_args *args);
void dirfield_arrows_add(struct dirfield_arrows *arrows, const struct dirfield_job *job);
struct hatch_bytes dirfield_arrows_end(struct dirfield_arrows *arrows);

#endif
