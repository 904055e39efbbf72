#include <math.h>
#include <string.h>

#include "base/random.h"
#include "lapped/work.h"

/* Largest number of rounds of growing and solving; after them, a patch is reduced to its seed face. */
#define ROUNDS_MAX 24
/* A face with a smaller determinant counts as turned over: its orientation must survive rounding to floats. */
#define DETERMINANT_MIN 0.05
/* Bounds of the determinant of a face that is visible. */
#define AREA_MIN 0.25
#define AREA_MAX 4.0
/* At most one face in NEAR_ONE_IN of a patch may be turned from the field by more than NEAR_SHARE of the limit. */
#define NEAR_ONE_IN 12
#define NEAR_SHARE 0.57
/* Number of bisections after which a segment counts as touched. */
#define HALVINGS 4
/* Factor by which the outline shrinks in a round: its largest value, and its smallest while a face exceeds a limit. */
#define SHRINK 0.97
#define SHRINK_MIN 0.7
/* A solution is reused as long as at most one vertex in UNSOLVED_ONE_IN is new, and the outline's area and the number
 * of faces are at least REUSE_MIN of those at the solution. */
#define UNSOLVED_ONE_IN 12
#define REUSE_MIN 0.8
/* Positions are solved for the faces that an outline larger by this factor touches, since solving moves faces. */
#define SOLVE_MARGIN 1.03
/* The initial faces_max of a patch is this factor times the number of faces of the last patch there, but at least
 * START_MIN. While no limit is exceeded, faces_max is raised by the same factor. */
#define START_FACTOR 4
#define START_MIN 16u
/* The initial faces_max is also at most this factor times the number of faces that the outline would contain if all
 * were like the seed face: a patch that grows from large faces into small ones would otherwise add many in vain. */
#define EXPECTED_FACTOR 2.0
/* Number of equilateral triangles of side 1 in a circle of radius 1. */
#define FACES_IN_CIRCLE 7.26
/* The outline's radius does not shrink below this many edge lengths: faces that exceed a limit are then excluded, and
 * the patch is cut there. */
#define RADIUS_MIN_EDGES 5.0
/* The core is larger than the circle around the seed face by this factor, so that few subdivisions suffice to show that
 * it contains the face. */
#define SEED_MARGIN 1.05

void hatch_patch_mask(const struct hatch_patch *patch, const double xy[2], double mask[2])
{
    double x = (xy[0] - patch->center[0]) / (2 * patch->radius);
    double y = (patch->center[1] - xy[1]) / (2 * patch->radius);
    mask[0] = 0.5 + patch->rotation[0] * x - patch->rotation[1] * y;
    mask[1] = 0.5 + patch->rotation[1] * x + patch->rotation[0] * y;
}

static bool segment_touches(const struct hatch_outline *outline, const double a[2], const double b[2], int halvings)
{
    double middle[2] = {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2};
    double x = b[0] - a[0], y = b[1] - a[1];
    double distance = hatch_outline_distance(outline, middle);
    if (distance <= 0 || halvings == 0)
        return distance <= 0 || distance < sqrt(x * x + y * y) / 2;
    return distance < sqrt(x * x + y * y) / 2 &&
           (segment_touches(outline, a, middle, halvings - 1) || segment_touches(outline, middle, b, halvings - 1));
}

bool hatch_patch_touches(const struct hatch_patch *patch, const struct hatch_outline *outline, const double a[2],
                         const double b[2])
{
    double ends[2][2];
    hatch_patch_mask(patch, a, ends[0]);
    hatch_patch_mask(patch, b, ends[1]);
    return segment_touches(outline, ends[0], ends[1], HALVINGS);
}

double hatch_patch_enclosing_circle(const double at[3][2], double center[2])
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
    double doubled = 2 * (bx * cy - by * cx), least = HATCH_LAPPED_AREA_FLOOR * (b2 + c2);
    doubled = fabs(doubled) < least ? least : doubled;
    double x = (cy * b2 - by * c2) / doubled, y = (bx * c2 - cx * b2) / doubled;
    center[0] = at[0][0] + x;
    center[1] = at[0][1] + y;
    return sqrt(x * x + y * y);
}

/* Puts the outline's center at its offset from the center of the seed face's circle. */
static void center_on_seed(struct hatch_growth *growth)
{
    struct hatch_patch *patch = &growth->patch;
    double at[3][2], middle[2];
    for (uint32_t c = 0; c < 3; c++) {
        if (patch->face_count == 0) {
            hatch_patch_domain_corner(growth->domain, patch->seed_face, c, at[c]);
            continue;
        }
        for (uint32_t i = 0; i < 2; i++)
            at[c][i] = patch->xy[2 * c + i];
    }
    patch->seed_radius = SEED_MARGIN * hatch_patch_enclosing_circle((const double(*)[2])at, middle);
    for (int i = 0; i < 2; i++)
        patch->center[i] = middle[i] + patch->offset[i];
    patch->radius = fmax(patch->radius, hatch_patch_radius_min(patch, growth->outline));
}

/* The state of a patch at the end of a round. */
struct verdict {
    uint32_t exceeding_face; /* the first local face that exceeds a limit and that the outline touches, or UINT32_MAX */
    bool can_grow;           /* the outline touches faces that growth may add */
    bool cut;                /* the outline touches a side behind which the patch has no face and cannot grow */
};

/* The state of the rounds in which a patch is made. */
struct trial {
    struct verdict verdict;
    double solved_radius;   /* the outline's radius at the last solution */
    uint64_t solved_faces;  /* sum over all solutions */
    bool solve_due, solved; /* the next round must solve; the last round did */
    bool regrow;            /* the next round must grow from the seed face, since faces have been excluded */
    bool shrinking;         /* faces_max is not raised any more */
    bool seed_face_exceeds; /* the seed face exceeded a limit in an outline that could not shrink */
};

/* Judges the boundary sides, and makes obstacles of those that the patch cannot grow across. */
static enum hatch_status judge_boundary(const struct hatch_growth *growth, struct hatch_obstacles *obstacles,
                                        struct verdict *verdict, struct hatch_err *err)
{
    const struct hatch_patch *patch = &growth->patch;
    bool full = patch->face_count >= patch->faces_max;
    for (uint32_t i = 0; i < patch->boundary_count; i++) {
        const struct hatch_boundary_side *side = &patch->boundary[i];
        if (side->covered)
            continue;
        const double *a = &patch->xy[2 * side->ends[0]], *b = &patch->xy[2 * side->ends[1]];
        bool touched = hatch_patch_touches(patch, growth->outline, a, b);
        if (side->growable && !full) {
            verdict->can_grow = verdict->can_grow || touched;
            continue;
        }
        verdict->cut = verdict->cut || touched;
        HATCH_TRY(hatch_obstacles_add(obstacles, a, b, err));
    }
    return HATCH_OK;
}

static enum hatch_limit_state find_limit_state(const struct hatch_growth *growth,
                                               const struct hatch_lapped_options *options, uint32_t local)
{
    struct hatch_fit fit;
    uint32_t face = growth->patch.faces[local];
    hatch_patch_fit(growth->domain, &growth->patch, local, &fit);
    if (!(fit.determinant >= DETERMINANT_MIN))
        return HATCH_LAPPED_EXCEEDED;
    if (growth->covered[face])
        return HATCH_LAPPED_WITHIN;
    if (!(fit.stretch <= options->stretch_max && fit.determinant >= AREA_MIN && fit.determinant <= AREA_MAX))
        return HATCH_LAPPED_EXCEEDED;
    if (growth->domain->singular[face] || fit.angle_tan <= tan(NEAR_SHARE * options->turn_max_rad))
        return HATCH_LAPPED_WITHIN;
    return fit.angle_tan <= tan(options->turn_max_rad) ? HATCH_LAPPED_NEAR : HATCH_LAPPED_EXCEEDED;
}

/* Finds the limit_state of faces added since the last call. If many faces are near a limit, these count as exceeding
 * it. A few are tolerated; otherwise patches of few faces, as on creases, could not be made. */
static void measure_faces(struct hatch_growth *growth, const struct hatch_lapped_options *options)
{
    struct hatch_patch *patch = &growth->patch;
    for (; patch->measured_count < patch->face_count; patch->measured_count++) {
        patch->limit_state[patch->measured_count] = (uint8_t)find_limit_state(growth, options, patch->measured_count);
        patch->exceeded_count += patch->limit_state[patch->measured_count] == HATCH_LAPPED_EXCEEDED;
        patch->near_count += patch->limit_state[patch->measured_count] == HATCH_LAPPED_NEAR;
    }
    if (patch->near_count * NEAR_ONE_IN <= patch->face_count)
        return;
    for (uint32_t f = 0; f < patch->face_count; f++)
        patch->limit_state[f] = patch->limit_state[f] != HATCH_LAPPED_WITHIN;
    patch->exceeded_count += patch->near_count;
    patch->near_count = 0;
}

/* Returns whether the outline touches a side of a local face; always true for the seed face. */
static bool face_touched(const struct hatch_growth *growth, uint32_t local)
{
    const struct hatch_patch *patch = &growth->patch;
    bool touched = local == 0;
    for (uint32_t c = 0; c < 3 && !touched; c++)
        touched = hatch_patch_touches(patch, growth->outline, &patch->xy[2 * patch->corners[3 * local + c]],
                                      &patch->xy[2 * patch->corners[3 * local + (c + 1) % 3]]);
    return touched;
}

static enum hatch_status judge(struct hatch_growth *growth, const struct hatch_lapped_options *options,
                               struct verdict *verdict, struct hatch_err *err)
{
    const struct hatch_patch *patch = &growth->patch;
    struct hatch_obstacles *obstacles = &growth->obstacles;
    *verdict = (struct verdict){.exceeding_face = UINT32_MAX};
    obstacles->count = 0;
    measure_faces(growth, options);
    HATCH_TRY(judge_boundary(growth, obstacles, verdict, err));
    for (uint32_t f = 0, left = patch->exceeded_count; left > 0; f++) {
        if (patch->limit_state[f] != HATCH_LAPPED_EXCEEDED)
            continue;
        left--;
        if (verdict->exceeding_face == UINT32_MAX && face_touched(growth, f))
            verdict->exceeding_face = f;
        for (uint32_t c = 0; c < 3; c++)
            HATCH_TRY(hatch_obstacles_add(obstacles, &patch->xy[2 * patch->corners[3 * f + c]],
                                          &patch->xy[2 * patch->corners[3 * f + (c + 1) % 3]], err));
    }
    return HATCH_OK;
}

static void rotate_at_random(struct hatch_patch *patch, uint64_t seed)
{
    double x = 1, y = 0, length = 1;
    for (uint64_t i = 0; i < 64; i += 2) {
        x = 2 * (double)hatch_random_unit(seed, patch->seed_face, i) - 1;
        y = 2 * (double)hatch_random_unit(seed, patch->seed_face, i + 1) - 1;
        length = sqrt(x * x + y * y);
        if (length <= 1 && length > 0.1)
            break;
    }
    patch->rotation[0] = x / length;
    patch->rotation[1] = y / length;
}

/* Moves and shrinks the outline so that it avoids the obstacles. If it cannot shrink further, excludes the faces that
 * exceed a limit, and returns false if the outline touches none of them. */
static bool shrink_or_exclude(struct hatch_growth *growth, struct trial *trial)
{
    const struct verdict *verdict = &trial->verdict;
    struct hatch_patch *patch = &growth->patch;
    double middle[2] = {patch->center[0] - patch->offset[0], patch->center[1] - patch->offset[1]};
    double radius_min = fmin(RADIUS_MIN_EDGES * growth->domain->edge_length[patch->seed_face],
                             growth->domain->target_radius[patch->seed_face]);
    bool small = patch->offset[0] == 0 && patch->offset[1] == 0 &&
                 patch->radius <= fmax(radius_min, hatch_patch_radius_min(patch, growth->outline));
    if (!small) {
        double largest_step = verdict->exceeding_face == UINT32_MAX ? 0 : SHRINK_MIN * patch->radius;
        patch->radius *= SHRINK;
        hatch_patch_avoid_obstacles(patch, growth->outline, &growth->obstacles, fmax(largest_step, radius_min));
        for (int i = 0; i < 2; i++)
            patch->center[i] = middle[i] + patch->offset[i];
        return true;
    }
    if (verdict->exceeding_face == 0) {
        patch->faces_max = (patch->face_count + 1) / 2;
        trial->seed_face_exceeds = true;
    }
    for (uint32_t f = 0; f < patch->face_count; f++)
        if (patch->limit_state[f] == HATCH_LAPPED_EXCEEDED)
            growth->excluded_from[patch->faces[f]] = growth->patch_number;
    trial->regrow = true;
    return verdict->exceeding_face != UINT32_MAX;
}

/* Leaves only the seed face, for which a solution always exists. */
static void reduce_to_seed_face(struct hatch_growth *growth, struct trial *trial)
{
    struct hatch_patch *patch = &growth->patch;
    patch->faces_max = 1;
    patch->offset[0] = patch->offset[1] = patch->radius = 0;
    center_on_seed(growth);
    trial->solve_due = true;
}

static void begin_patch(struct hatch_growth *growth, const struct hatch_lapped_options *options, uint32_t seed_face,
                        struct hatch_patch_notes *notes)
{
    struct hatch_patch *patch = &growth->patch;
    hatch_growth_begin(growth, seed_face);
    rotate_at_random(patch, options->seed);
    patch->radius = growth->domain->target_radius[seed_face];
    center_on_seed(growth);
    double radius_edges = 2 * growth->outline->reach_max * patch->radius / growth->domain->edge_length[seed_face];
    double expected = fmax(EXPECTED_FACTOR * FACES_IN_CIRCLE * radius_edges * radius_edges, START_MIN);
    patch->faces_max = expected < patch->faces_max ? (uint32_t)expected : patch->faces_max;
    double radius_to_contain =
        HATCH_LAPPED_CORE_FACTOR * patch->seed_radius / (SEED_MARGIN * 2 * growth->outline->core_min);
    *notes = (struct hatch_patch_notes){.enlarged = radius_to_contain > 0.999 * patch->radius};
}

/* Stores the faces of the first round, for set_start_faces_max. */
static enum hatch_status store_first_attempt(struct hatch_growth *growth, struct hatch_err *err)
{
    const struct hatch_patch *patch = &growth->patch;
    void *array = growth->first_attempt;
    HATCH_TRY(hatch_lapped_reserve(growth->arena, &array, &growth->first_attempt_capacity, patch->face_count,
                                   sizeof *growth->first_attempt, err));
    growth->first_attempt = array;
    growth->first_attempt_count = patch->face_count;
    memcpy(growth->first_attempt, patch->faces, patch->face_count * sizeof *patch->faces);
    return HATCH_OK;
}

/* Limits later patches that begin on faces of the first round: where this patch had to shrink much, they are likely to
 * shrink too. Without the limit, each face of a crumpled area would cost a patch of full size. */
static void set_start_faces_max(struct hatch_growth *growth)
{
    uint32_t most = growth->domain->faces_max, count = growth->patch.face_count;
    uint32_t start = count > most / START_FACTOR ? most : START_FACTOR * count;
    for (uint32_t i = 0; i < growth->first_attempt_count; i++)
        growth->start_faces_max[growth->first_attempt[i]] = start > START_MIN ? start : START_MIN;
}

/* Grows the patch, solves for positions when necessary, and judges the result. */
static enum hatch_status run_round(struct hatch_growth *growth, struct hatch_solver *solver,
                                   const struct hatch_lapped_options *options, struct trial *trial,
                                   struct hatch_err *err)
{
    struct hatch_patch *patch = &growth->patch;
    trial->solved = trial->solve_due ||
                    patch->radius * patch->radius < REUSE_MIN * trial->solved_radius * trial->solved_radius ||
                    trial->solved_radius == 0;
    if (!trial->solved) {
        double enough = REUSE_MIN * patch->face_count;
        HATCH_TRY(trial->regrow ? hatch_growth_grow(growth, err) : hatch_growth_extend(growth, err));
        trial->solved = growth->unsolved_count * UNSOLVED_ONE_IN > patch->vertex_count || patch->face_count < enough;
    }
    trial->regrow = false;
    if (trial->solved) {
        patch->radius *= SOLVE_MARGIN;
        HATCH_TRY(hatch_growth_grow(growth, err));
        patch->radius /= SOLVE_MARGIN;
        HATCH_TRY(hatch_solver_solve(solver, growth->domain, patch, err));
        hatch_growth_store_positions(growth);
        center_on_seed(growth);
        trial->solved_faces += patch->face_count;
        HATCH_TRY(hatch_growth_extend(growth, err));
        trial->solved_radius = patch->radius;
    }
    return judge(growth, options, &trial->verdict, err);
}

/* Prepares the next round. Returns false when the patch is finished. */
static bool plan_next_round(struct hatch_growth *growth, struct trial *trial)
{
    struct hatch_patch *patch = &growth->patch;
    const struct verdict *verdict = &trial->verdict;
    bool acceptable = verdict->exceeding_face == UINT32_MAX && !verdict->cut;
    trial->solve_due = false;
    if ((acceptable && !verdict->can_grow) || patch->faces_max == 1)
        return false;
    if (acceptable)
        return true;
    if (!trial->solved && growth->unsolved_count > 0) {
        trial->solve_due = true;
        return true;
    }
    if (verdict->exceeding_face == UINT32_MAX && !trial->shrinking && patch->face_count == patch->faces_max &&
        patch->faces_max < growth->domain->faces_max) {
        uint32_t most = growth->domain->faces_max;
        patch->faces_max = patch->faces_max > most / START_FACTOR ? most : START_FACTOR * patch->faces_max;
        return true;
    }
    trial->shrinking = true;
    return shrink_or_exclude(growth, trial);
}

enum hatch_status hatch_patch_make(struct hatch_growth *growth, struct hatch_solver *solver,
                                   const struct hatch_lapped_options *options, uint32_t seed_face, double radius_min,
                                   struct hatch_patch_notes *notes, struct hatch_err *err)
{
    struct hatch_patch *patch = &growth->patch;
    struct trial trial = {.solved_radius = 0};
    begin_patch(growth, options, seed_face, notes);
    for (int round = 0; round <= ROUNDS_MAX && !notes->given_up; round++) {
        if (round == ROUNDS_MAX)
            reduce_to_seed_face(growth, &trial);
        HATCH_TRY(run_round(growth, solver, options, &trial, err));
        if (round == 0)
            HATCH_TRY(store_first_attempt(growth, err));
        if (!plan_next_round(growth, &trial))
            break;
        notes->given_up = patch->radius < radius_min || (radius_min > 0 && trial.seed_face_exceeds);
    }
    if (!notes->given_up)
        set_start_faces_max(growth);
    notes->cut = trial.verdict.cut;
    notes->solved_faces = trial.solved_faces;
    return HATCH_OK;
}
