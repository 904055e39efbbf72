// three_ktx2.mjs FILE: prints the texels that KTX2Loader of three.js would upload from a KTX2 file, level after level.
// Fails when it would generate mip levels.
import { readFileSync, writeSync } from 'node:fs';
import assert from 'node:assert/strict';
import { pathToFileURL } from 'node:url';

const three = process.env.INTEROP + '/node_modules/three/';
const { KTX2Loader } = await import(pathToFileURL(three + 'examples/jsm/loaders/KTX2Loader.js'));
const bytes = readFileSync(process.argv[2]);
const loader = new KTX2Loader();
loader.workerConfig = {}; // what detectSupport() asks a renderer for concerns compressed formats
const buffer = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length);
const texture = await new Promise((resolve, reject) => loader.parse(buffer, resolve, reject));

assert.equal(texture.generateMipmaps, false);
assert.equal(texture.mipmaps.length, bytes.readUInt32LE(40));
assert(!texture.isCompressedTexture);
for (const level of texture.mipmaps)
    for (let at = 0; at < level.data.length; )
        at += writeSync(1, level.data, at);
