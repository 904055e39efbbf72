#include "render-gl/technique/technique.h"

#include <stddef.h>

extern const struct technique technique_tam, technique_tam_flat, technique_tam_face, technique_tam_gouraud,
    technique_tam_triple, technique_tam_threshold, technique_gouraud, technique_rptam, technique_volume,
    technique_threshold, technique_threshold_soft, technique_probe, technique_patches, technique_field,
    technique_places;

const struct technique *const techniques[TECHNIQUE_COUNT] = {
    &technique_tam,        &technique_tam_flat,      &technique_tam_face,       &technique_tam_gouraud,
    &technique_tam_triple, &technique_tam_threshold, &technique_gouraud,        &technique_rptam,
    &technique_volume,     &technique_threshold,     &technique_threshold_soft, &technique_probe,
    &technique_patches,    &technique_field,         &technique_places};

const char *const *technique_names(void)
{
    static const char *names[TECHNIQUE_CHOICES + 1];
    for (size_t i = 0; i < TECHNIQUE_CHOICES; i++)
        names[i] = techniques[i]->name;
    return names;
}
