#include "vector/runs.h"

struct piece {
    double ends[2][2];
    bool kept, apart; /* apart: it does not begin where the piece before it ends */
    bool blank;       /* it is never delivered unless it is kept */
};

/* Successive pieces that are kept, or are not. */
struct run {
    uint32_t first, count;
    double length;
    bool kept, apart; /* as in the first piece */
};

struct hatch_vector_runs hatch_vector_runs_of(struct hatch_arena *arena)
{
    return (struct hatch_vector_runs){.pieces = {.arena = arena}, .runs = {.arena = arena}};
}

void hatch_vector_runs_clear(struct hatch_vector_runs *runs)
{
    runs->pieces.size = runs->runs.size = 0;
    runs->piece_count = runs->run_count = 0;
    runs->apart = runs->whole = true;
}

void hatch_vector_runs_skip(struct hatch_vector_runs *runs)
{
    runs->apart = true;
    runs->whole = false;
}

static enum hatch_status add(struct hatch_vector_runs *runs, const double a[2], const double b[2], double begin,
                             double end, struct piece piece, struct hatch_err *err)
{
    if (!(begin < end))
        return HATCH_OK;
    for (int k = 0; k < 2; k++) {
        piece.ends[0][k] = begin > 0 ? a[k] + begin * (b[k] - a[k]) : a[k];
        piece.ends[1][k] = end < 1 ? a[k] + end * (b[k] - a[k]) : b[k];
    }
    piece.apart = runs->apart;
    runs->apart = false;
    runs->piece_count++;
    return hatch_buffer_add(&runs->pieces, &piece, sizeof piece, err);
}

enum hatch_status hatch_vector_runs_add(struct hatch_vector_runs *runs, const double a[2], const double b[2],
                                        double begin, double end, bool kept, struct hatch_err *err)
{
    return add(runs, a, b, begin, end, (struct piece){.kept = kept}, err);
}

enum hatch_status hatch_vector_runs_add_blank(struct hatch_vector_runs *runs, const double a[2], const double b[2],
                                              double begin, double end, struct hatch_err *err)
{
    return add(runs, a, b, begin, end, (struct piece){.blank = true}, err);
}

static struct run *run_at(const struct hatch_vector_runs *runs, uint32_t i)
{
    return (struct run *)(void *)runs->runs.data + i;
}

static const struct piece *piece_at(const struct hatch_vector_runs *runs, uint32_t i)
{
    return (const struct piece *)(const void *)runs->pieces.data + i;
}

enum hatch_status hatch_vector_runs_make(struct hatch_vector_runs *runs, struct hatch_err *err)
{
    for (uint32_t i = 0; i < runs->piece_count; i++) {
        const struct piece *piece = piece_at(runs, i);
        struct run *last = runs->run_count ? run_at(runs, runs->run_count - 1) : NULL;
        if (!last || piece->apart || piece->kept != last->kept) {
            const struct run run = {.first = i, .kept = piece->kept, .apart = piece->apart};
            HATCH_TRY(hatch_buffer_add(&runs->runs, &run, sizeof run, err));
            last = run_at(runs, runs->run_count++);
        }
        last->count++;
        last->length += hatch_vector_distance(piece->ends[0], piece->ends[1]);
    }
    return HATCH_OK;
}

/* Unites a run with the one before it if both are of one kind. Returns the new number of runs. */
static uint32_t keep_run(struct hatch_vector_runs *runs, uint32_t count, const struct run *run)
{
    struct run *before = count ? run_at(runs, count - 1) : NULL;
    if (before && !run->apart && before->kept == run->kept) {
        before->count += run->count;
        before->length += run->length;
        return count;
    }
    *run_at(runs, count) = *run;
    return count + 1;
}

/* Inverts runs that are shorter than a length and lie between two of the other kind.
 *   free_end  whether it is enough that one is on one side, and the line ends on the other */
static void invert(struct hatch_vector_runs *runs, bool kept, double shortest, bool free_end)
{
    uint32_t count = 0, all = runs->run_count;
    for (uint32_t i = 0; i < all; i++) {
        struct run run = *run_at(runs, i);
        bool before = count && !run.apart, after = i + 1 < all && !run_at(runs, i + 1)->apart;
        if (run.kept == kept && run.length < shortest && (free_end ? before || after : before && after))
            run.kept = !kept;
        count = keep_run(runs, count, &run);
    }
    runs->run_count = count;
}

void hatch_vector_runs_fill(struct hatch_vector_runs *runs, double gap)
{
    invert(runs, false, gap, false);
}

void hatch_vector_runs_drop(struct hatch_vector_runs *runs, double speck, bool closed)
{
    invert(runs, true, speck, !closed);
}

/* Adds the points of a run to the path that has begun. Where a run that is not kept has blank pieces, the path ends,
 * and another begins after them. */
static enum hatch_status add_points(const struct hatch_vector_runs *runs, const struct run *run,
                                    const struct hatch_vector_path *like, struct hatch_vector_builder *builder,
                                    struct hatch_err *err)
{
    for (uint32_t i = 0; i < run->count; i++) {
        const struct piece *piece = piece_at(runs, run->first + i);
        if (!run->kept && piece->blank) {
            HATCH_TRY(hatch_vector_end(builder, false, err));
            hatch_vector_begin(builder, like);
            continue;
        }
        for (int end = 0; end < 2; end++)
            HATCH_TRY(hatch_vector_add(builder, piece->ends[end], err));
    }
    return HATCH_OK;
}

static bool has_blanks(const struct hatch_vector_runs *runs)
{
    bool found = false;
    for (uint32_t i = 0; i < runs->piece_count; i++)
        found = found || piece_at(runs, i)->blank;
    return found;
}

enum hatch_status hatch_vector_runs_deliver(const struct hatch_vector_runs *runs, const struct hatch_vector_path *like,
                                            bool closed, bool kept, struct hatch_vector_builder *builder,
                                            struct hatch_err *err)
{
    uint32_t count = runs->run_count;
    bool round = closed && runs->whole;
    bool meets = round && count > 1 && run_at(runs, 0)->kept == run_at(runs, count - 1)->kept;
    for (uint32_t i = meets ? 1 : 0; i < count; i++) {
        const struct run *run = run_at(runs, i);
        if (run->kept != kept)
            continue;
        hatch_vector_begin(builder, like);
        HATCH_TRY(add_points(runs, run, like, builder, err));
        if (meets && i + 1 == count)
            HATCH_TRY(add_points(runs, run_at(runs, 0), like, builder, err));
        HATCH_TRY(hatch_vector_end(builder, round && count == 1 && (kept || !has_blanks(runs)), err));
    }
    return HATCH_OK;
}
