// pixi_dds.mjs FILE: prints the texels of a two-dimensional DDS file as read by PixiJS, level after level.
import { readFileSync, writeSync } from 'node:fs';
import assert from 'node:assert/strict';
import { pathToFileURL } from 'node:url';

const folder = process.env.INTEROP + '/node_modules/pixi.js/lib/compressed-textures/dds/';
const { parseDDS } = await import(pathToFileURL(folder + 'parseDDS.mjs'));
const bytes = readFileSync(process.argv[2]);
const buffer = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length);
const texture = parseDDS(buffer, ['rgba8unorm']);
assert.equal(texture.format, 'rgba8unorm');
for (const level of texture.resource)
    for (let at = 0; at < level.length; )
        at += writeSync(1, level, at);
