/* Interface of the OpenImageIO plugin, a C++ shared object that is loaded on demand. It consists of C functions and
 * plain types, and no exception leaves the plugin. */
#ifndef HATCH_IO_FOREIGN_PLUGIN_H
#define HATCH_IO_FOREIGN_PLUGIN_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define HATCH_OIIO_PLUGIN_TABLE "hatch_oiio_plugin_table"
#define HATCH_OIIO_VERSION 2u
#define HATCH_OIIO_OUT_OF_MEMORY "out of memory while decoding" /* message when memory ran out */

struct hatch_oiio_info {
    uint32_t width, height, channels;
    int is_encoded;       /* 1: values are sRGB; 0: linear light */
    int is_premultiplied; /* 1: colours are multiplied by alpha, the last of 2 or 4 channels */
};

/* On failure the functions write a sentence into message, an array of size bytes. */
struct hatch_oiio_plugin {
    uint32_t version; /* HATCH_OIIO_VERSION */

    /* Reads the header of an image and returns its handle, or NULL on failure. Of an OpenEXR file, the channels are Y,
     * or R, G and B, and A if it follows: those without a layer, else those of the first layer.
     *   data  must stay valid until close
     *   name  its extension selects the format; no file is opened */
    void *(*open)(const uint8_t *data, size_t data_size, const char *name, struct hatch_oiio_info *info, char *message,
                  size_t size);

    /* Decodes the pixels; returns 0 on failure.
     *   pixels  out: width * height * channels floats */
    int (*read)(void *image, float *pixels, char *message, size_t size);

    void (*close)(void *image);
};

/* The plugin's only symbol, HATCH_OIIO_PLUGIN_TABLE. */
const struct hatch_oiio_plugin *hatch_oiio_plugin_table(void);

#ifdef __cplusplus
}
#endif

#endif
