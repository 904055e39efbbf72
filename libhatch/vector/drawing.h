/* A drawing for a pen: paths in layers on a page. It is what writers of vector formats take. */
#ifndef HATCH_VECTOR_DRAWING_H
#define HATCH_VECTOR_DRAWING_H

#include "curve/stroke_look.h"
#include "vector/paths.h"

struct hatch_drawing_layer {
    const char *name; /* lower-case letters, digits and '-'; unique in the drawing; owned by the caller */
    float color[3];   /* linear light */
    double pen_mm;    /* width of its strokes */
    const struct hatch_stroke_look *look; /* its paths have colours of their own, by their ids; NULL: none has */
};

/* Returns whether the paths of a layer have colours of their own. */
static inline bool hatch_drawing_has_colors(const struct hatch_drawing_layer *layer)
{
    return layer->look && layer->look->color_count > 0;
}

struct hatch_drawing {
    double width_mm, height_mm; /* of the page */
    float paper[3];             /* linear light */
    uint32_t layer_count;
    const struct hatch_drawing_layer *layers;
    struct hatch_vector_paths paths; /* in millimetres from the page's upper left corner, y downwards; drawn in this
                                        order within each layer */
};

/* A page that a picture is placed on. */
struct hatch_page {
    double width_mm, height_mm; /* 0: as large as the picture, at 96 pixels per inch */
    double margin_mm;
};

#define HATCH_PAGE_LEAST_MM 1.0
#define HATCH_PAGE_MOST_MM 10000.0

/* Names of pages, NULL at the end. */
extern const char *const hatch_page_names[];

/* Finds the size of a page from its name, or from WxH or WxHmm. A page with a name is turned to match the picture: its
 * longer sides are parallel to the picture's. Returns false for any other text, and for sides outside
 * HATCH_PAGE_LEAST_MM .. HATCH_PAGE_MOST_MM.
 *   aspect  width / height of the picture
 *   page    out: width_mm and height_mm */
bool hatch_page_find(const char *text, double aspect, struct hatch_page *page);

/* Computes the size of a pixel of a picture that fills a page up to its margins. It is not over 0 if the margins leave
 * no room.
 *   page  in, out: a size of 0 is replaced by that of the picture and the margins */
double hatch_page_pixel_mm(struct hatch_page *page, double width_px, double height_px);

/* Moves paths from the picture to the middle of the page.
 *   page   with its size set
 *   paths  in: in pixels, y upwards; out: as in struct hatch_drawing */
void hatch_page_place(const struct hatch_page *page, double width_px, double height_px, double pixel_mm,
                      struct hatch_vector_paths *paths);

#endif
