/* Private to meshfit: what its files share. */
#ifndef MESHFIT_MESHFIT_H
#define MESHFIT_MESHFIT_H

#include "shared/views/views.h"
#include "measure/coarse/coarse_figures.h"

/* The scene, and the pictures that it is made coarser for. */
struct meshfit {
    struct cmd_args *args;
    const char *name; /* of the input */
    const struct hatch_scene *scene;
    uint64_t faces;         /* of all meshes of the scene */
    struct hatch_mesh full; /* all meshes, in the world relative to bounds.center; no faces: no node draws any */
    struct hatch_pose pose;
    struct hatch_bounds bounds;
    struct hatch_view_set views;
    float *share;       /* per vertex of full: the share of the tolerance that is allowed there */
    atomic_uint *worst; /* per face of full, as hatch_measure_coarse writes it */
};

/* Coarse meshes of the scene. */
struct meshfit_level {
    struct hatch_mesh *meshes; /* one per mesh of the scene, in args->keep */
    uint64_t faces;            /* of all of them */
    struct hatch_coarse_figures figures;
};

/* Counts the faces of the scene, poses it, makes the views and the full mesh. Dies on failure. */
void meshfit_begin(struct meshfit *fit, const struct cmd_view_options *views);

/* Makes the coarsest meshes whose measured displacement is at most error_px. Dies on failure. */
void meshfit_by_error(struct meshfit *fit, double error_px, struct meshfit_level *level);

/* Makes meshes of at most `faces` faces in all, with an error as small as possible. Dies on failure, and where the
 * surface has no such meshes. */
void meshfit_by_faces(struct meshfit *fit, uint64_t faces, struct meshfit_level *level);

/* Measures all figures; the functions above leave those of outlines and normals 0. */
void meshfit_measure_all(struct meshfit *fit, struct meshfit_level *level);

#define MESHFIT_LEVELS_MAX 8

/* Makes a scene with the meshes of one level, or with several levels of detail: each node with meshes gets a child that
 * draws them, with coarser nodes that stand for it. Dies on failure.
 *   scene  out: its arrays are in args->keep */
void meshfit_join_levels(struct meshfit *fit, const struct meshfit_level *levels, uint32_t count,
                         struct hatch_scene *scene);

#endif
