/* What strokes are read from on the GPU: a tonal art map in the two forms that techniques draw with, or a
 * texture of fine tone (fine.h). Texels of maps hold ink, 1 minus reflectance: the implicit white of Real-Time
 * Hatching §5 is then the absence of every column. */
#ifndef RENDER_COLUMNS_H
#define RENDER_COLUMNS_H

#include <epoxy/gl.h>

#include "tam/tam.h"

#define COLUMNS_SIX_MOST 6u

enum columns_form {
    COLUMNS_NONE,      /* the technique draws tone alone */
    COLUMNS_SIX,       /* six grey columns: the first four in a layer, the last four in another */
    COLUMNS_ARRAY,     /* every column a layer, grey or coloured */
    COLUMNS_VOLUME,    /* reflectance over tone: slices of a 3D texture, or layers */
    COLUMNS_THRESHOLDS /* four layers of tam/thresholds.h, or the runs of tam/exact.h */
};
#define COLUMNS_FORMS 5u

/* What a form is read from, for messages: "a tonal art map". */
const char *columns_name(enum columns_form form);

struct gpu_columns {
    enum columns_form form;
    GLuint texture; /* 2D array, or 3D */
    GLuint sampler;
    uint32_t size_px;
    uint32_t levels;    /* levels that hold strokes */
    uint32_t count;     /* columns, or slices, that are here */
    uint32_t map_count; /* columns of the map */
    bool color;
    bool layered;                       /* no 3D texture */
    bool whole;                         /* its last tone is all ink */
    bool exact;                         /* runs: whole numbers that no sampler filters */
    float targets[HATCH_TAM_TONES_MAX]; /* darkness of each, rising */
};

/* Uploads the map with its authored mip levels. SIX takes six columns, evenly chosen and the darkest
 * among them, from a map that has more. anisotropy: 1 and up. HATCH_LIMIT when the GPU's textures or
 * memory are too small. */
enum hatch_status columns_upload(const struct hatch_tam *map, enum columns_form form, float anisotropy,
                                 uint32_t size_max_px, struct hatch_arena *scratch, struct gpu_columns *columns,
                                 struct hatch_err *err) HATCH_MUST_USE;

/* Finer shading must not choose finer levels: strokes keep their width in pixels. levels: log2 of the
 * samples along a pixel's side. */
void columns_set_bias(const struct gpu_columns *columns, float levels);

/* Makes the sampler: repeating over the surface, held at both ends of tone. */
void columns_make_sampler(struct gpu_columns *columns, float anisotropy);

void columns_free(struct gpu_columns *columns);

#endif
