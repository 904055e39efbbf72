/* Dashes (SVG 2, section 13.5.6). */
#include <math.h>
#include <string.h>

#include "io/svg/parts.h"

#define PATTERN_MAX 64u

/* A line on which dashes and gaps take turns. */
struct cutter {
    double lengths[2 * PATTERN_MAX], left; /* of the dash or gap that the place is in */
    uint32_t count, now;                   /* even: a dash */
    const struct hatch_svg_look *look;
    struct hatch_path_builder *dash;
    uint32_t *made;
    enum hatch_status (*finish)(void *context, struct hatch_path_builder *line, struct hatch_err *err);
    void *context;
};

static double length_of(const struct hatch_path_builder *line)
{
    double sum = 0;
    for (uint32_t i = 1; i < line->count; i++)
        sum += hypot(line->xy[2 * i] - line->xy[2 * i - 2], line->xy[2 * i + 1] - line->xy[2 * i - 1]);
    return sum;
}

/* The pattern in the line's units, and where it begins; *sum 0: the line is whole. */
static enum hatch_status read_pattern(struct cutter *cutter, double page, double scale, double *sum,
                                      struct hatch_err *err)
{
    *sum = 0;
    HATCH_TRY(hatch_svg_lengths(cutter->look->dashes, page, PATTERN_MAX, cutter->lengths, &cutter->count, err));
    for (uint32_t i = 0; i < cutter->count; i++) {
        if (!(cutter->lengths[i] >= 0))
            return hatch_fail(err, HATCH_BAD_INPUT, "stroke-dasharray: %g is negative", cutter->lengths[i]);
        *sum += cutter->lengths[i] *= scale;
    }
    if (cutter->count % 2) { /* an odd number is taken twice */
        memcpy(cutter->lengths + cutter->count, cutter->lengths, cutter->count * sizeof *cutter->lengths);
        cutter->count *= 2;
        *sum *= 2;
    }
    if (!(*sum > 0))
        return HATCH_OK;
    double at = fmod(cutter->look->dash_offset * scale, *sum);
    at += at < 0 ? *sum : 0;
    cutter->now = 0;
    /* a dash without a length, which may be a dot, is not passed by beginning at it */
    while (cutter->now + 1 < cutter->count && at >= cutter->lengths[cutter->now] && (at > 0 || cutter->now % 2))
        at -= cutter->lengths[cutter->now++];
    cutter->left = fmax(cutter->lengths[cutter->now] - at, 0);
    return HATCH_OK;
}

static enum hatch_status end_dash(struct cutter *cutter, struct hatch_err *err)
{
    enum hatch_status status = HATCH_OK;
    if (cutter->dash->count) {
        ++*cutter->made;
        status = cutter->finish(cutter->context, cutter->dash, err);
    }
    cutter->dash->count = 0;
    return status;
}

/* At the end of a dash or a gap: the next one begins. */
static enum hatch_status turn(struct cutter *cutter, double x, double y, struct hatch_err *err)
{
    if (cutter->now % 2 == 0) {
        HATCH_TRY(hatch_path_add_line(cutter->dash, x, y, err));
        HATCH_TRY(end_dash(cutter, err));
    }
    cutter->now = (cutter->now + 1) % cutter->count;
    cutter->left = cutter->lengths[cutter->now];
    return cutter->now % 2 ? HATCH_OK : hatch_path_add_line(cutter->dash, x, y, err);
}

static enum hatch_status cut(struct cutter *cutter, const double from[2], const double to[2], struct hatch_err *err)
{
    double length = hypot(to[0] - from[0], to[1] - from[1]), at = 0;
    while (length - at > cutter->left) {
        at += cutter->left;
        double share = at / length;
        HATCH_TRY(turn(cutter, from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1]), err));
    }
    cutter->left -= length - at;
    return cutter->now % 2 ? HATCH_OK : hatch_path_add_line(cutter->dash, to[0], to[1], err);
}

enum hatch_status hatch_svg_dash(const struct hatch_path_builder *line, const struct hatch_svg_look *look, double page,
                                 double scale, struct hatch_path_builder *dash, uint32_t *made,
                                 enum hatch_status (*finish)(void *context, struct hatch_path_builder *line,
                                                             struct hatch_err *err),
                                 void *context, struct hatch_err *err)
{
    struct cutter cutter = {.look = look, .dash = dash, .made = made, .finish = finish, .context = context};
    struct hatch_path_builder whole = *line;
    double sum = 0;
    if (look->dashes.length)
        HATCH_TRY(read_pattern(&cutter, page, scale, &sum, err));
    if (!(sum > 0) || line->count < 2)
        return finish(context, &whole, err);
    if (!(length_of(line) / sum * cutter.count + *made < HATCH_SVG_DASHES_MAX))
        return hatch_fail(err, HATCH_LIMIT, "more than %u dashes", HATCH_SVG_DASHES_MAX);
    dash->count = 0;
    if (cutter.now % 2 == 0)
        HATCH_TRY(hatch_path_add_line(dash, line->xy[0], line->xy[1], err));
    for (uint32_t i = 1; i < line->count; i++)
        HATCH_TRY(cut(&cutter, line->xy + 2 * i - 2, line->xy + 2 * i, err));
    return end_dash(&cutter, err);
}
