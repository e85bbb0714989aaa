// three-mesh-bvh, from npm: triangle meshes of double vertices, any affine pose.
import { BufferAttribute, BufferGeometry, Matrix4 } from 'three';
import { MeshBVH } from 'three-mesh-bvh';
import { serve } from './subject.mjs';

const matrix = (m) => new Matrix4().set(...m, 0, 0, 0, 1);

serve({
  library: 'three-mesh-bvh',
  hello: { name: 'three-mesh-bvh', precision: 'float64', poses: 'affine' },
  prepare: ({ vertices, triangles }) => {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(vertices, 3));
    geometry.setIndex(new BufferAttribute(triangles, 1));
    geometry.boundsTree = new MeshBVH(geometry);
    return geometry;
  },
  collide: (a, b, { pose_a, pose_b }) => a.boundsTree.intersectsGeometry(b, matrix(pose_a).invert().multiply(matrix(pose_b))),
});
