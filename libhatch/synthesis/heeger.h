/* Synthesis by the histograms of bands, see synthesis.h. */
#ifndef HATCH_SYNTHESIS_HEEGER_H
#define HATCH_SYNTHESIS_HEEGER_H

#include "synthesis/synthesis.h"

/* Fills a solid.
 *   exemplar  from hatch_synthesis_exemplar
 *   solid     in, out: made
 *   figures   levels and iterations are set */
enum hatch_status hatch_heeger_fill(const struct hatch_image *exemplar, const struct hatch_synthesis_options *options,
                                    struct hatch_pool *pool, const struct hatch_progress *progress,
                                    struct hatch_arena *scratch, struct hatch_solid *solid,
                                    struct hatch_synthesis_figures *figures, struct hatch_err *err) HATCH_MUST_USE;

#endif
