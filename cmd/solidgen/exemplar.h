/* A solid texture from a picture. */
#ifndef SOLIDGEN_EXEMPLAR_H
#define SOLIDGEN_EXEMPLAR_H

#include "shared/cmd.h"
#include "synthesis/synthesis.h"

/* Values of the options. */
struct solidgen_exemplar {
    const char *path; /* NULL: none */
    int method;       /* enum hatch_synthesis_method */
    int axes;         /* index into solidgen_axes */
    int64_t neighborhood, levels, iterations;
    bool exhaustive;
};

/* Names of methods, in the order of enum hatch_synthesis_method, NULL-terminated. */
extern const char *const solidgen_methods[];

/* Axes across which slices look like the picture, NULL-terminated. */
extern const char *const solidgen_axes[];

/* Reads the picture. Warns of what is not used of it. Dies on failure.
 *   size      texels along a side of a solid in full resolution
 *   made      texels along a side of the one that is made: a power of two, at most size. The picture is reduced as much
 *   exemplar  out: in args->keep */
void solidgen_read_exemplar(struct cmd_args *args, const struct solidgen_exemplar *options, uint32_t size,
                            uint32_t made, struct hatch_image *exemplar);

/* Makes the solid, in args->keep. Dies on failure. */
void solidgen_synthesize(struct cmd_args *args, const struct solidgen_exemplar *options, uint32_t size,
                         const struct hatch_image *exemplar, struct hatch_solid *solid);

#endif
