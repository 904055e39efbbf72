/* How strokes fade between the levels of a recursive procedural tonal art map.
 *
 * Going out from a dense level (m = 0) to the sparse one (m = 1), strokes grow to twice their size in
 * the pattern, a quarter of them stay and the others go. Ink per area is then in proportion to
 * 4^m (1 + 3 f) / 4, where f is the mean share of their ink that those that go still have.
 *
 * A weighted set (§8) has no level at which all strokes are whole. Each dies at a depth D of its own, and
 * among the strokes alive at any depth M the share with D - M > x is 4^-x: the same everywhere, because that
 * law has no memory. With the weight (D - M) / overlap, up to 1, the weights of the strokes that are alive
 * are then spread in the same way at every depth, between levels as on them; a share of 1 - 4^-overlap is on
 * its way at any time, and ink per area does not change at all. */
#ifndef HATCH_SEED_FADE_H
#define HATCH_SEED_FADE_H

enum hatch_fade_law {
    HATCH_FADE_EVEN,    /* f = (4^(1 - m) - 1) / 3: the ink per area does not change */
    HATCH_FADE_PAPER,   /* f = 1 - m (Algorithm 2, line 14): up to 26 % more ink on the way */
    HATCH_FADE_WEIGHTED /* weights spread alike at every depth */
};

/* f at m, 0 .. 1; of weighted sets, among which it is that of EVEN, the share of those that go which are
 * still there. */
double hatch_fade_share(enum hatch_fade_law law, double m);

/* The depth, 0 .. 1 above the dense level, at which of those that go a share `rank` is left. */
double hatch_fade_death(double rank);

/* A stroke's weight at a depth, as a function of its life, 0 .. 1: 0 of the first to go, 1 of the last. With EVEN and
 * PAPER, life is 1 - rank; with WEIGHTED it is the depth of its death above the dense level. */
struct hatch_fade {
    double base, slope; /* weight = base + slope life, 0 .. 1 */
    double next;        /* added for strokes that stay, life then being that in the next level; 0: these have
                           weight 1 */
};

/* m: 0 .. 1. overlap, 0 .. 1: EVEN and PAPER: the share of the strokes that go which are on their way at one
 * time: 1 is all of them together, 0 one after the other. WEIGHTED: octaves that each takes. */
struct hatch_fade hatch_fade_at(enum hatch_fade_law law, double m, double overlap);

/* base + slope life + more, 0 .. 1. */
double hatch_fade_weight(const struct hatch_fade *fade, double life, double more);

/* Where the front of EVEN and PAPER stands: weight = clamp((front - rank (1 - overlap)) / overlap). */
double hatch_fade_front(double f, double overlap);

#define HATCH_FADE_OVERLAP_MIN 1e-6 /* below it a stroke is there or not */

#endif
