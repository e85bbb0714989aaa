'use strict';
// The page: what is shown is `state`, which the address's fragment holds too; controls change the state, and `draw` draws it.

const element = id => document.getElementById(id);
const canvas = element('picture'), pair = bodies.length === 2, hasFeatures = Boolean(data.features);
const hasMethod = bodies.every(body => body.nodes);  // a large body has no more than its surface
const hasSelf = bodies.some(body => body.self_pairs), hasOut = Boolean(data.solids) && data.solids.some(solids => solids && solids.out);
const layers = ['a', 'b', 'edges', 'self', 'features', 'contacts', 'overlap', 'way', 'nearest', 'first', 'rays', 'left', 'covering', 'tetrahedra', 'spheres', 'hull'];
const most = Math.max(...bodies.map(deepest));
const fewFaces = bodies.every(body => body.faces.length < 500);  // through which one sees the contacts
const start = {pose: 0, show: ['a', 'b', 'edges', 'self', 'features', 'overlap', 'way', 'nearest', 'first', 'rays'], level: Math.min(3, most),
               opacity: hasFeatures && fewFaces ? 0.8 : 1, shrink: 0.8, out: 0, theme: ''};
const state = {...start, show: new Set(start.show)};
const isWrong = k => data.exact !== undefined && data.exact[k] !== data.answer[k];
const wrongPoses = Array.from({length: poseCount}, (_, k) => k).filter(isWrong);

const renderer = makeRenderer(canvas);
const scene = new THREE.Scene(), marks = new THREE.Group(), lamp = new THREE.DirectionalLight('#ffffff', 0.65);
let fitted = true;  // nobody has moved the camera since it was fitted
const camera = makeCamera(canvas, () => { fitted = false; changed(); });
camera.lens.add(lamp);
lamp.position.set(-0.4, 0.6, 1);
scene.add(new THREE.AmbientLight('#ffffff', 0.5), camera.lens, marks, ...bodies.map(body => body.group));

// ---------------------------------------------------------------------------------------------------------------------
// The fragment: pose=3&show=a,b,hull&level=4&camera=...; what is as at the start is left out, but for show and camera.

function readFragment()
{
  const given = new URLSearchParams(location.hash.slice(1));
  const number = (name, low, high) => {
    const x = given.has(name) ? Number(given.get(name)) : NaN;
    state[name] = Number.isFinite(x) ? Math.min(high, Math.max(low, x)) : start[name];
  };
  number('pose', 0, poseCount - 1);
  number('level', 1, most);
  number('opacity', 0, 1);
  number('shrink', 0.1, 1);
  number('out', 0, 1);
  state.pose = Math.round(state.pose);
  state.level = Math.round(state.level);
  state.show = new Set((given.has('show') ? given.get('show').split(',') : start.show).filter(name => layers.includes(name)));
  state.theme = ['light', 'dark'].includes(given.get('theme')) ? given.get('theme') : '';
  return given.has('camera') && camera.read(given.get('camera'));
}

let written = '', writing = 0;
function writeFragment()
{
  const parts = [['show', [...state.show].join(',')], ['camera', camera.text()]];
  for (const name of ['pose', 'level', 'opacity', 'shrink', 'out', 'theme']) if (state[name] !== start[name]) parts.push([name, state[name]]);
  written = '#' + parts.map(([name, value]) => name + '=' + value).join('&');
  history.replaceState(null, '', written);
}

// ---------------------------------------------------------------------------------------------------------------------
// Drawing, when something changed and not before.

const made = {};  // name of layer -> {key, objects}: what stands, and for which state it was made
const whereTheyStand = ['features', 'contacts', 'left'];  // not where A is moved out to
const isMovedOut = () => state.out > 0 && outOf(state.pose).some(x => x !== 0);
function layer(name, key, make)
{
  const shown = state.show.has(name) && !(isMovedOut() && whereTheyStand.includes(name));
  if (shown && (!made[name] || made[name].key !== key)) {
    if (made[name]) made[name].objects.forEach(discard);
    made[name] = {key, objects: make()};
  }
  if (made[name]) for (const object of made[name].objects) object.visible = shown;
}

// An object in the frame of each body that is shown.
function onBodies(make)
{
  return bodies.filter(body => state.show.has(body.number ? 'b' : 'a')).map(body => {
    const object = make(body);
    body.group.add(object);
    return object;
  });
}
function onMarks(object)
{
  marks.add(object);
  return [object];
}

function update()
{
  const dark = state.theme ? state.theme === 'dark' : matchMedia('(prefers-color-scheme: dark)').matches;
  if (document.documentElement.classList.contains('dark') !== dark || !update.done) {
    document.documentElement.classList.toggle('dark', dark);
    recolour();
    renderer.setClearColor(colourOf('--paper'));
    drawLine();
  }
  update.done = true;
  const which = ['a', 'b'].filter(name => state.show.has(name)).join('');
  for (const body of bodies) {
    place(body, state.pose, state.out);
    body.group.visible = state.show.has(body.number ? 'b' : 'a') && !body.isPoint;
    const material = body.surface.material, clear = state.opacity < 1;
    if (material.transparent !== clear) material.needsUpdate = true;
    Object.assign(material, {transparent: clear, opacity: state.opacity, depthWrite: !clear});
    body.surface.visible = state.opacity > 0;
    body.edges.visible = state.show.has('edges');
  }
  if (hasMethod) {
    layer('covering', which + state.shrink, () => onBodies(body => coveringObject(body, state.shrink)));
    layer('tetrahedra', which + state.level, () => onBodies(body => boundingTetrahedra(body, state.level)));
    layer('spheres', which + state.level, () => onBodies(body => boundingSpheres(body, state.level)));
    layer('hull', which, () => onBodies(regularHull));
  }
  // Rods keep their width on the screen, but for steps of a quarter.
  const width = 0.003 * Math.pow(1.25, Math.round(Math.log(camera.view.distance) / Math.log(1.25)));
  const radius = width / placeMarks(marks, state.pose);
  if (hasSelf) layer('self', state.pose + ' ' + radius + ' ' + state.out, () => onMarks(selfObject(state.pose, radius, state.out)));
  if (data.solids) {
    layer('overlap', state.pose, () => onMarks(overlapObject(state.pose)));
    layer('way', state.pose + ' ' + radius, () => onMarks(wayObject(state.pose, radius)));
  }
  if (hasFeatures) {
    layer('features', state.pose + ' ' + radius, () => onMarks(featureObject(state.pose, radius)));
    layer('contacts', state.pose + ' ' + radius, () => onMarks(contactObject(state.pose, radius)));
    layer('nearest', state.pose + ' ' + radius, () => onMarks(nearestObject(state.pose, radius)));
    layer('left', state.pose, () => onMarks(leftObject(state.pose)));
  }
  if (data.motion) layer('first', state.pose + ' ' + radius, () => onMarks(firstObject(state.pose, radius)));
  if (data.rays) layer('rays', state.pose + ' ' + radius, () => onMarks(rayObject(state.pose, radius)));
}

function resize()
{
  const width = canvas.clientWidth, height = canvas.clientHeight;
  renderer.setPixelRatio(Math.min(2, devicePixelRatio || 1));
  renderer.setSize(width, height, false);
  // The bodies stand where the panel is not.
  const beside = width > 640 && element('panel').open ? element('panel').offsetWidth + 10 : 0;
  camera.lens.aspect = width / Math.max(1, height);
  camera.free = [1 - beside / width, 0.82];
  camera.lens.setViewOffset(width, height, beside / 2, 0, width, height);
  if (fitted) fit();
}

const changed = onceAPicture(() => {
  update();
  camera.aim();
  renderer.render(scene, camera.lens);
  tell();
  clearTimeout(writing);
  writing = setTimeout(writeFragment, 150);
});

// ---------------------------------------------------------------------------------------------------------------------
// In words, and for the tests.

function answerText(answer)
{
  if (answer === null || answer === undefined) return 'no answer';
  if (data.question === 'solid' || data.question === 'surface') return answer ? 'collide' : 'apart';
  return String(answer);
}

const short = x => x === null ? 'beyond the doubles' : Number(x.toPrecision(6));
// Six digits may not tell two numbers apart.
const range = numbers => [...new Set(numbers.map(short))].join(' to ');

function raysText()
{
  const met = data.rays.filter(hitCount).length, faces = data.rays.map(hitCount).reduce((x, y) => x + y, 0);
  return data.rays.length + (data.rays.length === 1 ? ' ray, ' : ' rays, ') + met + ' of them meeting ' + faces + (faces === 1 ? ' face.' : ' faces.');
}

function nearestText(k)
{
  const [distance, a, b] = [0, 7, 8].map(i => data.nearest[k][i]);
  return distance === 0 ? '' : 'Distance ' + short(distance) + ', ' + a + ' of A to ' + b + ' of B.';
}

function motionText(k)
{
  const {times, first, holders} = data.motion, at = 't = ' + short(times[k]);
  if (!first) return at + ', they never meet';
  const what = holders ? ': ' + holders[0][0] + ' of A, ' + holders[1][0] + ' of B' : '';
  return at + ', first contact at t = ' + range(first) + what;
}

const percentOut = () => Math.round(100 * state.out) + ' %';
const sharing = new Map([[-1, 'nothing'], [0, 'points alone'], [1, 'lines'], [2, 'areas']]);
function relationText(k)
{
  const own = bodies.filter(body => body.self_pairs)
                  .map(body => 'AB'[body.number] + ' intersects itself in ' + body.self_pairs + (body.self_pairs === 1 ? ' pair' : ' pairs') + ' of faces.');
  if (!data.solids) return own.join(' ');
  const solids = data.solids[k];
  if (!solids) return ['Too many leaves are left to tell the relation.', ...own].join(' ');
  const said = ['Relation: ' + solids.relation + '; the surfaces share ' + sharing.get(solids.dimension) + '.'];
  if (solids.volume !== undefined) said.push('Volume of the overlap: ' + short(solids.volume) + '.');
  if (solids.parts === null) said.push('Its parts are too many to be drawn.');
  if (solids.out) {
    const {bounds, exact, first, last} = solids.out;
    said.push(bounds === undefined ? 'First exit of A at ' + short(first) + ', last at ' + short(last) + ' lengths of the direction.'
              : exact ? 'Depth: ' + short(bounds[1]) + ', the least.' : 'Depth: ' + range(bounds) + '.');
  }
  if (isMovedOut())
    said.push('A is moved ' + percentOut() + ' of the way out. Verdict, overlap and pairs are those of 0 %.');
  return [...said, ...own].join(' ');
}

function contactsText(k)
{
  if (data.rays) return raysText();
  if (!hasFeatures) return '';
  const shown = featuresOf(k), count = data.feature_counts[k];
  if (count === null) return 'Too many leaves are left to look for edges that meet faces.';
  const lost = shown.filter(f => f[5] === 1).length, invented = shown.filter(f => f[5] === 2).length;
  if (!count && !invented) return data.exact[k] ? 'No edge meets a face: one body is inside the other.' : nearestText(k);
  const byKind = kinds.map((kind, i) => [shown.filter(f => f[4] === i && f[5] < 2).length, kind]).filter(([n]) => n)
                     .map(([n, kind]) => n + ' ' + kind);
  const more = count > shown.length - invented ? ' among the first ' + (shown.length - invented) : '';
  const wrong = [lost && lost + ' lost', invented && invented + ' invented'].filter(Boolean).join(', ');
  return count + (count === 1 ? ' pair' : ' pairs') + ' of an edge and a face' + (byKind.length ? more + ': ' + byKind.join(', ') : '') +
         (wrong ? '; by ' + data.subject + ': ' + wrong : '') + '.';
}

function tell()
{
  const k = state.pose, wrong = isWrong(k);
  const parts = data.motion ? [motionText(k)] : poseCount > 1 ? ['pose ' + (k + 1) + ' of ' + poseCount] : [];
  if (data.exact) parts.push(data.question + ', exact: ' + answerText(data.exact[k]), data.subject + ': ' + answerText(data.answer[k]) + (wrong ? ' \u2717 wrong' : ' \u2713'));
  element('verdict').textContent = parts.join(' \u00b7 ');
  element('verdict').classList.toggle('wrong', wrong);
  element('relation').textContent = relationText(k);
  element('contacts').textContent = contactsText(k);
  for (const input of document.querySelectorAll('[data-show]')) input.checked = state.show.has(input.dataset.show);
  for (const name of ['pose', 'level', 'opacity', 'shrink', 'out']) element(name).value = state[name];
  element('out-text').textContent = percentOut();
  element('to-contact').disabled = featuresOf(k).length === 0;
  element('level-text').textContent = state.level + ' of ' + most;
  const {triangles, lines, points, calls} = renderer.info.render;
  element('state').textContent = JSON.stringify({ready: true, errors, pose: k, poses: poseCount, show: [...state.show], level: state.level, out: state.out, wrong: wrongPoses,
                                                 exact: data.exact && data.exact[k], answer: data.answer && data.answer[k],
                                                 features: featuresOf(k).length, triangles, lines, points, calls, camera: camera.text()});
}

// The time line: a tick a pose, or the worst of several in one pixel. Colliding ones are tall, wrong ones stand out above.
function drawLine()
{
  const line = element('line'), ratio = devicePixelRatio || 1;
  const width = line.width = Math.round(line.clientWidth * ratio), height = line.height = Math.round(18 * ratio);
  if (!data.exact || poseCount < 2 || !width) return;
  const paint = line.getContext('2d'), step = width / poseCount;
  const bar = (k, colour, top, bottom) => {
    paint.fillStyle = colourOf(colour);
    paint.fillRect(Math.floor(k * step), top * height, Math.max(1, Math.ceil(step) - (step > 4 * ratio ? ratio : 0)), (bottom - top) * height);
  };
  for (let k = 0; k < poseCount; ++k) if (!data.exact[k]) bar(k, '--apart', 0.75, 1);
  for (let k = 0; k < poseCount; ++k) if (data.exact[k]) bar(k, '--collide', 0.4, 1);
  for (const k of wrongPoses) bar(k, '--wrong', 0, 0.32);
}

// ---------------------------------------------------------------------------------------------------------------------
// Controls.

function fit()
{
  const shown = bodies.filter(body => state.show.has(body.number ? 'b' : 'a'));
  const corners = (shown.length ? shown : bodies).flatMap(body => placedCorners(body, state.pose, state.out));
  camera.fit(boxOf(corners.map(p => inFrame(world, p))));
  fitted = true;
}
function setPose(k)
{
  state.pose = ((k % poseCount) + poseCount) % poseCount;
  changed();
}

let playing = 0;
function play(on)
{
  clearInterval(playing);
  const next = () => {
    setPose(state.pose + 1);
    if (data.motion && state.pose === poseCount - 1) play(false);  // a motion stands still where it ends
  };
  playing = on ? setInterval(next, data.motion || poseCount > 100 ? 50 : 200) : 0;
  element('play').textContent = on ? 'Pause' : 'Play';
}

for (const input of document.querySelectorAll('[data-show]'))
  input.addEventListener('change', () => {
    state.show[input.checked ? 'add' : 'delete'](input.dataset.show);
    // The method lies inside: bodies give way to it.
    if (input.checked && ['covering', 'tetrahedra', 'spheres', 'hull', 'left'].includes(input.dataset.show)) state.opacity = Math.min(state.opacity, 0.35);
    changed();
  });
for (const name of ['pose', 'level', 'opacity', 'shrink', 'out'])
  element(name).addEventListener('input', event => {
    state[name] = Number(event.target.value);
    if (name === 'out' && fitted) fit();
    changed();
  });
element('before').addEventListener('click', () => setPose(state.pose - 1));
element('after').addEventListener('click', () => setPose(state.pose + 1));
element('play').addEventListener('click', () => play(!playing));
element('next-wrong').addEventListener('click', () => setPose(wrongPoses.find(k => k > state.pose) ?? wrongPoses[0]));
element('fit').addEventListener('click', fit);
element('to-contact').addEventListener('click', () => {
  const box = contactBox(state.pose);
  if (box) camera.fit(box);
});
element('theme').addEventListener('click', () => {
  state.theme = document.documentElement.classList.contains('dark') ? 'light' : 'dark';
  changed();
});
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => changed());
element('panel').addEventListener('toggle', () => { resize(); changed(); });
window.addEventListener('resize', () => { resize(); drawLine(); changed(); });
window.addEventListener('hashchange', () => {
  if (location.hash === written) return;
  if (!readFragment()) fit();
  changed();
});

document.title = data.name + ' - tetracone';
element('name').textContent = data.name;
bodies.forEach((body, i) => { element('name-' + 'ab'[i]).textContent = 'AB'[i] + (data.case ? '' : ': ' + body.name); });
for (const part of document.querySelectorAll('[data-pair]')) part.hidden = !pair;
for (const part of document.querySelectorAll('[data-features]')) part.hidden = !hasFeatures;
for (const part of document.querySelectorAll('[data-self]')) part.hidden = !hasSelf;
for (const part of document.querySelectorAll('[data-solids]')) part.hidden = !data.solids;
for (const part of document.querySelectorAll('[data-out]')) part.hidden = !hasOut;
for (const part of document.querySelectorAll('[data-rays]')) part.hidden = !data.rays;
for (const part of document.querySelectorAll('[data-motion]')) part.hidden = !data.motion || !data.motion.holders;
element('poses').hidden = poseCount < 2;
element('line').hidden = !data.exact;
element('next-wrong').hidden = wrongPoses.length === 0;
element('pose').max = poseCount - 1;
element('level').max = most;
element('source').textContent = (data.case ? data.case.cause + '; family ' + data.case.family + ', seed ' + data.case.seed + ', index ' + data.case.index + '. ' : '') +
                                'tetracone ' + data.version;
element('panel').open = innerWidth > 640;
element('method').hidden = !hasMethod;
for (const part of document.querySelectorAll('[data-answers]')) part.hidden = !hasFeatures;

fitted = !readFragment();
resize();
changed();
