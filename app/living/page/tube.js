// The tube, pulled with the pointer or the keys.
function tubePanel() {
  if (!content.tube) return null;
  const depth = FORCE_MODEL.inputs[content.tube.depth];
  const conditions = () => content.tube.conditions.map((input) => state.inputs[input]);
  const offset = content.tube.offset, deepest = depth.max - offset, shown_s = 8;
  let tube = tubeStart(conditions()), hand = 0, wanted = 0, held = false, before = 0, running = false, quiet_s = 0,
      time = 0;
  let told = '', given = String(conditions());
  const keys = new Set();
  let strip = [];
  const phases = ['let go', 'held, it sticks', 'sliding'];

  const readout = {force: el('b'), depth: el('b'), phase: el('b'), stroke: el('b')};
  const spoken = el('p', {class: 'living-unseen', role: 'status', 'aria-live': 'polite'});
  const track = el('div', {
    class: 'living-tube',
    tabindex: '0',
    role: 'application',
    'aria-label':
        'The tube. The right arrow key pushes it in, the left one pulls it out, with Shift fast; Space holds it; Home begins anew.'
  });
  const strips = el('div', {class: 'living-drawing'});

  function drawTrack() {
    const width = widthOf(track), height = 92, x = (mm) => 14 + (width - 28) * Math.min(Math.max(mm / deepest, 0), 1);
    const drawing = svg('svg', {viewBox: '0 0 ' + width + ' ' + height, width, height, 'aria-hidden': 'true'});
    addParts(drawing, partsOf(depth), (at) => x(at - offset), 8, 64);
    for (const tick of ticksOf(0, deepest, Math.max(2, Math.floor(width / 110)))) {
      drawing.append(
          svg('text', {class: 'living-tick', x: x(tick), y: 82, 'text-anchor': tick === 0 ? 'start' : 'middle'},
              tick + (tick === 0 ? ' ' + depth.unit : '')));
    }
    const tip = x(tube.depth_mm);
    drawing.append(
        svg('rect', {class: 'living-passage', x: 14, y: 32, width: width - 28, height: 24, rx: 4}), svg('rect', {
          class: 'living-tube-body' + (held ? ' held' : ''),
          x: 0,
          y: 38,
          width: Math.max(tip, 2),
          height: 12,
          rx: 6
        }),
        svg('circle', {class: 'living-tip', cx: tip, cy: 44, r: 8}));
    track.replaceChildren(drawing);
  }
  function drawStrips() {
    const width = widthOf(strips), height = 190;
    const cap = Math.max(FORCE_MODEL.output.max, ...strip.map((one) => one.force));
    const low = Math.min(0, ...strip.map((one) => one.force));
    const place =
        axes(width, height, [-shown_s, 0], [low, cap], 'time (s), now is 0', 'Force on the hand (' + unit + ')');
    const drawing = svg('svg', {
      viewBox: '0 0 ' + width + ' ' + height,
      width,
      height,
      role: 'img',
      'aria-label': 'Force and depth of the time (s), now is 0'
    });
    const times = strip.map((one) => one.time - time);
    const deep = strip.map((one) => low + (cap - low) * one.depth / deepest);
    drawing.append(
        place.group, svg('path', {class: 'living-strip-depth', d: path(times, deep, place)}),
        svg('path', {class: 'living-strip-force', d: path(times, strip.map((one) => one.force), place)}));
    if (strip.length === 0)
      drawing.append(
          svg('text', {class: 'living-empty', x: width / 2, y: height / 2, 'text-anchor': 'middle'},
              'Pull the tube to see its force'));
    strips.replaceChildren(drawing);
  }
  function tell() {
    readout.force.textContent = newtons(tube.force_n === 0 ? 0 : tube.force_n);
    readout.depth.textContent = tube.depth_mm.toFixed(0) + ' mm';
    readout.phase.textContent = phases[tube.phase];
    readout.stroke.textContent = String(tube.stroke);
    const place = livingNumbers.placeText(wordsAt(depth, tube.depth_mm + offset));
    const now = 'Stroke ' + tube.stroke + ', ' + phases[tube.phase] + ' at ' + Math.round(tube.depth_mm / 10) * 10 +
        ' mm, ' + place;
    if (tube.phase + place + tube.stroke !== told) spoken.textContent = now;
    told = tube.phase + place + tube.stroke;
  }
  function frame(at) {
    const elapsed_s = Math.min(Math.max((at - before) / 1000, 0), 0.1);
    before = at;
    if (keys.size > 0) {
      held = true;
      const speed =
          (keys.has('fast') ? 200 : 60) * ((keys.has('ArrowRight') ? 1 : 0) - (keys.has('ArrowLeft') ? 1 : 0));
      wanted = hand + speed * elapsed_s;
    }
    if (String(conditions()) !== given) {
      given = String(conditions());
      tubeChange(tube, conditions(), 0.05);
    }
    const steps = Math.max(1, Math.round(elapsed_s * 1000)), start = hand;
    for (let k = 1; k <= steps; ++k) {
      hand = start + (wanted - start) * k / steps;
      tubeStep(tube, hand, held ? 1 : 0, 0.001);
      time += 0.001;
      if (k % 8 === 0 || k === steps) strip.push({time, force: tube.force_n, depth: tube.depth_mm});
    }
    strip = strip.filter((one) => time - one.time <= shown_s);
    quiet_s = held ? 0 : quiet_s + elapsed_s;
    drawTrack();
    drawStrips();
    tell();
    running = quiet_s < 1.5;
    if (running) requestAnimationFrame(frame);
  }
  function run() {
    quiet_s = 0;
    if (running) return;
    running = true;
    before = performance.now();
    requestAnimationFrame(frame);
  }
  const scale = () => deepest / Math.max(track.clientWidth - 28, 1);
  let last_x = 0;
  track.addEventListener('pointerdown', (event) => {
    track.setPointerCapture(event.pointerId);
    last_x = event.clientX;
    held = true;
    wanted = hand;
    run();
  });
  track.addEventListener('pointermove', (event) => {
    if (!held || !track.hasPointerCapture(event.pointerId)) return;
    wanted += (event.clientX - last_x) * scale();
    last_x = event.clientX;
  });
  const letGo = () => {
    held = false;
    keys.clear();
  };
  for (const name of ['pointerup', 'pointercancel', 'blur']) track.addEventListener(name, letGo);
  const keyOf = (event) => (event.key === ' ' ? 'Space' : event.key);
  track.addEventListener('keydown', (event) => {
    if (event.key === 'Home') {
      again();
      event.preventDefault();
      return;
    }
    if (!['Space', 'ArrowRight', 'ArrowLeft'].includes(keyOf(event))) return;
    event.preventDefault();
    keys.add(keyOf(event));
    if (event.shiftKey)
      keys.add('fast');
    else
      keys.delete('fast');
    run();
  });
  track.addEventListener('keyup', (event) => {
    keys.delete(keyOf(event));
    if (!keys.has('Space') && !keys.has('ArrowRight') && !keys.has('ArrowLeft')) letGo();
  });
  function again() {
    tube = tubeStart(conditions());
    hand = wanted = 0;
    strip = [];
    letGo();
    drawTrack();
    drawStrips();
    tell();
  }
  let width_before = 0;
  panels.push(() => {
    if (widthOf(track) === width_before) return;
    width_before = widthOf(track);
    drawTrack();
    drawStrips();
    tell();
  });
  return card(
      'Pull the tube',
      'Push it to the right with the mouse or a finger, let go, and push again. With the keys: arrows push and pull, with Shift fast, Space holds, Home begins anew. A mouse gives no force back: the strip shows what a hand on a device would feel.',
      track,
      el('p', {class: 'living-readout'}, el('span', {}, 'Force ', readout.force),
         el('span', {}, 'Depth ', readout.depth), el('span', {}, 'Phase ', readout.phase),
         el('span', {}, 'Stroke ', readout.stroke), el('button', {type: 'button', onclick: again}, 'Begin anew')),
      spoken, strips,
      el('p', {class: 'living-key'}, el('span', {}, el('i', {class: 'line strip-force'}), 'force'),
         el('span', {}, el('i', {class: 'line strip-depth'}), 'depth, 0 to ' + valueText(depth, deepest) + ' mm')));
}
