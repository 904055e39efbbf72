#include "view/around.h"

#define TURN 2.39996322972865332 /* radians: the golden section of a full turn, which spreads points on a spiral */

enum hatch_status hatch_views_make(const struct hatch_view_choice *choice, bool alone, double zoom,
                                   struct hatch_pose *pose, const struct hatch_bounds *bounds, const double size[2],
                                   struct hatch_arena *arena, struct hatch_arena *scratch, struct hatch_view_set *set,
                                   struct hatch_err *err)
{
    const struct hatch_pose_span rest = {.animation = HATCH_NONE, .moments = 1};
    const struct hatch_framing framing = {&rest, bounds, size[0] / size[1]};
    struct hatch_view_set made = {bounds, alone ? 1 : HATCH_VIEWS_AROUND, NULL, size[0], size[1]};
    struct hatch_view_middle middle;
    HATCH_TRY(HATCH_ALLOC(arena, &made.views, made.count, err));
    for (uint32_t i = 0; i < made.count; i++) {
        struct hatch_view_choice turned = *choice;
        if (!alone) {
            turned.azimuth_rad = TURN * i;
            turned.elevation_rad = asin(1 - (2.0 * i + 1) / made.count);
        }
        HATCH_TRY(hatch_view_make(&turned, pose, &framing, scratch, &made.views[i], err));
        if (zoom != 1) {
            HATCH_TRY(hatch_view_find_middle(pose, &rest, bounds, &made.views[i], scratch, &middle, err));
            hatch_view_zoom(&middle, zoom, &made.views[i]);
        }
    }
    *set = made;
    return HATCH_OK;
}

double hatch_views_pixels(const struct hatch_view_set *set, const double world[3])
{
    double unit[3], largest = 0;
    hatch_bounds_to_unit(set->bounds, world, unit);
    for (uint32_t i = 0; i < set->count; i++)
        largest = fmax(largest, hatch_view_pixels_per_unit(&set->views[i], unit, set->height_px));
    return largest / set->bounds->radius;
}
