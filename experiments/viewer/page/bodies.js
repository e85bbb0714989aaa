'use strict';
// The bodies, where they stand, and what of them collides.
//
// Each body is kept in a frame of its own, and what is marked in a pose in a frame of that pose. Their matrices into
// the scene, which holds all poses, are computed in double.

const data = JSON.parse(document.getElementById('data').textContent);

const poseCount = Math.max(data.poses[0].length, data.bodies.length > 1 ? data.poses[1].length : 0);
function poseOf(body, k)
{
  const poses = data.poses[body.number];
  return poses[poses.length === 1 ? 0 : k];
}

const bodies = data.bodies.map((body, number) => {
  const points = triples(body.vertices), box = boxOf(points);
  return {...body, number, colour: number === 0 ? '--a' : '--b', points, box, group: new THREE.Group(),
          local: p => inFrame(box, p)};
});

// How solids stand in pose k; and the vector that moves A out of B, which is 0 where they need not part.
function solidsOf(k) { return data.solids ? data.solids[k] : null; }
function outOf(k)
{
  const solids = solidsOf(k);
  return solids && solids.out ? solids.out.vector : [0, 0, 0];
}
const plus = (p, v, s = 1) => p.map((x, i) => x + s * v[i]);

// Where a body's point stands in pose k when A is moved by a share of the way out.
function standing(body, k, p, share = 0)
{
  return plus(image(poseOf(body, k), p), outOf(k), body.number === 0 ? share : 0);
}
// The corners of a body's box there: enough for the extent of the scene.
function placedCorners(body, k, share = 0) { return cornersOf(body.box).map(p => standing(body, k, p, share)); }

// Poses may be so far apart that single precision holds no mark in a frame of all.
const poseBoxes = Array.from({length: poseCount}, (_, k) => boxOf(bodies.flatMap(body => placedCorners(body, k))));
const world = worldOf(poseBoxes.flatMap(({low, high}, k) => [low, high, ...placedCorners(bodies[0], k, 1)]));
const marked = (body, k, p, share = 0) => inFrame(poseBoxes[k], standing(body, k, p, share));

// Places a body, and A by a share of the way out.
function place(body, k, share)
{
  setMatrix(body.group, frameMatrix(body.box, poseOf(body, k), world, standing(body, k, body.box.centre, share)));
  // The other body can be larger by more than doubles can say.
  body.isPoint = body.group.matrix.determinant() === 0;
}

// Places the group of the marks of a pose; returns how large their frame is in the scene.
const unmoved = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0];
function placeMarks(group, k)
{
  setMatrix(group, frameMatrix(poseBoxes[k], unmoved, world, poseBoxes[k].centre));
  return poseBoxes[k].extent / world.extent;
}

function setMatrix(group, matrix)
{
  group.matrixAutoUpdate = false;
  group.matrix.copy(matrix);
  group.matrixWorldNeedsUpdate = true;
}

// Colours are the style sheet's: light or dark, one place says which.
const coloured = new Map();
function withColour(material, variable)
{
  coloured.set(material, variable);
  material.color.set(colourOf(variable));
  return material;
}
function colourOf(variable) { return getComputedStyle(document.documentElement).getPropertyValue(variable).trim(); }
function recolour()
{
  for (const [material, variable] of coloured) material.color.set(colourOf(variable));
}

function discard(object)
{
  object.traverse(part => {
    if (part.geometry) part.geometry.dispose();
    if (!part.material || kept.has(part.material)) return;
    part.material.dispose();
    coloured.delete(part.material);
  });
  object.parent.remove(object);
}

function geometryOf(points)
{
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.Float32BufferAttribute(points.flat(), 3));
  return geometry;
}

function edgesOf(body)
{
  const seen = new Set(), edges = [];
  for (const face of body.faces)
    for (const loop of face)
      loop.forEach((v, i) => {
        const w = loop[(i + 1) % loop.length], key = Math.min(v, w) + ' ' + Math.max(v, w);
        if (!seen.has(key)) seen.add(key), edges.push([v, w]);
      });
  return edges;
}

// The triangles of some faces, or of all.
function trianglesOf(body, faces)
{
  const points = [], t = body.triangles, wanted = faces && new Set(faces);
  for (let i = 0; i < t.length; i += 4)
    if (!wanted || wanted.has(t[i])) points.push(body.points[t[i + 1]], body.points[t[i + 2]], body.points[t[i + 3]]);
  return points;
}

const fewPoints = 100;  // a body of few vertices shows them: it may be a point or a segment
for (const body of bodies) {
  const surface = withColour(new THREE.MeshPhongMaterial({flatShading: true, side: THREE.DoubleSide, shininess: 8, polygonOffset: true,
                                                         polygonOffsetFactor: 1, polygonOffsetUnits: 1}), body.colour);
  body.surface = new THREE.Mesh(geometryOf(trianglesOf(body).map(body.local)), surface);
  const line = withColour(new THREE.LineBasicMaterial({transparent: true, opacity: body.faces.length > 2000 ? 0.25 : 0.7}), '--ink');
  body.edges = new THREE.LineSegments(geometryOf(edgesOf(body).flat().map(v => body.local(body.points[v]))), line);
  body.group.add(body.surface, body.edges);
  if (body.points.length <= fewPoints) {
    const dot = withColour(new THREE.PointsMaterial({size: 5, sizeAttenuation: false}), body.colour);
    body.group.add(body.dots = new THREE.Points(geometryOf(body.points.map(body.local)), dot));
  }
}

// ---------------------------------------------------------------------------------------------------------------------
// Colliding edges and faces, in the pose's frame: edges as rods of about the same width on the screen, faces as sheets.

const kinds = ['none', 'vertex-vertex', 'vertex-edge', 'vertex-face', 'edge-edge', 'edge-face', 'coplanar overlap'];
const markColours = ['--feature', '--wrong', '--wrong'];  // found by both, lost by the kernel, invented by it

function featuresOf(k) { return data.features ? data.features[k] : []; }

function rods(segments, widest, material)
{
  // Thin enough to tell short edges apart.
  const mean = segments.reduce((sum, [p, q]) => sum + Math.hypot(...p.map((x, k) => q[k] - x)), 0) / segments.length;
  const radius = mean > 0 ? Math.min(widest, Math.max(0.06 * mean, 0.2 * widest)) : widest;
  const rod = new THREE.CylinderBufferGeometry(1, 1, 1, 8), ball = new THREE.IcosahedronBufferGeometry(1, 1);
  const group = new THREE.Group(), up = new THREE.Vector3(0, 1, 0);
  const rodMesh = new THREE.InstancedMesh(rod, material, segments.length), ballMesh = new THREE.InstancedMesh(ball, material, 2 * segments.length);
  segments.forEach(([p, q], i) => {
    const from = new THREE.Vector3(...p), to = new THREE.Vector3(...q), along = to.clone().sub(from), length = along.length();
    const turn = length > 0 ? new THREE.Quaternion().setFromUnitVectors(up, along.clone().divideScalar(length)) : new THREE.Quaternion();
    rodMesh.setMatrixAt(i, new THREE.Matrix4().compose(from.clone().add(to).multiplyScalar(0.5), turn, new THREE.Vector3(radius, length, radius)));
    for (const [j, end] of [[0, from], [1, to]])
      ballMesh.setMatrixAt(2 * i + j, new THREE.Matrix4().compose(end, new THREE.Quaternion(), new THREE.Vector3(1, 1, 1).multiplyScalar(1.8 * radius)));
  });
  for (const mesh of [rodMesh, ballMesh]) mesh.frustumCulled = false, mesh.renderOrder = 5, group.add(mesh);
  return group;
}

const markMaterials = markColours.map(variable => ({
  rod: withColour(new THREE.MeshLambertMaterial({depthTest: false, transparent: true, opacity: 0.9}), variable),
  sheet: withColour(new THREE.MeshBasicMaterial({side: THREE.DoubleSide, transparent: true, opacity: 0.45, depthWrite: false, polygonOffset: true,
                                                  polygonOffsetFactor: -1, polygonOffsetUnits: -1}), variable)}));

function featureObject(k, radius)
{
  const group = new THREE.Group(), edges = new Map(), faces = new Map();
  // Right ones first: where an edge is in several pairs, the wrong one gives the colour.
  for (const [body, from, to, face, , mark] of [...featuresOf(k)].sort((f, g) => f[5] - g[5])) {
    edges.set(body + ' ' + from + ' ' + to, {body, from, to, mark});
    faces.set(1 - body + ' ' + face, {body: 1 - body, face, mark});
  }
  for (const mark of [0, 1, 2]) {
    const segments = [...edges.values()].filter(e => e.mark === mark)
                         .map(e => [e.from, e.to].map(v => marked(bodies[e.body], k, bodies[e.body].points[v])));
    if (segments.length) group.add(rods(segments, radius, markMaterials[mark].rod));
    const sheets = [0, 1].flatMap(b => {
      const wanted = [...faces.values()].filter(f => f.mark === mark && f.body === b).map(f => f.face);
      return wanted.length ? trianglesOf(bodies[b], wanted).map(p => marked(bodies[b], k, p)) : [];
    });
    if (!sheets.length) continue;
    const mesh = new THREE.Mesh(geometryOf(sheets), markMaterials[mark].sheet);
    mesh.renderOrder = 4;
    group.add(mesh);
  }
  return group;
}

// Where faces meet: segments, and points as segments of no length.
const contactMaterial = withColour(new THREE.MeshLambertMaterial({depthTest: false, transparent: true, opacity: 0.95}), '--contact');
function contactObject(k, radius)
{
  const segments = data.contacts[k].map(s => triples(s).map(p => inFrame(poseBoxes[k], p)));
  const group = new THREE.Group();
  if (segments.length) group.add(rods(segments, radius, contactMaterial));
  return group;
}

// Where bodies intersect themselves, as contacts are drawn.
const selfMaterial = withColour(new THREE.MeshLambertMaterial({depthTest: false, transparent: true, opacity: 0.95}), '--self');
function selfObject(k, radius, share)
{
  const group = new THREE.Group();
  for (const body of bodies) {
    const segments = body.self.map(s => triples(s).map(p => marked(body, k, p, share)));
    if (segments.length) group.add(rods(segments, radius, selfMaterial));
  }
  return group;
}

// The overlap of two solids: the parts of both surfaces that bound it, seen through the bodies.
const overlapMaterial = withColour(new THREE.MeshPhongMaterial({flatShading: true, transparent: true, opacity: 0.6, depthTest: false, depthWrite: false,
                                                               shininess: 8}), '--overlap');
function partsOf(k) { return (solidsOf(k) && solidsOf(k).parts) || []; }
function overlapObject(k)
{
  const group = new THREE.Group(), points = [];
  for (const part of partsOf(k)) {
    const corners = triples(part).map(p => inFrame(poseBoxes[k], p));
    for (let i = 2; i < corners.length; ++i) points.push(corners[0], corners[i - 1], corners[i]);
  }
  if (!points.length) return group;
  const mesh = new THREE.Mesh(geometryOf(points), overlapMaterial);
  mesh.renderOrder = 2;
  group.add(mesh);
  return group;
}

// The vector that moves A out of B, from the middle of the overlap.
// A material is for instanced meshes or for others, not for both.
const tipMaterial = withColour(new THREE.MeshBasicMaterial({depthTest: false, transparent: true}), '--ink');
function wayObject(k, radius)
{
  const group = new THREE.Group(), vector = outOf(k), corners = partsOf(k).flatMap(triples);
  if (vector.every(x => x === 0)) return group;
  const from = corners.length ? boxOf(corners).centre : image(poseOf(bodies[0], k), bodies[0].box.centre);
  const ends = [from, plus(from, vector)].map(p => inFrame(poseBoxes[k], p));
  const along = new THREE.Vector3(...plus(ends[1], ends[0], -1));
  group.add(rods([ends], radius, nearestMaterial));
  const length = Math.min(14 * radius, along.length() / 2);
  const tip = new THREE.Mesh(new THREE.ConeBufferGeometry(length / 3, length, 12), tipMaterial);
  tip.quaternion.setFromUnitVectors(new THREE.Vector3(0, 1, 0), along.clone().normalize());
  tip.position.set(...ends[1]).addScaledVector(along.normalize(), -length / 2);
  tip.renderOrder = 5;
  group.add(tip);
  return group;
}

// The two nearest points of bodies apart, and the way between them.
const nearestMaterial = withColour(new THREE.MeshBasicMaterial({depthTest: false, transparent: true}), '--ink');
function nearestObject(k, radius)
{
  const group = new THREE.Group(), [distance, ...points] = data.nearest[k];
  const ends = triples(points.slice(0, 6)).map(p => inFrame(poseBoxes[k], p));
  if (distance !== 0) group.add(rods([ends], radius, nearestMaterial));
  return group;
}

// Rays as far as a little beyond what they meet last; where they meet a face, a ball.
const rayMaterial = withColour(new THREE.MeshBasicMaterial({}), '--ray');
const hitMaterial = withColour(new THREE.MeshBasicMaterial({depthTest: false, transparent: true}), '--feature');
const hitCount = ray => ray[1].length / 2;
function rayObject(k, radius)
{
  const group = new THREE.Group(), body = bodies[0], ways = [], balls = [];
  for (const [numbers, hits] of data.rays) {
    const [from, along] = triples(numbers), at = t => marked(body, k, from.map((x, i) => x + t * along[i]));
    const times = hits.filter((x, i) => i % 2 === 1 && x !== null), beyond = body.box.extent / Math.hypot(...along);
    const way = [at(0), at(times.length ? times[times.length - 1] + beyond / 2 : 3 * beyond)];
    if (way.flat().every(Number.isFinite)) ways.push(way);
    balls.push(...times.map(at).filter(p => p.every(Number.isFinite)).map(p => [p, p]));
  }
  if (ways.length) group.add(rods(ways, radius, rayMaterial));
  if (balls.length) group.add(rods(balls, 1.5 * radius, hitMaterial));
  return group;
}

// What meets first of bodies in motion, wherever it is in pose k: a vertex, an edge or a face of each.
function firstObject(k, radius)
{
  const group = new THREE.Group();
  (data.motion.holders || []).forEach(([, numbers, isFace], b) => {
    const at = v => marked(bodies[b], k, bodies[b].points[v]), {rod, sheet} = markMaterials[0];
    if (isFace) {
      const mesh = new THREE.Mesh(geometryOf(trianglesOf(bodies[b], numbers).map(p => marked(bodies[b], k, p))), sheet);
      mesh.renderOrder = 4;
      group.add(mesh);
    } else {
      group.add(rods([[at(numbers[0]), at(numbers[numbers.length - 1])]], 1.5 * radius, rod));
    }
  });
  return group;
}

// Where the contacts are in the scene, about: the middle of the boxes' intersections of each pair.
function contactBox(k)
{
  const points = [];
  for (const [b, from, to, face] of featuresOf(k)) {
    const box = (body, vertices) => boxOf(vertices.map(v => inFrame(world, standing(body, k, body.points[v]))));
    const edge = box(bodies[b], [from, to]), other = box(bodies[1 - b], bodies[1 - b].faces[face].flat());
    points.push(edge.low.map((x, i) => Math.max(x, other.low[i])), edge.high.map((x, i) => Math.min(x, other.high[i])));
  }
  return points.length ? boxOf(points) : null;
}

// What the paper's query leaves for the leaf tests: the faces in the leaves of pairs that are not discarded.
const leftMaterial = withColour(new THREE.MeshBasicMaterial({side: THREE.DoubleSide, transparent: true, opacity: 0.75, depthWrite: false,
                                                            polygonOffset: true, polygonOffsetFactor: -1, polygonOffsetUnits: -1}), '--left');
const kept = new Set([leftMaterial, contactMaterial, selfMaterial, overlapMaterial, tipMaterial, nearestMaterial, rayMaterial, hitMaterial, ...markMaterials.flatMap(m => [m.rod, m.sheet])]);  // their objects come and go with the pose
function leftObject(k)
{
  const group = new THREE.Group();
  for (const body of bodies) {
    const faces = data.left[k][body.number].flatMap(node => body.nodes.faces[node]);
    if (!faces.length) continue;
    const mesh = new THREE.Mesh(geometryOf(trianglesOf(body, faces).map(p => marked(body, k, p))), leftMaterial);
    mesh.renderOrder = 3;
    group.add(mesh);
  }
  return group;
}
