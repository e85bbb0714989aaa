// Manifold, from npm: solids whose smallest gap is 0. Its interface to JavaScript takes vertices of float. It declines
// what is not an oriented 2-manifold; poses are any affine map.
import load from 'manifold-3d';
import { serve } from './subject.mjs';

const { Manifold, Mesh, setup } = await load().then((m) => (m.setup(), m));

const columns = (m) => [m[0], m[4], m[8], 0, m[1], m[5], m[9], 0, m[2], m[6], m[10], 0, m[3], m[7], m[11], 1];

serve({
  library: 'manifold-3d',
  hello: { name: 'Manifold', precision: 'float64', vertices: 'float32', bodies: 'manifold', poses: 'affine', questions: ['solid'] },
  prepare: ({ vertices, triangles }) => {
    try {
      const solid = new Manifold(new Mesh({ numProp: 3, vertProperties: Float32Array.from(vertices), triVerts: triangles }));
      return solid.status() === 'NoError' && solid.volume() > 0 ? solid : null;
    } catch (refusal) {
      console.error(String(refusal));
      return null;
    }
  },
  collide: (a, b, { pose_a, pose_b }) => {
    const placed = [a.transform(columns(pose_a)), b.transform(columns(pose_b))];
    const size = 1 + Math.max(...[...pose_a, ...pose_b].map(Math.abs));
    const gap = placed[0].minGap(placed[1], size);
    placed.forEach((solid) => solid.delete());
    return gap === 0;
  },
  release: (solid) => solid.delete(),
});
