// Rapier (parry), from npm: triangle meshes, or with the word `hull` convex polyhedra. Its shapes are copied into
// WebAssembly, and a mesh's tree is built, at each question.
import RAPIER from '@dimforge/rapier3d-compat';
import { serve } from './subject.mjs';

await RAPIER.init();
const hull = process.argv[2] === 'hull';
const place = ([w, x, y, z, ...t]) => [{ x: t[0], y: t[1], z: t[2] }, { x, y, z, w }];

serve({
  library: '@dimforge/rapier3d-compat',
  hello: { name: hull ? 'Rapier hull' : 'Rapier mesh', ...(hull && { bodies: 'convex', questions: ['solid'] }) },
  prepare: ({ vertices, triangles }) => {
    const v = Float32Array.from(vertices);
    return hull ? new RAPIER.ConvexPolyhedron(v, null) : new RAPIER.TriMesh(v, triangles);
  },
  collide: (a, b, { rigid_a, rigid_b }) => {
    const [position, rotation] = place(rigid_a);
    return a.intersectsShape(position, rotation, b, ...place(rigid_b));
  },
});
