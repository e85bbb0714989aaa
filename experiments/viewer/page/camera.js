'use strict';
// The camera about a target: azimuth and elevation in degrees, distance. z is up. One pointer turns, two or the right button move,
// the wheel or two pointers zoom; arrow keys, + and - do the same.

function makeCamera(canvas, changed)
{
  const lens = new THREE.PerspectiveCamera(35, 1, 0.01, 100);
  lens.up.set(0, 0, 1);
  const view = {azimuth: -55, elevation: 22, distance: 5, target: [0, 0, 0]};
  const radians = Math.PI / 180;

  function aim()
  {
    view.elevation = Math.min(89.9, Math.max(-89.9, view.elevation));
    view.distance = Math.min(1e6, Math.max(1e-7, view.distance));
    const flat = Math.cos(view.elevation * radians), a = view.azimuth * radians;
    const away = [flat * Math.cos(a), flat * Math.sin(a), Math.sin(view.elevation * radians)];
    lens.position.set(...view.target.map((x, k) => x + view.distance * away[k]));
    lens.near = view.distance / 200;
    lens.far = view.distance * 20 + 10;
    lens.lookAt(...view.target);
    lens.updateProjectionMatrix();
  }

  function turn(dx, dy)
  {
    view.azimuth -= dx * 0.4;
    view.elevation += dy * 0.4;
    changed();
  }
  function move(dx, dy)
  {
    const scale = 2 * view.distance * Math.tan(lens.fov / 2 * radians) / canvas.clientHeight;
    const right = new THREE.Vector3().setFromMatrixColumn(lens.matrix, 0), up = new THREE.Vector3().setFromMatrixColumn(lens.matrix, 1);
    view.target = view.target.map((x, k) => x - scale * (dx * right.getComponent(k) - dy * up.getComponent(k)));
    changed();
  }
  function zoom(factor)
  {
    view.distance *= factor;
    changed();
  }

  const pointers = new Map();
  canvas.addEventListener('pointerdown', event => {
    canvas.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, event);
  });
  for (const end of ['pointerup', 'pointercancel']) canvas.addEventListener(end, event => pointers.delete(event.pointerId));
  canvas.addEventListener('pointermove', event => {
    const last = pointers.get(event.pointerId);
    if (!last) return;
    const dx = event.clientX - last.clientX, dy = event.clientY - last.clientY;
    if (pointers.size === 2) {
      const other = [...pointers.values()].find(p => p.pointerId !== event.pointerId);
      const apart = p => Math.hypot(p.clientX - other.clientX, p.clientY - other.clientY);
      move(dx / 2, dy / 2);
      if (apart(event) > 0) zoom(apart(last) / apart(event));
    } else if (event.buttons & 2 || event.shiftKey) {
      move(dx, dy);
    } else {
      turn(dx, dy);
    }
    pointers.set(event.pointerId, event);
  });
  canvas.addEventListener('contextmenu', event => event.preventDefault());
  canvas.addEventListener('wheel', event => {
    event.preventDefault();
    zoom(Math.exp(Math.sign(event.deltaY) * Math.min(0.3, Math.abs(event.deltaY) * 0.0015)));
  }, {passive: false});
  canvas.addEventListener('keydown', event => {
    const keys = {ArrowLeft: () => turn(-15, 0), ArrowRight: () => turn(15, 0), ArrowUp: () => turn(0, 15), ArrowDown: () => turn(0, -15),
                  '+': () => zoom(0.85), '-': () => zoom(1 / 0.85)};
    if (!keys[event.key]) return;
    event.preventDefault();
    keys[event.key]();
  });

  // The box, whole, in the shares of the picture's width and height that are free.
  function fit(box)
  {
    view.target = box.centre;
    const radius = Math.hypot(...box.high.map((x, k) => (x - box.low[k]) / 2)) || 1e-3;
    view.distance = radius / Math.sin(lens.fov / 2 * radians) / Math.min(this.free[1], lens.aspect * this.free[0]);
    changed();
  }

  const short = x => Number(x.toPrecision(6));
  return {
    lens, view, aim, fit, free: [1, 1],
    text: () => [view.azimuth, view.elevation, view.distance, ...view.target].map(short).join(','),
    read(text)
    {
      const numbers = text.split(',').map(Number);
      if (numbers.length !== 6 || numbers.some(x => !Number.isFinite(x))) return false;
      [view.azimuth, view.elevation, view.distance] = numbers;
      view.target = numbers.slice(3);
      return true;
    },
  };
}

function makeRenderer(canvas)
{
  try {
    return new THREE.WebGLRenderer({canvas, antialias: true});
  } catch (error) {
    throw new Error('this browser shows no WebGL here: ' + error.message);
  }
}

// What calls draw before the next picture, once, however often it is called until then.
let waiting = false;
function onceAPicture(draw)
{
  return () => {
    if (waiting) return;
    waiting = true;
    requestAnimationFrame(() => {
      waiting = false;
      draw();
    });
  };
}
