/* The codes of single blocks of 4x4 texels, row by row from the top. Private to image. */
#ifndef HATCH_IMAGE_BLOCK_CODES_H
#define HATCH_IMAGE_BLOCK_CODES_H

#include <stdbool.h>
#include <stdint.h>

#define HATCH_BLOCK_SIDE 4u
#define HATCH_BLOCK_TEXELS 16u

/* BC1: two ends of RGB with five, six and five bits, and two colours between them; or one, and black. */
void hatch_bc1_encode(uint8_t texels[HATCH_BLOCK_TEXELS][4], uint8_t block[8]);
void hatch_bc1_decode(const uint8_t block[8], uint8_t texels[HATCH_BLOCK_TEXELS][4]);

/* BC4: the first number of each texel. Two ends and six numbers between them, or four and 0 and 255,
 * whichever is nearer. */
void hatch_bc4_encode(uint8_t texels[HATCH_BLOCK_TEXELS][4], uint8_t block[8]);
void hatch_bc4_decode(const uint8_t block[8], uint8_t texels[HATCH_BLOCK_TEXELS][4]);

/* BC7, mode 6: two ends of RGBA with eight bits, and sixteen steps between them. */
void hatch_bc7_encode(uint8_t texels[HATCH_BLOCK_TEXELS][4], uint8_t block[16]);
/* false, and zeros, for a block of another mode. */
bool hatch_bc7_decode(const uint8_t block[16], uint8_t texels[HATCH_BLOCK_TEXELS][4]);

#endif
