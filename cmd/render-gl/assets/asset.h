/* The file that strokes are read from (--tam), by kind: as values, and on the GPU. A new kind is a table entry with its
 * reader and its upload; techniques name the kind that they draw with. */
#ifndef RENDER_ASSETS_ASSET_H
#define RENDER_ASSETS_ASSET_H

#include <epoxy/gl.h>

#include "render-gl/assets/texture.h"
#include "render-gl/frame/block.h"
#include "shared/cmd.h"
#include "tam/tam.h"

/* A file as values: a tonal art map, or a texture made from one. Zeroed: none. */
struct asset {
    struct hatch_tam map;        /* tones 0: a texture, or none */
    struct tone_texture texture; /* holds TONE_TEXTURE_NONE: a map, or none */
};

/* The tones of an asset on the GPU. Texels of maps hold ink, 1 minus reflectance: the implicit white of Real-Time
 * Hatching §5 is then the absence of every column. */
struct asset_tones {
    GLuint texture, sampler;
    bool layered;                       /* a 2D array; else a 3D texture */
    bool exact;                         /* runs: whole numbers that no sampler filters */
    bool reaches_ink;                   /* its last tone is all ink */
    uint32_t count;                     /* columns, or slices */
    float targets[HATCH_TAM_TONES_MAX]; /* darkness of each, rising */
};

/* Limits of an upload. */
struct asset_limits {
    uint32_t size_max_px; /* of textures */
    float anisotropy;     /* 1 and up */
};

struct asset_kind {
    const char *name; /* for messages: "a tonal art map (tamgen makes one)" */
    bool (*is)(const struct asset *asset);
    enum hatch_status (*upload)(const struct asset *asset, const struct asset_limits *limits,
                                struct hatch_arena *scratch, struct asset_tones *tones, struct hatch_err *err);
};

extern const struct asset_kind asset_six_columns; /* a map as six grey columns in two layers of four */
extern const struct asset_kind asset_columns;     /* a map with every column a layer, grey or coloured */
extern const struct asset_kind asset_volume;      /* reflectance over tone, in slices or in layers */
extern const struct asset_kind asset_thresholds;  /* thresholds, or exact runs */

#define ASSET_SIX_COLUMNS_MAX 6u

/* Reads a file into args->keep. Dies with one line where it holds no asset. */
void asset_read(struct cmd_args *args, const char *path, struct asset *asset);

/* Properties of whichever the asset holds. */
bool asset_is_map(const struct asset *asset);
float asset_darkest(const struct asset *asset);    /* the darkest tone, 0 .. 1 */
uint32_t asset_size_px(const struct asset *asset); /* side of the finest level */
uint32_t asset_levels(const struct asset *asset);  /* levels that hold strokes */

/* An asset and its uploads, each made when it is first asked for. */
struct assets {
    const struct asset *asset; /* kept by reference; NULL: none */
    struct asset_limits limits;
    struct {
        const struct asset_kind *kind;
        struct asset_tones tones;
    } uploaded[4];
};

/* Whether the asset is of a kind. kind: NULL: always. */
bool assets_have(const struct assets *assets, const struct asset_kind *kind);

/* Uploads the asset as a kind that it is of, unless that is done.
 *   tones  out: owned by assets
 * HATCH_LIMIT when the GPU's textures or memory are too small. */
enum hatch_status assets_upload(struct assets *assets, const struct asset_kind *kind, struct hatch_arena *scratch,
                                const struct asset_tones **tones, struct hatch_err *err) HATCH_MUST_USE;

void assets_free(struct assets *assets);

/* Lines that shaders are compiled with to read these tones; size: of text, at least 128. */
void asset_tones_defines(const struct asset_tones *tones, float anisotropy, char *text, size_t size);

/* Binds the tones for shaders, and names them to the frame's block.
 *   side  samples along a pixel's side: finer shading must not choose finer levels, so that strokes keep their width */
void asset_tones_use(const struct asset_tones *tones, float anisotropy, uint32_t side, struct frame_block *block);

/* Makes the sampler: repeating over the surface, held at both ends of tone. For uploads. */
void asset_tones_make_sampler(struct asset_tones *tones, float anisotropy);

/* Leaves *tones zeroed. */
void asset_tones_free(struct asset_tones *tones);

#endif
