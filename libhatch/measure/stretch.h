/* What a triangle's texture coordinates do to it. */
#ifndef HATCH_MEASURE_STRETCH_H
#define HATCH_MEASURE_STRETCH_H

#include "mesh/mesh.h"

struct hatch_stretch {
    double area;    /* of the triangle */
    double uv_area; /* of its picture: over 0 where the picture is mirrored, since v runs down the texture */
    double ratio;   /* the larger over the smaller singular value: 1 keeps angles; infinite without uv_area */
    double u[3];    /* unit direction on the triangle in which u rises and v stays; zero without uv_area */
};

/* uv: 2 floats a vertex of the mesh. false when the face has no area. */
bool hatch_stretch_of(const struct hatch_mesh *mesh, const float *uv, uint32_t face, struct hatch_stretch *stretch);

#endif
