#!/usr/bin/env node
// measure_three.mjs FILE...: what three.js shows of each glTF file's default scene, in the world: triangles, bounding
// box, area. Run where three is installed (npm install three@0.160.1).
import fs from 'fs';
import path from 'path';
import * as THREE from 'three';
import { GLTFLoader } from 'three/examples/jsm/loaders/GLTFLoader.js';

globalThis.self = globalThis;
globalThis.ProgressEvent ??= class extends Event {};

const dataUri = bytes => 'data:application/octet-stream;base64,' + Buffer.from(bytes).toString('base64');

/** As JSON that needs no other file and no pictures. */
function selfContained(file) {
    const bytes = fs.readFileSync(file);
    let json, binary;
    if (bytes.toString('latin1', 0, 4) === 'glTF') {
        const length = bytes.readUInt32LE(12);
        json = JSON.parse(bytes.toString('utf8', 20, 20 + length));
        binary = bytes.subarray(28 + length);
    } else {
        json = JSON.parse(bytes.toString('utf8'));
    }
    for (const buffer of json.buffers ?? []) {
        if (buffer.uri === undefined) buffer.uri = dataUri(binary);
        else if (!buffer.uri.startsWith('data:'))
            buffer.uri = dataUri(fs.readFileSync(path.join(path.dirname(file), decodeURIComponent(buffer.uri))));
    }
    for (const key of ['materials', 'textures', 'images', 'samplers', 'animations']) delete json[key];
    for (const mesh of json.meshes ?? []) for (const primitive of mesh.primitives) delete primitive.material;
    return JSON.stringify(json);
}

function measure(scene) {
    scene.updateMatrixWorld(true);
    const box = new THREE.Box3(), corners = [0, 1, 2].map(() => new THREE.Vector3());
    const place = new THREE.Matrix4();
    let triangles = 0, area = 0;
    scene.traverse(object => {
        if (!object.isMesh) return;
        const { index, attributes } = object.geometry;
        const count = index ? index.count : attributes.position.count;
        for (let instance = 0; instance < (object.isInstancedMesh ? object.count : 1); ++instance) {
            place.identity();
            if (object.isInstancedMesh) object.getMatrixAt(instance, place);
            place.premultiply(object.matrixWorld);
            for (let i = 0; i + 2 < count; i += 3) {
                corners.forEach((corner, k) => {
                    object.getVertexPosition(index ? index.getX(i + k) : i + k, corner).applyMatrix4(place);
                    box.expandByPoint(corner);
                });
                area += new THREE.Triangle(...corners).getArea();
                ++triangles;
            }
        }
    });
    return [triangles, ...box.min.toArray(), ...box.max.toArray(), area];
}

for (const file of process.argv.slice(2)) {
    const { scene } = await new GLTFLoader().parseAsync(selfContained(file), '');
    console.log([file, ...measure(scene)].join('\t'));
}
