// fine_tone.mjs KIND FLOATS TEXELS NUMBER ...: fails unless TEXELS, as read by ktx-parse, equal FLOATS, as read by
// OpenImageIO: part after part, each level after level.
import { readFileSync } from 'node:fs';
import assert from 'node:assert/strict';

const [what, floatFile, texelFile, ...numbers] = process.argv.slice(2);
const bytes = readFileSync(floatFile);
const floats = new Float32Array(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));
const texels = readFileSync(texelFile);
const [size] = numbers.map(Number);

const sides = [];
for (let side = size; side >= 1; side >>= 1) sides.push(side);
const chain = sides.reduce((sum, side) => sum + side * side, 0);
// Offset of a level of a part of EXR, in texels.
const starts = sides.map((_, level) => sides.slice(0, level).reduce((sum, side) => sum + side * side, 0));
const near = (got, want, most, where) =>
    assert(Math.abs(got - 255 * want) <= most, `${where}: ${got} for ${255 * want}`);

const checks = {
    // Slice k of level l is the column of its tone; below the drawn levels the mean of eight.
    volume(size, columns, tones, levels) {
        assert.equal(floats.length, columns * chain);
        let at = 0, before = 0;
        for (let level = 0; level < Math.max(sides.length, Math.log2(tones) + 1); level++) {
            const side = sides[level] ?? 1, depth = Math.max(1, tones >> level), from = at;
            for (let k = 0; k < depth; k++)
                for (let i = 0; i < side * side; i++, at++) {
                    if (level < levels) {
                        const column = ((k + 0.5) / depth) * columns - 1;
                        assert.equal(column, Math.round(column));
                        near(texels[at], floats[column * chain + starts[level] + i], 0.5001, `level ${level}`);
                        continue;
                    }
                    const wide = Math.max(1, size >> (level - 1)), deep = Math.max(1, tones >> (level - 1));
                    const rx = wide > 1 ? 2 : 1, rz = deep > 1 ? 2 : 1;
                    let sum = 0;
                    for (let z = 0; z < rz; z++)
                        for (let y = 0; y < rx; y++)
                            for (let x = 0; x < rx; x++)
                                sum += texels[before + ((k * rz + z) * wide + Math.floor(i / side) * rx + y) * wide
                                    + (i % side) * rx + x];
                    near(texels[at], sum / (255 * rx * rx * rz), 0.5001, `filtered level ${level}`);
                }
            before = from;
        }
        assert.equal(at, texels.length);
    },
    // Part k of the EXR file has on level l the slice k >> l.
    slices(size, tones) {
        assert.equal(floats.length, tones * chain);
        let at = 0;
        sides.forEach((side, level) => {
            const depth = Math.max(1, tones >> level);
            for (let k = 0; k < tones; k++)
                for (let i = 0; i < side * side; i++) {
                    const slice = Math.min(k >> level, depth - 1);
                    near(texels[at + slice * side * side + i], floats[k * chain + starts[level] + i], 0.1, `slice ${k}`);
                }
            at += depth * side * side;
        });
    },
    layers(size) {
        assert.equal(floats.length, 4 * 4 * chain);
        assert.equal(texels.length, 4 * 4 * chain);
        sides.forEach((side, level) => {
            for (let layer = 0; layer < 4; layer++)
                for (let i = 0; i < side * side * 4; i++)
                    near(texels[16 * starts[level] + layer * side * side * 4 + i],
                         floats[4 * (layer * chain + starts[level]) + i], 0.1, `layer ${layer}`);
        });
    },
    // The steps of a texel sum to the darkness of the last column, and the masks are 1.
    sums(size, columns) {
        sides.forEach((side, level) => {
            const plane = side * side * 4, at = 16 * starts[level];
            for (let i = 0; i < side * side; i++) {
                let sum = 0;
                for (let bin = 0; bin < 7; bin++)
                    sum += texels[at + (2 + (bin >> 2)) * plane + 4 * i + (bin & 3)];
                near(sum, 1 - floats[(columns - 1) * chain + starts[level] + i], 0.5001, `level ${level}`);
                assert.equal(texels[at + plane + 4 * i + 3], 255);
                assert.equal(texels[at + 3 * plane + 4 * i + 3], 255);
            }
        });
    },
    exact(size, columns) {
        const word = (i) => texels.readUInt32LE(4 * i);
        assert.deepEqual([0, 1, 2, 4, 7].map(word), [1, size, sides.length, columns, 0]);
        for (let column = 0; column < columns; column++)
            assert(Math.abs(texels.readFloatLE(4 * (8 + sides.length + column)) - (column + 1) / columns) < 1e-6);
        sides.forEach((side, level) => {
            for (let i = 0; i < side * side; i++) {
                const index = word(8 + level) + i;
                let run = word(index), darkness = 0;
                for (let column = 0; column < columns; column++) {
                    const at = 4 * word(5) + 2 * run;
                    if (run < word(index + 1) && texels[at] === column) {
                        assert(texels[at + 1] > darkness);
                        darkness = texels[at + 1];
                        run++;
                    }
                    near(darkness, 1 - floats[column * chain + starts[level] + i], 0.5001, `column ${column}`);
                }
                assert.equal(run, word(index + 1));
            }
        });
    },
};
checks[what](...numbers.map(Number));
