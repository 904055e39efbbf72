/* How strokes fade between two levels of a recursive procedural tonal art map, and with tone.
 *
 * Going out from a dense level (m = 0) to the sparse one (m = 1), strokes grow to twice their size in
 * the pattern, a quarter of them stay and the others go. Ink per area is then in proportion to
 * 4^m (1 + 3 f) / 4, where f is the mean share of their ink that those that go still have. */
#ifndef HATCH_SEED_FADE_H
#define HATCH_SEED_FADE_H

enum hatch_fade_law {
    HATCH_FADE_EVEN, /* f = (4^(1 - m) - 1) / 3: the ink per area does not change */
    HATCH_FADE_PAPER /* f = 1 - m (Algorithm 2, line 14): up to 26 % more ink on the way */
};

/* f at m, 0 .. 1. */
double hatch_fade_share(enum hatch_fade_law law, double m);

/* The weight, 0 .. 1, of the stroke at `rank` (0 .. 1, the last to go at 0) among many whose weights' mean is to
 * be f. overlap, 0 .. 1: the share of the strokes that are on their way at one time: 1 is all of
 * them together, 0 one after the other. */
double hatch_fade_weight(double f, double rank, double overlap);

/* What of the above is the same for all ranks: weight = clamp((x - rank (1 - overlap)) / overlap). */
double hatch_fade_front(double f, double overlap);

#endif
