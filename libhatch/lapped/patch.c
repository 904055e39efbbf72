#include <math.h>

#include "base/random.h"
#include "lapped/work.h"
#include "mesh/edges.h"

/* Rounds of growing and placing before a patch is cut back to its first face. */
#define ROUNDS_MAX 16
/* A determinant below this counts as turned over: floats must still show the face's side. */
#define DETERMINANT_MIN 0.05
/* How deep a way is halved before it counts as touched. */
#define HALVINGS 4
/* Places of a way that are asked for their share. */
#define SHARE_STEPS 4
/* The core is so much larger than the circle around the first face, so that a few cuts show that it holds it. */
#define SEED_ROOM 1.05

void hatch_patch_mask(const struct hatch_patch *patch, const double place[2], double mask[2])
{
    double x = (place[0] - patch->center[0]) / (2 * patch->radius);
    double y = (patch->center[1] - place[1]) / (2 * patch->radius);
    mask[0] = 0.5 + patch->turn[0] * x - patch->turn[1] * y;
    mask[1] = 0.5 + patch->turn[1] * x + patch->turn[0] * y;
}

static bool way_touches(const struct hatch_outline *outline, const double a[2], const double b[2], int halvings)
{
    double middle[2] = {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2};
    double x = b[0] - a[0], y = b[1] - a[1];
    double distance = hatch_outline_distance(outline, middle);
    if (distance <= 0 || halvings == 0)
        return distance <= 0 || distance < sqrt(x * x + y * y) / 2;
    return distance < sqrt(x * x + y * y) / 2 && (way_touches(outline, a, middle, halvings - 1) ||
                                                  way_touches(outline, middle, b, halvings - 1));
}

bool hatch_patch_touches(const struct hatch_patch *patch, const struct hatch_outline *outline,
                         const double a[2], const double b[2])
{
    double ends[2][2];
    hatch_patch_mask(patch, a, ends[0]);
    hatch_patch_mask(patch, b, ends[1]);
    return way_touches(outline, ends[0], ends[1], HALVINGS);
}

double hatch_patch_share(const struct hatch_patch *patch, const struct hatch_outline *outline,
                         const double a[2], const double b[2])
{
    double ends[2][2], least = HUGE_VAL;
    hatch_patch_mask(patch, a, ends[0]);
    hatch_patch_mask(patch, b, ends[1]);
    for (int i = 0; i <= SHARE_STEPS; i++) {
        double t = (double)i / SHARE_STEPS;
        double at[2] = {ends[0][0] + t * (ends[1][0] - ends[0][0]), ends[0][1] + t * (ends[1][1] - ends[0][1])};
        least = fmin(least, hatch_outline_share(outline, at));
    }
    return least;
}

/* The smallest circle around a triangle. */
static double circle_around(const double at[3][2], double center[2])
{
    for (int c = 0; c < 3; c++) {
        const double *a = at[c], *b = at[(c + 1) % 3], *o = at[(c + 2) % 3];
        double dot = (a[0] - o[0]) * (b[0] - o[0]) + (a[1] - o[1]) * (b[1] - o[1]);
        if (dot <= 0) {
            center[0] = (a[0] + b[0]) / 2;
            center[1] = (a[1] + b[1]) / 2;
            return sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1])) / 2;
        }
    }
    double bx = at[1][0] - at[0][0], by = at[1][1] - at[0][1];
    double cx = at[2][0] - at[0][0], cy = at[2][1] - at[0][1];
    double doubled = 2 * (bx * cy - by * cx), b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
    double x = (cy * b2 - by * c2) / doubled, y = (bx * c2 - cx * b2) / doubled;
    center[0] = at[0][0] + x;
    center[1] = at[0][1] + y;
    return sqrt(x * x + y * y);
}

/* Puts the outline around the first face; returns the smallest radius with which its core holds it. */
static double center_on_seed(struct hatch_growth *growth)
{
    double at[3][2];
    for (uint32_t c = 0; c < 3; c++) {
        if (growth->patch.face_count == 0) {
            hatch_ground_corner(growth->ground, growth->patch.seed, c, at[c]);
            continue;
        }
        for (uint32_t i = 0; i < 2; i++)
            at[c][i] = growth->patch.place[2 * c + i];
    }
    double radius = circle_around((const double(*)[2])at, growth->patch.center);
    return SEED_ROOM * radius / (2 * growth->outline->core_min);
}

struct verdict {
    double share;       /* to which the outline must shrink to leave out what is wrong; 1: nothing is */
    uint32_t bad;       /* the first face that is past a limit, or UINT32_MAX */
    bool more;          /* faces are left that the outline touches and growth may take */
    bool open;          /* the outline touches a side behind which there is nothing */
};

static void judge_sides(const struct hatch_growth *growth, const uint8_t *covered, uint32_t local,
                        struct verdict *verdict)
{
    const struct hatch_patch *patch = &growth->patch;
    for (uint32_t c = 0; c < 3; c++) {
        uint32_t side = patch->faces[local] * 3 + c;
        if (hatch_growth_side(growth, side) != HATCH_SIDE_OPEN)
            continue;
        if (covered[growth->ground->surface->opposite[side] / 3])
            continue;
        const double *a = &patch->place[2 * patch->corners[3 * local + c]];
        const double *b = &patch->place[2 * patch->corners[3 * local + (c + 1) % 3]];
        if (!hatch_patch_touches(patch, growth->outline, a, b))
            continue;
        if (hatch_growth_may(growth, side)) {
            verdict->more = true;
        } else {
            verdict->open = true;
            verdict->share = fmin(verdict->share, hatch_patch_share(patch, growth->outline, a, b));
        }
    }
}

static bool past_limits(const struct hatch_growth *growth, const struct hatch_lapped_options *options,
                        const uint8_t *covered, uint32_t local)
{
    struct hatch_fit fit;
    uint32_t face = growth->patch.faces[local];
    hatch_patch_fit(growth->ground, &growth->patch, local, &fit);
    if (!(fit.determinant >= DETERMINANT_MIN))
        return true;
    if (covered[face])
        return false;
    return !(fit.stretch <= options->stretch_max) ||
           (!growth->ground->singular[face] && !(fit.turn <= tan(options->turn_max_rad)));
}

static void judge(const struct hatch_growth *growth, const struct hatch_lapped_options *options,
                  const uint8_t *covered, struct verdict *verdict)
{
    const struct hatch_patch *patch = &growth->patch;
    *verdict = (struct verdict){.share = 1, .bad = UINT32_MAX};
    for (uint32_t f = 0; f < patch->face_count; f++) {
        judge_sides(growth, covered, f, verdict);
        if (!past_limits(growth, options, covered, f))
            continue;
        if (verdict->bad == UINT32_MAX)
            verdict->bad = f;
        for (uint32_t c = 0; c < 3; c++) {
            const double *a = &patch->place[2 * patch->corners[3 * f + c]];
            const double *b = &patch->place[2 * patch->corners[3 * f + (c + 1) % 3]];
            verdict->share = fmin(verdict->share, hatch_patch_share(patch, growth->outline, a, b));
        }
    }
}

static void turn_at_random(struct hatch_patch *patch, uint64_t seed)
{
    double x = 1, y = 0, length = 1;
    for (uint64_t i = 0; i < 64; i += 2) {
        x = 2 * (double)hatch_random_unit(seed, patch->seed, i) - 1;
        y = 2 * (double)hatch_random_unit(seed, patch->seed, i + 1) - 1;
        length = sqrt(x * x + y * y);
        if (length <= 1 && length > 0.1)
            break;
    }
    patch->turn[0] = x / length;
    patch->turn[1] = y / length;
}

/* Shrinks outline or patch so that it leaves out what was wrong; false when there is nothing more to
 * be done. */
static bool retreat(struct hatch_patch *patch, const struct verdict *verdict, double least)
{
    if (patch->radius > least) {
        double share = fmin(0.95, fmax(0.6, 0.98 * verdict->share));
        patch->radius = fmax(least, patch->radius * share);
        return true;
    }
    if (verdict->bad == UINT32_MAX)
        return false;
    patch->faces_max = verdict->bad > 1 ? verdict->bad : 1;
    return true;
}

enum hatch_status hatch_patch_make(struct hatch_growth *growth, struct hatch_solver *solver,
                                   const struct hatch_lapped_options *options, const uint8_t *covered,
                                   uint32_t seed, struct hatch_patch_notes *notes, struct hatch_err *err)
{
    struct hatch_patch *patch = &growth->patch;
    hatch_growth_begin(growth, seed);
    turn_at_random(patch, options->seed);
    double wish = growth->ground->wish[seed], least = center_on_seed(growth);
    patch->radius = fmax(wish, least);
    notes->enlarged = least > wish;
    struct verdict verdict = {0};
    for (int round = 0; round <= ROUNDS_MAX; round++) {
        if (round == ROUNDS_MAX) {
            patch->faces_max = 1;
            patch->radius = least;
        }
        HATCH_TRY(hatch_growth_grow(growth, err));
        HATCH_TRY(hatch_solver_solve(solver, growth->ground, patch, err));
        hatch_growth_keep(growth);
        least = center_on_seed(growth);
        patch->radius = fmax(patch->radius, least);
        judge(growth, options, covered, &verdict);
        bool right = verdict.bad == UINT32_MAX && !verdict.open;
        if ((right && !verdict.more) || patch->faces_max == 1)
            break;
        if (!right && !retreat(patch, &verdict, least))
            break;
    }
    notes->cut = verdict.open;
    return HATCH_OK;
}
