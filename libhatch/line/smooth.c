/* From pieces that are hidden or not to lines without crumbs. */
#include <math.h>
#include <string.h>

#include "line/strip.h"

#define TRIMMED 2u
#define CUT 3u /* visible, but for a halo */

/* A closed strip is gone round from where visibility changes, so that no run is cut in two. */
static uint32_t piece_at(const struct hatch_line_strip *strip, uint32_t start, uint32_t i)
{
    return strip->first + (start + i) % strip->count;
}

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

/* Turns runs of `value` round that are shorter than short_px. A run that the strip's end cuts off is
 * as long as anything if the line is joined there, and stays; a gap at a free end stays, too. */
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

/* Whether what stays goes on before or after a piece, given by its number in the strip. */
static bool is_beside(const struct hatch_line_strip *strip, uint32_t i, const uint8_t *visible)
{
    uint32_t before = i > 0 ? i - 1 : strip->closed ? strip->count - 1 : i;
    uint32_t after = i + 1 < strip->count ? i + 1 : strip->closed ? 0 : i;
    return visible[strip->first + before] == HATCH_LINE_VISIBLE || visible[strip->first + after] == HATCH_LINE_VISIBLE;
}

/* Shortens visible runs where hidden ones follow. Marks what goes first, so that one run's end
 * is not taken for the next one's. */
static void trim_runs(const struct hatch_line_strips *strips, const struct hatch_line_strip *strip, double trim_px,
                      uint8_t *visible)
{
    uint32_t count = strip->count, steps = strip->closed ? 2 * count : count;
    for (int back = 0; back < 2; back++) {
        double left_px = 0;
        for (uint32_t i = 0; i < steps; i++) {
            uint32_t at = strip->first + (back ? steps - 1 - i : i) % count;
            if (visible[at] == 0)
                left_px = trim_px;
            else if (left_px > 0)
                visible[at] = TRIMMED;
            left_px -= visible[at] ? length_of(&strips->pieces[at]) : 0;
        }
    }
    for (uint32_t i = strip->first; i < strip->first + count; i++)
        visible[i] = visible[i] == TRIMMED ? 0 : visible[i];
}

/* What haloes cover is no more than the end of what they leave beside it. */
static void keep_beside(const struct hatch_line_strip *strip, uint8_t *visible)
{
    for (uint32_t i = 0; i < strip->count; i++)
        if (visible[strip->first + i] == CUT && !is_beside(strip, i, visible))
            visible[strip->first + i] = 0;
    for (uint32_t i = strip->first; i < strip->first + strip->count; i++)
        visible[i] = visible[i] != 0;
}

void hatch_line_strips_smooth(const struct hatch_line_strips *strips, double gap_px, double crumb_px, double trim_px,
                              const uint8_t *seen, uint8_t *visible)
{
    for (uint32_t i = 0; i < strips->piece_count; i++)
        visible[i] = seen[i] & HATCH_LINE_VISIBLE;
    for (uint32_t s = 0; s < strips->strip_count; s++) {
        const struct hatch_line_strip *strip = &strips->strips[s];
        drop_runs(strips, strip, 0, gap_px, visible);
        for (uint32_t i = strip->first; i < strip->first + strip->count; i++)
            if (visible[i] && seen[i] & HATCH_LINE_COVERED)
                visible[i] = CUT;
        drop_runs(strips, strip, HATCH_LINE_VISIBLE, crumb_px, visible);
        trim_runs(strips, strip, trim_px, visible);
        keep_beside(strip, visible);
    }
}

/* Fragments ask for haloes within their own piece, whose ends lie halfway to where the next ones were asked. */
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
        bool goes_on = false;
        for (uint32_t i = strip->first; i < strip->first + strip->count; i++) {
            const struct hatch_line_piece *piece = &strips->pieces[i];
            float in_halo = near_halo(strip, i, seen) ? 1.0f : 0.0f;
            goes_on =
                goes_on && visible[i] && piece->segment == piece[-1].segment && segments[count - 1].in_halo == in_halo;
            if (!visible[i])
                continue;
            if (!goes_on)
                segments[count++] = (struct hatch_line_segment){
                    .a = {piece->a[0], piece->a[1]}, .depth = {piece->depth[0]}, .in_halo = in_halo};
            struct hatch_line_segment *segment = &segments[count - 1];
            memcpy(segment->b, piece->b, sizeof segment->b);
            segment->depth[1] = piece->depth[1];
            goes_on = true;
        }
    }
    return count;
}
