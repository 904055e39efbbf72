#include "tam/tam.h"

#include <stdio.h>
#include <string.h>

void hatch_tam_set_metadata(const struct hatch_tam_metadata *metadata, uint32_t tone, float target,
                            struct hatch_mipmap *column)
{
    snprintf(column->name, sizeof column->name, "tone.%03u", tone);
    hatch_mipmap_set_number(column, HATCH_TAM_ATTR_TONE, (double)target, HATCH_ATTRIBUTE_FLOAT);
    hatch_mipmap_set_number(column, HATCH_TAM_ATTR_TONES, metadata->tones, HATCH_ATTRIBUTE_INT);
    hatch_mipmap_set_number(column, HATCH_TAM_ATTR_LEVELS, metadata->levels, HATCH_ATTRIBUTE_INT);
    hatch_mipmap_set_number(column, HATCH_TAM_ATTR_GROWTH, (double)metadata->growth, HATCH_ATTRIBUTE_FLOAT);
    hatch_mipmap_set_text(column, HATCH_TAM_ATTR_SEED, metadata->seed);
    hatch_mipmap_set_text(column, HATCH_TAM_ATTR_STYLE, metadata->style);
    if (metadata->flat)
        hatch_mipmap_set_text(column, HATCH_TAM_ATTR_OVERLAP, HATCH_TAM_OVERLAP_FLAT);
    if (!metadata->whole.tones)
        return;
    hatch_mipmap_set_number(column, HATCH_TAM_ATTR_WHOLE_SIZE, metadata->whole.size_px, HATCH_ATTRIBUTE_INT);
    hatch_mipmap_set_number(column, HATCH_TAM_ATTR_WHOLE_TONES, metadata->whole.tones, HATCH_ATTRIBUTE_INT);
    hatch_mipmap_set_number(column, HATCH_TAM_ATTR_WHOLE_TONE, (double)metadata->whole.darkest, HATCH_ATTRIBUTE_FLOAT);
    hatch_mipmap_set_number(column, HATCH_TAM_ATTR_TOLERANCE, (double)metadata->whole.tolerance, HATCH_ATTRIBUTE_FLOAT);
}

static bool same_channels(const struct hatch_image *a, const struct hatch_image *b)
{
    if (a->channel_count != b->channel_count)
        return false;
    for (uint32_t c = 0; c < a->channel_count; c++)
        if (strcmp(a->channels[c].name, b->channels[c].name) != 0)
            return false;
    return true;
}

static enum hatch_status check_shape(const struct hatch_mipmap *part, const struct hatch_mipmap *first,
                                     struct hatch_err *err)
{
    const struct hatch_image *finest = &part->levels[0];
    if (finest->width != finest->height)
        return hatch_fail(err, HATCH_BAD_INPUT, "%ux%u pixels, want a square", finest->width, finest->height);
    if (finest->width != first->levels[0].width || part->level_count != first->level_count)
        return hatch_fail(err, HATCH_BAD_INPUT, "%u pixels and %u levels, but %s has %u pixels and %u levels",
                          finest->width, part->level_count, first->name, first->levels[0].width, first->level_count);
    uint32_t chain = hatch_mip_chain_length(finest->width, finest->height);
    if (part->level_count != chain)
        return hatch_fail(err, HATCH_BAD_INPUT, "%u mip levels, want the whole chain of %u", part->level_count, chain);
    bool grey = hatch_image_channel(finest, "Y") == 0;
    bool rgb = hatch_image_channel(finest, "R") == 0 && hatch_image_channel(finest, "G") == 1 &&
               hatch_image_channel(finest, "B") == 2;
    if (!grey && !rgb)
        return hatch_fail(err, HATCH_BAD_INPUT, "no channel Y, and no channels R, G and B");
    if (!same_channels(finest, &first->levels[0]))
        return hatch_fail(err, HATCH_BAD_INPUT, "channels differ from those of %s", first->name);
    return HATCH_OK;
}

/* Has no early exit, so that compilers vectorise it: maps are large. */
static bool all_finite(const float *numbers, size_t count)
{
    uint32_t non_finite = 0;
    for (size_t i = 0; i < count; i++) {
        uint32_t bits;
        memcpy(&bits, &numbers[i], sizeof bits);
        non_finite |= (bits & 0x7f800000u) == 0x7f800000u;
    }
    return !non_finite;
}

static enum hatch_status check_pixels(const struct hatch_mipmap *part, struct hatch_err *err)
{
    for (uint32_t level = 0; level < part->level_count; level++) {
        const struct hatch_image *image = &part->levels[level];
        if (!all_finite(image->pixels, (size_t)image->width * image->height * image->channel_count))
            return hatch_fail(err, HATCH_BAD_INPUT, "level %u: a pixel is not a finite number", level);
    }
    return HATCH_OK;
}

/* Checks the number of columns against the one that a column names, if it does. */
static enum hatch_status check_count(const struct hatch_mipmap *part, uint32_t count, struct hatch_err *err)
{
    const struct hatch_attribute *tones = hatch_mipmap_attribute(part, HATCH_TAM_ATTR_TONES);
    if (tones && tones->type != HATCH_ATTRIBUTE_INT)
        return hatch_fail(err, HATCH_BAD_INPUT, HATCH_TAM_ATTR_TONES " is not a whole number");
    if (tones && tones->number != count)
        return hatch_fail(err, HATCH_BAD_INPUT, HATCH_TAM_ATTR_TONES " %g, but the file has %u parts", tones->number,
                          count);
    return HATCH_OK;
}

static enum hatch_status check_attributes(const struct hatch_mipmap *part, struct hatch_tam *tam, uint32_t tone,
                                          struct hatch_err *err)
{
    const struct hatch_attribute *target = hatch_mipmap_attribute(part, HATCH_TAM_ATTR_TONE);
    const struct hatch_attribute *levels = hatch_mipmap_attribute(part, HATCH_TAM_ATTR_LEVELS);
    if (!target || target->type != HATCH_ATTRIBUTE_FLOAT)
        return hatch_fail(err, HATCH_BAD_INPUT, "no attribute " HATCH_TAM_ATTR_TONE);
    if (!(target->number >= 0 && target->number <= 1))
        return hatch_fail(err, HATCH_BAD_INPUT, HATCH_TAM_ATTR_TONE " %g, want 0 to 1", target->number);
    if (tone && !((float)target->number >= tam->target[tone - 1]))
        return hatch_fail(err, HATCH_BAD_INPUT, "tone %g is lighter than the column before it, %g", target->number,
                          (double)tam->target[tone - 1]);
    if (levels && levels->type != HATCH_ATTRIBUTE_INT)
        return hatch_fail(err, HATCH_BAD_INPUT, HATCH_TAM_ATTR_LEVELS " is not a whole number");
    if (levels && !(levels->number >= 1 && levels->number <= part->level_count))
        return hatch_fail(err, HATCH_BAD_INPUT, HATCH_TAM_ATTR_LEVELS " %g, want 1 to %u", levels->number,
                          part->level_count);
    tam->target[tone] = (float)target->number;
    uint32_t drawn = levels ? (uint32_t)levels->number : part->level_count;
    if (tone && drawn != tam->levels)
        return hatch_fail(err, HATCH_BAD_INPUT, "%u drawn levels, but the first column has %u", drawn, tam->levels);
    tam->levels = drawn;
    return HATCH_OK;
}

/* Reads an attribute of the first column that maps have which are not whole. */
static enum hatch_status read_whole(const struct hatch_mipmap *part, const char *name, enum hatch_attribute_type type,
                                    double low, double high, double *value, struct hatch_err *err)
{
    const struct hatch_attribute *attribute = hatch_mipmap_attribute(part, name);
    if (!attribute || attribute->type != type)
        return hatch_fail(err, HATCH_BAD_INPUT, "no attribute %s of its type", name);
    if (!(attribute->number >= low && attribute->number <= high))
        return hatch_fail(err, HATCH_BAD_INPUT, "%s %g, want %g to %g", name, attribute->number, low, high);
    *value = attribute->number;
    return HATCH_OK;
}

/* Sets tam->whole; the other members must be set. */
static enum hatch_status find_whole(struct hatch_tam *tam, struct hatch_err *err)
{
    const struct hatch_mipmap *part = &tam->columns[0];
    double last = (double)tam->target[tam->tones - 1], size = 0, tones = 0, darkest = 0, tolerance = 0;
    tam->whole = (struct hatch_tam_whole){.size_px = tam->size_px, .tones = tam->tones, .darkest = (float)last};
    if (!hatch_mipmap_attribute(part, HATCH_TAM_ATTR_WHOLE_TONES))
        return HATCH_OK;
    HATCH_TRY(
        read_whole(part, HATCH_TAM_ATTR_WHOLE_SIZE, HATCH_ATTRIBUTE_INT, tam->size_px, HATCH_TAM_SIZE_MAX, &size, err));
    HATCH_TRY(read_whole(part, HATCH_TAM_ATTR_WHOLE_TONES, HATCH_ATTRIBUTE_INT, tam->tones, HATCH_TAM_TONES_MAX, &tones,
                         err));
    HATCH_TRY(read_whole(part, HATCH_TAM_ATTR_WHOLE_TONE, HATCH_ATTRIBUTE_FLOAT, last, 1, &darkest, err));
    HATCH_TRY(read_whole(part, HATCH_TAM_ATTR_TOLERANCE, HATCH_ATTRIBUTE_FLOAT, 0, 1, &tolerance, err));
    tam->whole = (struct hatch_tam_whole){(uint32_t)size, (uint32_t)tones, (float)darkest, (float)tolerance};
    return HATCH_OK;
}

static bool is_flat(const struct hatch_mipmap *part)
{
    const struct hatch_attribute *overlap = hatch_mipmap_attribute(part, HATCH_TAM_ATTR_OVERLAP);
    return overlap && overlap->type == HATCH_ATTRIBUTE_TEXT && strcmp(overlap->text, HATCH_TAM_OVERLAP_FLAT) == 0;
}

bool hatch_tam_is_whole(const struct hatch_tam *tam)
{
    return tam->tones == tam->whole.tones && tam->size_px == tam->whole.size_px;
}

enum hatch_status hatch_tam_from_mipmaps(struct hatch_mipmap *parts, uint32_t count, struct hatch_tam *tam,
                                         struct hatch_err *err)
{
    if (count < 1 || count > HATCH_TAM_TONES_MAX)
        return hatch_fail(err, HATCH_BAD_INPUT, "%u parts, want 1 to %u tones", count, HATCH_TAM_TONES_MAX);
    struct hatch_tam made = {.tones = count, .columns = parts, .size_px = parts[0].levels[0].width};
    for (uint32_t tone = 0; tone < count; tone++) {
        char name[HATCH_NAME_MAX];
        snprintf(name, sizeof name, "tone.%03u", tone);
        if (strcmp(parts[tone].name, name) != 0)
            return hatch_fail(err, HATCH_BAD_INPUT, "part %u is named '%s', want %s: not a tonal art map", tone,
                              parts[tone].name, name);
        if (check_shape(&parts[tone], &parts[0], err) != HATCH_OK ||
            check_count(&parts[tone], count, err) != HATCH_OK ||
            check_attributes(&parts[tone], &made, tone, err) != HATCH_OK || check_pixels(&parts[tone], err) != HATCH_OK)
            return hatch_fail_at(err, "%s: ", name);
    }
    made.color = hatch_image_channel(&parts[0].levels[0], "R") == 0;
    made.ids = hatch_image_channel(&parts[0].levels[0], "id") >= 0;
    made.flat = is_flat(&parts[0]);
    if (find_whole(&made, err) != HATCH_OK)
        return hatch_fail_at(err, "%s: ", parts[0].name);
    *tam = made;
    return HATCH_OK;
}
