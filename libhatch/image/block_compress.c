#include "image/block_compress.h"

#include <assert.h>
#include <math.h>

#include "image/block_codes.h"

#define SIDE HATCH_BLOCK_SIDE
#define TEXELS (SIDE * SIDE)

/* Errors of a block. */
struct errors {
    uint32_t squares, worst;
};

/* The work on one mip level; a task handles one row of blocks: of all layers or slices when packing, of one when
 * unpacking. */
struct job {
    const struct hatch_texels *plain, *packed;
    uint32_t level, width, height;
    uint32_t across, down; /* size in blocks */
    struct errors *last;   /* when packing, per place: those of the block in the layer before */
    struct sums {
        uint64_t squares;
        uint32_t worst;
        bool unknown; /* a block has an unknown mode */
    } * rows;
};

static uint32_t planes_of(const struct hatch_texels *texels, uint32_t level)
{
    return texels->depth ? hatch_mip_size(texels->depth, level) : texels->layers ? texels->layers : 1;
}

static struct job job_of(const struct hatch_texels *plain, const struct hatch_texels *packed, uint32_t level)
{
    struct job job = {.plain = plain, .packed = packed, .level = level};
    job.width = hatch_mip_size(plain->width, level);
    job.height = hatch_mip_size(plain->height, level);
    job.across = (job.width + SIDE - 1) / SIDE;
    job.down = (job.height + SIDE - 1) / SIDE;
    return job;
}

/* Returns a texel of a block in the plain texture; for a texel beyond the border, the nearest one within it. */
static uint8_t *texel_at(const struct job *job, uint32_t row, uint32_t block, uint32_t texel)
{
    uint32_t x = block * SIDE + texel % SIDE, y = row % job->down * SIDE + texel / SIDE;
    x = x < job->width ? x : job->width - 1;
    y = y < job->height ? y : job->height - 1;
    size_t at = ((size_t)(row / job->down) * job->height + y) * job->width + x;
    return job->plain->texels[job->level] + at * job->plain->channels;
}

static uint8_t *block_at(const struct job *job, uint32_t row, uint32_t block)
{
    uint32_t bytes = hatch_texels_block_bytes(job->packed->code, job->packed->channels);
    return job->packed->texels[job->level] + ((size_t)row * job->across + block) * bytes;
}

/* Copies the texels of a block; alpha is 255 in a texture without alpha. */
static void get_block(const struct job *job, uint32_t row, uint32_t block, uint8_t texels[TEXELS][4])
{
    const uint32_t channels = job->plain->channels, last = job->width - 1;
    for (uint32_t line = 0; line < TEXELS; line += SIDE) {
        const uint8_t *first = texel_at(job, row, block, line);
        for (uint32_t x = 0; x < SIDE; x++) {
            const uint8_t *from = first + (block * SIDE + x <= last ? x : last - block * SIDE) * channels;
            texels[line + x][3] = 255;
            for (uint32_t c = 0; c < channels; c++)
                texels[line + x][c] = from[c];
        }
    }
}

static struct errors compare(uint32_t channels, uint8_t before[TEXELS][4], uint8_t after[TEXELS][4])
{
    struct errors errors = {0, 0};
    for (uint32_t i = 0; i < TEXELS; i++)
        for (uint32_t c = 0; c < channels; c++) {
            uint32_t apart =
                (uint32_t)(before[i][c] > after[i][c] ? before[i][c] - after[i][c] : after[i][c] - before[i][c]);
            errors.squares += apart * apart;
            errors.worst = apart > errors.worst ? apart : errors.worst;
        }
    return errors;
}

/* Returns whether a block has the texels of that in the layer before. */
static bool is_repeated(const struct job *job, uint32_t row, uint32_t block)
{
    if (row < job->down)
        return false;
    const uint32_t across = job->width - block * SIDE < SIDE ? job->width - block * SIDE : SIDE;
    for (uint32_t line = 0; line < TEXELS; line += SIDE)
        if (memcmp(texel_at(job, row, block, line), texel_at(job, row - job->down, block, line),
                   (size_t)across * job->plain->channels) != 0)
            return false;
    return true;
}

static void encode(enum hatch_texels_code code, uint8_t texels[TEXELS][4], uint8_t *block)
{
    if (code == HATCH_TEXELS_BC1)
        hatch_bc1_encode(texels, block);
    else if (code == HATCH_TEXELS_BC4)
        hatch_bc4_encode(texels, block);
    else
        hatch_bc7_encode(texels, block);
}

/* Returns false for a block of an unknown mode. */
static bool decode(enum hatch_texels_code code, const uint8_t *block, uint8_t texels[TEXELS][4])
{
    if (code == HATCH_TEXELS_BC7)
        return hatch_bc7_decode(block, texels);
    if (code == HATCH_TEXELS_BC1)
        hatch_bc1_decode(block, texels);
    else
        hatch_bc4_decode(block, texels);
    return true;
}

static struct errors pack_block(const struct job *job, uint32_t row, uint32_t b)
{
    uint8_t texels[TEXELS][4], got[TEXELS][4], *block = block_at(job, row, b);
    get_block(job, row, b, texels);
    encode(job->packed->code, texels, block);
    decode(job->packed->code, block, got);
    return compare(job->plain->channels, texels, got);
}

/* Packs a row of blocks of each layer. In a volume most blocks are those of the layer before. */
static void pack_row(void *context, uint32_t y)
{
    const struct job *job = context;
    const uint32_t bytes = hatch_texels_block_bytes(job->packed->code, job->packed->channels);
    struct sums *sums = &job->rows[y];
    for (uint32_t row = y; row < job->down * planes_of(job->plain, job->level); row += job->down)
        for (uint32_t b = 0; b < job->across; b++) {
            struct errors *errors = &job->last[(size_t)y * job->across + b];
            if (is_repeated(job, row, b))
                memcpy(block_at(job, row, b), block_at(job, row - job->down, b), bytes);
            else
                *errors = pack_block(job, row, b);
            sums->squares += errors->squares;
            sums->worst = errors->worst > sums->worst ? errors->worst : sums->worst;
        }
}

static void unpack_row(void *context, uint32_t row)
{
    const struct job *job = context;
    for (uint32_t b = 0; b < job->across; b++) {
        uint8_t texels[TEXELS][4];
        if (!decode(job->packed->code, block_at(job, row, b), texels))
            job->rows[row].unknown = true;
        /* Backwards, because beyond the border several texels are clamped to one, of which the first must be written
         * last. */
        for (uint32_t i = TEXELS; i-- > 0;)
            memcpy(texel_at(job, row, b, i), texels[i], job->plain->channels);
    }
}

static enum hatch_status for_rows(struct job *job, uint32_t rows, struct hatch_pool *pool, hatch_task task,
                                  struct hatch_arena *arena, struct sums *sums, struct hatch_err *err)
{
    struct hatch_arena_mark mark = hatch_arena_mark(arena);
    HATCH_TRY(HATCH_ALLOC(arena, &job->rows, rows, err));
    HATCH_TRY(HATCH_ALLOC(arena, &job->last, (size_t)job->down * job->across, err));
    hatch_parallel_for(pool, rows, task, job);
    for (uint32_t i = 0; i < rows; i++) {
        sums->squares += job->rows[i].squares;
        sums->worst = job->rows[i].worst > sums->worst ? job->rows[i].worst : sums->worst;
        sums->unknown |= job->rows[i].unknown;
    }
    hatch_arena_rewind(arena, mark);
    return HATCH_OK;
}

enum hatch_status hatch_texels_compress(const struct hatch_texels *plain, enum hatch_texels_code code,
                                        struct hatch_pool *pool, struct hatch_arena *arena, struct hatch_texels *packed,
                                        struct hatch_block_figures *figures, struct hatch_err *err)
{
    assert(plain->code == HATCH_TEXELS_PLAIN);
    assert(hatch_texels_block_side(code) == SIDE);
    assert(code == HATCH_TEXELS_BC4 ? plain->channels == 1 : plain->channels >= 3);
    struct hatch_texels made = *plain;
    struct sums sums = {0};
    double numbers = 0;
    made.code = code;
    made.channels = code == HATCH_TEXELS_BC4 ? 1 : code == HATCH_TEXELS_BC1 ? 3 : 4;
    HATCH_TRY(hatch_texels_make(arena, &made, err));
    for (uint32_t level = 0; level < plain->level_count; level++) {
        struct job job = job_of(plain, &made, level);
        HATCH_TRY(for_rows(&job, job.down, pool, pack_row, arena, &sums, err));
        numbers += (double)TEXELS * job.across * job.down * planes_of(plain, level) * plain->channels;
    }
    if (figures)
        *figures = (struct hatch_block_figures){sums.worst / 255.0, sqrt((double)sums.squares / numbers) / 255};
    *packed = made;
    return HATCH_OK;
}

enum hatch_status hatch_texels_decompress(const struct hatch_texels *packed, struct hatch_arena *arena,
                                          struct hatch_texels *plain, struct hatch_err *err)
{
    if (packed->code == HATCH_TEXELS_PLAIN) {
        *plain = *packed;
        return HATCH_OK;
    }
    if (packed->code == HATCH_TEXELS_R32UI)
        return hatch_fail(err, HATCH_BAD_INPUT, "the texture holds whole numbers, want colours");
    struct hatch_texels made = *packed;
    struct sums sums = {0};
    made.code = HATCH_TEXELS_PLAIN;
    HATCH_TRY(hatch_texels_make(arena, &made, err));
    for (uint32_t level = 0; level < made.level_count; level++) {
        struct job job = job_of(&made, packed, level);
        HATCH_TRY(for_rows(&job, job.down * planes_of(&made, level), NULL, unpack_row, arena, &sums, err));
        if (sums.unknown)
            return hatch_fail(err, HATCH_BAD_INPUT, "level %u: BC7 is supported in mode 6 only", level);
    }
    *plain = made;
    return HATCH_OK;
}
