'use strict';
// The method of the paper: the covering, and of a level of the tree the bounding tetrahedra and spheres, and the regular hull. All
// are in the frame of their body, made when they are first asked for.

// The nodes of a level: those of the level, and the leaves above it.
function nodesAt(body, level)
{
  const nodes = [];
  body.nodes.level.forEach((l, n) => { if (l === level || (l < level && body.nodes.leaf[n])) nodes.push(n); });
  return nodes;
}

function deepest(body) { return !body.nodes ? 1 : body.nodes.level.reduce((most, level) => Math.max(most, level), 1); }

// Neighbours in the tree differ in hue, about the body's own colour.
function shade(body, i)
{
  const colour = new THREE.Color(colourOf(body.colour));
  return colour.offsetHSL(((i * 0.618034) % 1 - 0.5) * 0.24, 0, ((i * 0.381966) % 1 - 0.5) * 0.2);
}

// Bounds rounded outward can be beyond single precision, and even infinite (null), about bodies of denormal or huge coordinates: not drawn.
function drawable(point) { return point.every(x => Math.abs(x) < 1e30); }

function addTetrahedron(positions, colours, corners, colour)
{
  for (const [i, j, k] of [[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]])
    for (const p of [corners[i], corners[j], corners[k]]) {
      positions.push(p[0], p[1], p[2]);
      colours.push(colour.r, colour.g, colour.b);
    }
}

function tetrahedraObject(positions, colours, edges, opacity)
{
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.Float32BufferAttribute(positions, 3));
  geometry.setAttribute('color', new THREE.Float32BufferAttribute(colours, 3));
  const common = {vertexColors: THREE.VertexColors, side: THREE.DoubleSide};
  const material = opacity < 1 ? new THREE.MeshBasicMaterial({...common, transparent: true, opacity, depthWrite: false})
                               : new THREE.MeshPhongMaterial({...common, flatShading: true, shininess: 5});
  const group = new THREE.Group();
  group.add(new THREE.Mesh(geometry, material));
  if (edges.length) {
    const lines = new THREE.BufferGeometry();
    lines.setAttribute('position', new THREE.Float32BufferAttribute(edges, 3));
    const opacity = Math.min(0.35, 300 / edges.length + 0.05);
    group.add(new THREE.LineSegments(lines, withColour(new THREE.LineBasicMaterial({transparent: true, opacity}), '--ink')));
  }
  return group;
}

// The tetrahedra O W Q Q' of JS08 Theorem 1, each drawn smaller about its own centre, so that one can see between them.
function coveringObject(body, shrink)
{
  const positions = [], colours = [], origin = body.local(body.covering.origin), negative = new THREE.Color(colourOf('--negative'));
  const flat = new THREE.Color('#888888'), corners = triples(body.covering.triangles);
  corners.forEach((triangle, i) => {
    const sign = body.covering.signs[i], points = [origin, ...triangle.map(v => body.local(body.points[v]))];
    const centre = [0, 1, 2].map(k => points.reduce((sum, p) => sum + p[k], 0) / 4);
    const smaller = points.map(p => p.map((x, k) => centre[k] + shrink * (x - centre[k])));
    addTetrahedron(positions, colours, smaller, sign > 0 ? shade(body, i) : sign < 0 ? negative : flat);
  });
  return tetrahedraObject(positions, colours, [], 1);
}

function boundingTetrahedra(body, level)
{
  const positions = [], colours = [], edges = [], origin = body.local(body.covering.origin);
  nodesAt(body, level).forEach((n, i) => {
    const t = body.nodes.tetrahedron.slice(9 * n, 9 * n + 9);
    const corners = [origin, ...triples(t).map(body.local)];
    if (t.includes(null) || !corners.every(drawable)) return;
    addTetrahedron(positions, colours, corners, shade(body, i));
    for (const [i, j] of [[0, 1], [0, 2], [0, 3], [1, 2], [2, 3], [3, 1]]) edges.push(...corners[i], ...corners[j]);
  });
  return tetrahedraObject(positions, colours, edges, 0.3);
}

function boundingSpheres(body, level)
{
  const nodes = nodesAt(body, level).filter(n => {
    const sphere = body.nodes.sphere.slice(4 * n, 4 * n + 4);
    return !sphere.includes(null) && drawable([...body.local(sphere.slice(0, 3)), sphere[3] / body.box.extent]);
  });
  // Many spheres are small on the screen: fewer triangles each.
  const ball = new THREE.IcosahedronBufferGeometry(1, nodes.length > 1500 ? 2 : 3);
  // Seen as one skin about the body, which is drawn before it.
  const skin = withColour(new THREE.MeshPhongMaterial({transparent: true, opacity: 0.4, shininess: 20}), body.colour);
  const mesh = new THREE.InstancedMesh(ball, skin, nodes.length);
  nodes.forEach((n, i) => {
    const [x, y, z, radius] = body.nodes.sphere.slice(4 * n, 4 * n + 4), r = radius / body.box.extent;
    mesh.setMatrixAt(i, new THREE.Matrix4().makeScale(r, r, r).setPosition(...body.local([x, y, z])));
  });
  mesh.frustumCulled = false;
  mesh.renderOrder = 2;
  return mesh;
}

// The cones of a level, by the directions of their rays: octants, then four children each by the midpoints (JS08 Definition 4).
function conesOf(level)
{
  let cones = [];
  for (let k = 0; k < 8; ++k) cones.push([[0, 0, k & 4 ? -1 : 1], [k & 1 ? -1 : 1, 0, 0], [0, k & 2 ? -1 : 1, 0]]);
  const middle = (a, b) => a.map((x, k) => (x + b[k]) / 2);
  for (; level > 1; --level)
    cones = cones.flatMap(([a, b, c]) => {
      const ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      return [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]];
    });
  return cones;
}

// All corners at distance dmax from V0 (JS08 Definition 7); deeper than that is convex, a sphere stands in its place and is not drawn.
function regularHull(body)
{
  const points = [];
  if (body.hull.dmax > 0 && drawable([body.hull.dmax / body.box.extent]))
    for (const cone of conesOf(body.hull.level))
      for (const ray of cone) {
        const length = Math.hypot(...ray);
        points.push(body.local(ray.map((x, k) => body.covering.origin[k] + x / length * body.hull.dmax)));
      }
  const geometry = geometryOf(points), group = new THREE.Group();
  const common = {transparent: true, depthWrite: false}, wires = body.hull.level > 5 ? 0.08 : 0.25;
  const sheet = withColour(new THREE.MeshLambertMaterial({...common, opacity: 0.15, side: THREE.DoubleSide}), body.colour);
  const net = withColour(new THREE.MeshBasicMaterial({...common, opacity: wires, wireframe: true}), body.colour);
  group.add(new THREE.Mesh(geometry, sheet), new THREE.Mesh(geometry, net));
  return group;
}
