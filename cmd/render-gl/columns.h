/* A tonal art map on the GPU, in the two forms that techniques draw with. Texels hold ink, 1 minus
 * reflectance: the implicit white of the paper's §5 is then the absence of every column. */
#ifndef RENDER_COLUMNS_H
#define RENDER_COLUMNS_H

#include <epoxy/gl.h>

#include "tam/tam.h"

#define COLUMNS_SIX_MOST 6u

enum columns_form {
    COLUMNS_NONE,  /* the technique draws tone alone */
    COLUMNS_SIX,   /* six grey columns: the first four in a layer, the last four in another */
    COLUMNS_ARRAY  /* every column a layer, grey or coloured */
};

struct gpu_columns {
    enum columns_form form;
    GLuint texture;     /* 2D array */
    GLuint sampler;
    uint32_t size_px;
    uint32_t levels;     /* levels that hold strokes */
    uint32_t count;      /* columns that are here */
    uint32_t map_count;  /* columns of the map */
    bool color;
    float targets[HATCH_TAM_TONES_MAX]; /* darkness of each, rising */
};

/* Uploads the map with its authored mip levels. SIX takes six columns, evenly chosen and the darkest
 * among them, from a map that has more. anisotropy: 1 and up. HATCH_LIMIT when the GPU's textures or
 * memory are too small. */
enum hatch_status columns_upload(const struct hatch_tam *map, enum columns_form form,
                                 float anisotropy, uint32_t size_max_px,
                                 struct hatch_arena *scratch, struct gpu_columns *columns,
                                 struct hatch_err *err) HATCH_MUST_USE;

/* Finer shading must not choose finer levels: strokes keep their width in pixels. levels: log2 of the
 * samples along a pixel's side. */
void columns_set_bias(const struct gpu_columns *columns, float levels);

void columns_free(struct gpu_columns *columns);

#endif
