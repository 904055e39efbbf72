/* Cleans up the visibility of pieces, and joins visible ones into segments. */
#include <string.h>

#include "line/strip.h"

/* Values of visible[] besides 0 and HATCH_LINE_VISIBLE. */
#define TRIMMED 2u
#define COVERED 3u /* hidden by no surface, but covered by a halo */

/* Returns piece i of a strip, counted from piece `start` and wrapping around. */
static uint32_t piece_at(const struct hatch_line_strip *strip, uint32_t start, uint32_t i)
{
    return strip->first + (start + i) % strip->count;
}

/* Returns the piece to start at: for a closed strip one at which visibility changes, so that no run is split. */
static uint32_t start_of(const struct hatch_line_strip *strip, const uint8_t *visible)
{
    for (uint32_t i = 1; i < strip->count && strip->closed; i++)
        if (visible[strip->first + i] != visible[strip->first + i - 1])
            return i;
    return 0;
}

static double length_of(const struct hatch_line_piece *piece)
{
    double x = (double)(piece->b[0] - piece->a[0]), y = (double)(piece->b[1] - piece->a[1]);
    return sqrt(x * x + y * y);
}

/* Inverts runs of `value` that are shorter than short_px. A run at an end of the strip is kept if the line may continue
 * there, because its length is then unknown. A gap at a free end is kept, too. */
static void drop_runs(const struct hatch_line_strips *strips, const struct hatch_line_strip *strip, uint8_t value,
                      double short_px, uint8_t *visible)
{
    uint32_t start = start_of(strip, visible), i = 0;
    while (i < strip->count) {
        uint32_t begin = i;
        double length = 0;
        while (i < strip->count && visible[piece_at(strip, start, i)] == value)
            length += length_of(&strips->pieces[piece_at(strip, start, i++)]);
        bool cut_off =
            (begin == 0 && (strip->joined[0] || !value)) || (i == strip->count && (strip->joined[1] || !value));
        if (strip->closed)
            cut_off = i - begin == strip->count && !value;
        for (uint32_t k = begin; k < i && !cut_off && length < short_px; k++)
            visible[piece_at(strip, start, k)] = !value;
        while (i < strip->count && visible[piece_at(strip, start, i)] != value)
            i++;
    }
}

/* Returns whether the piece before or after piece i of a strip is visible. */
static bool is_beside(const struct hatch_line_strip *strip, uint32_t i, const uint8_t *visible)
{
    uint32_t before = i > 0 ? i - 1 : strip->closed ? strip->count - 1 : i;
    uint32_t after = i + 1 < strip->count ? i + 1 : strip->closed ? 0 : i;
    return visible[strip->first + before] == HATCH_LINE_VISIBLE || visible[strip->first + after] == HATCH_LINE_VISIBLE;
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
            else if (remaining_px > 0)
                visible[at] = TRIMMED;
            remaining_px -= visible[at] ? length_of(&strips->pieces[at]) : 0;
        }
    }
    for (uint32_t i = strip->first; i < strip->first + count; i++)
        visible[i] = visible[i] == TRIMMED ? 0 : visible[i];
}

/* Keeps covered pieces only next to uncovered visible ones, and reduces visible[] to 0 and 1. */
static void keep_beside(const struct hatch_line_strip *strip, uint8_t *visible)
{
    for (uint32_t i = 0; i < strip->count; i++)
        if (visible[strip->first + i] == COVERED && !is_beside(strip, i, visible))
            visible[strip->first + i] = 0;
    for (uint32_t i = strip->first; i < strip->first + strip->count; i++)
        visible[i] = visible[i] != 0;
}

void hatch_line_strips_smooth(const struct hatch_line_strips *strips, double gap_px, double speck_px, double trim_px,
                              const uint8_t *seen, uint8_t *visible)
{
    for (uint32_t i = 0; i < strips->piece_count; i++)
        visible[i] = seen[i] & HATCH_LINE_VISIBLE;
    for (uint32_t s = 0; s < strips->strip_count; s++) {
        const struct hatch_line_strip *strip = &strips->strips[s];
        drop_runs(strips, strip, 0, gap_px, visible);
        for (uint32_t i = strip->first; i < strip->first + strip->count; i++)
            if (visible[i] && seen[i] & HATCH_LINE_COVERED)
                visible[i] = COVERED;
        drop_runs(strips, strip, HATCH_LINE_VISIBLE, speck_px, visible);
        trim_runs(strips, strip, trim_px, visible);
        keep_beside(strip, visible);
    }
}

/* Returns whether a halo may cover a part of a piece: halo tests are at the middles of pieces, so a halo at a
 * neighbour's middle may reach it. */
static bool near_halo(const struct hatch_line_strip *strip, uint32_t i, const uint8_t *seen)
{
    uint32_t last = strip->first + strip->count - 1;
    return ((seen[i] | seen[i > strip->first ? i - 1 : i] | seen[i < last ? i + 1 : i]) & HATCH_LINE_TOUCHED) != 0;
}

uint32_t hatch_line_strips_visible(const struct hatch_line_strips *strips, const uint8_t *visible, const uint8_t *seen,
                                   struct hatch_line_segment *segments)
{
    uint32_t count = 0;
    for (uint32_t s = 0; s < strips->strip_count; s++) {
        const struct hatch_line_strip *strip = &strips->strips[s];
        bool continues = false;
        for (uint32_t i = strip->first; i < strip->first + strip->count; i++) {
            const struct hatch_line_piece *piece = &strips->pieces[i];
            float in_halo = near_halo(strip, i, seen) ? 1.0f : 0.0f;
            continues = continues && visible[i] && piece->segment == piece[-1].segment &&
                        segments[count - 1].in_halo == in_halo;
            if (!visible[i])
                continue;
            if (!continues)
                segments[count++] = (struct hatch_line_segment){
                    .a = {piece->a[0], piece->a[1]}, .depth = {piece->depth[0]}, .in_halo = in_halo};
            struct hatch_line_segment *segment = &segments[count - 1];
            memcpy(segment->b, piece->b, sizeof segment->b);
            segment->depth[1] = piece->depth[1];
            continues = true;
        }
    }
    return count;
}
