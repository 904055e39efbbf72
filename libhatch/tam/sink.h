/* A callback that receives the columns of a tonal art map one after another. */
#ifndef HATCH_TAM_SINK_H
#define HATCH_TAM_SINK_H

#include "image/image.h"

/* The callback and its context. Columns come lightest first. */
struct hatch_tam_sink {
    /* tone is the index of the column; its images are valid until the call returns. */
    enum hatch_status (*take)(void *context, uint32_t tone, const struct hatch_mipmap *column, struct hatch_err *err);
    void *context;
};

#endif
