/* The uniform block that all shaders of a frame read: block Frame of shaders/frame/frame.glsl. */
#ifndef RENDER_FRAME_BLOCK_H
#define RENDER_FRAME_BLOCK_H

#include "view/light.h"

#define FRAME_TONES_MAX 256u

/* Colours of paper and inks, in linear light. */
struct frame_inks {
    float paper[3], ink[3];
    float light_ink[3]; /* the second ink; used only if two is set */
    bool two;           /* paper is the middle tone: ink draws the darker parts, light_ink the lighter ones */
};

/* Conversion of light to tone. */
struct frame_curve {
    double low, high; /* least and greatest amount of ink, 0 .. 1: on fully lit and on unlit surfaces with dark ink */
    double gamma;     /* exponent of the darkness, over 0; a value over 1 makes middle tones lighter */
    double ambient;   /* light from all directions, 0 .. 1 */
    double specular;  /* strength of highlights, at least 0; 0: none */
    double shininess; /* exponent of highlights */
    double exposure;  /* factor for the scene's lights, over 0 */
};

/* std140 layout; the same as block Frame of shaders/frame/frame.glsl. */
struct frame_block {
    float clip_from_unit[16]; /* from the unit scene to clip space; column-major */
    float eye[4];             /* w = 1: position of the camera; w = 0 (orthographic): direction towards the camera */
    float paper[4], ink[4], light_ink[4];
    float curve[4];                         /* low, high, gamma; samples per pixel */
    float shade[4];                         /* darkest tone of a volume; ambient, specular, shininess */
    float viewport[4];                      /* half the tile's width and height, and its lower left corner, in pixels */
    float hatch[4];                         /* cosine and sine of the pattern's rotation, both divided by its scale */
    int32_t counts[4];                      /* numbers of lights and of tones; enum frame_ink_mode; unused */
    float ramp_low[2][4], ramp_scale[2][4]; /* for the first six tones: the preceding tone, 1 / difference from it */
    float targets[FRAME_TONES_MAX / 4][4];  /* tone of each column, ascending */
    struct hatch_unit_light lights[HATCH_LIGHTS_MAX];
};

enum frame_ink_mode {
    FRAME_INK_DARKENS = 0,  /* ink on lighter paper */
    FRAME_INK_LIGHTENS = 1, /* ink on darker paper, as on scratchboard: strokes draw the lit parts */
    FRAME_INK_BOTH = 2      /* two inks on paper of a middle tone */
};

/* Returns what the inks do on their paper. */
enum frame_ink_mode frame_ink_mode(const struct frame_inks *inks);

/* Convert inks and curve to the block's members. */
void frame_block_set_inks(struct frame_block *block, const struct frame_inks *inks);
void frame_block_set_curve(struct frame_block *block, const struct frame_curve *curve);

/* Sets the tones of the asset that strokes are read from.
 *   targets  tone of each column, ascending
 *   count    number of tones, at most FRAME_TONES_MAX; 0: none
 *   darkest  of a volume: darkest tone of its slices, 0 .. 1 */
void frame_block_set_tones(struct frame_block *block, const float *targets, uint32_t count, float darkest);

/* Sets the rotation and the scale of the strokes' pattern on surfaces.
 *   turn_rad  rotation, counter-clockwise as seen from outside
 *   scale     factor for the pattern's size, over 0 */
void frame_block_set_hatch(struct frame_block *block, double turn_rad, double scale);

/* Sets the view, for one tile of the picture.
 *   side  samples along a pixel's side */
void frame_block_set_view(struct frame_block *block, const struct hatch_view *view, const struct hatch_tile *tile,
                          uint32_t side);

#endif
