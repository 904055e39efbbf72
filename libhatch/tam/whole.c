#include "tam/whole.h"

#include <stdio.h>
#include <string.h>

#include "base/text.h"
#include "image/texels.h"

void hatch_tam_whole_print(const struct hatch_tam *tam, struct hatch_tam_whole_keys *keys)
{
    const struct hatch_tam_whole *whole = &tam->whole;
    static const char *const names[4] = {HATCH_TAM_ATTR_WHOLE_SIZE, HATCH_TAM_ATTR_WHOLE_TONE, HATCH_TAM_ATTR_LAST_TONE,
                                         HATCH_TAM_ATTR_TOLERANCE};
    const double values[4] = {whole->size_px, (double)whole->darkest, (double)tam->target[tam->tones - 1],
                              (double)whole->tolerance};
    keys->pairs[0] = NULL;
    for (int i = 0; i < 4 && !hatch_tam_is_whole(tam); i++) {
        snprintf(keys->values[i], sizeof keys->values[i], "%.9g", values[i]);
        keys->pairs[2 * i] = names[i];
        keys->pairs[2 * i + 1] = keys->values[i];
        keys->pairs[2 * i + 2] = NULL;
    }
}

static enum hatch_status read_key(const char *const *key_values, const char *key, double low, double high,
                                  double *value, struct hatch_err *err)
{
    const char *text = hatch_texels_value(key_values, key);
    if (!text || !hatch_text_number((struct hatch_text){text, strlen(text)}, value) ||
        !(*value >= low && *value <= high))
        return hatch_fail(err, HATCH_BAD_INPUT, "%s '%s': want a number from %g to %g", key, text ? text : "", low,
                          high);
    return HATCH_OK;
}

enum hatch_status hatch_tam_whole_read(const char *const *key_values, uint32_t size_px, struct hatch_tam_whole *whole,
                                       float *last, struct hatch_err *err)
{
    double size, darkest, tone, tolerance;
    if (!hatch_texels_value(key_values, HATCH_TAM_ATTR_TOLERANCE)) {
        *whole = (struct hatch_tam_whole){.size_px = size_px};
        return HATCH_OK;
    }
    HATCH_TRY(read_key(key_values, HATCH_TAM_ATTR_WHOLE_SIZE, size_px, HATCH_TAM_SIZE_MAX, &size, err));
    HATCH_TRY(read_key(key_values, HATCH_TAM_ATTR_WHOLE_TONE, 0, 1, &darkest, err));
    HATCH_TRY(read_key(key_values, HATCH_TAM_ATTR_LAST_TONE, 0, darkest, &tone, err));
    HATCH_TRY(read_key(key_values, HATCH_TAM_ATTR_TOLERANCE, 1e-6, 1, &tolerance, err));
    *whole =
        (struct hatch_tam_whole){.size_px = (uint32_t)size, .darkest = (float)darkest, .tolerance = (float)tolerance};
    *last = (float)tone;
    return HATCH_OK;
}

void hatch_tam_cut(struct hatch_tam *tam, uint32_t tones, uint32_t finer, double tolerance)
{
    for (uint32_t i = 0; i < tones; i++) {
        tam->columns[i].levels += finer;
        tam->columns[i].level_count -= finer;
    }
    tam->size_px = tam->columns[0].levels[0].width;
    tam->levels -= finer;
    tam->tones = tones;
    tam->whole.tolerance = (float)tolerance;
}
