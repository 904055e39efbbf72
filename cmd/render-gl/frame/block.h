/* The uniform block that every shader of a frame reads: struct Frame of shaders/frame/frame.glsl. */
#ifndef RENDER_FRAME_BLOCK_H
#define RENDER_FRAME_BLOCK_H

#include "view/light.h"

#define FRAME_TONES_MAX 256u

/* A picture's inks: colours in linear light. */
struct frame_inks {
    float paper[3], ink[3], light_ink[3];
    bool two; /* ink where it is darker than half, light_ink where it is lighter */
};

/* How light becomes tone. */
struct frame_curve {
    double low, high;           /* darkness of full light and of none, 0 .. 1 */
    double gamma;               /* exponent of the darkness, over 0: over 1 lightens the middle */
    double ambient;             /* light from all directions */
    double specular, shininess; /* strength of the highlight, exponent */
    double exposure;            /* factor for the scene's lights, over 0 */
};

/* Tones of what strokes are read from. Zeroed: none. */
struct frame_tones {
    uint32_t count;       /* at most FRAME_TONES_MAX */
    const float *targets; /* darkness of each, rising */
    bool reaches_ink;     /* the last is all ink */
};

/* std140 */
struct frame_block {
    float clip_from_unit[16];
    float eye[4]; /* w: 1; orthographic: direction to the camera, w: 0 */
    float paper[4], ink[4], light_ink[4];
    float curve[4];                         /* low, high, gamma, samples a pixel */
    float shade[4];                         /* 0, ambient, specular, shininess */
    float viewport[4];                      /* half the tile's width and height in pixels */
    float hatch[4];                         /* cosine and sine of the strokes' turn, over their size */
    int32_t counts[4];                      /* lights, tones, enum frame_ink_mode, 1: the last tone is all ink */
    float ramp_low[2][4], ramp_scale[2][4]; /* of six tones: darkness where each begins, 1/step */
    float targets[FRAME_TONES_MAX / 4][4];
    struct hatch_unit_light lights[HATCH_LIGHTS_MAX];
};

enum frame_ink_mode {
    FRAME_INK_DARKENS = 0,  /* ink on a lighter paper */
    FRAME_INK_LIGHTENS = 1, /* scratchboard: the lit parts are drawn */
    FRAME_INK_BOTH = 2
};

void frame_block_set_inks(struct frame_block *block, const struct frame_inks *inks);
void frame_block_set_curve(struct frame_block *block, const struct frame_curve *curve);
void frame_block_set_tones(struct frame_block *block, const struct frame_tones *tones);

/* How strokes lie on their surface: turned counter-clockwise as seen from outside, and their size, over 0. */
void frame_block_set_hatch(struct frame_block *block, double turn_rad, double scale);

/* side: samples along a pixel's side. */
void frame_block_set_view(struct frame_block *block, const struct hatch_view *view, const struct hatch_tile *tile,
                          uint32_t side);

#endif
