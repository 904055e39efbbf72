/* Styles and textures for tests of solid textures. */
#ifndef HATCH_TEST_SOLID_MADE_H
#define HATCH_TEST_SOLID_MADE_H

#include <string.h>

#include "arenas.h"
#include "solid/make.h"

static inline enum hatch_status parse_style(const char *text, struct hatch_solid_style *style)
{
    return hatch_solid_style_parse((struct hatch_bytes){(const uint8_t *)text, strlen(text)}, style, &err);
}

/* Makes a texture in keep. */
static inline struct hatch_solid make_solid(const char *text, uint32_t size, uint64_t seed, struct hatch_pool *pool)
{
    struct hatch_solid_style style = {0};
    struct hatch_solid solid;
    HATCH_TEST_OK(parse_style(text, &style), &err);
    const struct hatch_solid_options options = {.style = &style, .size = size, .seed = seed, .pool = pool};
    HATCH_TEST_OK(hatch_solid_from_style(&options, &keep, &scratch, &solid, &err), &err);
    return solid;
}

#endif
