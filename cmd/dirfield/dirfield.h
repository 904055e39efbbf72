/* What the files of dirfield share. */
#ifndef DIRFIELD_H
#define DIRFIELD_H

#include "shared/field.h"
#include "shared/report.h"
#include "math/percentile.h"
#include "scene/scene.h"
#include "curvature/curvature.h"
#include "field/field.h"

struct dirfield_options {
    double turn_deg;         /* from the first principal direction, counter-clockwise seen from outside */
    const char *constraints; /* a table of them, or NULL */
    double coarse_faces;     /* fit to meshes of so many faces together; 0: to the meshes as they are */
    struct hatch_curvature_options curvature;
    struct hatch_field_options field;
    char comment[160]; /* for the file */
};

/* The outputs; those without one are not asked for. */
enum dirfield_file { DIRFIELD_MESH, DIRFIELD_REPORT, DIRFIELD_ARROWS, DIRFIELD_FILES };

/* Reads the input and fills the files. Dies on failure. */
void dirfield_run(struct cmd_args *args, const struct dirfield_options *options, const char *input,
                  struct cmd_file files[DIRFIELD_FILES]);

enum dirfield_phase { PHASE_SURFACES, PHASE_FRAMES, PHASE_CURVATURE, PHASE_FIELD, PHASE_COUNT };

/* Where a node shows a mesh: a point m of the mesh is at matrix m + offset. */
struct dirfield_pose {
    double matrix[3][3], offset[3];
};

/* A direction given by hand. */
struct dirfield_constraint {
    uint32_t point;
    uint32_t line;               /* of the file */
    double direction[3], weight; /* in the mesh's coordinates */
};

/* One mesh of the scene. The surface and the constraints live in args->keep, the rest in work, whose
 * memory goes when the mesh is done. */
struct dirfield_part {
    const char *name; /* of the input, for messages */
    uint32_t number;
    struct hatch_scene_mesh *mesh;
    const struct hatch_surface *surface;
    double share;        /* of the faces of all meshes */
    uint32_t pose_count; /* 0: no node shows it */
    struct dirfield_pose *poses;
    uint32_t constraint_count;
    struct dirfield_constraint *constraints;
    struct hatch_arena work;
    struct hatch_frames frames;
    struct hatch_field field;
    struct hatch_singularities singular;
    double ms[PHASE_COUNT]; /* of PHASE_SURFACES 0: all are made together */
};

/* Finds the poses of all parts: at rest, skinned meshes as they were bound. */
void dirfield_find_poses(struct cmd_args *args, const struct hatch_scene *scene, struct dirfield_part *parts);

/* A point of the mesh in the scene. */
void dirfield_to_scene(const struct dirfield_pose *pose, const double mesh[3], double scene[3]);

/* A vector of the scene (a point less the pose's offset, or a direction) in the mesh. False when the pose is flat. */
bool dirfield_to_mesh(const struct dirfield_pose *pose, const double vector[3], double mesh[3]);

/* Reads a table of constraints and gives each part its own. Dies on failure. */
void dirfield_read_constraints(struct cmd_args *args, const char *path, struct dirfield_part *parts, uint32_t count);

/* Computes the field of a part, and the singularities. Dies on failure. */
void dirfield_solve(struct cmd_args *args, const struct dirfield_options *options, struct dirfield_part *part);

#define DIRFIELD_REPORT_COLUMNS 25

/* A report and its last row, of all meshes together. */
struct dirfield_report {
    struct cmd_args *args;
    struct cmd_report table;
    double all[DIRFIELD_REPORT_COLUMNS];
    struct hatch_weighted *confidence; /* of the points so far */
    uint32_t points;
};

/* points: of all meshes. */
void dirfield_report_begin(struct dirfield_report *report, struct cmd_args *args, uint32_t points);
void dirfield_report_add(struct dirfield_report *report, const struct dirfield_part *part);
struct hatch_bytes dirfield_report_end(struct dirfield_report *report, double surfaces_ms);

/* A PLY of thin rhombs along the field of every node that shows a mesh, as the scene places it. */
struct dirfield_arrows {
    struct hatch_buffer vertices; /* their bytes */
    uint32_t count;               /* of rhombs */
};

void dirfield_arrows_begin(struct dirfield_arrows *arrows, struct cmd_args *args);
void dirfield_arrows_add(struct dirfield_arrows *arrows, const struct dirfield_part *part);
struct hatch_bytes dirfield_arrows_end(struct dirfield_arrows *arrows);

#endif
