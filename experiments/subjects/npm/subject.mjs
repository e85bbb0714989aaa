// The protocol's side of each subject here: an engine gives its hello, and how it prepares, asks and releases bodies.
import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { createInterface } from 'node:readline';

for (const print of ['log', 'info', 'warn', 'debug']) console[print] = console.error;  // engines print there

const folder = new URL('.', import.meta.url);
export const file = (name) => readFileSync(new URL(name, folder));

// The version of an npm package, and a digest of our own scripts: another one is another subject.
const version = (name) => JSON.parse(file(`node_modules/${name}/package.json`)).version;
const script = () =>
  createHash('sha256').update(file('subject.mjs')).update(readFileSync(process.argv[1])).digest('hex').slice(0, 16);

const number = (x) => typeof x !== 'string' ? x : x.includes('/') ? x.split('/')[0] / x.split('/')[1] : Number(x);

// Unit quaternion w, x, y, z and translation of a pose; null where it is not rigid. For harnesses that send none.
function rigid(m) {
  const r = [m.slice(0, 3), m.slice(4, 7), m.slice(8, 11)], dot = (u, v) => u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
  for (let i = 0; i < 3; ++i)
    for (let j = i; j < 3; ++j) if (!(Math.abs(dot(r[i], r[j]) - (i === j)) <= 1e-12)) return null;
  const [[a, b, c], [d, e, f], [g, h, k]] = r;
  if (a * (e * k - f * h) - b * (d * k - f * g) + c * (d * h - e * g) < 0) return null;
  const q = [[1 + a + e + k, h - f, c - g, d - b], [h - f, 1 + a - e - k, b + d, c + g],
             [c - g, b + d, 1 - a + e - k, f + h], [d - b, c + g, f + h, 1 - a - e + k]]
    .reduce((best, row, i) => row[i] > best[0] ? [row[i], row] : best, [0])[1];
  const norm = Math.hypot(...q);
  return [...q.map((x) => x / norm), m[3], m[7], m[11]];
}

// Fans of triangles, where an old harness sends none; null where a face has a hole.
function fans(faces) {
  if (faces.some((loops) => loops.length > 1)) return null;
  return faces.flatMap(([f]) => f.slice(2).map((_, k) => [f[0], f[k + 1], f[k + 2]]));
}

// Whether the body is convex and has a volume, to 1e-12 of its size: what an engine of hulls can be asked.
export function isConvex({ vertices: v, triangles: t }) {
  if (t.length > 3 * 2000) return false;
  let side = 0, flat = true, size = 0;
  for (let k = 0; k < v.length; ++k) size = Math.max(size, Math.abs(v[k] - v[k % 3]));
  for (let k = 0; k < t.length; k += 3) {
    const [p, q, r] = [t[k], t[k + 1], t[k + 2]].map((i) => v.subarray(3 * i, 3 * i + 3));
    const u = [0, 1, 2].map((i) => (q[i] - p[i]) / size), w = [0, 1, 2].map((i) => (r[i] - p[i]) / size);
    const n = [u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]], length = Math.hypot(...n);
    if (length === 0) continue;
    for (let i = 0; i < v.length; i += 3) {
      const d = (n[0] * (v[i] - p[0]) + n[1] * (v[i + 1] - p[1]) + n[2] * (v[i + 2] - p[2])) / (length * size);
      if (Math.abs(d) <= 1e-12) continue;
      flat = false;
      if (d * side < 0) return false;
      side = Math.sign(d);
    }
  }
  return !flat;
}

// Speaks for an engine. `prepare(body)` returns its form of a body of `vertices` (Float64Array) and `triangles`
// (Uint32Array), null to decline; `collide(a, b, pose)` returns a boolean, null to decline; pose has rigid_a, rigid_b,
// pose_a and pose_b. `ready(a, b)` is not timed. `release(form)` frees it. An exception ends the program: the harness counts a failure.
export async function serve({ hello, library, prepare, collide, ready = () => {}, release = () => {} }) {
  const takes = { precision: 'float32', bodies: 'any', poses: 'rigid', questions: ['surface'], touching: 'closed', batch: true, ...hello };
  const say = (message) => process.stdout.write(JSON.stringify(message) + '\n');
  say({ hello: 1, version: version(library), library: `${library}@${version(library)}`, script: script(), ...takes });
  const bodies = new Map();

  const form = (body) => {
    if (!('form' in body)) body.form = body.triangles && (takes.bodies !== 'convex' || isConvex(body)) ? prepare(body) : null;
    return body.form;
  };
  const answer = (m) => {
    const told = { ask: m.ask, answer: null };
    if (!takes.questions.includes(m.question)) return told;
    for (const key of ['pose_a', 'pose_b']) m[key] = m[key].map(number);
    if (takes.poses === 'rigid') {
      m.rigid_a ??= rigid(m.pose_a);
      m.rigid_b ??= rigid(m.pose_b);
      if (!m.rigid_a || !m.rigid_b) return told;
    }
    const a = form(bodies.get(m.a)), b = form(bodies.get(m.b));
    if (a == null || b == null) return told;
    ready(a, b);
    const start = process.hrtime.bigint();
    const hit = collide(a, b, m);
    if (hit == null) return told;
    return { ask: m.ask, answer: hit ? 1 : 0, ns: Number(process.hrtime.bigint() - start) };
  };

  for await (const line of createInterface({ input: process.stdin, crlfDelay: Infinity })) {
    const m = JSON.parse(line);
    if ('model' in m) {
      const triangles = m.triangles ?? fans(m.faces);
      bodies.set(m.model, { vertices: Float64Array.from(m.vertices.flat()), triangles: triangles && Uint32Array.from(triangles.flat()) });
    } else if ('forget' in m) {
      const body = bodies.get(m.forget);
      if (body?.form != null) release(body.form);
      bodies.delete(m.forget);
    } else if ('asks' in m) say({ answers: m.asks.map(answer) });
    else if ('ask' in m) say(answer(m));
  }
}
