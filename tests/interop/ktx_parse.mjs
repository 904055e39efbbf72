// ktx_parse.mjs FILE: prints the texels of a KTX2 file as read by ktx-parse, level after level. Fails when the header, the
// data format descriptor or the order of the keys violates the specification.
import { readFileSync, writeSync } from 'node:fs';
import assert from 'node:assert/strict';
import { createRequire } from 'node:module';
import { pathToFileURL } from 'node:url';

const require = createRequire(process.env.INTEROP + '/');
const { read } = await import(pathToFileURL(require.resolve('ktx-parse')));
const bytes = readFileSync(process.argv[2]);
const ktx = read(new Uint8Array(bytes));

const plain = { 9: 1, 16: 2, 23: 3, 37: 4 }[ktx.vkFormat];
// R32UI, BC1, BC4, BC7: colour model, bytes of a block, texels each way, bits and largest number of its sample
const packed = {
    98: [1, 4, 1, 32, 1],
    131: [128, 8, 4, 64, 0xffffffff],
    139: [131, 8, 4, 64, 0xffffffff],
    145: [134, 16, 4, 128, 0xffffffff],
}[ktx.vkFormat];
assert(plain || packed, 'a format that is known');
const [model, block, side, bits, upper] = packed ?? [1, plain, 1, 8, 255];
assert.equal(ktx.typeSize, ktx.vkFormat === 98 ? 4 : 1);
assert.equal(ktx.faceCount, 1);
assert.equal(ktx.supercompressionScheme, 0);

const [dfd] = ktx.dataFormatDescriptor;
assert.equal(dfd.vendorId, 0);
assert.equal(dfd.descriptorType, 0);
assert.equal(dfd.versionNumber, 2);
assert.equal(dfd.colorModel, model); // 1: RGBSDA
assert.equal(dfd.colorPrimaries, 1); // BT.709
assert.equal(dfd.transferFunction, 1); // linear
assert.deepEqual([...dfd.texelBlockDimension], [side - 1, side - 1, 0, 0]);
assert.equal(dfd.bytesPlane[0], block);
assert.equal(dfd.samples.length, plain ?? 1);
dfd.samples.forEach((sample, c) => {
    assert.equal(sample.bitOffset, 8 * c);
    assert.equal(sample.bitLength, bits - 1);
    assert.equal(sample.channelType, [0, 1, 2, 15][c]);
    assert.equal(sample.sampleLower, 0);
    assert.equal(sample.sampleUpper >>> 0, upper);
});

const keys = Object.keys(ktx.keyValue);
assert.deepEqual(keys, [...keys].sort());
assert(keys.includes('KTXwriter'));

// Levels must be stored smallest first, aligned to lcm(4, block), without overlap.
const alignment = block === 3 ? 12 : Math.max(block, 4);
let end = 0;
for (let level = ktx.levels.length; level-- > 0; ) {
    const at = Number(bytes.readBigUInt64LE(80 + 24 * level));
    assert.equal(at % alignment, 0);
    assert(at >= end && at - end < alignment || end === 0);
    end = at + Number(bytes.readBigUInt64LE(80 + 24 * level + 8));
}
assert.equal(end, bytes.length);
for (const level of ktx.levels)
    for (let at = 0; at < level.levelData.length; )
        at += writeSync(1, level.levelData, at);
