/* Stretch of the map from a triangle to texture space. */
#ifndef HATCH_MEASURE_STRETCH_H
#define HATCH_MEASURE_STRETCH_H

#include "mesh/mesh.h"

struct hatch_stretch {
    double area;    /* of the triangle */
    double uv_area; /* signed area in texture space; positive when mirrored, since v points down */
    double ratio;   /* larger / smaller singular value; 1 preserves angles; infinite without uv_area */
    double u[3];    /* unit direction on the triangle in which u rises and v is constant; zero without uv_area */
};

/* Computes the stretch of a face. Returns false when the face has no area.
 *   uv  2 floats per vertex of the mesh */
bool hatch_measure_stretch(const struct hatch_mesh *mesh, const float *uv, uint32_t face,
                           struct hatch_stretch *stretch);

#endif
