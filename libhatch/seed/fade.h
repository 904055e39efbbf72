/* Fading of strokes between the nesting levels of a recursive procedural tonal art map.
 *
 * While the view moves out from a dense level (m = 0) to the next, sparse one (m = 1), strokes grow to twice their size
 * relative to the pattern, a quarter of them stay, and the others fade out. Ink per area is then proportional to
 * 4^m (1 + 3 f) / 4, where f is the mean share of their ink that the fading strokes still have.
 *
 * A weighted set (§8) has no level at which all strokes are whole. Each stroke vanishes at its own depth D, and of the
 * strokes present at any depth M a share of 4^-x has D - M > x. This exponential distribution has no memory, so it is
 * the same at every depth; with the weight min(1, (D - M) / overlap) so is the distribution of weights. A share of
 * 1 - 4^-overlap is fading at any time, and ink per area is constant. */
#ifndef HATCH_SEED_FADE_H
#define HATCH_SEED_FADE_H

enum hatch_fade_law {
    HATCH_FADE_EVEN,    /* f = (4^(1 - m) - 1) / 3: constant ink per area */
    HATCH_FADE_PAPER,   /* f = 1 - m (Algorithm 2, line 14): up to 26 % more ink between levels */
    HATCH_FADE_WEIGHTED /* weighted set: one distribution of weights at every depth */
};

/* Overlaps below it count as it: strokes appear and vanish at once. */
#define HATCH_FADE_OVERLAP_MIN 1e-6

/* Returns f at m, 0 .. 1. For WEIGHTED, where it equals that of EVEN, it is the share of the fading strokes that are
 * still present. */
double hatch_fade_share(enum hatch_fade_law law, double m);

/* Returns the depth above the dense level, 0 .. 1, at which a share `rank` of the fading strokes is left. */
double hatch_fade_death(double rank);

/* Weight of strokes at a depth as a function of their life, 0 (first to vanish) .. 1 (last). For EVEN and PAPER, life
 * is 1 - rank; for WEIGHTED it is the depth at which the stroke vanishes, above the dense level. */
struct hatch_fade {
    double base, slope; /* weight = base + slope life, clamped to 0 .. 1 */
    double next;        /* added for strokes that stay, whose life is that in the next level; 0: their weight is 1 */
};

/* Computes the fade at a depth.
 *   m        0 .. 1 above the dense level
 *   overlap  0 .. 1. EVEN and PAPER: share of the fading strokes that fade at the same time; 1: all together, 0: one
 *            after the other. WEIGHTED: octaves of depth over which each stroke fades */
struct hatch_fade hatch_fade_at(enum hatch_fade_law law, double m, double overlap);

/* Returns base + slope life + more, clamped to 0 .. 1. */
double hatch_fade_weight(const struct hatch_fade *fade, double life, double more);

/* Returns the position of the fading front of EVEN and PAPER for a share f:
 * weight = clamp((front - rank (1 - overlap)) / overlap). */
double hatch_fade_front(double f, double overlap);

#endif
