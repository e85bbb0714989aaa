'use strict';
// Many bodies over frames. Of each model there are two sets of copies: bodies that collide in the frame, and the others.

const element = id => document.getElementById(id);
const data = JSON.parse(element('data').textContent);
const canvas = element('picture'), frameCount = data.frames.length;
const state = {frame: 0, theme: '', drawn: 0};

const renderer = makeRenderer(canvas);
const scene = new THREE.Scene(), lamp = new THREE.DirectionalLight('#ffffff', 0.65);
let fitted = true;  // nobody has moved the camera since it was fitted
const camera = makeCamera(canvas, () => { fitted = false; changed(); });
camera.lens.add(lamp);
lamp.position.set(-0.4, 0.6, 1);
scene.add(new THREE.AmbientLight('#ffffff', 0.5), camera.lens);

// ---------------------------------------------------------------------------------------------------------------------
// Each model in a frame of its own, so that the card's floats hold what doubles were.

const materials = ['--a', '--wrong'].map(() => new THREE.MeshPhongMaterial({flatShading: true, shininess: 8, side: THREE.DoubleSide}));
const models = data.models.map((model, m) => {
  const points = triples(model.vertices), box = boxOf(points), positions = new Float32Array(3 * model.triangles.length);
  model.triangles.forEach((v, i) => positions.set(inFrame(box, points[v]), 3 * i));
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(positions, 3));
  geometry.computeVertexNormals();
  const count = data.bodies.filter(of => of === m).length;
  // A geometry of its own each: three.js r111 takes copies of one for the same ones.
  const copies = materials.map(material => new THREE.InstancedMesh(geometry.clone(), material, count));
  for (const mesh of copies) mesh.frustumCulled = false;
  if (count) scene.add(...copies);
  return {box, copies};
});

function corners(k)
{
  return data.frames[k].flatMap((pose, body) => cornersOf(models[data.bodies[body]].box).map(p => image(pose, p)));
}
const world = worldOf(data.frames.flatMap((_, k) => { const {low, high} = boxOf(corners(k)); return [low, high]; }));

function place()
{
  const colliding = new Set(data.pairs[state.frame].flat());
  for (const {copies} of models) for (const mesh of copies) mesh.count = 0;
  data.frames[state.frame].forEach((pose, body) => {
    const model = models[data.bodies[body]], mesh = model.copies[colliding.has(body) ? 1 : 0];
    mesh.setMatrixAt(mesh.count++, frameMatrix(model.box, pose, world, image(pose, model.box.centre)));
  });
  for (const {copies} of models) for (const mesh of copies) mesh.instanceMatrix.needsUpdate = true;
}

// ---------------------------------------------------------------------------------------------------------------------

const colourOf = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
function recolour()
{
  const dark = state.theme ? state.theme === 'dark' : matchMedia('(prefers-color-scheme: dark)').matches;
  document.documentElement.classList.toggle('dark', dark);
  materials[0].color.set(colourOf('--a'));
  materials[1].color.set(colourOf('--wrong'));
  renderer.setClearColor(colourOf('--paper'));
  drawLine();
}

// The time line: how many pairs collide in each frame, as a share of the most.
function drawLine()
{
  const line = element('line'), width = line.clientWidth, height = line.clientHeight;
  if (!width) return;
  line.width = width;
  line.height = height;
  const paint = line.getContext('2d'), step = width / frameCount;
  const most = data.pairs.reduce((most, pairs) => Math.max(most, pairs.length), 1);
  paint.fillStyle = colourOf('--collide');
  data.pairs.forEach((pairs, k) => {
    const tall = height * pairs.length / most;
    paint.fillRect(k * step, height - tall, Math.max(1, step - 1), tall);
  });
}

function tell()
{
  const pairs = data.pairs[state.frame], bodies = new Set(pairs.flat()).size;
  element('verdict').textContent = 'frame ' + (state.frame + 1) + ' of ' + frameCount + ': ' + pairs.length + (pairs.length === 1 ? ' pair collides' : ' pairs collide');
  element('contacts').textContent = bodies + ' of ' + data.bodies.length + ' bodies';
  element('pose').value = state.frame;
  element('state').textContent = JSON.stringify({ready: true, errors, frame: state.frame, frames: frameCount, bodies: data.bodies.length,
                                                 pairs: pairs.length, marked: bodies, drawn: state.drawn});
}

function draw()
{
  place();
  camera.aim();
  renderer.render(scene, camera.lens);
  ++state.drawn;
  tell();
}
const changed = onceAPicture(draw);
function setFrame(k)
{
  state.frame = ((k % frameCount) + frameCount) % frameCount;
  changed();
}
function fit()
{
  camera.fit(boxOf(corners(state.frame).map(p => inFrame(world, p))));
  fitted = true;
}
function resize()
{
  renderer.setPixelRatio(Math.min(2, devicePixelRatio || 1));
  renderer.setSize(canvas.clientWidth, canvas.clientHeight, false);
  camera.lens.aspect = canvas.clientWidth / Math.max(1, canvas.clientHeight);
  camera.free = [1, 0.82];
  drawLine();
  if (fitted) fit();
  changed();
}

let playing = false;
function play(on)
{
  playing = on;
  element('play').textContent = on ? 'Pause' : 'Play';
  const step = () => {
    if (!playing) return;
    state.frame = (state.frame + 1) % frameCount;
    draw();
    requestAnimationFrame(step);
  };
  if (on) requestAnimationFrame(step);
}

element('before').addEventListener('click', () => setFrame(state.frame - 1));
element('after').addEventListener('click', () => setFrame(state.frame + 1));
element('play').addEventListener('click', () => play(!playing));
element('pose').addEventListener('input', event => setFrame(Number(event.target.value)));
element('fit').addEventListener('click', () => { fit(); changed(); });
element('theme').addEventListener('click', () => {
  state.theme = document.documentElement.classList.contains('dark') ? 'light' : 'dark';
  recolour();
  changed();
});
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => { recolour(); changed(); });
window.addEventListener('resize', resize);

document.title = data.name + ' - tetracone';
element('name').textContent = data.name;
element('pose').max = frameCount - 1;
const first = new URLSearchParams(location.hash.slice(1)).get('frame');
if (first !== null && Number.isInteger(Number(first))) state.frame = Math.min(Math.max(0, Number(first)), frameCount - 1);
recolour();
resize();
