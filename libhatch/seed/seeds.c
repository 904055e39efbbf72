#include "seed/seeds.h"

#include "base/text.h"

void hatch_seed_points(const struct hatch_seed_set *set, struct hatch_seed_point *points)
{
    /* The last point is built bit by bit; each point before it has one more crumb in front. */
    struct hatch_seed_point point = {0, 0};
    for (uint64_t k = 0; k < 64; k++) {
        uint8_t crumb = set->crumbs[(set->count - 1u + k) % set->count];
        point.u = point.u << 1 | (crumb & 1u);
        point.v = point.v << 1 | crumb >> 1;
    }
    points[set->count - 1] = point;
    for (uint32_t i = set->count - 1; i-- > 0;) {
        point.u = point.u >> 1 | (uint64_t)(set->crumbs[i] & 1u) << 63;
        point.v = point.v >> 1 | (uint64_t)(set->crumbs[i] >> 1) << 63;
        points[i] = point;
    }
}

static enum hatch_status read_layer(struct hatch_text line, uint32_t number, struct hatch_arena *arena,
                                    struct hatch_seed_set *set, struct hatch_err *err)
{
    if (line.length < HATCH_CYCLE_MIN || line.length > HATCH_CYCLE_MAX)
        return hatch_fail(err, HATCH_BAD_INPUT, "line %u: a seed set of %zu digits, want %u to %u", number, line.length,
                          HATCH_CYCLE_MIN, HATCH_CYCLE_MAX);
    set->count = (uint32_t)line.length;
    HATCH_TRY(HATCH_ALLOC(arena, &set->crumbs, line.length, err));
    for (size_t i = 0; i < line.length; i++) {
        if (line.at[i] < '0' || line.at[i] > '3')
            return hatch_fail(err, HATCH_BAD_INPUT, "line %u, column %zu: want 0, 1, 2 or 3", number, i + 1);
        set->crumbs[i] = (uint8_t)(line.at[i] - '0');
    }
    return HATCH_OK;
}

enum hatch_status hatch_seeds_read(struct hatch_bytes file, struct hatch_arena *arena, struct hatch_seeds *seeds,
                                   struct hatch_err *err)
{
    struct hatch_text rest = hatch_text_of(file), line;
    struct hatch_seeds found = {0};
    HATCH_TRY(HATCH_ALLOC(arena, &found.layers, HATCH_SEED_LAYERS_MAX, err));
    for (uint32_t number = 1; hatch_text_line(&rest, &line); number++) {
        if (line.length == 0 || line.at[0] == '#')
            continue;
        if (line.at + line.length == (const char *)file.data + file.size)
            return hatch_fail(err, HATCH_BAD_INPUT, "line %u has no end: the file is truncated", number);
        if (found.layer_count == HATCH_SEED_LAYERS_MAX)
            return hatch_fail(err, HATCH_LIMIT, "line %u: more than %u layers", number, HATCH_SEED_LAYERS_MAX);
        HATCH_TRY(read_layer(line, number, arena, &found.layers[found.layer_count], err));
        found.layer_count++;
    }
    if (!found.layer_count)
        return hatch_fail(err, HATCH_BAD_INPUT, "the file has no seed set");
    *seeds = found;
    return HATCH_OK;
}

enum hatch_status hatch_seeds_write(const struct hatch_seeds *seeds, const char *comment, struct hatch_buffer *file,
                                    struct hatch_err *err)
{
    if (comment)
        HATCH_TRY(hatch_buffer_print(file, err, "# %s\n", comment));
    for (uint32_t i = 0; i < seeds->layer_count; i++) {
        const struct hatch_seed_set *set = &seeds->layers[i];
        HATCH_TRY(hatch_buffer_reserve(file, (size_t)set->count + 1, err));
        for (uint32_t k = 0; k < set->count; k++)
            file->data[file->size++] = (uint8_t)('0' + set->crumbs[k]);
        file->data[file->size++] = '\n';
    }
    return HATCH_OK;
}
