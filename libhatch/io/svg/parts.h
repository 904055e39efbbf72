/* Private to the SVG reader: parsing of values, computed styles, and drawing of shapes. */
#ifndef HATCH_IO_SVG_PARTS_H
#define HATCH_IO_SVG_PARTS_H

#include <stdbool.h>

#include "base/text.h"
#include "io/svg/svg.h"
#include "stroke/path.h"

/* x' = a x + c y + e, y' = b x + d y + f, as in SVG's matrix(). */
struct hatch_svg_matrix {
    double a, b, c, d, e, f;
};

/* Transforms the point (x, y). */
void hatch_svg_apply(const struct hatch_svg_matrix *m, double x, double y, double point[2]);

/* Returns the transform that applies inner, then outer. */
struct hatch_svg_matrix hatch_svg_multiply(const struct hatch_svg_matrix *outer, const struct hatch_svg_matrix *inner);

/* Returns the determinant: the area that the unit square has after the transform, negative where it is mirrored. */
double hatch_svg_determinant(const struct hatch_svg_matrix *m);

/* Parses any number of translate, scale, rotate, skew and matrix, and those of one axis such as scaleX.
 *   page  side of the page in user units, for percentages */
enum hatch_status hatch_svg_transform(struct hatch_text text, double page, struct hatch_svg_matrix *matrix,
                                      struct hatch_err *err) HATCH_MUST_USE;

/* Removes white space and at most one comma from the start of *rest. */
void hatch_svg_skip(struct hatch_text *rest);

/* Removes a finite number, and the white space and comma after it, from the start of *rest. Returns false when there is
 * no number. */
bool hatch_svg_number(struct hatch_text *rest, double *number);

/* Removes count numbers like hatch_svg_number. */
bool hatch_svg_numbers(struct hatch_text *rest, uint32_t count, double *numbers);

/* Removes an angle, a number with deg, grad, rad, turn or no unit, and the white space and comma after it. Returns
 * false when there is none. */
bool hatch_svg_angle(struct hatch_text *rest, double *angle_deg);

/* Removes a length, a number with px, pt, pc, mm, cm, in, em, ex, %, or no unit, and the white space and comma after
 * it. Returns false when there is none. Arguments as for hatch_svg_length. */
bool hatch_svg_take_length(struct hatch_text *rest, double whole, double *length);

/* Parses a length, as hatch_svg_take_length does, and nothing else.
 *   whole   length of 100 %, user units
 *   length  out: user units */
enum hatch_status hatch_svg_length(struct hatch_text text, double whole, double *length,
                                   struct hatch_err *err) HATCH_MUST_USE;

/* Parses lengths separated by white space or commas.
 *   lengths  out: *count of them, at most max */
enum hatch_status hatch_svg_lengths(struct hatch_text text, double whole, uint32_t max, double *lengths,
                                    uint32_t *count, struct hatch_err *err) HATCH_MUST_USE;

/* Kinds of paint; SERVER: a gradient or a pattern. */
enum hatch_svg_paint { HATCH_SVG_NONE, HATCH_SVG_COLOR, HATCH_SVG_SERVER };

/* Computed style of an element. */
struct hatch_svg_style {
    enum hatch_svg_paint stroke;
    bool filled;                         /* has a fill whose own colour is not transparent */
    bool stroke_current, fill_current;   /* they have the colour color_rgba */
    float stroke_rgba[4], color_rgba[4]; /* linear light, then alpha; color_rgba: of the property color */
    double width;                        /* user units */
    double stroke_opacity, fill_opacity; /* 0 .. 1 */
    double opacity;                      /* 0 .. 1; product of own_opacity and those of all groups around */
    double own_opacity;                  /* 0 .. 1; opacity of the element alone */
    struct hatch_text dashes;            /* stroke-dasharray; empty: none */
    double dash_offset;                  /* user units */
    bool capped;                         /* round or square caps: lines of length 0 are visible */
    bool invisible;                      /* visibility is hidden */
    bool undisplayed, own_undisplayed;   /* display is none: of the element or of a group around it; of itself */
    bool incomplete;                     /* some of its properties are left out: filter, mask, clip-path and others */
    struct hatch_text own_transform, own_origin; /* transform and transform-origin of the element; empty: none */
    bool own_box;                                /* of the element: its origin refers to another box than the page */
    bool own_pen;                                /* of the element: its width is in units of the page (vector-effect) */
    struct hatch_svg_matrix matrix;              /* from user units to tiles */
};

/* Returns whether a name is in a list that ends with NULL. */
bool hatch_svg_is_any(struct hatch_text name, const char *const *list);

/* Applies a property ("stroke-width", "2mm") to a style; other properties are ignored.
 *   page  side of the page in user units, for percentages */
enum hatch_status hatch_svg_property(struct hatch_text name, struct hatch_text value, double page,
                                     struct hatch_svg_style *style, struct hatch_err *err) HATCH_MUST_USE;

/* Replaces the comments of CSS by spaces.
 *   text  out: a copy in arena, which ends with '\0' */
enum hatch_status hatch_svg_blank_comments(struct hatch_text *text, struct hatch_arena *arena,
                                           struct hatch_err *err) HATCH_MUST_USE;

/* Applies a list of declarations: "stroke:#000; stroke-width:2". A declaration whose value is malformed or unknown is
 * ignored (CSS 2.1, section 4.2); the style is incomplete then.
 *   important  whether those that end with "!important" are applied, or the others */
void hatch_svg_declarations(struct hatch_text declarations, double page, bool important, struct hatch_svg_style *style);

/* A callback that receives a finished line, in tiles. */
typedef enum hatch_status (*hatch_svg_finish)(void *context, struct hatch_path_builder *line, struct hatch_err *err);

#define HATCH_SVG_DASHES_MAX 1000000u /* limit per drawing */

/* Cuts the lines of a drawing into dashes. */
struct hatch_svg_dasher {
    struct hatch_path_builder dash; /* the dash being built */
    uint32_t count;                 /* dashes so far */
    hatch_svg_finish finish;        /* called for each dash */
    void *context;
};

/* Cuts a line into dashes, which are measured in user units; a line without dashes is passed on unchanged.
 *   line  in tiles
 *   page  side of the page in user units, for percentages
 * HATCH_BAD_INPUT for a malformed list of lengths; HATCH_LIMIT also above HATCH_SVG_DASHES_MAX. */
enum hatch_status hatch_svg_dash(struct hatch_svg_dasher *dasher, const struct hatch_path_builder *line,
                                 const struct hatch_svg_style *style, double page,
                                 struct hatch_err *err) HATCH_MUST_USE;

/* Parses a colour: three, four, six or eight hexadecimal digits after "#", "rgb(1, 2, 3)", "rgb(1% 2% 3% / 50%)",
 * "hsl(120, 100%, 50%)", the same as rgba() and hsla(), "transparent", or a name of CSS. Returns false for other texts.
 *   rgba  out: linear, then alpha; unchanged on failure */
bool hatch_svg_color(struct hatch_text text, float rgba[4]);

/* Draws subpaths that are given in user units. */
struct hatch_svg_pen {
    struct hatch_path_builder line; /* the current subpath, in tiles */
    struct hatch_svg_matrix matrix; /* from user units to tiles */
    double x, y;                    /* current point, user units */
    hatch_svg_finish finish;        /* called for each subpath */
    void *context;
};

/* Ends the current subpath; the next one begins at (x, y). */
enum hatch_status hatch_svg_move(struct hatch_svg_pen *pen, double x, double y, struct hatch_err *err) HATCH_MUST_USE;
enum hatch_status hatch_svg_line(struct hatch_svg_pen *pen, double x, double y, struct hatch_err *err) HATCH_MUST_USE;
/* Adds a cubic Bézier curve.
 *   xy  two control points and the end point */
enum hatch_status hatch_svg_cubic(struct hatch_svg_pen *pen, const double xy[6], struct hatch_err *err) HATCH_MUST_USE;
/* Adds an elliptical arc, with the arguments of the path command A. */
enum hatch_status hatch_svg_arc(struct hatch_svg_pen *pen, const double radii[2], double rotation_deg, bool large,
                                bool sweep, const double end[2], struct hatch_err *err) HATCH_MUST_USE;
/* Ends the current subpath, if any. */
enum hatch_status hatch_svg_end(struct hatch_svg_pen *pen, struct hatch_err *err) HATCH_MUST_USE;

/* Draws path data ("m 3,4 l 5,6"); "none" is an empty path. */
enum hatch_status hatch_svg_path(struct hatch_text data, struct hatch_svg_pen *pen,
                                 struct hatch_err *err) HATCH_MUST_USE;

/* Returns the value of an attribute; empty when absent.
 *   attributes  names and values alternating, NULL-terminated */
struct hatch_text hatch_svg_attribute(const char *const *attributes, const char *name);

/* Draws a line, rect, circle, ellipse, polyline, polygon or path; does nothing for other elements.
 *   page  side of the page in user units, for percentages */
enum hatch_status hatch_svg_shape(const char *element, const char *const *attributes, double page,
                                  struct hatch_svg_pen *pen, struct hatch_err *err) HATCH_MUST_USE;

#endif
