/* The asset: the file of --tam, from which strokes are read. A technique names the kind of asset that it needs; struct
 * asset_kind has a function that recognises such an asset and one that uploads it in the form that the technique's
 * shaders read. */
#ifndef RENDER_ASSETS_ASSET_H
#define RENDER_ASSETS_ASSET_H

#include <epoxy/gl.h>

#include "render-gl/assets/texture.h"
#include "render-gl/frame/block.h"
#include "shared/cmd.h"
#include "stroke/stroke.h"
#include "tam/tam.h"

/* The content of the file: a tonal art map, or a texture made from one. Zeroed: neither. */
struct asset {
    struct hatch_tam map;             /* map.tones == 0: no map */
    struct hatch_stroke_list strokes; /* listed in the map; count 0: it has no list */
    struct tone_texture texture;      /* texture.holds == TONE_TEXTURE_NONE: no texture */
};

/* The part of a map that was made for the needs of some views. */
struct asset_part {
    bool cut_tones, cut_levels; /* columns, or levels, were left out */
    float last;                 /* tone of the last column; unset where none was left out */
    float tolerance;            /* mean difference of tone that was allowed; 0: nothing was left out */
};

/* An asset on the GPU. Texels of maps hold ink, which is 1 minus reflectance, so that no texture is needed for paper
 * (the implicit white tone of Real-Time Hatching §5). Texels of volumes hold reflectance. */
struct asset_tones {
    GLuint texture, sampler;
    bool layered;                       /* a 2D array texture; false: 3D, or 2D if exact */
    bool exact;                         /* exact runs or lists: integers, which samplers cannot filter */
    float darkest;                      /* of a volume: darkest tone of its slices; 0 for others */
    uint32_t count;                     /* number of columns or slices, at most HATCH_TAM_TONES_MAX */
    float targets[HATCH_TAM_TONES_MAX]; /* tone of each column, ascending; of a volume, the first is the number of its
                                           slices with those that were left out; 0 for threshold textures */
    float stroke_px, stroke_ink;        /* width in texels and darkness of a stroke; only of asset_strokes */
    bool flat;                          /* crossing strokes do not darken each other; only of asset_strokes */
};

/* Limits of uploads. */
struct asset_limits {
    uint32_t size_max_px; /* largest side of a texture */
    float anisotropy;     /* greatest anisotropy of the sampler, 1 (none) .. 16 */
};

/* A kind of asset. */
struct asset_kind {
    const char *name;                      /* for messages: "a tonal art map (tamgen makes one)" */
    bool (*is)(const struct asset *asset); /* whether the asset is of this kind */
    /* Uploads an asset of this kind.
     *   size_max_px  largest side of a texture
     *   tones        in: zeroed; out: all members but the sampler; on failure the caller deletes what they hold
     * HATCH_LIMIT when the GPU's textures or memory are too small. */
    enum hatch_status (*upload)(const struct asset *asset, uint32_t size_max_px, struct hatch_arena *scratch,
                                struct asset_tones *tones, struct hatch_err *err);
};

extern const struct asset_kind asset_six_columns; /* a map as up to six grey columns, in two layers of four channels */
extern const struct asset_kind asset_columns;     /* a map, each column a layer, grey or coloured */
extern const struct asset_kind asset_volume;      /* a volume: slices of a 3D texture or layers of a 2D array */
extern const struct asset_kind asset_thresholds;  /* a threshold texture, or exact runs */
extern const struct asset_kind asset_strokes;     /* a map with ids, as lists of the strokes that cover each texel */

#define ASSET_SIX_COLUMNS_MAX 6u

/* Reads an asset into args->keep. Exits with a message if the file is not an asset.
 *   path  NULL or "-": standard input */
void asset_read(struct cmd_args *args, const char *path, struct asset *asset);

/* Properties of the asset, whether it is a map or a texture. The darkest tone, 0 .. 1, of one that is not whole is that
 * of the whole one. */
bool asset_is_map(const struct asset *asset);
bool asset_is_colored(const struct asset *asset); /* a map or a volume whose strokes have colours */
float asset_darkest(const struct asset *asset);
uint32_t asset_size_px(const struct asset *asset); /* side of the finest level; 0: no asset */

/* The number of levels that hold strokes, and of those that have enough slices of tone: all, but in 3D textures those
 * of hatch_volume_dense_levels. 0: no asset. */
uint32_t asset_levels(const struct asset *asset);
uint32_t asset_dense_levels(const struct asset *asset);

/* Returns how much of the whole map the asset holds, itself or the map that it was made from. */
struct asset_part asset_part(const struct asset *asset);

/* The side of the finest level and the number of levels that hold strokes; of one that is not whole, those of the
 * whole one, so that both repeat as often over a surface. 0: no asset. */
uint32_t asset_whole_size_px(const struct asset *asset);
uint32_t asset_whole_levels(const struct asset *asset);

/* An asset and its uploads, each made on first use. */
struct assets {
    const struct asset *asset; /* kept by reference; NULL: none */
    struct asset_limits limits;
    struct {
        const struct asset_kind *kind; /* NULL: a free entry */
        struct asset_tones tones;
    } uploaded[5]; /* one per kind */
};

/* Returns whether there is an asset of a kind.
 *   kind  NULL: no asset is needed, and the result is true */
bool assets_have(const struct assets *assets, const struct asset_kind *kind);

/* Uploads the asset in the form of a kind, or returns the earlier upload if there is one.
 *   kind   assets_have must be true for it
 *   tones  out: owned by assets
 * HATCH_LIMIT when the GPU's textures or memory are too small. */
enum hatch_status assets_upload(struct assets *assets, const struct asset_kind *kind, struct hatch_arena *scratch,
                                const struct asset_tones **tones, struct hatch_err *err) HATCH_MUST_USE;

/* Releases the uploads. */
void assets_free(struct assets *assets);

/* Binds the tones for shaders and writes their number and targets into the frame's block.
 *   anisotropy  1 (none) .. 16
 *   side        samples along a pixel's side; the mip level is chosen for the whole pixel, so that strokes have the
 *               same width for any number of samples */
void asset_tones_use(const struct asset_tones *tones, float anisotropy, uint32_t side, struct frame_block *block);

#endif
