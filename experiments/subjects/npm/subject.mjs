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
// Other kinds of question, which the hello names: `inside(a, point)` returns -1, 0 or 1; `distance(a, b, poses)` a number, null to decline;
// `ray(a, origin, direction)` and `firstContact(a, b, poses)` return t, null where nothing is met, undefined to decline.
export async function serve({ hello, library, prepare, collide, inside, distance, ray, firstContact, ready = () => {}, release = () => {} }) {
  const takes = { precision: 'float32', bodies: 'any', poses: 'rigid', questions: ['surface'], touching: 'closed', batch: true, ...hello };
  const say = (message) => process.stdout.write(JSON.stringify(message) + '\n');
  say({ hello: 1, version: version(library), library: `${library}@${version(library)}`, script: script(), ...takes });
  const bodies = new Map();

  const form = (body) => {
    if (!('form' in body)) body.form = body.triangles && (takes.bodies !== 'convex' || isConvex(body)) ? prepare(body) : null;
    return body.form;
  };
  const met = (t) => t === undefined ? { answer: null } : t === null ? { answer: 0 } : { answer: 1, t };
  const yes = (hit) => ({ answer: hit == null ? null : hit ? 1 : 0 });
  const kinds = {
    inside: (a, b, m) => ({ answer: inside(a, m.point) }),
    ray: (a, b, m) => met(ray(a, m.origin, m.direction)),
    distance: (a, b, m) => ({ answer: distance(a, b, m) }),
    within: (a, b, m) => {
      const d = distance(a, b, m);
      return yes(d == null ? null : d <= number(m.limit));
    },
    'first contact': (a, b, m) => met(firstContact(a, b, m)),
  };
  const answer = (m) => {
    const declined = { ask: m.ask, answer: null };
    if (!takes.questions.includes(m.question)) return declined;
    for (const which of ['a', 'b', 'end_a', 'end_b']) {
      const [pose, motion] = which.length > 1 ? [which, `rigid_${which}`] : [`pose_${which}`, `rigid_${which}`];
      if (!(pose in m)) continue;
      m[pose] = m[pose].map(number);
      if (takes.poses === 'rigid' && !(m[motion] ??= rigid(m[pose]))) return declined;
    }
    const forms = [m.a, m.b].filter((body) => body !== undefined).map((body) => form(bodies.get(body)));
    if (forms.some((f) => f == null)) return declined;
    const [a, b] = forms;
    ready(a, b ?? a);
    const start = process.hrtime.bigint();
    const told = kinds[m.question]?.(a, b, m) ?? yes(collide(a, b, m));
    if (told.answer === null) return declined;
    return { ask: m.ask, ...told, ns: Number(process.hrtime.bigint() - start) };
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
