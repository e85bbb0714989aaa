// MuJoCo, from npm: contacts of the hulls of two meshes, whose vertices it rounds to float. A model is compiled for
// each pair of bodies, and kept for its poses. Poses are those of free joints.
import load from '@mujoco/mujoco';
import { serve } from './subject.mjs';

const M = await load({ print: console.error, printErr: console.error });
let made = {};

function compiled(a, b) {
  if (made.a === a && made.b === b) return made;
  made.data?.delete();
  made.model?.delete();
  const mesh = (name, body) => `<mesh name="${name}" vertex="${[...body.vertices].join(' ')}"/>`;
  const body = (name) => `<body><freejoint/><geom type="mesh" mesh="${name}"/></body>`;
  const xml = `<mujoco><asset>${mesh('a', a)}${mesh('b', b)}</asset><worldbody>${body('a')}${body('b')}</worldbody></mujoco>`;
  const model = M.MjModel.from_xml_string(xml);
  made = { a, b, model, data: new M.MjData(model) };
  return made;
}

serve({
  library: '@mujoco/mujoco',
  hello: { name: 'MuJoCo hull', precision: 'float64', vertices: 'float32', bodies: 'convex', questions: ['solid'], touching: 'open' },
  prepare: (body) => body,
  ready: compiled,
  collide: (a, b, { rigid_a, rigid_b }) => {
    const { model, data } = compiled(a, b);
    data.qpos.set([rigid_a, rigid_b].flatMap((r) => [...r.slice(4), ...r.slice(0, 4)]));
    M.mj_forward(model, data);
    return data.ncon > 0;
  },
});
