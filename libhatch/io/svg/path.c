/* Draws with the pen, and reads path data (SVG 2, section 9.3). */
#include <assert.h>
#include <string.h>

#include "io/svg/parts.h"

#define PI 3.14159265358979323846

enum hatch_status hatch_svg_end(struct hatch_svg_pen *pen, struct hatch_err *err)
{
    enum hatch_status status = HATCH_OK;
    if (pen->line.count)
        status = pen->finish(pen->context, &pen->line, err);
    pen->line.count = 0;
    return status;
}

/* Adds the first point of a line unless it has one. A move does not add it, since a path may end with a move. */
static enum hatch_status begin_line(struct hatch_svg_pen *pen, struct hatch_err *err)
{
    double point[2];
    hatch_svg_apply(&pen->matrix, pen->x, pen->y, point);
    return pen->line.count ? HATCH_OK : hatch_path_add_line(&pen->line, point[0], point[1], err);
}

enum hatch_status hatch_svg_move(struct hatch_svg_pen *pen, double x, double y, struct hatch_err *err)
{
    HATCH_TRY(hatch_svg_end(pen, err));
    pen->x = x;
    pen->y = y;
    return HATCH_OK;
}

enum hatch_status hatch_svg_line(struct hatch_svg_pen *pen, double x, double y, struct hatch_err *err)
{
    double point[2];
    HATCH_TRY(begin_line(pen, err));
    hatch_svg_apply(&pen->matrix, x, y, point);
    pen->x = x;
    pen->y = y;
    return hatch_path_add_line(&pen->line, point[0], point[1], err);
}

enum hatch_status hatch_svg_cubic(struct hatch_svg_pen *pen, const double xy[6], struct hatch_err *err)
{
    double points[6];
    HATCH_TRY(begin_line(pen, err));
    for (int i = 0; i < 6; i += 2)
        hatch_svg_apply(&pen->matrix, xy[i], xy[i + 1], points + i);
    pen->x = xy[4];
    pen->y = xy[5];
    return hatch_path_add_cubic(&pen->line, points, err);
}

struct ellipse {
    double x, y, rx, ry, cosine, sine; /* centre, radii, rotation */
    double from, sweep;                /* start angle and signed extent of the arc, radians */
};

/* Converts an arc from its end points to its centre (SVG 2, appendix B.2.4). */
static struct ellipse ellipse_through(const struct hatch_svg_pen *pen, const double radii[2], double rotation_deg,
                                      bool large, bool sweep, const double end[2])
{
    struct ellipse e = {.rx = fabs(radii[0]), .ry = fabs(radii[1])};
    e.cosine = cos(rotation_deg * PI / 180);
    e.sine = sin(rotation_deg * PI / 180);
    double dx = (pen->x - end[0]) / 2, dy = (pen->y - end[1]) / 2;
    double x = (e.cosine * dx + e.sine * dy) / e.rx, y = (e.cosine * dy - e.sine * dx) / e.ry;
    double chord2 = x * x + y * y;
    if (chord2 > 1) { /* radii that are too small are enlarged */
        e.rx *= sqrt(chord2);
        e.ry *= sqrt(chord2);
        x /= sqrt(chord2);
        y /= sqrt(chord2);
        chord2 = 1;
    }
    /* With the ellipse scaled to the unit circle, (x, y) is half the chord, and the centre lies perpendicular to it. */
    double distance = chord2 > 0 ? sqrt((1 - chord2) / chord2) : 0;
    if (large == sweep)
        distance = -distance;
    double mx = distance * y, my = -distance * x;
    e.x = e.cosine * mx * e.rx - e.sine * my * e.ry + (pen->x + end[0]) / 2;
    e.y = e.sine * mx * e.rx + e.cosine * my * e.ry + (pen->y + end[1]) / 2;
    e.from = atan2(y - my, x - mx);
    e.sweep = atan2(-y - my, -x - mx) - e.from;
    if (sweep && e.sweep < 0)
        e.sweep += 2 * PI;
    else if (!sweep && e.sweep > 0)
        e.sweep -= 2 * PI;
    return e;
}

static void point_of(const struct ellipse *e, double x, double y, double *point)
{
    point[0] = e->x + e->cosine * e->rx * x - e->sine * e->ry * y;
    point[1] = e->y + e->sine * e->rx * x + e->cosine * e->ry * y;
}

enum hatch_status hatch_svg_arc(struct hatch_svg_pen *pen, const double radii[2], double rotation_deg, bool large,
                                bool sweep, const double end[2], struct hatch_err *err)
{
    if (pen->x == end[0] && pen->y == end[1])
        return HATCH_OK;
    if (radii[0] == 0 || radii[1] == 0)
        return hatch_svg_line(pen, end[0], end[1], err);
    struct ellipse e = ellipse_through(pen, radii, rotation_deg, large, sweep, end);
    uint32_t quarters = e.sweep < -1e-9 || e.sweep > 1e-9 ? (uint32_t)ceil(fabs(e.sweep) / (PI / 2) - 1e-9) : 1;
    double step = e.sweep / quarters, handle = 4.0 / 3 * tan(step / 4);
    for (uint32_t i = 0; i < quarters; i++) {
        double a = e.from + step * i, b = a + step, xy[6];
        point_of(&e, cos(a) - handle * sin(a), sin(a) + handle * cos(a), xy);
        point_of(&e, cos(b) + handle * sin(b), sin(b) - handle * cos(b), xy + 2);
        point_of(&e, cos(b), sin(b), xy + 4);
        if (i + 1 == quarters)
            memcpy(xy + 4, end, 2 * sizeof *end);
        HATCH_TRY(hatch_svg_cubic(pen, xy, err));
    }
    return HATCH_OK;
}

/* State of reading path data. */
struct reading {
    struct hatch_svg_pen *pen;
    double start[2];   /* start of the subpath */
    double control[2]; /* the previous command's last control point, for S and T */
    char last;         /* the previous command, upper case; 0: none */
};

static enum hatch_status quadratic(struct reading *r, const double *v, struct hatch_err *err)
{
    const struct hatch_svg_pen *pen = r->pen;
    double xy[6] = {pen->x + (v[0] - pen->x) * 2 / 3,
                    pen->y + (v[1] - pen->y) * 2 / 3,
                    v[2] + (v[0] - v[2]) * 2 / 3,
                    v[3] + (v[1] - v[3]) * 2 / 3,
                    v[2],
                    v[3]};
    memcpy(r->control, v, sizeof r->control);
    return hatch_svg_cubic(r->pen, xy, err);
}

static enum hatch_status cubic(struct reading *r, const double *v, struct hatch_err *err)
{
    memcpy(r->control, v + 2, sizeof r->control);
    return hatch_svg_cubic(r->pen, v, err);
}

/* Reflects the previous control point at the current point. If the previous command is not one of kinds, the result is
 * the current point. */
static void mirror(const struct reading *r, const char *kinds, double *point)
{
    bool smooth = r->last && strchr(kinds, r->last);
    point[0] = smooth ? 2 * r->pen->x - r->control[0] : r->pen->x;
    point[1] = smooth ? 2 * r->pen->y - r->control[1] : r->pen->y;
}

/* Draws a command whose coordinates are absolute. */
static enum hatch_status draw(struct reading *r, char command, double *v, struct hatch_err *err)
{
    struct hatch_svg_pen *pen = r->pen;
    double smooth[6];
    switch (command) {
    case 'M':
        memcpy(r->start, v, sizeof r->start);
        return hatch_svg_move(pen, v[0], v[1], err);
    case 'L':
        return hatch_svg_line(pen, v[0], v[1], err);
    case 'H':
        return hatch_svg_line(pen, v[0], pen->y, err);
    case 'V':
        return hatch_svg_line(pen, pen->x, v[0], err);
    case 'C':
        return cubic(r, v, err);
    case 'S':
        mirror(r, "CS", smooth);
        memcpy(smooth + 2, v, 4 * sizeof *v);
        return cubic(r, smooth, err);
    case 'Q':
        return quadratic(r, v, err);
    case 'T':
        mirror(r, "QT", smooth);
        memcpy(smooth + 2, v, 2 * sizeof *v);
        return quadratic(r, smooth, err);
    case 'A':
        return hatch_svg_arc(pen, v, v[2], v[3] != 0, v[4] != 0, v + 5, err);
    default: /* Z */
        HATCH_TRY(hatch_svg_line(pen, r->start[0], r->start[1], err));
        return hatch_svg_end(pen, err);
    }
}

/* Removes one flag of an arc. Flags may follow each other without a separator: "0 01 3,4". */
static bool take_flag(struct hatch_text *rest, double *flag)
{
    if (!rest->length || (*rest->at != '0' && *rest->at != '1'))
        return false;
    *flag = *rest->at - '0';
    rest->at++;
    rest->length--;
    hatch_svg_skip(rest);
    return true;
}

static bool take_values(struct hatch_text *rest, char command, uint32_t count, double *v)
{
    if (command != 'A')
        return hatch_svg_numbers(rest, count, v);
    return hatch_svg_numbers(rest, 3, v) && take_flag(rest, v + 3) && take_flag(rest, v + 4) &&
           hatch_svg_numbers(rest, 2, v + 5);
}

/* Makes a relative command's coordinates absolute. */
static void make_absolute(const struct hatch_svg_pen *pen, char command, uint32_t count, double *v)
{
    if (command == 'H' || command == 'V')
        v[0] += command == 'H' ? pen->x : pen->y;
    else
        for (uint32_t i = command == 'A' ? 5 : 0; i + 1 < count; i += 2) {
            v[i] += pen->x;
            v[i + 1] += pen->y;
        }
}

/* Returns whether path data are "none" and white space. */
static bool is_none(struct hatch_text data)
{
    while (data.length && strchr(" \t\r\n\f", data.at[data.length - 1]))
        data.length--;
    return hatch_text_is(data, "none");
}

enum hatch_status hatch_svg_path(struct hatch_text data, struct hatch_svg_pen *pen, struct hatch_err *err)
{
    static const char commands[] = "MLHVCSQTAZ", counts[] = "2211644270";
    struct reading r = {.pen = pen};
    struct hatch_text rest = data;
    char letter = 0;
    hatch_svg_skip(&rest);
    if (is_none(rest))
        rest.length = 0;
    while (rest.length) {
        char first = *rest.at;
        bool repeated = letter && first != 0 && strchr("+-.0123456789", first);
        if (!repeated)
            letter = first;
        char upper = (char)(letter >= 'a' && letter <= 'z' ? letter - 'a' + 'A' : letter);
        const char *known = upper ? strchr(commands, upper) : NULL;
        size_t at = (size_t)(rest.at - data.at);
        if (!known || (!r.last && upper != 'M') || (repeated && upper == 'Z'))
            return hatch_fail(err, HATCH_BAD_INPUT, "path data: unexpected '%c' at character %zu", first, at + 1);
        if (!repeated) {
            rest.at++;
            rest.length--;
            hatch_svg_skip(&rest);
        }
        uint32_t count = (uint32_t)(counts[known - commands] - '0');
        double v[7] = {0};
        if (!take_values(&rest, upper, count, v))
            return hatch_fail(err, HATCH_BAD_INPUT, "path data: a number is missing or malformed at character %zu",
                              (size_t)(rest.at - data.at) + 1);
        if (letter != upper)
            make_absolute(pen, upper, count, v);
        HATCH_TRY(draw(&r, upper, v, err));
        r.last = upper;
        if (upper == 'M') /* coordinates that follow are those of lines */
            letter = letter == 'M' ? 'L' : 'l';
    }
    return hatch_svg_end(pen, err);
}
