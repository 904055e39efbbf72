/* Basic shapes, drawn as lines and arcs (SVG 2, section 10). */
#include <math.h>
#include <string.h>

#include "io/svg/parts.h"

struct hatch_text hatch_svg_attribute(const char *const *attributes, const char *name)
{
    for (; *attributes; attributes += 2)
        if (strcmp(attributes[0], name) == 0)
            return (struct hatch_text){attributes[1], strlen(attributes[1])};
    return (struct hatch_text){"", 0};
}

/* Reads the lengths that some attributes have; 0 for absent ones. */
static enum hatch_status read_lengths(const char *const *attributes, const char *const *names, uint32_t count,
                                      double page, double *lengths, struct hatch_err *err)
{
    for (uint32_t i = 0; i < count; i++) {
        struct hatch_text text = hatch_svg_attribute(attributes, names[i]);
        lengths[i] = 0;
        if (text.length && hatch_svg_length(text, page, &lengths[i], err) != HATCH_OK)
            return hatch_fail_at(err, "%s: ", names[i]);
    }
    return HATCH_OK;
}

static enum hatch_status draw_line(const char *const *attributes, double page, struct hatch_svg_pen *pen,
                                   struct hatch_err *err)
{
    static const char *const names[] = {"x1", "y1", "x2", "y2"};
    double v[4];
    HATCH_TRY(read_lengths(attributes, names, 4, page, v, err));
    HATCH_TRY(hatch_svg_move(pen, v[0], v[1], err));
    return hatch_svg_line(pen, v[2], v[3], err);
}

static enum hatch_status draw_ellipse(double x, double y, double rx, double ry, struct hatch_svg_pen *pen,
                                      struct hatch_err *err)
{
    const double radii[2] = {rx, ry}, left[2] = {x - rx, y}, right[2] = {x + rx, y};
    if (!(rx > 0 && ry > 0))
        return HATCH_OK;
    HATCH_TRY(hatch_svg_move(pen, right[0], y, err));
    HATCH_TRY(hatch_svg_arc(pen, radii, 0, false, true, left, err));
    return hatch_svg_arc(pen, radii, 0, false, true, right, err);
}

static enum hatch_status draw_circle(const char *const *attributes, double page, struct hatch_svg_pen *pen,
                                     struct hatch_err *err)
{
    static const char *const names[] = {"cx", "cy", "r"};
    double v[3];
    HATCH_TRY(read_lengths(attributes, names, 3, page, v, err));
    return draw_ellipse(v[0], v[1], v[2], v[2], pen, err);
}

/* Reads the radii rx and ry. One that is absent, "auto" or negative is that of the other axis; 0 if both are. */
static enum hatch_status read_radii(const char *const *attributes, double page, double radii[2], struct hatch_err *err)
{
    static const char *const names[] = {"rx", "ry"};
    for (int axis = 0; axis < 2; axis++) {
        struct hatch_text text = hatch_svg_attribute(attributes, names[axis]);
        radii[axis] = -1;
        if (text.length && !hatch_text_is(text, "auto") && hatch_svg_length(text, page, &radii[axis], err) != HATCH_OK)
            return hatch_fail_at(err, "%s: ", names[axis]);
    }
    for (int axis = 0; axis < 2; axis++)
        if (!(radii[axis] >= 0))
            radii[axis] = fmax(radii[!axis], 0);
    return HATCH_OK;
}

static enum hatch_status draw_ellipse_element(const char *const *attributes, double page, struct hatch_svg_pen *pen,
                                              struct hatch_err *err)
{
    static const char *const names[] = {"cx", "cy"};
    double v[2], radii[2];
    HATCH_TRY(read_lengths(attributes, names, 2, page, v, err));
    HATCH_TRY(read_radii(attributes, page, radii, err));
    return draw_ellipse(v[0], v[1], radii[0], radii[1], pen, err);
}

/* Draws a side of a rectangle to (to_x, to_y), and the rounded corner from there to (end_x, end_y). */
static enum hatch_status draw_side(struct hatch_svg_pen *pen, const double radii[2], double to_x, double to_y,
                                   double end_x, double end_y, struct hatch_err *err)
{
    const double end[2] = {end_x, end_y};
    HATCH_TRY(hatch_svg_line(pen, to_x, to_y, err));
    return hatch_svg_arc(pen, radii, 0, false, true, end, err);
}

static enum hatch_status draw_rect(const char *const *attributes, double page, struct hatch_svg_pen *pen,
                                   struct hatch_err *err)
{
    static const char *const names[] = {"x", "y", "width", "height"};
    double v[4], radii[2];
    HATCH_TRY(read_lengths(attributes, names, 4, page, v, err));
    HATCH_TRY(read_radii(attributes, page, radii, err));
    double x = v[0], y = v[1], width = v[2], height = v[3];
    if (!(width > 0 && height > 0))
        return HATCH_OK;
    radii[0] = radii[1] > 0 ? fmin(radii[0], width / 2) : 0; /* corners are square where either radius is 0 */
    radii[1] = radii[0] > 0 ? fmin(radii[1], height / 2) : 0;
    double left = x + radii[0], right = x + width - radii[0], top = y + radii[1], low = y + height - radii[1];
    HATCH_TRY(hatch_svg_move(pen, left, y, err));
    HATCH_TRY(draw_side(pen, radii, right, y, x + width, top, err));
    HATCH_TRY(draw_side(pen, radii, x + width, low, right, y + height, err));
    HATCH_TRY(draw_side(pen, radii, left, y + height, x, low, err));
    return draw_side(pen, radii, x, top, left, y, err);
}

static enum hatch_status draw_points(const char *const *attributes, bool closed, struct hatch_svg_pen *pen,
                                     struct hatch_err *err)
{
    struct hatch_text rest = hatch_svg_attribute(attributes, "points");
    double first[2] = {0, 0}, point[2];
    bool begun = false;
    for (hatch_svg_skip(&rest); rest.length; begun = true) {
        if (!hatch_svg_numbers(&rest, 2, point))
            return hatch_fail(err, HATCH_BAD_INPUT, "points: a number is missing or malformed");
        if (!begun)
            memcpy(first, point, sizeof first);
        HATCH_TRY(begun ? hatch_svg_line(pen, point[0], point[1], err) : hatch_svg_move(pen, point[0], point[1], err));
    }
    return closed && begun ? hatch_svg_line(pen, first[0], first[1], err) : HATCH_OK;
}

enum hatch_status hatch_svg_shape(const char *element, const char *const *attributes, double page,
                                  struct hatch_svg_pen *pen, struct hatch_err *err)
{
    if (strcmp(element, "path") == 0)
        HATCH_TRY(hatch_svg_path(hatch_svg_attribute(attributes, "d"), pen, err));
    else if (strcmp(element, "line") == 0)
        HATCH_TRY(draw_line(attributes, page, pen, err));
    else if (strcmp(element, "polyline") == 0 || strcmp(element, "polygon") == 0)
        HATCH_TRY(draw_points(attributes, strcmp(element, "polygon") == 0, pen, err));
    else if (strcmp(element, "circle") == 0)
        HATCH_TRY(draw_circle(attributes, page, pen, err));
    else if (strcmp(element, "ellipse") == 0)
        HATCH_TRY(draw_ellipse_element(attributes, page, pen, err));
    else if (strcmp(element, "rect") == 0)
        HATCH_TRY(draw_rect(attributes, page, pen, err));
    return hatch_svg_end(pen, err);
}
