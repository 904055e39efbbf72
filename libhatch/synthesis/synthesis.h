/* Solid textures from pictures: each slice of the solid along x, y and z looks like the picture, the exemplar.
 *
 * Two methods. HATCH_SYNTHESIS_KOPF reproduces neighbourhoods of pixels: Kopf, Fu, Cohen-Or, Deussen, Lischinski &
 * Wong, "Solid Texture Synthesis from 2D Exemplars", SIGGRAPH 2007. HATCH_SYNTHESIS_PYRAMID reproduces the histogram of
 * each band of frequencies: Heeger & Bergen, "Pyramid-Based Texture Analysis/Synthesis", SIGGRAPH 1995; it is fast, and
 * knows no lines.
 *
 * In each slice the exemplar's right is along the first of the two axes in the order x, y, z, and its down along the
 * other one. One texel has the size of one pixel of the exemplar as used (hatch_synthesis_exemplar). The solid repeats
 * along each axis.
 */
#ifndef HATCH_SYNTHESIS_SYNTHESIS_H
#define HATCH_SYNTHESIS_SYNTHESIS_H

#include <stdbool.h>

#include "base/parallel.h"
#include "base/progress.h"
#include "image/image.h"
#include "solid/solid.h"

#define HATCH_SYNTHESIS_SIDE_MIN 3u /* of neighbourhoods, in pixels */
#define HATCH_SYNTHESIS_SIDE_MAX 12u
#define HATCH_SYNTHESIS_LEVELS_MAX 4u
#define HATCH_SYNTHESIS_EXEMPLAR_MAX 256u /* largest side of an exemplar as used */

enum hatch_synthesis_method { HATCH_SYNTHESIS_KOPF, HATCH_SYNTHESIS_PYRAMID };

struct hatch_synthesis_options {
    uint32_t size; /* texels along each axis, as in struct hatch_solid */
    enum hatch_synthesis_method method;
    uint64_t seed;
    uint32_t side;   /* kopf: side of neighbourhoods, HATCH_SYNTHESIS_SIDE_MIN .. MAX pixels; smaller exemplars have
                        smaller ones */
    uint32_t levels; /* kopf: levels of detail at most, 1 .. HATCH_SYNTHESIS_LEVELS_MAX */
    uint32_t
        iterations;  /* kopf: at the finest level, four times as many at each coarser one; pyramid: in all; 1 .. 1000 */
    uint32_t axes;   /* kopf: slices across axis a look like the exemplar where bit a is set, 1 .. 7; two axes suit an
                        exemplar that no solid can look like along all three, such as stripes or bricks */
    bool exhaustive; /* kopf: compare with each neighbourhood of the exemplar, as a reference; slow */
};

struct hatch_synthesis_figures {
    uint32_t width, height; /* of the exemplar as used */
    uint32_t halvings;      /* of its resolution */
    bool cropped;           /* part of it is not used */
    uint32_t side, levels;  /* as used */
    uint32_t iterations;    /* over all levels */
    double energy;          /* kopf: mean over all texels and the slices through each of the root mean square
                               difference between its neighbourhood and the one that it was matched with, 0 .. 1 */
};

/* Takes from a picture what synthesis uses: grey (one channel) or R G B, without alpha. Its resolution is halved while
 * the shorter side exceeds max(128, 2 size) and HATCH_SYNTHESIS_EXEMPLAR_MAX; then the middle of the longer side is cut
 * out.
 *   picture   in linear light: grey or colours in the first channels; values are clamped to 0 .. 1
 *   size      texels along each axis of the solid
 *   exemplar  out: in arena, which may be scratch; channels 1 or 3
 *   figures   width, height, halvings and cropped are set */
enum hatch_status hatch_synthesis_exemplar(const struct hatch_image *picture, uint32_t size, struct hatch_arena *arena,
                                           struct hatch_arena *scratch, struct hatch_image *exemplar,
                                           struct hatch_synthesis_figures *figures,
                                           struct hatch_err *err) HATCH_MUST_USE;

/* Makes a solid texture whose slices look like the picture. The same bytes for any number of threads.
 *   picture   as in hatch_synthesis_exemplar
 *   pool      may be NULL
 *   progress  may be NULL
 *   solid     out: in arena; with one channel where the picture is grey, otherwise with three
 *   figures   out
 * HATCH_LIMIT, before any work, when the memory does not suffice. */
enum hatch_status hatch_synthesis_make(const struct hatch_image *picture, const struct hatch_synthesis_options *options,
                                       struct hatch_pool *pool, const struct hatch_progress *progress,
                                       struct hatch_arena *arena, struct hatch_arena *scratch,
                                       struct hatch_solid *solid, struct hatch_synthesis_figures *figures,
                                       struct hatch_err *err) HATCH_MUST_USE;

#endif
