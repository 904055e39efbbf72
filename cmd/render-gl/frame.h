/* What every shader knows of a frame: the uniform block of shaders/frame.glsl, filled from the view,
 * the lights and the inks. */
#ifndef RENDER_FRAME_H
#define RENDER_FRAME_H

#include "render-gl/columns.h"
#include "scene/view.h"

#define LIGHTS_MAX 64u

/* A picture's inks: colours in linear light. */
struct inks {
    float paper[3], ink[3], light_ink[3];
    bool two; /* ink where it is darker than half, light_ink where it is lighter */
};

/* How light becomes tone. */
struct tone_curve {
    double low, high;           /* darkness of full light and of none; the amount of ink asked for */
    double gamma;               /* exponent of the darkness: over 1 lightens the middle */
    double ambient;             /* light that comes from everywhere */
    double specular, shininess; /* strength of the highlight, exponent */
    double exposure;            /* over 0; from the light meter where the user says nothing */
};

/* The light that is used where the scene has none, or where the command line names one. */
struct own_light {
    bool wanted;                       /* instead of the scene's */
    double azimuth_rad, elevation_rad; /* seen from the camera: 0 0 is from behind it */
};

struct frame_light {
    float position[4];  /* xyz in the unit scene; w: 0 directional, 1 point or spot */
    float direction[4]; /* unit, to the light (directional) or along the spot; w: strength */
    float cone[4];      /* scale and offset of the spot's edge; 1/range²; smallest distance² */
};

/* std140 */
struct frame_block {
    float clip_from_unit[16];
    float eye[4]; /* w: 1; orthographic: direction to the camera, w: 0 */
    float paper[4], ink[4], light_ink[4];
    float curve[4];    /* low, high, gamma, samples a pixel */
    float shade[4];    /* 0, ambient, specular, shininess */
    float viewport[4]; /* half the tile's width and height in pixels */
    float hatch[4];    /* cosine and sine of the strokes' turn, over their size */
    int32_t counts[4]; /* lights, columns, ink mode (enum ink_mode), 1: the last column is all ink */
    float ramp_low[2][4], ramp_scale[2][4]; /* six columns: darkness where each begins, 1/step */
    float targets[64][4];                   /* 256 darknesses */
    struct frame_light lights[LIGHTS_MAX];
};

enum ink_mode {
    INK_DARKENS = 0,  /* ink on a lighter paper */
    INK_LIGHTENS = 1, /* scratchboard: the lit parts are drawn */
    INK_BOTH = 2
};

/* What does not change with the view: inks, curve, columns. columns may be NULL (no map). */
void frame_set_style(struct frame_block *block, const struct inks *inks, const struct tone_curve *curve,
                     const struct gpu_columns *columns);

/* How strokes lie on their surface: turned against the clock as seen from outside, and their size. */
void frame_set_hatch(struct frame_block *block, double turn_rad, double scale);

/* Camera and tile. side: samples along a pixel's side. */
void frame_set_view(struct frame_block *block, const struct hatch_view *view, const struct hatch_tile *tile,
                    uint32_t side);

/* Lights of the scene at its pose, the first LIGHTS_MAX of them, or the own light. */
void frame_set_lights(struct frame_block *block, const struct hatch_pose *pose, const struct hatch_bounds *bounds,
                      const struct hatch_view *view, const struct own_light *own, double exposure);

/* Whether the own light is all there is, instead of the scene's. */
bool frame_has_lone_sun(const struct hatch_scene *scene, const struct own_light *own);

/* How many of the scene's lights that leaves out. */
uint32_t frame_lights_left_out(const struct hatch_scene *scene);

/* The strength of the strongest of the scene's lights, in the unit scene; 0 where none shines. */
double frame_strongest_light(const struct hatch_pose *pose, const struct hatch_bounds *bounds);

#endif
