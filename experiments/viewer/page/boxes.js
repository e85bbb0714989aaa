'use strict';
// Points and boxes in doubles. The picture is drawn in single precision, and coordinates of a file may be far apart,
// huge or tiny: each thing is kept in the frame of a box, which is about 0 there and of extent 1.

function boxOf(points)
{
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (const p of points)
    for (let k = 0; k < 3; ++k) low[k] = Math.min(low[k], p[k]), high[k] = Math.max(high[k], p[k]);
  // Halved first: the extent of a huge model overflows.
  const centre = low.map((x, k) => x / 2 + high[k] / 2), extent = Math.max(...low.map((x, k) => high[k] / 2 - x / 2));
  return {low, high, centre, extent: extent > 0 ? extent : 1};
}

// The box of all that a page shows.
function worldOf(points)
{
  const box = boxOf(points);
  if (![box.extent, ...box.centre].every(Number.isFinite))
    throw new Error('these coordinates are too large to be drawn');
  return box;
}

function inFrame(box, p) { return p.map((x, k) => (x - box.centre[k]) / box.extent); }

function cornersOf({low, high})
{
  return [0, 1, 2, 3, 4, 5, 6, 7].map(c => [0, 1, 2].map(k => (c >> k & 1 ? high : low)[k]));
}

function triples(flat)
{
  const all = [];
  for (let i = 0; i < flat.length; i += 3) all.push([flat[i], flat[i + 1], flat[i + 2]]);
  return all;
}

function image(pose, p)
{
  return [0, 4, 8].map(r => pose[r] * p[0] + pose[r + 1] * p[1] + pose[r + 2] * p[2] + pose[r + 3]);
}

// The matrix of a box's frame under a pose into that of the world; its 0 is at `centre` there.
function frameMatrix(box, pose, world, centre)
{
  const m = pose.map(x => x * (box.extent / world.extent)), [x, y, z] = inFrame(world, centre);
  return new THREE.Matrix4().set(m[0], m[1], m[2], x, m[4], m[5], m[6], y, m[8], m[9], m[10], z, 0, 0, 0, 1);
}
