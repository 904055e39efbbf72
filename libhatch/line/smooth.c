/* Cleans up the visibility of pieces, and joins visible ones into segments. */
#include <string.h>

#include "line/strip.h"

/* Values of visible[] besides 0, HATCH_LINE_VISIBLE and HATCH_LINE_BRIDGED. */
#define TRIMMED 3u
#define COVERED 4u    /* hidden by no surface, but covered by a halo */
#define FOLD_PX 16.0  /* length of the hidden part of a fold that is left out; less than HATCH_LINES_REACH_PX */
#define BRUSHED 6     /* most pieces of a segment that a brush draws */
#define FLAT_GAPS 3.0 /* gaps without a step are closed if they are shorter than this times other gaps */

/* Returns piece i of a strip, counted from piece `start` and wrapping around. */
static uint32_t piece_at(const struct hatch_line_strip *strip, uint32_t start, uint32_t i)
{
    return strip->first + (start + i) % strip->count;
}

static bool is_shown(uint8_t visible)
{
    return visible == HATCH_LINE_VISIBLE || visible == HATCH_LINE_BRIDGED;
}

/* Returns the piece to start at: for a closed strip one at which visibility changes, so that no run is split. */
static uint32_t start_of(const struct hatch_line_strip *strip, const uint8_t *visible)
{
    for (uint32_t i = 1; i < strip->count && strip->closed; i++)
        if (is_shown(visible[strip->first + i]) != is_shown(visible[strip->first + i - 1]))
            return i;
    return 0;
}

static double length_of(const struct hatch_line_piece *piece)
{
    double x = (double)(piece->b[0] - piece->a[0]), y = (double)(piece->b[1] - piece->a[1]);
    return sqrt(x * x + y * y);
}

/* Returns the distance between the pieces on both sides of a run. */
static double gap_of(const struct hatch_line_strips *strips, const struct hatch_line_strip *strip, uint32_t start,
                     uint32_t begin, uint32_t end)
{
    const struct hatch_line_piece *before = &strips->pieces[piece_at(strip, start, begin + strip->count - 1)];
    const struct hatch_line_piece *after = &strips->pieces[piece_at(strip, start, end)];
    double x = (double)(after->a[0] - before->b[0]), y = (double)(after->a[1] - before->b[1]);
    return sqrt(x * x + y * y);
}

/* Closes hidden runs between visible ones. */
static void close_gaps(const struct hatch_line_strips *strips, const struct hatch_line_strip *strip, double gap_px,
                       const uint8_t *seen, uint8_t *visible)
{
    uint32_t start = start_of(strip, visible), i = 0;
    while (i < strip->count) {
        while (i < strip->count && visible[piece_at(strip, start, i)])
            i++;
        uint32_t begin = i;
        double length = 0;
        bool flat = true;
        for (; i < strip->count && !visible[piece_at(strip, start, i)]; i++) {
            length += length_of(&strips->pieces[piece_at(strip, start, i)]);
            flat = flat && seen[piece_at(strip, start, i)] & HATCH_LINE_FLAT;
        }
        bool between = strip->closed ? i - begin < strip->count : begin > 0 && i < strip->count;
        if (!between || i == begin)
            continue;
        bool whole = length < (flat ? FLAT_GAPS * gap_px : gap_px);
        bool narrow = length < FOLD_PX && gap_of(strips, strip, start, begin, i) < gap_px;
        for (uint32_t k = begin; k < i && (whole || narrow); k++)
            visible[piece_at(strip, start, k)] = whole ? HATCH_LINE_VISIBLE : HATCH_LINE_BRIDGED;
    }
}

/* Hides visible runs that are shorter than short_px. A run at an end of the strip is kept if the line may continue
 * there, because its length is then unknown. */
static void drop_specks(const struct hatch_line_strips *strips, const struct hatch_line_strip *strip, double short_px,
                        uint8_t *visible)
{
    uint32_t start = start_of(strip, visible), i = 0;
    while (i < strip->count) {
        uint32_t begin = i;
        double length = 0;
        for (; i < strip->count && is_shown(visible[piece_at(strip, start, i)]); i++)
            if (visible[piece_at(strip, start, i)] == HATCH_LINE_VISIBLE)
                length += length_of(&strips->pieces[piece_at(strip, start, i)]);
        bool cut_off = !strip->closed && ((begin == 0 && strip->joined[0]) || (i == strip->count && strip->joined[1]));
        for (uint32_t k = begin; k < i && !cut_off && length < short_px; k++)
            visible[piece_at(strip, start, k)] = 0;
        i += i == begin;
    }
}

/* Finds the pieces before and after a piece of a strip: itself where an open strip ends. */
static void find_neighbours(const struct hatch_line_strip *strip, uint32_t piece, uint32_t neighbours[2])
{
    uint32_t first = strip->first, last = first + strip->count - 1;
    neighbours[0] = piece > first ? piece - 1 : strip->closed ? last : piece;
    neighbours[1] = piece < last ? piece + 1 : strip->closed ? first : piece;
}

/* Returns whether the piece before or after a piece of a strip is visible. */
static bool is_beside(const struct hatch_line_strip *strip, uint32_t piece, const uint8_t *visible)
{
    uint32_t at[2];
    find_neighbours(strip, piece, at);
    return visible[at[0]] == HATCH_LINE_VISIBLE || visible[at[1]] == HATCH_LINE_VISIBLE;
}

/* Shortens visible runs where they meet hidden ones. Trimmed pieces are only marked at first, so that the pass in the
 * other direction does not take them for hidden ones. */
static void trim_runs(const struct hatch_line_strips *strips, const struct hatch_line_strip *strip, double trim_px,
                      uint8_t *visible)
{
    uint32_t count = strip->count, steps = strip->closed ? 2 * count : count;
    for (int back = 0; back < 2; back++) {
        double remaining_px = 0;
        for (uint32_t i = 0; i < steps; i++) {
            uint32_t at = strip->first + (back ? steps - 1 - i : i) % count;
            if (visible[at] == 0)
                remaining_px = trim_px;
            else if (remaining_px > 0 && visible[at] != HATCH_LINE_BRIDGED)
                visible[at] = TRIMMED;
            remaining_px -= visible[at] ? length_of(&strips->pieces[at]) : 0;
        }
    }
    for (uint32_t i = strip->first; i < strip->first + count; i++)
        visible[i] = visible[i] == TRIMMED ? 0 : visible[i];
}

/* Keeps covered pieces only next to uncovered visible ones. */
static void keep_beside(const struct hatch_line_strip *strip, uint8_t *visible)
{
    for (uint32_t i = 0; i < strip->count; i++)
        if (visible[strip->first + i] == COVERED && !is_beside(strip, strip->first + i, visible))
            visible[strip->first + i] = 0;
    for (uint32_t i = strip->first; i < strip->first + strip->count; i++)
        visible[i] = visible[i] == COVERED ? HATCH_LINE_VISIBLE : visible[i];
}

void hatch_line_strips_smooth(const struct hatch_line_strips *strips, double gap_px, double speck_px, double trim_px,
                              const uint8_t *seen, uint8_t *visible)
{
    for (uint32_t i = 0; i < strips->piece_count; i++)
        visible[i] = seen[i] & HATCH_LINE_VISIBLE;
    for (uint32_t s = 0; s < strips->strip_count; s++) {
        const struct hatch_line_strip *strip = &strips->strips[s];
        close_gaps(strips, strip, gap_px, seen, visible);
        for (uint32_t i = strip->first; i < strip->first + strip->count; i++)
            if (visible[i] == HATCH_LINE_VISIBLE && seen[i] & HATCH_LINE_COVERED)
                visible[i] = COVERED;
        drop_specks(strips, strip, speck_px, visible);
        trim_runs(strips, strip, trim_px, visible);
        keep_beside(strip, visible);
    }
}

/* Returns whether a halo may cover a part of a piece: halo tests are at the middles of pieces, so a halo at a
 * neighbour's middle may reach it. */
static bool near_halo(const struct hatch_line_strip *strip, uint32_t piece, const uint8_t *seen)
{
    uint32_t at[2];
    find_neighbours(strip, piece, at);
    return ((seen[piece] | seen[at[0]] | seen[at[1]]) & HATCH_LINE_TOUCHED) != 0;
}

/* Returns the piece to begin at, so that no path is split where a closed strip happens to begin: a visible one after a
 * hidden one. */
static uint32_t first_of(const struct hatch_line_strip *strip, const uint8_t *visible)
{
    for (uint32_t i = 0; i < strip->count && strip->closed; i++)
        if (visible[piece_at(strip, 0, i)] == HATCH_LINE_VISIBLE && !visible[piece_at(strip, i, strip->count - 1)])
            return i;
    for (uint32_t i = 0; i < strip->count && strip->closed; i++)
        if (visible[piece_at(strip, 0, i)] == HATCH_LINE_VISIBLE)
            return i;
    return 0;
}

/* Pieces under way to segments. */
struct joining {
    const struct hatch_line_strips *strips;
    const struct hatch_line_touch *touches; /* per piece; NULL: none */
    struct hatch_line_segment *segments;
    uint32_t count;
};

/* Sets an end of a segment to that of a piece. */
static void set_end(const struct joining *joining, const struct hatch_line_piece *piece, int from, int to,
                    struct hatch_line_segment *segment)
{
    static const struct hatch_line_touch plain = {{1, 1}, {1, 1}, {{0, 0}, {0, 0}}};
    const struct hatch_line_touch *touch =
        joining->touches ? &joining->touches[piece - joining->strips->pieces] : &plain;
    for (int k = 0; k < 2; k++)
        (to ? segment->b : segment->a)[k] = (from ? piece->b : piece->a)[k] + touch->beside[from][k];
    segment->depth[to] = piece->depth[from];
    segment->width[to] = touch->width[from];
    segment->ink[to] = touch->ink[from];
}

/* Appends a segment. */
static void add_segment(struct joining *joining, const struct hatch_line_piece *from, int from_end,
                        const struct hatch_line_piece *to, int to_end, float in_halo)
{
    struct hatch_line_segment *segment = &joining->segments[joining->count++];
    segment->in_halo = in_halo;
    set_end(joining, from, from_end, 0, segment);
    set_end(joining, to, to_end, 1, segment);
}

/* Appends the segments of a strip. */
static void join_strip(struct joining *joining, const struct hatch_line_strip *strip, const uint8_t *visible,
                       const uint8_t *seen)
{
    const struct hatch_line_strips *strips = joining->strips;
    const struct hatch_line_piece *last = NULL;  /* the visible piece before, with none but bridged ones after it */
    const struct hatch_line_piece *first = NULL; /* of the segment */
    uint32_t start = first_of(strip, visible);
    bool bridged = false;
    for (uint32_t i = 0; i < strip->count; i++) {
        uint32_t at = piece_at(strip, start, i);
        const struct hatch_line_piece *piece = &strips->pieces[at];
        if (visible[at] != HATCH_LINE_VISIBLE) {
            bridged = visible[at] == HATCH_LINE_BRIDGED;
            last = bridged ? last : NULL;
            continue;
        }
        float in_halo = near_halo(strip, at, seen) ? 1.0f : 0.0f;
        bool continues = last && last + 1 == piece && last->segment == piece->segment &&
                         joining->segments[joining->count - 1].in_halo == in_halo &&
                         (!joining->touches || piece - first < BRUSHED);
        if (last && bridged)
            add_segment(joining, last, 1, piece, 0, in_halo);
        first = continues ? first : piece;
        if (continues)
            set_end(joining, piece, 1, 1, &joining->segments[joining->count - 1]);
        else
            add_segment(joining, piece, 0, piece, 1, in_halo);
        last = piece;
        bridged = false;
    }
    if (strip->closed && last && bridged)
        add_segment(joining, last, 1, &strips->pieces[piece_at(strip, start, 0)], 0, 0);
}

uint32_t hatch_line_strips_visible(const struct hatch_line_strips *strips, const uint8_t *visible, const uint8_t *seen,
                                   const struct hatch_line_touch *touches, struct hatch_line_segment *segments)
{
    struct joining joining = {strips, touches, segments, 0};
    for (uint32_t s = 0; s < strips->strip_count; s++)
        join_strip(&joining, &strips->strips[s], visible, seen);
    return joining.count;
}
