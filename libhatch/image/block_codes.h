/* Codes of single texture blocks of 4x4 texels, row by row from the top. Private to image. */
#ifndef HATCH_IMAGE_BLOCK_CODES_H
#define HATCH_IMAGE_BLOCK_CODES_H

#include <stdbool.h>
#include <stdint.h>

#define HATCH_BLOCK_SIDE 4u
#define HATCH_BLOCK_TEXELS 16u

/* BC1: two end points of RGB with 5, 6 and 5 bits, and two colours between them, or one and black. Encodes and decodes
 * R, G and B; decoding sets alpha to 255. */
void hatch_bc1_encode(uint8_t texels[HATCH_BLOCK_TEXELS][4], uint8_t block[8]);
void hatch_bc1_decode(const uint8_t block[8], uint8_t texels[HATCH_BLOCK_TEXELS][4]);

/* BC4: two end points and six numbers between them, or four and 0 and 255; encoding takes the one with less error.
 * Encodes and decodes the first channel only. */
void hatch_bc4_encode(uint8_t texels[HATCH_BLOCK_TEXELS][4], uint8_t block[8]);
void hatch_bc4_decode(const uint8_t block[8], uint8_t texels[HATCH_BLOCK_TEXELS][4]);

/* BC7, mode 6: two end points of RGBA with 8 bits and sixteen steps between them. Encoding ignores the texels' alpha
 * and stores 254 or 255. Decoding returns false, and zeros, for a block of another mode. */
void hatch_bc7_encode(uint8_t texels[HATCH_BLOCK_TEXELS][4], uint8_t block[16]);
bool hatch_bc7_decode(const uint8_t block[16], uint8_t texels[HATCH_BLOCK_TEXELS][4]);

#endif
