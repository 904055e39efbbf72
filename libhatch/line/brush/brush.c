#include "line/brush/brush.h"

#include <string.h>

#include "base/random.h"
#include "math/vector.h"

#define WAVE_PX 60.0  /* mean length of the waves along a line */
#define ANCHOR 4u     /* pieces from one place whose noise is computed to the next */
#define AVERAGED 6u   /* pieces before and after a piece over whose weights its own is averaged */
#define POINTED 0.15f /* width of a pointed end, as a share of the line's */
#define CHANNELS 4

/* Noises along a line, each -1 .. 1: of its width, its ink, its place across and up. */
struct noise {
    float value[CHANNELS];
};

/* State of one strip. */
struct work {
    const struct hatch_line_brush *brush;
    const struct hatch_line_strips *strips;
    const uint8_t *visible, *seen;
    double from_unit[3][3], scale; /* rows of the matrix from the unit scene to the item, whose mesh has size 1 there;
                                      lengths grow by scale */
    double origin[3];              /* of the item, in the unit scene */
    struct noise *noise;           /* per piece of all strips: at its start */
    float *before, *after;         /* per piece: length of the line up to its start, and from its end on */
    float *weight;                 /* per piece */
};

static void find_item(const struct hatch_item *item, double size, struct work *w)
{
    double columns[3][3];
    memset(w->from_unit, 0, sizeof w->from_unit);
    for (int k = 0; k < 3; k++)
        w->from_unit[k][k] = 1;
    w->scale = 1;
    if (item->deformed)
        return;
    for (int c = 0; c < 3; c++)
        for (int k = 0; k < 3; k++)
            columns[c][k] = size * (double)item->to_unit[4 * c + k];
    hatch_vec_of(item->to_unit + 12, w->origin);
    double cross[3];
    hatch_vec_cross(columns[0], columns[1], cross);
    double determinant = hatch_vec_dot(cross, columns[2]);
    if (!(fabs(determinant) > 1e-30))
        return;
    for (int r = 0; r < 3; r++) {
        hatch_vec_cross(columns[(r + 1) % 3], columns[(r + 2) % 3], cross);
        for (int k = 0; k < 3; k++)
            w->from_unit[r][k] = cross[k] / determinant;
    }
    w->scale = 1 / cbrt(fabs(determinant));
}

/* Adds smooth noise whose waves are 2^-octave long. */
static void add_waves(const double at[3], int octave, double share, struct noise *noise)
{
    double from[3];
    int64_t cell[3];
    for (int k = 0; k < 3; k++) {
        double scaled = ldexp(at[k], octave), low = floor(scaled);
        from[k] = scaled - low;
        from[k] *= from[k] * (3 - 2 * from[k]);
        cell[k] = (int64_t)fmin(fmax(low, -0x1p60), 0x1p60);
    }
    for (int corner = 0; corner < 8; corner++) {
        uint64_t number = (uint64_t)octave;
        double weight = share;
        for (int k = 0; k < 3; k++) {
            number = hatch_random_mix(number + (uint64_t)(cell[k] + (corner >> k & 1)) * 0x9e3779b97f4a7c15u);
            weight *= corner >> k & 1 ? from[k] : 1 - from[k];
        }
        for (int c = 0; c < CHANNELS; c++)
            noise->value[c] += (float)(weight * ((double)(number >> 16 * c & 0xffff) / 32767.5 - 1));
    }
}

/* Computes the noise at the start of a piece. Its waves keep about the same length in pixels: it fades from one octave
 * to the next. */
static struct noise noise_at(const struct work *w, const struct hatch_line_piece *piece)
{
    struct noise noise = {{0}};
    double place[3], from[3], at[3];
    hatch_vec_of(piece->place, place);
    hatch_vec_sub(place, w->origin, from);
    for (int r = 0; r < 3; r++)
        at[r] = hatch_vec_dot(w->from_unit[r], from);
    double octave = fmin(fmax(-log2(WAVE_PX * (double)piece->pixel * w->scale), -60), 60), low = floor(octave);
    add_waves(at, (int)low, 1 - (octave - low), &noise);
    add_waves(at, (int)low + 1, octave - low, &noise);
    return noise;
}

static void find_noise(const struct work *w, const struct hatch_line_strip *strip)
{
    const struct hatch_line_piece *pieces = w->strips->pieces + strip->first;
    struct noise *noise = w->noise + strip->first;
    const uint8_t *visible = w->visible + strip->first;
    for (uint32_t i = 0; i < strip->count; i += ANCHOR) {
        uint32_t next = i + ANCHOR < strip->count ? i + ANCHOR : strip->count - 1;
        bool any = false;
        for (uint32_t k = i; k <= next; k++)
            any = any || visible[k];
        if (!any)
            continue;
        noise[i] = noise_at(w, &pieces[i]);
        noise[next] = noise_at(w, &pieces[next]);
        for (uint32_t k = i + 1; k < next; k++)
            for (int c = 0; c < CHANNELS; c++) {
                float share = (float)(k - i) / (float)(next - i);
                noise[k].value[c] = noise[i].value[c] + share * (noise[next].value[c] - noise[i].value[c]);
            }
    }
}

static float length_of(const struct hatch_line_piece *piece)
{
    return hypotf(piece->b[0] - piece->a[0], piece->b[1] - piece->a[1]);
}

/* Measures the visible parts of a strip, in one direction.
 *   lengths  out: per piece of all strips */
static void measure(const struct work *w, const struct hatch_line_strip *strip, bool back, float *lengths)
{
    uint32_t steps = strip->closed ? 2 * strip->count : strip->count;
    float length = strip->closed || strip->joined[back ? 1 : 0] ? INFINITY : 0;
    for (uint32_t i = 0; i < steps; i++) {
        uint32_t at = strip->first + (back ? steps - 1 - i : i) % strip->count;
        lengths[at] = length;
        length = w->visible[at] ? length + length_of(&w->strips->pieces[at]) : 0;
    }
}

static void find_weights(const struct work *w, const struct hatch_line_strip *strip)
{
    for (uint32_t i = 0; i < strip->count; i++) {
        uint32_t low = i > AVERAGED ? i - AVERAGED : 0;
        float sum = 0, count = 0;
        for (uint32_t k = low; k < strip->count && k <= i + AVERAGED && w->visible[strip->first + i]; k++)
            if (w->seen[strip->first + k] & HATCH_LINE_VISIBLE) {
                sum += (float)(w->seen[strip->first + k] >> HATCH_LINE_WEIGHT_SHIFT);
                count += 1;
            }
        w->weight[strip->first + i] = count > 0 ? HATCH_LINE_WEIGHT_LEAST + HATCH_LINE_WEIGHT_STEP * sum / count : 1;
    }
}

/* Returns the share of the width that the pointed ends leave at a point.
 *   before, after  lengths of the line to both sides of it */
static float taper(const struct hatch_line_brush *brush, float before, float after)
{
    float reach = fminf(brush->taper_px, 0.3f * (before + after));
    float share = reach > 0 ? fminf(fminf(before, after) / reach, 1) : 1;
    return POINTED + (1 - POINTED) * share * (2 - share);
}

static void touch(const struct work *w, const struct hatch_line_strip *strip, struct hatch_line_touch *touches)
{
    for (uint32_t i = 0; i < strip->count; i++) {
        uint32_t at = strip->first + i, after = i + 1 < strip->count ? at + 1 : strip->closed ? strip->first : at;
        uint32_t before = i > 0 ? at - 1 : strip->closed ? strip->first + strip->count - 1 : at;
        uint32_t nodes[2] = {at, w->visible[after] ? after : at};
        float weights[2] = {0.5f * (w->weight[w->visible[before] ? before : at] + w->weight[at]),
                            0.5f * (w->weight[at] + w->weight[w->visible[after] ? after : at])};
        float length = length_of(&w->strips->pieces[at]);
        for (int end = 0; end < 2 && w->visible[at]; end++) {
            const float *noise = w->noise[nodes[end]].value;
            touches[at].width[end] =
                weights[end] * (1 + w->brush->vary * noise[0]) *
                taper(w->brush, w->before[at] + (end ? length : 0), w->after[at] + (end ? 0 : length));
            touches[at].ink[end] = 1 - w->brush->pressure * (0.5f - 0.5f * noise[1]);
            for (int k = 0; k < 2; k++)
                touches[at].beside[end][k] = w->brush->wobble_px * noise[2 + k];
        }
    }
}

enum hatch_status hatch_line_brush_touch(const struct hatch_line_brush *brush, const struct hatch_item *item,
                                         double size, const struct hatch_line_strips *strips, const uint8_t *visible,
                                         const uint8_t *seen, struct hatch_arena *arena,
                                         struct hatch_line_touch **touches, struct hatch_err *err)
{
    struct work work = {.brush = brush, .strips = strips, .visible = visible, .seen = seen};
    HATCH_TRY(HATCH_ALLOC(arena, touches, strips->piece_count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &work.noise, strips->piece_count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &work.before, strips->piece_count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &work.after, strips->piece_count, err));
    HATCH_TRY(HATCH_ALLOC(arena, &work.weight, strips->piece_count, err));
    find_item(item, size, &work);
    for (uint32_t s = 0; s < strips->strip_count; s++) {
        const struct hatch_line_strip *strip = &strips->strips[s];
        find_noise(&work, strip);
        find_weights(&work, strip);
        measure(&work, strip, false, work.before);
        measure(&work, strip, true, work.after);
        touch(&work, strip, *touches);
    }
    return HATCH_OK;
}
