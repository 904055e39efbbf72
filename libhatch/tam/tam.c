#include "tam/tam.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

void hatch_tam_label(uint32_t tone, float target, uint32_t levels, uint64_t seed,
                     struct hatch_mipmap *column)
{
    snprintf(column->name, sizeof column->name, "tone.%03u", tone);
    hatch_mipmap_set_number(column, HATCH_TAM_ATTR_TONE, (double)target, HATCH_ATTRIBUTE_FLOAT);
    hatch_mipmap_set_number(column, HATCH_TAM_ATTR_LEVELS, levels, HATCH_ATTRIBUTE_INT);
    hatch_mipmap_set_number(column, HATCH_TAM_ATTR_SEED, (double)seed, HATCH_ATTRIBUTE_INT);
}
