/* Encodes and decodes single texture blocks of 4x4 texels, row by row from the top. Private to image. */
#ifndef HATCH_IMAGE_BLOCK_CODES_H
#define HATCH_IMAGE_BLOCK_CODES_H

#include <stdbool.h>
#include <stdint.h>

#define HATCH_BLOCK_SIDE 4u
#define HATCH_BLOCK_TEXELS 16u

/* BC1: two RGB end points with 5, 6 and 5 bits, and either two colours between them, or one colour between them and
 * black. Encodes and decodes R, G and B only; decoding sets alpha to 255. */
void hatch_bc1_encode(uint8_t texels[HATCH_BLOCK_TEXELS][4], uint8_t block[8]);
void hatch_bc1_decode(const uint8_t block[8], uint8_t texels[HATCH_BLOCK_TEXELS][4]);

/* BC4: two end points, and either six values between them, or four values between them and the constants 0 and 255.
 * Encoding chooses whichever has the smaller error. Only the first channel is encoded and decoded. */
void hatch_bc4_encode(uint8_t texels[HATCH_BLOCK_TEXELS][4], uint8_t block[8]);
void hatch_bc4_decode(const uint8_t block[8], uint8_t texels[HATCH_BLOCK_TEXELS][4]);

/* BC7, mode 6: two RGBA end points with 8 bits per channel, and sixteen colours from one to the other. Encoding ignores
 * the alpha of the texels and stores 254 or 255. Decoding a block of another mode returns false and sets the texels to
 * zero. */
void hatch_bc7_encode(uint8_t texels[HATCH_BLOCK_TEXELS][4], uint8_t block[16]);
bool hatch_bc7_decode(const uint8_t block[16], uint8_t texels[HATCH_BLOCK_TEXELS][4]);

#endif
