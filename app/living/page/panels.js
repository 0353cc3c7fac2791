// Inputs and force, the curve, the balance and the map.
/* Experts whose curves are drawn; of more of them the range is. */
const MOST_LINES = 12;

function inputRow(input, i) {
  const step = roundStep(input.max - input.min, 400);
  const slider = el('input', {
    type: 'range',
    id: 'living-input-' + i,
    min: input.min,
    max: input.max,
    step,
    'aria-describedby': 'living-words-' + i,
    oninput: () => setInput(i, Number(slider.value))
  });
  const field = el('input', {
    type: 'number',
    min: input.min,
    max: input.max,
    step: 'any',
    'aria-label': named(input),
    onchange: () => {
      if (field.value === '')
        changed();
      else
        setInput(i, Number(field.value));
    }
  });
  const words = el('span', {class: 'living-words', id: 'living-words-' + i});
  panels.push(() => {
    slider.value = state.inputs[i];
    if (document.activeElement !== field || Number(field.value) !== state.inputs[i])
      field.value = valueText(input, state.inputs[i]);
    const held = wordsAt(input, state.inputs[i]);
    words.textContent =
        held.map(
                ([label, share]) =>
                    (held.length === 1 && share > 0.995 ? label : label + ' ' + Math.round(share * 100) + ' %'))
            .join(', ');
    slider.setAttribute(
        'aria-valuetext', valueText(input, state.inputs[i]) + ' ' + input.unit + ', ' + words.textContent);
  });
  return el(
      'div', {class: 'living-input'},
      el('label', {'for': 'living-input-' + i}, labelOf(input)),
      el('span', {class: 'living-field'}, field,
         el('span', {class: 'living-unit'}, input.unit === '1' ? '' : input.unit)),
      slider, words);
}

function forcePanel() {
  const big = el('div', {class: 'living-force'});
  const what_if = el('div', {class: 'living-what-if-force', hidden: true});
  const sentence = el('p', {class: 'living-sentence', role: 'status', 'aria-live': 'polite'});
  const rows = FORCE_MODEL.experts.map((expert, e) => {
    const bar = el('span', {class: 'living-bar', style: 'background:' + content.colors[e]});
    const value = el('span', {class: 'living-value'});
    panels.push(() => {
      const own = forceModelExpert(e, state.inputs);
      value.textContent = own.fired ? newtons(own.force) : 'no rule fires';
      const {min, max} = FORCE_MODEL.output;
      bar.style.width = own.fired ? 100 * (own.force - min) / (max - min) + '%' : '0';
    });
    return el(
        'li', {}, el('span', {class: 'living-name'}, labelOf(expert)), el('span', {class: 'living-track'}, bar), value);
  });
  let late = 0;
  panels.push(() => {
    const whole = forceModel(state.inputs);
    big.textContent = newtons(whole.force);
    what_if.hidden = !state.what_if;
    if (state.what_if) what_if.textContent = 'What if: ' + newtons(forceModel(state.inputs, state.what_if).force);
    // A screen reader hears the sentence when the hand rests.
    clearTimeout(late);
    late = setTimeout(() => {
      const places = {region: content.region, speed: content.speed};
      const text = livingNumbers.sentenceOf(FORCE_MODEL, places, state.inputs, engine);
      if (text !== sentence.textContent) sentence.textContent = text;
    }, sentence.textContent === '' ? 0 : 120);
  });
  return card(
      labelOf(FORCE_MODEL.output), '', el('div', {class: 'living-numbers'}, big, what_if), sentence,
      FORCE_MODEL.experts.length > 1 ?
          el('ul', {
            class: FORCE_MODEL.experts.length > MOST_LINES ? 'living-experts many' : 'living-experts',
            'aria-label': 'Force of each expert',
            tabindex: FORCE_MODEL.experts.length > MOST_LINES && '0'
          },
             rows) :
          null);
}

function curvePanel() {
  const holder = el('div', {class: 'living-drawing'});
  const choice =
      el('select', {
        onchange: () => {
          state.over = Number(choice.value);
          changed();
        }
      },
         FORCE_MODEL.inputs.map((input, i) => el('option', {value: i, selected: i === state.over}, labelOf(input))));
  const many = FORCE_MODEL.experts.length > 1, lines = many && FORCE_MODEL.experts.length <= MOST_LINES;
  const key = el('p', {class: 'living-key'});
  panels.push(() => {
    const input = FORCE_MODEL.inputs[state.over], width = widthOf(holder), height = width < 500 ? 260 : 320;
    /* Of many experts fewer places, so that the curve follows the hand. */
    const all = positionsOf(FORCE_MODEL, state.over);
    const every = (step) => all.filter((_, k) => k % step === 0 || k === all.length - 1);
    const xs = many && !lines ? every(2) : all, own_xs = many && !lines ? every(4) : all;
    const own = FORCE_MODEL.experts.map((_, e) => curve(FORCE_MODEL, state.inputs, state.over, own_xs, e, engine));
    const mean = curve(FORCE_MODEL, state.inputs, state.over, xs, null, engine);
    const place = axes(
        width, height, [input.min, input.max], [FORCE_MODEL.output.min, FORCE_MODEL.output.max], named(input),
        named(FORCE_MODEL.output));
    const drawing = svg('svg', {
      viewBox: '0 0 ' + width + ' ' + height,
      width,
      height,
      role: 'img',
      'aria-label': 'Force over ' + labelOf(input) + ': ' + newtons(forceModel(state.inputs).force) + ' at ' +
          valueText(input, state.inputs[state.over]) + ' ' + input.unit
    });
    if (state.over === content.region) {
      addParts(drawing, partsOf(input), place.x, place.top, place.bottom);
    }
    drawing.append(place.group);
    if (many) {
      const low = own_xs.map(
          (_, k) => own.reduce((least, one) => (one[k] === null ? least : Math.min(least, one[k])), Infinity));
      const high = own_xs.map(
          (_, k) => own.reduce((most, one) => (one[k] === null ? most : Math.max(most, one[k])), -Infinity));
      for (let k = 0; k < own_xs.length;) {
        let end = k;
        while (end < own_xs.length && high[end] >= low[end]) ++end;
        if (end > k) {
          const points = own_xs.slice(k, end)
                             .map((x, j) => [x, high[k + j]])
                             .concat(own_xs.slice(k, end).map((x, j) => [x, low[k + j]]).reverse());
          drawing.append(svg('polygon', {
            class: 'living-band',
            points: points.map(([x, force]) => place.x(x).toFixed(1) + ',' + place.y(force).toFixed(1)).join(' ')
          }));
        }
        k = Math.max(end, k + 1);
      }
      if (lines) {
        own.forEach(
            (ys, e) => drawing.append(
                svg('path', {class: 'living-expert', d: path(xs, ys, place), stroke: content.colors[e]})));
      }
    }
    drawing.append(svg('path', {class: 'living-mean', d: path(xs, mean, place)}));
    if (state.what_if) {
      const more = [...xs, ...positionsOf(state.what_if, state.over)].sort((one, other) => one - other);
      drawing.append(svg('path', {
        class: 'living-what-if',
        d: path(more, curve(state.what_if, state.inputs, state.over, more, null, engine), place)
      }));
    }
    const now = forceModel(state.inputs), x = place.x(state.inputs[state.over]);
    drawing.append(
        svg('line', {class: 'living-here', x1: x, x2: x, y1: place.top, y2: place.bottom}),
        svg('circle', {class: 'living-marker', cx: x, cy: place.y(now.force), r: 5.5}));
    const take = (event) => setInput(
        state.over,
        place.value(
            (event.clientX - drawing.getBoundingClientRect().left) * width / drawing.getBoundingClientRect().width));
    drawing.addEventListener('pointerdown', (event) => {
      holder.pulled = true;
      holder.setPointerCapture(event.pointerId);
      take(event);
    });
    holder.onpointermove = (event) => {
      if (holder.pulled) take(event);
    };
    holder.onpointerup = holder.onpointercancel = () => {
      holder.pulled = false;
    };
    holder.replaceChildren(drawing);
    key.replaceChildren(
        el('span', {}, el('i', {class: 'line mean'}), many ? 'average' : labelOf(FORCE_MODEL.experts[0])),
        ...(lines ? FORCE_MODEL.experts.map(
                        (expert, e) =>
                            el('span', {}, el('i', {class: 'line', style: 'border-color:' + content.colors[e]}),
                               labelOf(expert))) :
                    []),
        ...(many ? [el('span', {}, el('i', {class: 'area'}), 'between the experts')] : []),
        ...(state.what_if ? [el('span', {}, el('i', {class: 'line what-if'}), 'what if: not the model')] : []));
  });
  return card(
      'Curve', '',
      el('p', {class: 'living-choice'}, el('label', {}, 'Force over ', choice),
         ' Drag in the curve, or move the slider.'),
      holder, key);
}

function whyPanel() {
  const body = el('tbody'), last = el('p', {class: 'living-hint'});
  panels.push(() => {
    const found = livingNumbers.balance(FORCE_MODEL, state.inputs, engine);
    const most = Math.max(...found.words.map((word) => Math.abs(word.pull)), 1e-300);
    body.replaceChildren(...found.words.map((word) => {
      const color = content.words[word.id] || '#8b949e', half = 50 * Math.abs(word.pull) / most;
      return el(
          'tr', {}, el('th', {scope: 'row'}, el('i', {class: 'swatch', style: 'background:' + color}), word.label),
          el('td', {class: 'number'}, (100 * word.share).toFixed(1) + ' %'),
          el('td', {class: 'number'},
             (word.pull > 0     ? '+' :
                  word.pull < 0 ? '−' :
                                  '') +
                 Math.abs(word.pull).toFixed(4)),
          el('td', {class: 'living-beam', 'aria-hidden': 'true'}, el('span', {
               style: 'background:' + color + ';width:' + half + '%;' + (word.pull < 0 ? 'right:50%' : 'left:50%')
             })));
    }));
    const up = found.words.reduce((best, word) => (word.pull > best.pull ? word : best), {pull: 0});
    const down = found.words.reduce((best, word) => (word.pull < best.pull ? word : best), {pull: 0});
    last.textContent = !found.fired ? 'No rule fires here.' :
        up.label && down.label      ? up.label + ' pulls the force up most, ' + down.label.toLowerCase() +
            ' down. The pulls sum to zero: the force is where they balance.' :
                                 'One word alone makes this force.';
  });
  return card(
      'Why this force', '',
      el('div', {class: 'living-scroll'},
         el('table', {class: 'living-why'},
            el('thead', {},
               el('tr', {}, el('th', {scope: 'col'}, 'Word'), el('th', {scope: 'col', class: 'number'}, 'Share'),
                  el('th', {scope: 'col', class: 'number'}, 'Pull (' + unit + ')'),
                  el('th', {scope: 'col'}, el('span', {class: 'living-unseen'}, 'Drawing')))),
            body)),
      last);
}

function mapPanel() {
  if (content.region < 0 || FORCE_MODEL.inputs.length < 2) return null;
  const depth = FORCE_MODEL.inputs[content.region];
  const others = FORCE_MODEL.inputs.map((input, i) => ({input, i})).filter(({i}) => i !== content.region);
  const head =
      el('thead', {},
         el('tr', {}, el('td', {}),
            others.map(({input}) => el('th', {scope: 'colgroup', colspan: input.terms.length}, labelOf(input)))),
         el('tr', {}, el('td', {}),
            others.map(
                ({input}) =>
                    input.terms.map((term, t) => el('th', {scope: 'col', class: t === 0 && 'group'}, labelOf(term))))));
  /* One stop of the Tab key; the arrow keys go from cell to cell. */
  function goOn(event) {
    const rows = [...body.rows].map((row) => [...row.querySelectorAll('button')]);
    const row = rows.findIndex((cells) => cells.includes(event.target)), column = rows[row].indexOf(event.target);
    const way = {ArrowRight: [0, 1], ArrowLeft: [0, -1], ArrowDown: [1, 0], ArrowUp: [-1, 0]}[event.key];
    const next = way && rows[row + way[0]]?.[column + way[1]];
    if (!way) return;
    event.preventDefault();
    if (!next) return;
    event.target.tabIndex = -1;
    next.tabIndex = 0;
    next.focus();
  }
  const body =
      el('tbody', {onkeydown: goOn},
         depth.terms.map(
             (region, r) =>
                 el('tr', {}, el('th', {scope: 'row'}, labelOf(region)),
                    others.map(({input, i}) => input.terms.map((term, t) => {
                      const goes = [coreMiddle(depth, region), coreMiddle(input, term)];
                      const button = el('button', {
                        type: 'button',
                        tabindex: r === 0 && i === others[0].i && t === 0 ? '0' : '-1',
                        onclick: () => {
                          state.inputs[content.region] = goes[0];
                          setInput(i, goes[1]);
                        }
                      });
                      panels.push(() => {
                        const point = state.inputs.slice();
                        point[content.region] = goes[0];
                        point[i] = goes[1];
                        const one = forceModel(point), color = one.fired ? lightened(rampColor(one.force)) : '#ffffff';
                        button.textContent = one.fired ? forceText(FORCE_MODEL, one.force) : '–';
                        button.style.background = color;
                        const here = state.inputs[content.region] === goes[0] && state.inputs[i] === goes[1];
                        button.classList.toggle('here', here);
                        button.setAttribute(
                            'aria-label',
                            labelOf(region) + ', ' + labelOf(input) + ' ' + labelOf(term) + ': ' +
                                (one.fired ? newtons(one.force) : 'no rule fires'));
                      });
                      return el('td', {class: t === 0 && 'group'}, button);
                    })))));
  return card(
      'Map',
      'Each cell is the force in the middle of two words, the other inputs as they are set. A click or Enter goes there; the arrow keys go from cell to cell.',
      el('div', {class: 'living-scroll'}, el('table', {class: 'living-map'}, head, body)));
}
