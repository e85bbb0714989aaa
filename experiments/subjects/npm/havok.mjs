// Havok, from npm: convex hulls by shape proximity. Two meshes have no answer there, so meshes are declined. Each
// question makes a body anew, since a moved body ignores moves that are small.
import load from '@babylonjs/havok';
import { file, serve } from './subject.mjs';

const wasmBinary = file('node_modules/@babylonjs/havok/lib/esm/HavokPhysics.wasm');
const H = await load({ wasmBinary, print: console.error, printErr: console.error });
const ok = ([result, value]) => {
  if (result !== H.Result.RESULT_OK) throw new Error(`Havok's result ${result?.value ?? result}`);
  return value;
};
const world = ok(H.HP_World_Create()), collector = ok(H.HP_QueryCollector_Create(1));
const turn = ([w, x, y, z]) => [x, y, z, w], move = (r) => r.slice(4);

serve({
  library: '@babylonjs/havok',
  hello: { name: 'Havok hull', bodies: 'convex', questions: ['solid'], touching: 'open' },
  prepare: ({ vertices }) => {
    const v = Float32Array.from(vertices), at = H._malloc(v.byteLength);
    new Float32Array(H.HEAPU8.buffer, at, v.length).set(v);
    const [result, shape] = H.HP_Shape_CreateConvexHull(at, v.length / 3);
    H._free(at);
    return result === H.Result.RESULT_OK ? shape : null;
  },
  collide: (a, b, { rigid_a, rigid_b }) => {
    const body = ok(H.HP_Body_Create());
    ok([H.HP_Body_SetShape(body, a)]);
    ok([H.HP_Body_SetQTransform(body, [move(rigid_a), turn(rigid_a)])]);
    ok([H.HP_World_AddBody(world, body, false)]);
    const query = [b, move(rigid_b), turn(rigid_b), 0, true, [BigInt(0)]];
    const asked = H.HP_World_ShapeProximityWithCollector(world, collector, query);
    const hits = ok(H.HP_QueryCollector_GetNumHits(collector));
    H.HP_World_RemoveBody(world, body);
    H.HP_Body_Release(body);
    ok([asked]);
    return hits > 0;
  },
  release: (shape) => H.HP_Shape_Release(shape),
});
