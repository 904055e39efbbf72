/* Footprints of drawn paths. Each pixel belongs to the nearest piece of the line, which determines its position along
 * and across; from there on the path is treated like a straight line. */
#include <assert.h>
#include <stdbool.h>

#include "stroke/footprint.h"
#include "stroke/frame.h"
#include "stroke/path.h"

/* Pieces shorter than this are joined before they are drawn; on coarse levels most are. */
#define PIECE_PX 0.25f

struct piece {
    float x, y;         /* start, px from the stroke's middle */
    float cosine, sine; /* direction */
    float length;       /* px */
    float start;        /* px along the whole line, from its middle */
    float stretch;      /* factor from lengths along the joined pieces, which cut corners, to lengths along the line */
    bool first, last;
};

/* Largest distance of a covered pixel's centre from the line, px, with a margin. */
static float reach_px(const struct hatch_frame *f)
{
    return f->half_width + 0.75f;
}

/* Adds the pixel, or assigns it to this piece if this piece is nearer. Until all pieces are drawn, out->along and
 * out->alpha hold the positions along and across, in px. */
static void assign_pixel(const struct hatch_frame *f, uint32_t at, float along, float across,
                         struct hatch_footprint *out)
{
    uint32_t *entry = &out->entry_of[at];
    if (*entry == 0) {
        assert(out->count < out->capacity);
        out->at[out->count] = at;
        *entry = ++out->count;
    } else {
        uint32_t i = *entry - 1;
        float beyond = fabsf(along) - f->core, beyond_before = fabsf(out->along[i]) - f->core;
        float square = across * across + (beyond > 0 ? beyond * beyond : 0);
        if (square >= out->alpha[i] * out->alpha[i] + (beyond_before > 0 ? beyond_before * beyond_before : 0))
            return;
    }
    out->along[*entry - 1] = along;
    out->alpha[*entry - 1] = across;
}

/* Assigns a pixel to the piece if the piece covers it. If the nearest point is an inner corner of the line, the
 * distance to the corner is taken as the position across.
 *   dx, dy  px from the start of the piece */
static void test_pixel(const struct hatch_frame *f, const struct piece *piece, uint32_t at, float dx, float dy,
                       struct hatch_footprint *out)
{
    float along = dx * piece->cosine + dy * piece->sine;
    float across = dy * piece->cosine - dx * piece->sine;
    float beyond = along < 0 && !piece->first ? along : 0;
    if (along > piece->length && !piece->last)
        beyond = along - piece->length;
    if (beyond != 0) {
        float distance = sqrtf(across * across + beyond * beyond);
        across = across < 0 ? -distance : distance;
    }
    float outside = fmaxf(-along, along - piece->length);
    if (fabsf(across) < f->half_width + 0.5f && (beyond != 0 || outside < f->half_width + 0.5f))
        assign_pixel(f, at, piece->start + (along - beyond) * piece->stretch, across, out);
}

static void draw_piece(const struct hatch_frame *f, const struct piece *piece, uint32_t size_px,
                       struct hatch_footprint *out)
{
    float reach = reach_px(f), half = piece->length / 2 + reach;
    float left = f->centre_x + piece->x, top = f->centre_y + piece->y;
    float run_x = piece->length * piece->cosine, run_y = piece->length * piece->sine;
    int32_t from_y = (int32_t)floorf(top + fminf(0, run_y) - reach - 0.5f);
    int32_t to_y = (int32_t)ceilf(top + fmaxf(0, run_y) + reach - 0.5f);
    for (int32_t y = from_y; y <= to_y; y++) {
        float dy = (float)y + 0.5f - top;
        float low = fminf(0, run_x) - reach, high = fmaxf(0, run_x) + reach;
        hatch_frame_clip(piece->cosine, piece->sine * dy - piece->length / 2, half, &low, &high);
        hatch_frame_clip(-piece->sine, piece->cosine * dy, reach, &low, &high);
        if (!(low <= high))
            continue;
        int32_t from = (int32_t)floorf(left + low - 0.5f), to = (int32_t)ceilf(left + high - 0.5f);
        uint32_t row = hatch_frame_wrap(y, size_px) * size_px, column = hatch_frame_wrap(from, size_px);
        for (int32_t x = from; x <= to; x++, column = column + 1 == size_px ? 0 : column + 1)
            test_pixel(f, piece, row + column, (float)x + 0.5f - left, dy, out);
    }
}

/* Advances to the next piece of at least PIECE_PX, or to the rest of the line. Returns false at the end.
 *   next  in and out: end point of the piece; 0 before the first */
static bool next_piece(const struct hatch_path *path, float size, uint32_t *next, struct piece *piece)
{
    piece->first = *next == 0;
    piece->x = path->xy[2 * *next] * size;
    piece->y = path->xy[2 * *next + 1] * size;
    while (++*next < path->count) {
        float dx = path->xy[2 * *next] * size - piece->x, dy = path->xy[2 * *next + 1] * size - piece->y;
        piece->length = sqrtf(dx * dx + dy * dy);
        piece->last = *next + 1 == path->count;
        if (piece->length >= PIECE_PX || (piece->last && piece->length > 0)) {
            piece->cosine = dx / piece->length;
            piece->sine = dy / piece->length;
            return true;
        }
    }
    return false;
}

static void draw_pieces(const struct hatch_stroke *stroke, const struct hatch_frame *f, uint32_t size_px,
                        struct hatch_footprint *out)
{
    float size = (float)size_px, whole = stroke->length * size, drawn = 0;
    struct piece piece = {.length = 0};
    for (uint32_t next = 0; next_piece(stroke->path, size, &next, &piece);)
        drawn += piece.length;
    piece.start = -whole / 2;
    piece.stretch = drawn > 0 ? whole / drawn : 1;
    if (!(drawn > 0)) { /* a closed line that is a dot at this size */
        piece = (struct piece){.x = piece.x, .y = piece.y, .cosine = 1, .stretch = 1, .first = true, .last = true};
        draw_piece(f, &piece, size_px, out);
    }
    for (uint32_t next = 0; next_piece(stroke->path, size, &next, &piece);) {
        draw_piece(f, &piece, size_px, out);
        piece.start += piece.length * piece.stretch;
    }
}

void hatch_footprint_draw_path(const struct hatch_stroke *stroke, const struct hatch_brush *brush,
                               const struct hatch_frame *frame, uint32_t size_px, struct hatch_footprint *footprint)
{
    draw_pieces(stroke, frame, size_px, footprint);
    uint32_t kept = 0;
    for (uint32_t i = 0; i < footprint->count; i++) {
        float along = footprint->along[i], alpha = hatch_frame_alpha(frame, brush, along, footprint->alpha[i]);
        footprint->entry_of[footprint->at[i]] = 0;
        if (!(alpha > 0))
            continue;
        float t = along * frame->per_length + 0.5f;
        footprint->at[kept] = footprint->at[i];
        footprint->alpha[kept] = alpha;
        footprint->along[kept++] = t < 0 ? 0 : t > 1 ? 1 : t;
    }
    footprint->count = kept;
}
