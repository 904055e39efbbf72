/* A technique: how tone becomes strokes. One file technique/NAME.c with one table entry, listed in
 * technique/technique.c; adding one touches its file, the list and its section of render-gl(1). */
#ifndef RENDER_TECHNIQUE_H
#define RENDER_TECHNIQUE_H

#include "render-gl/columns.h"
#include "render-gl/shader.h"

#define TECHNIQUE_PASSES_MAX 4u
#define TECHNIQUE_GOURAUD 6u /* the reference for tone and for speed */
#define TECHNIQUE_RPTAM 7u
#define TECHNIQUE_CHOICES 11u /* of --technique; those after them serve other options */
#define TECHNIQUE_PROBE 11u
#define TECHNIQUE_PATCHES 12u
#define TECHNIQUE_FIELD 13u
#define TECHNIQUE_PLACES 14u
#define TECHNIQUE_COUNT 15u

/* What a technique makes of patches over a surface. */
enum technique_patches {
    PATCHES_BLEND, /* each over those before it by its outline. A technique of several passes begins with
                      black and adds in the others; its shaders put the outline into alpha */
    PATCHES_COVER, /* the uppermost hides the others: what is drawn is no colour */
    PATCHES_UNSEEN /* the surface is drawn instead, as if it had none */
};

struct technique {
    const char *name;
    const char *summary;       /* one line for the window's terminal help */
    enum columns_form columns; /* what it reads strokes from */
    bool seeds;                /* it draws strokes at seeds */
    struct shader_stages stages;
    const char *defines; /* lines before each stage, "" for none */
    bool pixel_light;    /* it can light each pixel: its shaders know PIXEL_LIGHT */
    uint32_t samples;    /* a pixel, by default; 0: what the option says */
    uint32_t pass_count; /* 1 .. TECHNIQUE_PASSES_MAX; shaders know it as `pass` */
    const char *pass_names[TECHNIQUE_PASSES_MAX];
    enum technique_patches patches;
    void (*begin_pass)(uint32_t pass); /* sets blending and depth other than the usual; or NULL */
};

/* In the order of --technique's choices. */
extern const struct technique *const techniques[TECHNIQUE_COUNT];

/* Whether it draws strokes along texture coordinates, and not tone alone. */
static inline bool technique_draws_strokes(const struct technique *technique)
{
    return technique->seeds || technique->columns != COLUMNS_NONE;
}

/* The choices' names, for the option table; the last entry is NULL. */
const char *const *technique_names(void);

#endif
