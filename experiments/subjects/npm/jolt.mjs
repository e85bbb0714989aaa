// Jolt, from npm: convex hulls. Its release build answers 0 for two triangle meshes, so meshes are declined. Touching
// is no hit by design. Recommended sizes are 0.1 to 10 m.
import load from 'jolt-physics';
import { serve } from './subject.mjs';

const J = await load();
const setup = new J.JoltSettings(), pairs = new J.ObjectLayerPairFilterTable(1), layers = new J.BroadPhaseLayerInterfaceTable(1, 1);
layers.MapObjectToBroadPhaseLayer(0, new J.BroadPhaseLayer(0));
setup.mObjectLayerPairFilter = pairs;
setup.mBroadPhaseLayerInterface = layers;
setup.mObjectVsBroadPhaseLayerFilter = new J.ObjectVsBroadPhaseLayerFilterTable(layers, 1, pairs, 1);
new J.JoltInterface(setup);  // registers the kinds of shapes

const one = new J.Vec3(1, 1, 1), origin = new J.RVec3(0, 0, 0), filter = new J.ShapeFilter();
const settings = new J.CollideShapeSettings(), collector = new J.CollideShapeAnyHitCollisionCollector();
const placed = [0, 1].map(() => new J.TransformedShape()), at = new J.RVec3(), turn = new J.Quat();

function place(transformed, shape, [w, x, y, z, ...t]) {
  transformed.mShape = shape;
  at.Set(...t);
  turn.Set(x, y, z, w);
  transformed.SetWorldTransform(at, turn, one);
  return transformed;
}

serve({
  library: 'jolt-physics',
  hello: { name: 'Jolt hull', bodies: 'convex', questions: ['solid'], touching: 'open', sizes: [0.1, 10] },
  prepare: ({ vertices }) => {
    const hull = new J.ConvexHullShapeSettings(), point = new J.Vec3();
    for (let k = 0; k < vertices.length; k += 3) {
      point.Set(...vertices.subarray(k, k + 3));
      hull.mPoints.push_back(point);
    }
    const made = hull.Create(), shape = made.IsValid() ? made.Get() : null;
    if (shape) shape.AddRef();
    else console.error(made.GetError().c_str());
    J.destroy(point);
    J.destroy(hull);
    return shape;
  },
  collide: (a, b, { rigid_a, rigid_b }) => {
    place(placed[0], a, rigid_a);
    const there = place(placed[1], b, rigid_b).GetCenterOfMassTransform();
    collector.Reset();
    placed[0].CollideShape(b, one, there, settings, origin, collector, filter);
    return collector.HadHit();
  },
  release: (shape) => shape.Release(),
});
