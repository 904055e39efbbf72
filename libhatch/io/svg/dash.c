/* Cuts lines into dashes (SVG 2, section 13.5.6). */
#include <string.h>

#include "io/svg/parts.h"

#define PATTERN_MAX 64u
#define END_TOLERANCE 1e-9 /* of the line: over the rounding of a million dashes, under a thousandth of one of them */

/* Position in the dash pattern while following a line. */
struct cutter {
    double lengths[2 * PATTERN_MAX]; /* in user units; dashes and gaps alternate, a dash first */
    double remaining;                /* rest of the current dash or gap, user units */
    double left;                     /* rest of the line in which dashes and gaps may end, user units */
    uint32_t count, current;         /* number of lengths; index of the current one: even for a dash, odd for a gap */
    const struct hatch_svg_style *style;
    struct hatch_svg_dasher *dasher;
};

/* Returns the length of a segment, which is given in tiles, in user units: before the transform of its element. */
static double length_before(const struct hatch_svg_matrix *m, const double from[2], const double to[2])
{
    double x = to[0] - from[0], y = to[1] - from[1];
    return hypot(m->d * x - m->c * y, m->a * y - m->b * x) / fabs(hatch_svg_determinant(m));
}

static double length_of(const struct hatch_svg_matrix *m, const struct hatch_path_builder *line)
{
    double sum = 0;
    for (uint32_t i = 1; i < line->count; i++)
        sum += length_before(m, line->xy + 2 * i - 2, line->xy + 2 * i);
    return sum;
}

/* Reads the pattern and applies its offset.
 *   page  side of the page in user units, for percentages
 *   sum   out: length of the pattern, user units; 0: the line has no dashes */
static enum hatch_status read_pattern(struct cutter *cutter, double page, double *sum, struct hatch_err *err)
{
    *sum = 0;
    if (hatch_svg_lengths(cutter->style->dashes, page, PATTERN_MAX, cutter->lengths, &cutter->count, err) != HATCH_OK)
        return hatch_fail_at(err, "stroke-dasharray: ");
    for (uint32_t i = 0; i < cutter->count; i++) {
        if (!(cutter->lengths[i] >= 0))
            return hatch_fail(err, HATCH_BAD_INPUT, "stroke-dasharray: %g is negative", cutter->lengths[i]);
        *sum += cutter->lengths[i];
    }
    if (cutter->count % 2) { /* a pattern with an odd number of entries is repeated */
        memcpy(cutter->lengths + cutter->count, cutter->lengths, cutter->count * sizeof *cutter->lengths);
        cutter->count *= 2;
        *sum *= 2;
    }
    if (!(*sum > 0))
        return HATCH_OK;
    double at = fmod(cutter->style->dash_offset, *sum);
    at += at < 0 ? *sum : 0;
    cutter->current = 0;
    /* A dash of length 0 at the start is kept: with caps it is a dot. */
    while (cutter->current + 1 < cutter->count && at >= cutter->lengths[cutter->current] &&
           (at > 0 || cutter->current % 2))
        at -= cutter->lengths[cutter->current++];
    cutter->remaining = fmax(cutter->lengths[cutter->current] - at, 0);
    return HATCH_OK;
}

static enum hatch_status end_dash(struct cutter *cutter, struct hatch_err *err)
{
    enum hatch_status status = HATCH_OK;
    struct hatch_svg_dasher *dasher = cutter->dasher;
    if (dasher->dash.count) {
        dasher->count++;
        status = dasher->finish(dasher->context, &dasher->dash, err);
    }
    dasher->dash.count = 0;
    return status;
}

/* Ends the current dash or gap at (x, y) and begins the next. */
static enum hatch_status advance(struct cutter *cutter, double x, double y, struct hatch_err *err)
{
    if (cutter->current % 2 == 0) {
        HATCH_TRY(hatch_path_add_line(&cutter->dasher->dash, x, y, err));
        HATCH_TRY(end_dash(cutter, err));
    }
    cutter->current = (cutter->current + 1) % cutter->count;
    cutter->remaining = cutter->lengths[cutter->current];
    return cutter->current % 2 ? HATCH_OK : hatch_path_add_line(&cutter->dasher->dash, x, y, err);
}

/* Follows a segment. A dash or gap that ends within the tolerance of the line's end lasts to that end: the next one
 * would be a dot that only rounding made. */
static enum hatch_status cut(struct cutter *cutter, const double from[2], const double to[2], struct hatch_err *err)
{
    double length = length_before(&cutter->style->matrix, from, to), at = 0;
    while (length - at > cutter->remaining && cutter->left - at > cutter->remaining) {
        at += cutter->remaining;
        double t = at / length;
        HATCH_TRY(advance(cutter, from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1]), err));
    }
    cutter->remaining -= length - at;
    cutter->left -= length;
    return cutter->current % 2 ? HATCH_OK : hatch_path_add_line(&cutter->dasher->dash, to[0], to[1], err);
}

enum hatch_status hatch_svg_dash(struct hatch_svg_dasher *dasher, const struct hatch_path_builder *line,
                                 const struct hatch_svg_style *style, double page, struct hatch_err *err)
{
    struct cutter cutter = {.style = style, .dasher = dasher};
    struct hatch_path_builder solid = *line;
    double sum = 0;
    if (style->dashes.length)
        HATCH_TRY(read_pattern(&cutter, page, &sum, err));
    if (!(sum > 0) || line->count < 2)
        return dasher->finish(dasher->context, &solid, err);
    double length = length_of(&style->matrix, line);
    if (!(length / sum * cutter.count + dasher->count < HATCH_SVG_DASHES_MAX))
        return hatch_fail(err, HATCH_LIMIT, "more than %u dashes", HATCH_SVG_DASHES_MAX);
    cutter.left = length * (1 - END_TOLERANCE);
    dasher->dash.count = 0;
    if (cutter.current % 2 == 0)
        HATCH_TRY(hatch_path_add_line(&dasher->dash, line->xy[0], line->xy[1], err));
    for (uint32_t i = 1; i < line->count; i++)
        HATCH_TRY(cut(&cutter, line->xy + 2 * i - 2, line->xy + 2 * i, err));
    return end_dash(&cutter, err);
}
