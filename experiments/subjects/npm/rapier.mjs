// Rapier (parry), from npm: triangle meshes, or with the word `hull` convex polyhedra. Its shapes are copied into
// WebAssembly, and a mesh's tree is built, at each question. Rays meet either; hulls are swept.
import RAPIER from '@dimforge/rapier3d-compat';
import { serve } from './subject.mjs';

await RAPIER.init();
const hull = process.argv[2] === 'hull';
const place = ([w, x, y, z, ...t]) => [{ x: t[0], y: t[1], z: t[2] }, { x, y, z, w }];

serve({
  library: '@dimforge/rapier3d-compat',
  hello: hull ? { name: 'Rapier hull', bodies: 'convex', questions: ['solid', 'ray', 'first contact'] } :
    { name: 'Rapier mesh', questions: ['surface', 'ray'] },
  prepare: ({ vertices, triangles }) => {
    const v = Float32Array.from(vertices);
    return hull ? new RAPIER.ConvexPolyhedron(v, null) : new RAPIER.TriMesh(v, triangles);
  },
  collide: (a, b, { rigid_a, rigid_b }) => {
    const [position, rotation] = place(rigid_a);
    return a.intersectsShape(position, rotation, b, ...place(rigid_b));
  },
  // Not solid: a ray from within meets the surface. Its limit is that of floats.
  ray: (a, [x, y, z], [u, v, w]) => {
    const hit = a.castRay(new RAPIER.Ray({ x, y, z }, { x: u, y: v, z: w }), { x: 0, y: 0, z: 0 }, { x: 0, y: 0, z: 0, w: 1 }, 3e38, false);
    return hit < 0 ? null : hit;
  },
  firstContact: (a, b, m) => {
    if ([0, 1, 2, 3].some((k) => m.rigid_a[k] !== m.rigid_end_a[k] || m.rigid_b[k] !== m.rigid_end_b[k])) return undefined;
    const way = (from, to) => ({ x: to[4] - from[4], y: to[5] - from[5], z: to[6] - from[6] });
    const hit = a.castShape(...place(m.rigid_a), way(m.rigid_a, m.rigid_end_a), b, ...place(m.rigid_b), way(m.rigid_b, m.rigid_end_b), 0, 1, true);
    return hit ? hit.time_of_impact : null;
  },
});
