// The tube in MuJoCo: a tip on a slide joint that a hand of 0.3 kg pushes along the axis of insertion. MuJoCo computes
// where the tip is, the bundle's js/tube.js what the hand feels there.
//   npm install mujoco-js            (MuJoCo for Node, by its makers)
//   node mujoco.mjs BUNDLE
// First each step of BUNDLE/checks_tube.csv: the tip is put where the row says, and the force must be the row's. Then
// two strokes of a free hand. Ends with 1 where a force is not within 1e-12 N.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const bundle = resolve(process.argv[2] ?? '.');
const require = createRequire(pathToFileURL(join(bundle, 'js', 'tube.js')));
const { tubeStart, tubeChange, tubeStep } = require('./tube.js');
const mujoco = await (await import(createRequire(join(process.cwd(), 'x')).resolve('mujoco-js'))).default();

// MuJoCo works in m, the tube in mm; both in N.
const kMm = 1000;
const kScene = `<mujoco>
  <option timestep="0.001" gravity="0 0 0" integrator="implicitfast"/>
  <worldbody>
    <body name="tip">
      <joint name="axis" type="slide" axis="1 0 0" damping="2"/>
      <geom type="capsule" fromto="-0.05 0 0 0 0 0" size="0.0025" mass="0.3" contype="0" conaffinity="0"/>
    </body>
  </worldbody>
</mujoco>`;

const model = mujoco.MjModel.loadFromXML ? (() => {
  mujoco.FS.writeFile('/scene.xml', kScene);
  return mujoco.MjModel.loadFromXML('/scene.xml');
})() : mujoco.MjModel.from_xml_string(kScene);
const data = new mujoco.MjData(model);

/// The rows of the scripted insertions, trace by trace.
function traces() {
  const [head, ...rows] = readFileSync(join(bundle, 'checks_tube.csv'), 'utf8').trim().split('\n').map((row) => row.split(','));
  const conditions = head.slice(5, head.indexOf('force_n'));
  const out = new Map();
  for (const row of rows) {
    const [position, held, dt, ...rest] = row.slice(2).map(Number);
    const step = { position, held, dt, conditions: rest.slice(0, conditions.length), force: rest[conditions.length] };
    if (!out.has(row[0])) out.set(row[0], []);
    out.get(row[0]).push(step);
  }
  return out;
}

let steps = 0;
let worst = 0;
for (const [name, trace] of traces()) {
  let tube = null;
  let before = '';
  for (const step of trace) {
    data.qpos[0] = step.position / kMm;
    mujoco.mj_forward(model, data);
    // What the engine hands back is what the tube gets, rounded to a tenth of a micrometre as the rows are.
    const position = Math.round(data.xpos[3] * kMm * 1e4) / 1e4;
    if (!tube) tube = tubeStart(step.conditions);
    else if (String(step.conditions) !== before) tubeChange(tube, step.conditions, 0.05);
    before = String(step.conditions);
    const force = tubeStep(tube, position, step.held, step.dt);
    data.qfrc_applied[0] = -force;
    const error = Math.abs(force - step.force);
    if (!(error <= worst)) worst = error;
    ++steps;
  }
  console.log(`${name}: ${trace.length} steps`);
}
console.log(`${steps} steps of checks_tube.csv in MuJoCo ${mujoco.mj_versionString?.() ?? ''}: at most ${worst} N off`);

// A free hand: a spring that pulls the tip 60 mm further with each stroke, held while it pushes.
mujoco.mj_resetData(model, data);
const conditions = traces().values().next().value[0].conditions;
const tube = tubeStart(conditions);
let largest = 0;
for (let tick = 0; tick < 2400; ++tick) {
  const stroke = Math.floor(tick / 1200);
  const along = Math.min((tick % 1200) / 800, 1);
  const aim = (stroke * 0.06 + 0.06 * along * along * along * (10 + along * (6 * along - 15)));
  const force = tubeStep(tube, data.qpos[0] * kMm, tick % 1200 < 900 ? 1 : 0, 0.001);
  data.qfrc_applied[0] = 400 * (aim - data.qpos[0]) - 12 * data.qvel[0] - force;
  mujoco.mj_step(model, data);
  largest = Math.max(largest, Math.abs(force));
}
console.log(`free hand: ${tube.stroke} strokes, depth ${tube.depth_mm.toFixed(1)} mm, largest force ${largest.toFixed(2)} N`);
process.exit(worst <= 1e-12 && tube.stroke === 2 && tube.depth_mm > 20 ? 0 : 1);
