/* The pen and the grammar of path data. */
#include <assert.h>
#include <math.h>
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

/* The line's first point is set when something is drawn from it: a path may end with a move. */
static enum hatch_status begin_line(struct hatch_svg_pen *pen, struct hatch_err *err)
{
    double place[2];
    hatch_svg_apply(&pen->matrix, pen->x, pen->y, place);
    return pen->line.count ? HATCH_OK : hatch_path_add_line(&pen->line, place[0], place[1], err);
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
    double place[2];
    HATCH_TRY(begin_line(pen, err));
    hatch_svg_apply(&pen->matrix, x, y, place);
    pen->x = x;
    pen->y = y;
    return hatch_path_add_line(&pen->line, place[0], place[1], err);
}

enum hatch_status hatch_svg_cubic(struct hatch_svg_pen *pen, const double xy[6], struct hatch_err *err)
{
    double places[6];
    HATCH_TRY(begin_line(pen, err));
    for (int i = 0; i < 6; i += 2)
        hatch_svg_apply(&pen->matrix, xy[i], xy[i + 1], places + i);
    pen->x = xy[4];
    pen->y = xy[5];
    return hatch_path_add_cubic(&pen->line, places, err);
}

/* An ellipse's middle, from two points on it (SVG 2, appendix B.2.4). */
struct ellipse {
    double x, y, rx, ry, cosine, sine;
    double from, sweep; /* angles on it, radians */
};

static struct ellipse ellipse_through(const struct hatch_svg_pen *pen, const double radii[2], double rotation_deg,
                                      bool large, bool sweep, const double end[2])
{
    struct ellipse e = {.rx = fabs(radii[0]), .ry = fabs(radii[1])};
    e.cosine = cos(rotation_deg * PI / 180);
    e.sine = sin(rotation_deg * PI / 180);
    double dx = (pen->x - end[0]) / 2, dy = (pen->y - end[1]) / 2;
    double x = (e.cosine * dx + e.sine * dy) / e.rx, y = (e.cosine * dy - e.sine * dx) / e.ry;
    double short_of = x * x + y * y;
    if (short_of > 1) { /* radii that do not reach are scaled until they do */
        e.rx *= sqrt(short_of);
        e.ry *= sqrt(short_of);
        x /= sqrt(short_of);
        y /= sqrt(short_of);
        short_of = 1;
    }
    /* On the unit circle: (x, y) is half the chord, and the middle lies across it. */
    double aside = short_of > 0 ? sqrt((1 - short_of) / short_of) : 0;
    if (large == sweep)
        aside = -aside;
    double mx = aside * y, my = -aside * x;
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

static void point_of(const struct ellipse *e, double x, double y, double *place)
{
    place[0] = e->x + e->cosine * e->rx * x - e->sine * e->ry * y;
    place[1] = e->y + e->sine * e->rx * x + e->cosine * e->ry * y;
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

/* Where the grammar stands. */
struct reading {
    struct hatch_svg_pen *pen;
    double start[2];   /* of the subpath */
    double control[2]; /* the last one of the command before, for S and T */
    char last;         /* that command, upper case */
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

/* The last control point, mirrored at the pen; the pen where the command before was of another kind. */
static void mirror(const struct reading *r, const char *kinds, double *point)
{
    bool smooth = r->last && strchr(kinds, r->last);
    point[0] = smooth ? 2 * r->pen->x - r->control[0] : r->pen->x;
    point[1] = smooth ? 2 * r->pen->y - r->control[1] : r->pen->y;
}

/* One command with its numbers, in absolute places. */
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

/* The two flags of an arc may stand without anything between them: "0 01 3,4". */
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

/* Turns a relative command's numbers into absolute ones. */
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

enum hatch_status hatch_svg_path(struct hatch_text data, struct hatch_svg_pen *pen, struct hatch_err *err)
{
    static const char commands[] = "MLHVCSQTAZ", counts[] = "2211644270";
    struct reading r = {.pen = pen};
    struct hatch_text rest = data;
    char letter = 0;
    hatch_svg_skip(&rest);
    while (rest.length) {
        char first = *rest.at;
        bool again = letter && first != 0 && strchr("+-.0123456789", first);
        if (!again)
            letter = first;
        char upper = (char)(letter >= 'a' && letter <= 'z' ? letter - 'a' + 'A' : letter);
        const char *known = upper ? strchr(commands, upper) : NULL;
        size_t at = (size_t)(rest.at - data.at);
        if (!known || (!r.last && upper != 'M') || (again && upper == 'Z'))
            return hatch_fail(err, HATCH_BAD_INPUT, "path data: '%c' at character %zu", first, at + 1);
        if (!again) {
            rest.at++;
            rest.length--;
            hatch_svg_skip(&rest);
        }
        uint32_t count = (uint32_t)(counts[known - commands] - '0');
        double v[7] = {0};
        if (!take_values(&rest, upper, count, v))
            return hatch_fail(err, HATCH_BAD_INPUT, "path data: a number is missing or wrong at character %zu",
                              (size_t)(rest.at - data.at) + 1);
        if (letter != upper)
            make_absolute(pen, upper, count, v);
        HATCH_TRY(draw(&r, upper, v, err));
        r.last = upper;
        if (upper == 'M') /* more numbers are lines */
            letter = letter == 'M' ? 'L' : 'l';
    }
    return hatch_svg_end(pen, err);
}
