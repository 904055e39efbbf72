// ktx_parse.mjs FILE: the texels of a KTX2 file as ktx-parse reads them, level after level, on standard
// output. Fails when the header, the data format descriptor or the order of the keys breaks a rule.
import { readFileSync, writeSync } from 'node:fs';
import assert from 'node:assert/strict';
import { createRequire } from 'node:module';
import { pathToFileURL } from 'node:url';

const require = createRequire(process.env.INTEROP + '/');
const { read } = await import(pathToFileURL(require.resolve('ktx-parse')));
const bytes = readFileSync(process.argv[2]);
const ktx = read(new Uint8Array(bytes));

const channels = { 9: 1, 16: 2, 23: 3, 37: 4 }[ktx.vkFormat];
assert(channels, 'an 8-bit format');
assert.equal(ktx.typeSize, 1);
assert.equal(ktx.faceCount, 1);
assert.equal(ktx.supercompressionScheme, 0);

const [dfd] = ktx.dataFormatDescriptor;
assert.equal(dfd.vendorId, 0);
assert.equal(dfd.descriptorType, 0);
assert.equal(dfd.versionNumber, 2);
assert.equal(dfd.colorModel, 1); // RGBSDA
assert.equal(dfd.colorPrimaries, 1); // BT.709
assert.equal(dfd.transferFunction, 1); // linear
assert.deepEqual([...dfd.texelBlockDimension], [0, 0, 0, 0]);
assert.equal(dfd.bytesPlane[0], channels);
assert.equal(dfd.samples.length, channels);
dfd.samples.forEach((sample, c) => {
    assert.equal(sample.bitOffset, 8 * c);
    assert.equal(sample.bitLength, 7);
    assert.equal(sample.channelType, [0, 1, 2, 15][c]);
    assert.equal(sample.sampleLower, 0);
    assert.equal(sample.sampleUpper, 255);
});

const keys = Object.keys(ktx.keyValue);
assert.deepEqual(keys, [...keys].sort());
assert(keys.includes('KTXwriter'));

// Levels: smallest first in the file, aligned to lcm(4, texel), none overlapping.
const alignment = channels === 3 ? 12 : 4;
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
