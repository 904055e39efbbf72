/* What the reader of SVG drawings is made of. Private to io/svg*. */
#ifndef HATCH_IO_SVG_PARTS_H
#define HATCH_IO_SVG_PARTS_H

#include <stdbool.h>

#include "base/text.h"
#include "io/svg/svg.h"
#include "stroke/path.h"

/* x' = a x + c y + e, y' = b x + d y + f, as SVG writes matrices. */
struct hatch_svg_matrix {
    double a, b, c, d, e, f;
};

/* The place of (x, y) by m. */
void hatch_svg_apply(const struct hatch_svg_matrix *m, double x, double y, double place[2]);

/* First inner, then outer. */
struct hatch_svg_matrix hatch_svg_multiply(const struct hatch_svg_matrix *outer, const struct hatch_svg_matrix *inner);

/* A transform attribute: translate, scale, rotate, skewX, skewY and matrix, any number of them. */
enum hatch_status hatch_svg_transform(struct hatch_text text, struct hatch_svg_matrix *matrix,
                                      struct hatch_err *err) HATCH_MUST_USE;

/* Takes blanks, and one comma among them, off *rest. */
void hatch_svg_skip(struct hatch_text *rest);

/* Takes a number, with the blanks and the comma behind it, off *rest; false where there is none, or none
 * that is finite. */
bool hatch_svg_number(struct hatch_text *rest, double *number);

/* The same for count numbers. */
bool hatch_svg_numbers(struct hatch_text *rest, uint32_t count, double *numbers);

/* A length in user units: a number with px, pt, pc, mm, cm, in, em, ex, or % of `whole`. */
enum hatch_status hatch_svg_length(struct hatch_text text, double whole, double *length,
                                   struct hatch_err *err) HATCH_MUST_USE;

/* The same for count at most, separated by blanks or commas; *count is how many there are. */
enum hatch_status hatch_svg_lengths(struct hatch_text text, double whole, uint32_t most, double *lengths,
                                    uint32_t *count, struct hatch_err *err) HATCH_MUST_USE;

enum hatch_svg_paint { HATCH_SVG_NONE, HATCH_SVG_COLOR, HATCH_SVG_SERVER };

/* What elements inherit, and what they are drawn in: the computed style. */
struct hatch_svg_look {
    enum hatch_svg_paint stroke, fill;
    float stroke_rgb[3], color_rgb[3]; /* linear; the second is what currentColor means */
    double width;                      /* user units */
    double stroke_opacity, opacity;    /* opacity: of all its groups */
    double own_opacity;                /* the element's, which the groups' is multiplied by at last */
    struct hatch_text dashes;          /* stroke-dasharray; empty: none */
    double dash_offset;                /* user units */
    bool capped;                       /* lines have ends of their own: dots are seen */
    bool hidden;                       /* display none or visibility hidden */
    bool masked;                       /* by a filter, a mask or a clip */
    struct hatch_svg_matrix matrix;    /* to the page */
};

/* Puts one property ("stroke-width", "2mm") into the look; other names than those that it knows are passed
 * over. page: what per cents are of. */
enum hatch_status hatch_svg_property(struct hatch_text name, struct hatch_text value, double page,
                                     struct hatch_svg_look *look, struct hatch_err *err) HATCH_MUST_USE;

/* The same for a style attribute: "stroke:#000; stroke-width:2". */
enum hatch_status hatch_svg_style(struct hatch_text declarations, double page, struct hatch_svg_look *look,
                                  struct hatch_err *err) HATCH_MUST_USE;

#define HATCH_SVG_DASHES_MAX 1000000u /* of a drawing */

/* Cuts a line into its dashes, each of which goes to `finish`; a line without dashes goes there whole. scale: from
 * user units to those of the line; dash: a builder that is used for nothing else; *made counts them.
 * HATCH_BAD_INPUT for what is no list of lengths, HATCH_LIMIT beyond HATCH_SVG_DASHES_MAX. */
enum hatch_status hatch_svg_dash(const struct hatch_path_builder *line, const struct hatch_svg_look *look, double page,
                                 double scale, struct hatch_path_builder *dash, uint32_t *made,
                                 enum hatch_status (*finish)(void *context, struct hatch_path_builder *line,
                                                             struct hatch_err *err),
                                 void *context, struct hatch_err *err) HATCH_MUST_USE;

/* "#rgb", "#rrggbb", "rgb(1, 2, 3)", "rgb(1% 2% 3%)" or a name of CSS, as linear. */
bool hatch_svg_color(struct hatch_text text, float rgb[3]);

/* A line in user units on its way to the page. */
struct hatch_svg_pen {
    struct hatch_path_builder line; /* of the subpath, in tiles */
    struct hatch_svg_matrix matrix; /* user units to tiles */
    double x, y;                    /* where the pen is, user units */
    /* Called for each finished subpath. */
    enum hatch_status (*finish)(void *context, struct hatch_path_builder *line, struct hatch_err *err);
    void *context;
};

/* Ends the line that there is, and begins one. */
enum hatch_status hatch_svg_move(struct hatch_svg_pen *pen, double x, double y, struct hatch_err *err) HATCH_MUST_USE;
enum hatch_status hatch_svg_line(struct hatch_svg_pen *pen, double x, double y, struct hatch_err *err) HATCH_MUST_USE;
/* xy: two control points and the end. */
enum hatch_status hatch_svg_cubic(struct hatch_svg_pen *pen, const double xy[6], struct hatch_err *err) HATCH_MUST_USE;
/* An elliptical arc, as the path command has it: radii, rotation in degrees, flags, end. */
enum hatch_status hatch_svg_arc(struct hatch_svg_pen *pen, const double radii[2], double rotation_deg, bool large,
                                bool sweep, const double end[2], struct hatch_err *err) HATCH_MUST_USE;
/* Ends the line that there is, if there is one. */
enum hatch_status hatch_svg_end(struct hatch_svg_pen *pen, struct hatch_err *err) HATCH_MUST_USE;

/* All of a path's data ("m 3,4 l 5,6"). */
enum hatch_status hatch_svg_path(struct hatch_text data, struct hatch_svg_pen *pen,
                                 struct hatch_err *err) HATCH_MUST_USE;

/* The value of an element's attribute, which has names and values in turn and ends with NULL; empty where
 * it has none. */
struct hatch_text hatch_svg_attribute(const char *const *attributes, const char *name);

/* Draws a line, rect, circle, ellipse, polyline, polygon or path; *drawn is false for any other element. */
enum hatch_status hatch_svg_shape(const char *element, const char *const *attributes, double page,
                                  struct hatch_svg_pen *pen, bool *drawn, struct hatch_err *err) HATCH_MUST_USE;

#endif
