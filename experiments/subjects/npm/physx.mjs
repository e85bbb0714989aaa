// PhysX, from npm: triangle meshes, or with the word `hull` convex meshes, by PxGeometryQuery::overlap.
import { file, serve } from './subject.mjs';

// The package is made for browsers and refuses node: it is told that there is none, and given its own program.
const node = globalThis.process;
globalThis.process = undefined;
globalThis.window = globalThis;
const { default: load } = await import('physx-js-webidl');
const P = await load({ wasmBinary: file('node_modules/physx-js-webidl/physx-js-webidl.wasm'), print: console.error, printErr: console.error });
globalThis.process = node;

const version = P.PHYSICS_VERSION, top = P.PxTopLevelFunctions.prototype;
const foundation = top.CreateFoundation(version, new P.PxDefaultAllocator(), new P.PxDefaultErrorCallback());
const scale = new P.PxTolerancesScale();
top.CreatePhysics(version, foundation, scale);
const cooking = new P.PxCookingParams(scale), hull = node.argv[2] === 'hull';
const poses = [0, 1].map(() => new P.PxTransform(P.PxIDENTITYEnum.PxIdentity));

function bounded(data, values) {
  const at = P._webidl_malloc(values.byteLength);
  P.HEAPU8.set(new Uint8Array(values.buffer), at);
  Object.assign(data, { count: values.length / 3, stride: 12, data: at });
  return at;
}
function place(pose, [w, x, y, z, ...t]) {
  [pose.q.w, pose.q.x, pose.q.y, pose.q.z] = [w, x, y, z];
  [pose.p.x, pose.p.y, pose.p.z] = t;
  return pose;
}

serve({
  library: 'physx-js-webidl',
  hello: { name: hull ? 'PhysX hull' : 'PhysX mesh', note: 'PhysX 5.6.1', ...(hull && { bodies: 'convex', questions: ['solid'] }) },
  prepare: ({ vertices, triangles }) => {
    const desc = hull ? new P.PxConvexMeshDesc() : new P.PxTriangleMeshDesc();
    const used = [bounded(desc.points, Float32Array.from(vertices))];
    if (hull) desc.flags.raise(P.PxConvexFlagEnum.eCOMPUTE_CONVEX);
    else used.push(bounded(desc.triangles, triangles));
    const mesh = hull ? top.CreateConvexMesh(cooking, desc) : top.CreateTriangleMesh(cooking, desc);
    used.forEach((at) => P._webidl_free(at));
    P.destroy(desc);
    if (mesh.ptr === 0) return null;
    return { mesh, geometry: hull ? new P.PxConvexMeshGeometry(mesh) : new P.PxTriangleMeshGeometry(mesh) };
  },
  collide: (a, b, { rigid_a, rigid_b }) =>
    P.PxGeometryQuery.prototype.overlap(a.geometry, place(poses[0], rigid_a), b.geometry, place(poses[1], rigid_b)),
  release: ({ mesh, geometry }) => {
    P.destroy(geometry);
    mesh.release();
  },
});
