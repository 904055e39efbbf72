/* Direction marks: short lines along a direction field (_HATCH_DIR), spread evenly over the surfaces that have one. */
#ifndef HATCH_LINE_MARKS_H
#define HATCH_LINE_MARKS_H

#include "scene/unit_scene.h"
#include "view/view.h"

/* A place and a direction on a face, in its barycentric coordinates, so that both move with it. */
struct hatch_mark {
    uint32_t face;
    float share[3];    /* weights of the corners: the place; their sum is 1 */
    float velocity[3]; /* weights of the corners: the direction; their sum is 0 */
    float confidence;  /* 0 .. 1 */
};

/* A mark at the scene's pose, in the unit scene. */
struct hatch_mark_line {
    float middle[3], half[3]; /* half: from the middle to an end */
    float confidence;
};

struct hatch_marks {
    const struct hatch_unit_scene *scene;
    uint32_t count;
    struct hatch_mark *at;         /* in the order of items */
    uint32_t *item_end;            /* one past the last mark of each item */
    double half_length;            /* in the unit scene */
    double *positions;             /* room for a surface's vertices */
    struct hatch_mark_line *lines; /* hatch_marks_place fills them */
};

/* Spreads marks over a posed scene.
 *   scene      kept by reference
 *   height_px  of the picture from the view: the distance between marks suits it
 *   arena      keeps the marks
 * HATCH_BAD_INPUT where no mesh has directions. */
enum hatch_status hatch_marks_make(const struct hatch_unit_scene *scene, const struct hatch_view *view,
                                   double height_px, struct hatch_arena *arena, struct hatch_arena *scratch,
                                   struct hatch_marks *marks, struct hatch_err *err) HATCH_MUST_USE;

/* Computes the lines at the scene's pose. */
void hatch_marks_place(struct hatch_marks *marks);

#endif
