// The words of a copy of the model, which can be moved.
function wordsPanel() {
  const variables = FORCE_MODEL.inputs.concat([FORCE_MODEL.output]);
  const holder = el('div', {class: 'living-drawing'});
  const choice =
      el('select', {
        onchange: () => {
          state.word_of = Number(choice.value);
          changed();
        }
      },
         variables.map((variable, v) => el('option', {value: v, selected: v === state.word_of}, labelOf(variable))));
  const back =
      el('button', {
        type: 'button',
        onclick: () => {
          state.what_if = null;
          changed();
        }
      },
         'Put all back');
  const note = el('p', {class: 'living-hint'});
  const shown = (model) => (state.word_of < model.inputs.length ? model.inputs[state.word_of] : model.output);
  function move(from, to, index) {
    if (!state.what_if) state.what_if = structuredClone(FORCE_MODEL);
    livingNumbers.moveCorner(shown(state.what_if), from, to);
    if (JSON.stringify(state.what_if) === JSON.stringify(FORCE_MODEL)) state.what_if = null;
    focus_on = index;
    changed();
  }
  let focus_on = -1, dragged = -1;
  panels.push(() => {
    const old = shown(FORCE_MODEL), now = shown(state.what_if || FORCE_MODEL);
    const width = widthOf(holder), height = 210,
          place = axes(width, height, [old.min, old.max], [0, 1.12], named(old), 'Membership');
    const drawing = svg('svg', {
      viewBox: '0 0 ' + width + ' ' + height,
      width,
      height,
      role: 'group',
      'aria-label': 'Words of ' + labelOf(old)
    });
    drawing.append(place.group);
    const xs = Array.from({length: 301}, (_, i) => old.min + (old.max - old.min) * i / 300);
    const line = (term) => {
      const places = (term.at ? xs.concat(term.at.filter((x) => x >= old.min && x <= old.max)) : xs)
                         .sort((one, other) => one - other);
      return path(places, places.map((x) => livingNumbers.membership(term, x)), place);
    };
    let written = 0;
    old.terms.forEach((term, t) => {
      drawing.append(svg('path', {class: 'living-word', d: line(term)}));
      if (state.what_if && line(term) !== line(now.terms[t]))
        drawing.append(svg('path', {class: 'living-what-if', d: line(now.terms[t])}));
      const text = labelOf(term), half = text.length * 3.2;
      const middle = Math.min(Math.max(place.x(coreMiddle(now, now.terms[t])), place.left + half), place.right - half);
      if (middle - half < written) return;
      written = middle + half + 6;
      drawing.append(
          svg('text', {class: 'living-region-name', x: middle, y: place.top + 4, 'text-anchor': 'middle'}, text));
    });
    const corners = livingNumbers.cornersOf(now);
    corners.forEach(({x, words}, k) => {
      const step = roundStep(old.max - old.min, 200);
      const top = now.terms.some((term) => livingNumbers.membership(term, x) > 0.999) ? 1 : 0;
      drawing.append(svg('circle', {
        class: 'living-corner',
        cx: place.x(x),
        cy: place.y(top),
        r: 7.5,
        tabindex: '0',
        role: 'slider',
        'data-corner': k,
        'aria-label': 'Corner of ' + words.join(' and '),
        'aria-valuemin': old.min,
        'aria-valuemax': old.max,
        'aria-valuenow': x,
        'aria-valuetext': valueText(old, x) + ' ' + old.unit,
        onkeydown: (event) => {
          const way = {ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1}[event.key];
          if (!way) return;
          event.preventDefault();
          move(x, x + way * step * (event.shiftKey ? 10 : 1), k);
        },
        onpointerdown: (event) => {
          dragged = k;
          holder.setPointerCapture(event.pointerId);
          event.preventDefault();
        }
      }));
    });
    holder.onpointermove = (event) => {
      if (dragged < 0) return;
      const box = holder.firstChild.getBoundingClientRect(),
            corner = livingNumbers.cornersOf(shown(state.what_if || FORCE_MODEL))[dragged];
      if (corner) move(corner.x, place.value((event.clientX - box.left) * width / box.width), dragged);
    };
    holder.onpointerup = holder.onpointercancel = () => {
      dragged = -1;
    };
    holder.replaceChildren(drawing);
    if (focus_on >= 0) holder.querySelector('[data-corner="' + focus_on + '"]')?.focus({preventScroll: true});
    focus_on = -1;
    back.disabled = !state.what_if;
    const v = state.word_of,
          own =
              FORCE_MODEL.experts.filter((expert) => (v < FORCE_MODEL.inputs.length ? expert.inputs[v] : expert.output))
                  .map(labelOf);
    note.textContent =
        (own.length > 0 ? (own.length > MOST_LINES ? own.length + ' experts' : own.join(', ')) + (own.length > 1 ? ' have' : ' has') + ' own words here, which stay. ' : '') +
        (state.what_if ?
             'What if: not the model. At the present inputs ' + newtons(forceModel(state.inputs, state.what_if).force) +
                 ' instead of ' + newtons(forceModel(state.inputs).force) + '.' :
             'Drag a corner, or step to it with Tab and move it with the arrow keys. Words that meet in a corner move together.');
    note.classList.toggle('living-warned', Boolean(state.what_if));
  });
  return card(
      'What if a word meant something else?',
      'These are the words of a copy. The model, its checks and the tube above stay as they are.',
      el('p', {class: 'living-choice'}, el('label', {}, 'Words of ', choice), back), holder, note);
}
