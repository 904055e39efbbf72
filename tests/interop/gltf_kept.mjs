// gltf_kept.mjs A B [fewer]: prints "kept" if B has all of A's scene except the parts that lapped-param replaces, else
// what is missing. fewer: B may lack vertices of A.
import { readFileSync } from 'node:fs';

function read(path) {
    const file = readFileSync(path);
    const length = file.readUInt32LE(12);
    return { json: JSON.parse(file.subarray(20, 20 + length)), bin: file.subarray(28 + length) };
}

const readers = { 5121: [1, 'readUInt8'], 5123: [2, 'readUInt16LE'], 5125: [4, 'readUInt32LE'], 5126: [4, 'readFloatLE'] };
const widths = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT4: 16 };
function numbers({ json, bin }, index) {
    const { bufferView, componentType, count, type } = json.accessors[index];
    const [size, reader] = readers[componentType];
    const at = json.bufferViews[bufferView].byteOffset ?? 0;
    return Array.from({ length: count * widths[type] }, (_, i) => bin[reader](at + i * size));
}

// Attributes of every vertex of a mesh, by its position.
function places(file, mesh, names) {
    const found = new Map();
    for (const { attributes } of file.json.meshes[mesh].primitives) {
        const lists = names.map((name) => (name in attributes ? numbers(file, attributes[name]) : []));
        const positions = numbers(file, attributes.POSITION);
        for (let v = 0; v < positions.length / 3; v++) {
            const key = positions.slice(3 * v, 3 * v + 3).join();
            const width = (list) => list.length / (positions.length / 3);
            const value = lists.map((list) => list.slice(v * width(list), (v + 1) * width(list)).join()).join(';');
            found.set(key, (found.get(key) ?? new Set()).add(value));
        }
    }
    return found;
}

const [a, b] = process.argv.slice(2, 4).map(read);
const lost = [];
const same = (what, x, y) => JSON.stringify(x) === JSON.stringify(y) || lost.push(what);
for (const part of ['nodes', 'cameras', 'extensions', 'scenes'])
    same(part, a.json[part], b.json[part]);
// The outline replaces the textures of materials and their transforms.
const used = (file) => file.json.extensionsUsed?.filter((name) => name !== 'KHR_texture_transform');
same('extensionsUsed', used(a), used(b));
const skins = (file) => file.json.skins?.map((s) => [s.joints, numbers(file, s.inverseBindMatrices)]);
same('skins', skins(a), skins(b));
const motion = (file) => file.json.animations?.map(({ channels, samplers }) => [
    channels,
    samplers.map((s) => [s.interpolation, numbers(file, s.input), numbers(file, s.output)]),
]);
same('animations', motion(a), motion(b));
const replaced = /^(POSITION|TANGENT|TEXCOORD_\d|_HATCH_DIR)$/;
a.json.meshes.forEach((mesh, m) => {
    const names = Object.keys(mesh.primitives[0].attributes).filter((name) => !replaced.test(name));
    const [was, is] = [places(a, m, names), places(b, m, names)];
    for (const [place, values] of was)
        if (!is.has(place)) process.argv[4] === 'fewer' || lost.push(`mesh ${m}: position ${place}`);
        else for (const value of is.get(place)) if (!values.has(value)) lost.push(`mesh ${m} at ${place}: ${value}`);
});
console.log(lost.length ? lost.slice(0, 5).join('\n') : 'kept');
