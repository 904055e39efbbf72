#include <math.h>
#include <string.h>

#include "base/random.h"
#include "lapped/work.h"
#include "mesh/edges.h"

/* Rounds of growing and placing before a patch is cut back to its first face. */
#define ROUNDS_MAX 24
/* A determinant below this counts as turned over: floats must still show the face's side. */
#define DETERMINANT_MIN 0.05
/* Nor may a face that shows be so small a part, or so many times, of what it should be. */
#define AREA_MIN 0.25
#define AREA_MAX 4.0
/* One face in so many of a patch may be farther off the field than this share of the limit. */
#define WIDE_ONE_IN 12
#define WIDE_SHARE 0.57
/* How deep a way is halved before it counts as touched. */
#define HALVINGS 4
/* What the outline shrinks by each time that something was wrong. */
#define SHRINK 0.97
/* The least that is left of it. */
#define STEP_MIN 0.7
/* One part in so many vertices may be added without placing all anew, and how small a share of the outline
 * for which places were found may be left. */
#define FEW 12
#define LEFT_MIN 0.8
/* Places are found for what an outline so much larger would touch: faces move when they are placed. */
#define ROOM 1.03
/* After a patch of so many faces the next one around begins with so many times as many, but no fewer
 * than these, and goes on so as long as all is right. */
#define BUDGET_MORE 4
#define BUDGET_MIN 16u
/* It does not begin with more than so many times the faces that would be within its outline if all were like the
 * first one: where a patch comes from large faces into small ones it would take many in vain. */
#define BUDGET_EXPECTED 2.0
/* Of an equilateral triangle with the side 1: faces in a circle with the radius 1. */
#define FACES_IN_CIRCLE 7.26
/* An outline does not shrink below this many edges: what it then cannot leave outside is cut. */
#define FLOOR_GRAINS 5.0
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
    return distance < sqrt(x * x + y * y) / 2 &&
           (way_touches(outline, a, middle, halvings - 1) || way_touches(outline, middle, b, halvings - 1));
}

bool hatch_patch_touches(const struct hatch_patch *patch, const struct hatch_outline *outline, const double a[2],
                         const double b[2])
{
    double ends[2][2];
    hatch_patch_mask(patch, a, ends[0]);
    hatch_patch_mask(patch, b, ends[1]);
    return way_touches(outline, ends[0], ends[1], HALVINGS);
}

double hatch_patch_circle(const double at[3][2], double center[2])
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
    double b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
    double doubled = 2 * (bx * cy - by * cx), least = HATCH_LAPPED_THIN * (b2 + c2);
    doubled = fabs(doubled) < least ? least : doubled;
    double x = (cy * b2 - by * c2) / doubled, y = (bx * c2 - cx * b2) / doubled;
    center[0] = at[0][0] + x;
    center[1] = at[0][1] + y;
    return sqrt(x * x + y * y);
}

/* Keeps the outline where it was, seen from the first face. */
static void center_on_seed(struct hatch_growth *growth)
{
    struct hatch_patch *patch = &growth->patch;
    double at[3][2], middle[2];
    for (uint32_t c = 0; c < 3; c++) {
        if (patch->face_count == 0) {
            hatch_ground_corner(growth->ground, patch->seed, c, at[c]);
            continue;
        }
        for (uint32_t i = 0; i < 2; i++)
            at[c][i] = patch->place[2 * c + i];
    }
    patch->seed_radius = SEED_ROOM * hatch_patch_circle((const double(*)[2])at, middle);
    for (int i = 0; i < 2; i++)
        patch->center[i] = middle[i] + patch->offset[i];
    patch->radius = fmax(patch->radius, hatch_patch_least(patch, growth->outline));
}

struct verdict {
    uint32_t bad; /* the first face that is past a limit, or UINT32_MAX */
    bool more;    /* faces are left that the outline touches and growth may take */
    bool open;    /* the outline touches a side behind which there is nothing */
};

/* How a patch comes about. */
struct trial {
    struct verdict verdict;
    double solved;         /* the radius that places were last found for */
    uint64_t placed_faces; /* over all times */
    bool due, placed;      /* places must be found; were found this time */
    bool anew;             /* faces must be left out */
    bool shrinking;        /* it will not be asked to become larger */
    bool halved;           /* its first face was wrong */
};

/* Sides behind which growth cannot go on are in the outline's way. */
static enum hatch_status judge_rim(const struct hatch_growth *growth, struct hatch_obstacles *obstacles,
                                   struct verdict *verdict, struct hatch_err *err)
{
    const struct hatch_patch *patch = &growth->patch;
    bool full = patch->face_count >= patch->faces_max;
    for (uint32_t i = 0; i < patch->rim_count; i++) {
        const struct hatch_rim *rim = &patch->rim[i];
        if (rim->covered)
            continue;
        const double *a = &patch->place[2 * rim->ends[0]], *b = &patch->place[2 * rim->ends[1]];
        bool touched = hatch_patch_touches(patch, growth->outline, a, b);
        if (rim->may && !full) {
            verdict->more = verdict->more || touched;
            continue;
        }
        verdict->open = verdict->open || touched;
        HATCH_TRY(hatch_obstacles_add(obstacles, a, b, err));
    }
    return HATCH_OK;
}

static enum hatch_past past_limits(const struct hatch_growth *growth, const struct hatch_lapped_options *options,
                                   uint32_t local)
{
    struct hatch_fit fit;
    uint32_t face = growth->patch.faces[local];
    hatch_patch_fit(growth->ground, &growth->patch, local, &fit);
    if (!(fit.determinant >= DETERMINANT_MIN))
        return HATCH_LAPPED_PAST;
    if (growth->covered[face])
        return HATCH_LAPPED_WITHIN;
    if (!(fit.stretch <= options->stretch_max && fit.determinant >= AREA_MIN && fit.determinant <= AREA_MAX))
        return HATCH_LAPPED_PAST;
    if (growth->ground->singular[face] || fit.turn <= tan(WIDE_SHARE * options->turn_max_rad))
        return HATCH_LAPPED_WITHIN;
    return fit.turn <= tan(options->turn_max_rad) ? HATCH_LAPPED_WIDE : HATCH_LAPPED_PAST;
}

/* Finds which faces are past a limit, where that is not known yet. Those that are near it are where they are
 * many: a patch of few faces, as on a crease, would not be that patch without them. */
static void measure_faces(struct hatch_growth *growth, const struct hatch_lapped_options *options)
{
    struct hatch_patch *patch = &growth->patch;
    for (; patch->measured < patch->face_count; patch->measured++) {
        patch->past[patch->measured] = (uint8_t)past_limits(growth, options, patch->measured);
        patch->past_count += patch->past[patch->measured] == HATCH_LAPPED_PAST;
        patch->wide_count += patch->past[patch->measured] == HATCH_LAPPED_WIDE;
    }
    if (patch->wide_count * WIDE_ONE_IN <= patch->face_count)
        return;
    for (uint32_t f = 0; f < patch->face_count; f++)
        patch->past[f] = patch->past[f] != HATCH_LAPPED_WITHIN;
    patch->past_count += patch->wide_count;
    patch->wide_count = 0;
}

/* The first face is; another one only where its sides are. */
static bool face_touched(const struct hatch_growth *growth, uint32_t local)
{
    const struct hatch_patch *patch = &growth->patch;
    bool touched = local == 0;
    for (uint32_t c = 0; c < 3 && !touched; c++)
        touched = hatch_patch_touches(patch, growth->outline, &patch->place[2 * patch->corners[3 * local + c]],
                                      &patch->place[2 * patch->corners[3 * local + (c + 1) % 3]]);
    return touched;
}

static enum hatch_status judge(struct hatch_growth *growth, const struct hatch_lapped_options *options,
                               struct verdict *verdict, struct hatch_err *err)
{
    const struct hatch_patch *patch = &growth->patch;
    struct hatch_obstacles *obstacles = &growth->obstacles;
    *verdict = (struct verdict){.bad = UINT32_MAX};
    obstacles->count = 0;
    measure_faces(growth, options);
    HATCH_TRY(judge_rim(growth, obstacles, verdict, err));
    for (uint32_t f = 0, left = patch->past_count; left > 0; f++) {
        if (patch->past[f] != HATCH_LAPPED_PAST)
            continue;
        left--;
        if (verdict->bad == UINT32_MAX && face_touched(growth, f))
            verdict->bad = f;
        for (uint32_t c = 0; c < 3; c++)
            HATCH_TRY(hatch_obstacles_add(obstacles, &patch->place[2 * patch->corners[3 * f + c]],
                                          &patch->place[2 * patch->corners[3 * f + (c + 1) % 3]], err));
    }
    return HATCH_OK;
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

/* Slides and shrinks the outline so that it leaves out what was wrong. Where it is as small as it may
 * be, bars the faces that were; false when there is nothing more to be done. */
static bool retreat(struct hatch_growth *growth, struct trial *trial)
{
    const struct verdict *verdict = &trial->verdict;
    struct hatch_patch *patch = &growth->patch;
    double middle[2] = {patch->center[0] - patch->offset[0], patch->center[1] - patch->offset[1]};
    double floor = fmin(FLOOR_GRAINS * growth->ground->grain[patch->seed], growth->ground->wish[patch->seed]);
    bool small = patch->offset[0] == 0 && patch->offset[1] == 0 &&
                 patch->radius <= fmax(floor, hatch_patch_least(patch, growth->outline));
    if (!small) {
        double large = verdict->bad == UINT32_MAX ? 0 : STEP_MIN * patch->radius;
        patch->radius *= SHRINK;
        hatch_patch_slide(patch, growth->outline, &growth->obstacles, fmax(large, floor));
        for (int i = 0; i < 2; i++)
            patch->center[i] = middle[i] + patch->offset[i];
        return true;
    }
    if (verdict->bad == 0) {
        patch->faces_max = (patch->face_count + 1) / 2;
        trial->halved = true;
    }
    for (uint32_t f = 0; f < patch->face_count; f++)
        if (patch->past[f] == HATCH_LAPPED_PAST)
            growth->barred[patch->faces[f]] = growth->number;
    trial->anew = true;
    return verdict->bad != UINT32_MAX;
}

/* Nothing but the first face, which can always be placed. */
static void cut_back(struct hatch_growth *growth, struct trial *trial)
{
    struct hatch_patch *patch = &growth->patch;
    patch->faces_max = 1;
    patch->offset[0] = patch->offset[1] = patch->radius = 0;
    center_on_seed(growth);
    trial->due = true;
}

static void begin(struct hatch_growth *growth, const struct hatch_lapped_options *options, uint32_t seed,
                  struct hatch_patch_notes *notes)
{
    struct hatch_patch *patch = &growth->patch;
    hatch_growth_begin(growth, seed);
    turn_at_random(patch, options->seed);
    patch->radius = growth->ground->wish[seed];
    center_on_seed(growth);
    double wide = 2 * growth->outline->reach_max * patch->radius / growth->ground->grain[seed];
    double expected = fmax(BUDGET_EXPECTED * FACES_IN_CIRCLE * wide * wide, BUDGET_MIN);
    patch->faces_max = expected < patch->faces_max ? (uint32_t)expected : patch->faces_max;
    double hold = HATCH_LAPPED_HOLD * patch->seed_radius / (SEED_ROOM * 2 * growth->outline->core_min);
    *notes = (struct hatch_patch_notes){.enlarged = hold > 0.999 * patch->radius};
}

/* Notes what the patch tried to take, for those that begin there later. */
static enum hatch_status note_tried(struct hatch_growth *growth, struct hatch_err *err)
{
    const struct hatch_patch *patch = &growth->patch;
    void *array = growth->tried;
    HATCH_TRY(
        hatch_heap_reserve(growth->arena, &array, &growth->tried_room, patch->face_count, sizeof *growth->tried, err));
    growth->tried = array;
    growth->tried_count = patch->face_count;
    memcpy(growth->tried, patch->faces, patch->face_count * sizeof *patch->faces);
    return HATCH_OK;
}

/* Where little came of much, the patches around are likely to come to no more: without this a crumpled
 * place costs each of its faces a patch of full size. */
static void set_budgets(struct hatch_growth *growth)
{
    uint32_t most = growth->ground->faces_max, count = growth->patch.face_count;
    uint32_t budget = count > most / BUDGET_MORE ? most : BUDGET_MORE * count;
    for (uint32_t i = 0; i < growth->tried_count; i++)
        growth->budget[growth->tried[i]] = budget > BUDGET_MIN ? budget : BUDGET_MIN;
}

/* One more time round: grows, places if that is due, and looks what is wrong. */
static enum hatch_status attempt(struct hatch_growth *growth, struct hatch_solver *solver,
                                 const struct hatch_lapped_options *options, struct trial *trial, struct hatch_err *err)
{
    struct hatch_patch *patch = &growth->patch;
    trial->placed =
        trial->due || patch->radius * patch->radius < LEFT_MIN * trial->solved * trial->solved || trial->solved == 0;
    if (!trial->placed) {
        double enough = LEFT_MIN * patch->face_count;
        HATCH_TRY(trial->anew ? hatch_growth_grow(growth, err) : hatch_growth_extend(growth, err));
        trial->placed = growth->unfolded * FEW > patch->vertex_count || patch->face_count < enough;
    }
    trial->anew = false;
    if (trial->placed) {
        patch->radius *= ROOM;
        HATCH_TRY(hatch_growth_grow(growth, err));
        patch->radius /= ROOM;
        HATCH_TRY(hatch_solver_solve(solver, growth->ground, patch, err));
        hatch_growth_keep(growth);
        center_on_seed(growth);
        trial->placed_faces += patch->face_count;
        HATCH_TRY(hatch_growth_extend(growth, err));
        trial->solved = patch->radius;
    }
    return judge(growth, options, &trial->verdict, err);
}

/* What to do about it; false when nothing is left to be done. */
static bool go_on(struct hatch_growth *growth, struct trial *trial)
{
    struct hatch_patch *patch = &growth->patch;
    const struct verdict *verdict = &trial->verdict;
    bool right = verdict->bad == UINT32_MAX && !verdict->open;
    trial->due = false;
    if ((right && !verdict->more) || patch->faces_max == 1)
        return false;
    if (right)
        return true;
    if (!trial->placed && growth->unfolded > 0) {
        trial->due = true;
        return true;
    }
    if (verdict->bad == UINT32_MAX && !trial->shrinking && patch->face_count == patch->faces_max &&
        patch->faces_max < growth->ground->faces_max) {
        uint32_t most = growth->ground->faces_max;
        patch->faces_max = patch->faces_max > most / BUDGET_MORE ? most : BUDGET_MORE * patch->faces_max;
        return true;
    }
    trial->shrinking = true;
    return retreat(growth, trial);
}

enum hatch_status hatch_patch_make(struct hatch_growth *growth, struct hatch_solver *solver,
                                   const struct hatch_lapped_options *options, uint32_t seed, double least,
                                   struct hatch_patch_notes *notes, struct hatch_err *err)
{
    struct hatch_patch *patch = &growth->patch;
    struct trial trial = {.solved = 0};
    begin(growth, options, seed, notes);
    for (int round = 0; round <= ROUNDS_MAX && !notes->given_up; round++) {
        if (round == ROUNDS_MAX)
            cut_back(growth, &trial);
        HATCH_TRY(attempt(growth, solver, options, &trial, err));
        if (round == 0)
            HATCH_TRY(note_tried(growth, err));
        if (!go_on(growth, &trial))
            break;
        notes->given_up = patch->radius < least || (least > 0 && trial.halved);
    }
    if (!notes->given_up)
        set_budgets(growth);
    notes->cut = trial.verdict.open;
    notes->placed = trial.placed_faces;
    return HATCH_OK;
}
