#include "render-gl/technique/list.h"

#define ENTRY(name) &technique_##name,
const struct technique *const techniques[] = {TECHNIQUES(ENTRY) NULL};

const struct technique *technique_find(enum technique_feature feature)
{
    uint32_t i = 0;
    while (!(techniques[i]->features & feature))
        i++;
    return techniques[i];
}
