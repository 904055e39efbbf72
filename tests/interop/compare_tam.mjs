// compare_tam.mjs FLOATS TEXELS SIZE TONES INDEX INK: fails unless TEXELS (RGBA8, level after level) equals the three
// tones from 3 * INDEX on in FLOATS (tone after tone, each level after level).
import { readFileSync } from 'node:fs';
import assert from 'node:assert/strict';

const [floatFile, texelFile, ...numbers] = process.argv.slice(2);
const [size, tones, index, ink] = numbers.map(Number);
const bytes = readFileSync(floatFile);
const floats = new Float32Array(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));
const texels = readFileSync(texelFile);

const levels = [];
for (let side = size; side >= 1; side = side >> 1) levels.push(side * side);
const chain = levels.reduce((a, b) => a + b);
assert.equal(floats.length, tones * chain);
assert.equal(texels.length, 4 * chain);
for (let at = 0; at < chain; at++)
    for (let c = 0; c < 4; c++) {
        const tone = 3 * index + c;
        const reflectance = c < 3 && tone < tones ? floats[tone * chain + at] : 1;
        const value = c === 3 ? 1 : ink ? 1 - reflectance : reflectance;
        const error = Math.abs(texels[4 * at + c] - 255 * value);
        assert(error <= 0.5001, `texel ${at} channel ${c}: ${texels[4 * at + c]} for ${255 * value}`);
    }
