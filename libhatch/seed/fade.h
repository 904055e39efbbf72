/* Fading of strokes between the nesting levels of a recursive procedural tonal art map.
 *
 * As the view moves out from one nesting level, the dense one (m = 0), to the next, the sparse one (m = 1), strokes
 * double in size relative to the pattern, a quarter of them stay, and the others fade out. Ink per area is then
 * proportional to 4^m (1 + 3 f) / 4, where f is the share of their ink that the fading strokes still have on average.
 *
 * A weighted set (Szécsi & Szirányi 2014, §8) has no level at which all strokes are whole. Each stroke vanishes at a
 * depth D of its own; of the strokes present at a depth M, the share with D - M > x is 4^-x. This exponential
 * distribution has no memory, so it is the same at every depth. The weight of a stroke is min(1, (D - M) / overlap),
 * where overlap is the number of octaves over which a stroke fades; weights too are therefore distributed alike at
 * every depth. At any depth a share of 1 - 4^-overlap of the strokes is fading, and ink per area is constant. */
#ifndef HATCH_SEED_FADE_H
#define HATCH_SEED_FADE_H

enum hatch_fade_law {
    HATCH_FADE_EVEN,    /* f = (4^(1 - m) - 1) / 3: constant ink per area */
    HATCH_FADE_PAPER,   /* f = 1 - m (Algorithm 2, line 14): up to 26 % more ink between levels */
    HATCH_FADE_WEIGHTED /* a weighted set: weights are distributed alike at every depth */
};

/* The smallest overlap, which replaces smaller ones: strokes appear and vanish abruptly. */
#define HATCH_FADE_OVERLAP_MIN 1e-6

/* Returns f at m, 0 .. 1. HATCH_FADE_WEIGHTED has the value of HATCH_FADE_EVEN; there it is the share of the fading
 * strokes that are still present. */
double hatch_fade_share(enum hatch_fade_law law, double m);

/* Returns the depth above the dense level, 0 .. 1, at which the share `rank` of the fading strokes is still present
 * under HATCH_FADE_WEIGHTED. */
double hatch_fade_death(double rank);

/* The weight of a stroke at one depth, as a function of its life, 0 (first to vanish) .. 1 (last). For EVEN and PAPER,
 * life is 1 - rank, where rank is the stroke's position in the order of the fading strokes, from the last to vanish, 0,
 * to the first, 1. For WEIGHTED, life is the depth above the dense level at which the stroke vanishes. */
struct hatch_fade {
    double base, slope; /* weight = base + slope life, clamped to 0 .. 1 */
    double next; /* added for a stroke that stays, with its life in the next level; 0: such a stroke has weight 1 */
};

/* Computes the fade at a depth.
 *   m        depth above the dense level, 0 .. 1
 *   overlap  0 .. 1. EVEN and PAPER: share of the fading strokes that fade at the same time; 1: all together, 0: one
 *            after the other. WEIGHTED: octaves of depth over which each stroke fades */
struct hatch_fade hatch_fade_at(enum hatch_fade_law law, double m, double overlap);

/* Returns base + slope life + more, clamped to 0 .. 1. */
double hatch_fade_weight(const struct hatch_fade *fade, double life, double more);

/* Returns the front, 0 .. 1, at which the fading strokes of EVEN and PAPER have the mean weight f. The weight of a
 * stroke is (front - rank (1 - overlap)) / overlap, clamped to 0 .. 1. */
double hatch_fade_front(double f, double overlap);

#endif
