/* What the OpenImageIO plugin offers, as C functions and plain types: it is a shared object of C++
 * that is opened on demand. No exception leaves it. */
#ifndef HATCH_IO_FOREIGN_PLUGIN_H
#define HATCH_IO_FOREIGN_PLUGIN_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define HATCH_OIIO_PLUGIN_TABLE "hatch_oiio_plugin_table"
#define HATCH_OIIO_VERSION 1u

struct hatch_oiio_info {
    uint32_t width, height, channels;
    int is_encoded; /* the numbers are sRGB and not linear light */
};

/* Every function writes a sentence into message, which holds size bytes, when it fails. */
struct hatch_oiio_plugin {
    uint32_t version; /* HATCH_OIIO_VERSION, or the plugin is of another build */

    /* Reads the header of an image; data must live until close. name: its ending is a hint, no file
     * of that name is opened. Returns NULL when no reader takes it. */
    void *(*open)(const uint8_t *data, size_t data_size, const char *name, struct hatch_oiio_info *info, char *message,
                  size_t size);

    /* Decodes into width * height * channels floats; returns 0 when that fails. */
    int (*read)(void *image, float *pixels, char *message, size_t size);

    void (*close)(void *image);
};

/* The one symbol of the plugin. */
const struct hatch_oiio_plugin *hatch_oiio_plugin_table(void);

#ifdef __cplusplus
}
#endif

#endif
