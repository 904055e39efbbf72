#include "placement/place.h"

#define SHORTLIST 6u
#define COARSE_SAMPLES 24u

struct scored {
    float score;
    struct hatch_stroke stroke;
};

/* Inserts an entry into the list, which is sorted by score, the lowest first; of equal scores the earlier candidate
 * comes first. Returns the new length of the list. */
static uint32_t insert(struct scored *list, uint32_t count, const struct scored *entry)
{
    uint32_t at = count < SHORTLIST ? count : SHORTLIST - 1;
    if (count == SHORTLIST && !(entry->score < list[at].score))
        return count;
    for (; at > 0 && entry->score < list[at - 1].score; at--)
        list[at] = list[at - 1];
    list[at] = *entry;
    return count < SHORTLIST ? count + 1 : count;
}

static struct hatch_stroke moved_across(const struct hatch_stroke *stroke, float distance)
{
    struct hatch_stroke moved = *stroke;
    moved.x = hatch_stroke_wrap(stroke->x - (float)sin((double)stroke->angle_rad) * distance);
    moved.y = hatch_stroke_wrap(stroke->y + (float)cos((double)stroke->angle_rad) * distance);
    return moved;
}

/* Moves the stroke across its direction to a local minimum of the score, in halving steps. */
static struct scored descend(const struct hatch_potential *field, const struct hatch_stroke *stroke)
{
    struct scored best = {hatch_potential_score(field, stroke, UINT32_MAX), *stroke};
    for (float step = 4.0f / (float)field->size; step * (float)field->size > 0.4f; step /= 2)
        for (uint32_t tries = 0; tries < 4; tries++) {
            struct hatch_stroke ahead = moved_across(&best.stroke, step);
            struct hatch_stroke behind = moved_across(&best.stroke, -step);
            float score_ahead = hatch_potential_score(field, &ahead, UINT32_MAX);
            float score_behind = hatch_potential_score(field, &behind, UINT32_MAX);
            if (score_ahead < best.score && score_ahead <= score_behind)
                best = (struct scored){score_ahead, ahead};
            else if (score_behind < best.score)
                best = (struct scored){score_behind, behind};
            else
                break;
        }
    return best;
}

struct hatch_stroke hatch_place_by_field(const struct hatch_style *style, const struct hatch_potential *field,
                                         const struct hatch_choice *choice)
{
    struct scored list[SHORTLIST] = {{0}};
    uint32_t count = 0;
    for (uint32_t c = 0; c < choice->candidates; c++) {
        struct scored entry = {0, hatch_choice_candidate(style, choice, c)};
        entry.stroke.length *= choice->scale; /* it is scored at the size at which it will first be drawn */
        entry.stroke.bend_rad *= choice->scale;
        entry.score = hatch_potential_score(field, &entry.stroke, COARSE_SAMPLES);
        count = insert(list, count, &entry);
    }
    struct scored best = descend(field, &list[0].stroke);
    for (uint32_t i = 1; i < count; i++) {
        struct scored other = descend(field, &list[i].stroke);
        if (other.score < best.score)
            best = other;
    }
    best.stroke.length /= choice->scale;
    best.stroke.bend_rad /= choice->scale;
    return best.stroke;
}
