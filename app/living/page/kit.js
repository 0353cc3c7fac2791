// Elements, drawings and the state that all panels show.
const SVG = 'http://www.w3.org/2000/svg';
const {labelOf, within, coreMiddle, wordsAt, partsOf, positionsOf, curve, forceText, valueText} = livingNumbers;
const engine = {
  forceModel,
  forceModelExpert
};

function put(node, attributes, children) {
  for (const [name, value] of Object.entries(attributes || {})) {
    if (value === null || value === undefined || value === false) continue;
    if (name.startsWith('on'))
      node.addEventListener(name.slice(2), value);
    else
      node.setAttribute(name, value === true ? '' : value);
  }
  node.append(...children.flat(Infinity).filter((child) => child !== null && child !== undefined && child !== false));
  return node;
}
const el = (name, attributes, ...children) => put(document.createElement(name), attributes, children);
const svg = (name, attributes, ...children) => put(document.createElementNS(SVG, name), attributes, children);

const content = JSON.parse(document.getElementById('living-data').textContent);
const unit = FORCE_MODEL.output.unit;
const newtons = (force) => forceText(FORCE_MODEL, force) + ' ' + unit;
const state = {
  inputs: livingNumbers.startPoint(FORCE_MODEL, content.region, engine),
  over: Math.max(content.region, 0),    // the input of the curve
  what_if: null,                        // a copy of the model with moved words
  word_of: Math.max(content.region, 0)  // the variable whose words are shown; the number of inputs: the force
};

/* Every panel adds what it draws again; one drawing a frame is enough. */
const panels = [];
let waiting = false;
function changed() {
  if (waiting) return;
  waiting = true;
  requestAnimationFrame(() => {
    waiting = false;
    for (const draw of panels) draw();
  });
}
function setInput(input, value) {
  if (!Number.isFinite(value)) return;
  state.inputs[input] = within(FORCE_MODEL.inputs[input], value);
  changed();
}

/* 1, 2 or 5 times a power of ten, about a `parts`th of `range`. */
function roundStep(range, parts) {
  const power = 10 ** Math.floor(Math.log10(range / parts));
  return [1, 2, 5, 10].map((one) => one * power).find((one) => one >= range / parts * 0.999);
}
function ticksOf(min, max, parts) {
  const step = roundStep(max - min, parts), out = [];
  for (let k = Math.ceil(min / step - 1e-9); k * step <= max + step * 1e-9 && out.length < 30; ++k)
    out.push(Number((k * step).toPrecision(12)));
  return out;
}

function rampColor(force) {
  const {min, max} = FORCE_MODEL.output;
  const share = Math.min(Math.max((force - min) / (max - min), 0), 1);
  return content.ramp[Math.round(share * (content.ramp.length - 1))];
}
/* A color with a third of white, on which dark text reads well. */
const lightened = (color) => '#' +
    [1, 3, 5].map((at) => Math.round(parseInt(color.slice(at, at + 2), 16) * 0.65 + 255 * 0.35).toString(16)).join('');

function card(title, hint, ...children) {
  const id = 'living-' + title.toLowerCase().replace(/[^a-z]+/g, '-');
  return el(
      'section', {class: 'living-card', 'aria-labelledby': id}, el('h3', {id}, title),
      hint ? el('p', {class: 'living-hint'}, hint) : null, children);
}

/* The axes of a drawing; `x` and `y` place a value. */
function axes(width, height, x_range, y_range, x_label, y_label) {
  const left = 46, right = 12, top = 12, bottom = 40;
  const x = (value) => left + (value - x_range[0]) / (x_range[1] - x_range[0]) * (width - left - right);
  const y = (value) => height - bottom - (value - y_range[0]) / (y_range[1] - y_range[0]) * (height - top - bottom);
  const group = svg('g', {class: 'living-axes'});
  for (const tick of ticksOf(...y_range, 5)) {
    group.append(
        svg('line', {x1: left, x2: width - right, y1: y(tick), y2: y(tick)}),
        svg('text', {x: left - 6, y: y(tick) + 4, 'text-anchor': 'end'}, String(tick)));
  }
  for (const tick of ticksOf(...x_range, Math.max(2, Math.floor(width / 90)))) {
    group.append(
        svg('line', {x1: x(tick), x2: x(tick), y1: height - bottom, y2: height - bottom + 4}),
        svg('text', {x: x(tick), y: height - bottom + 17, 'text-anchor': 'middle'}, String(tick)));
  }
  group.append(
      svg('text', {x: left + (width - left - right) / 2, y: height - 5, 'text-anchor': 'middle'}, x_label),
      svg('text', {
        x: 12,
        y: top + (height - top - bottom) / 2,
        'text-anchor': 'middle',
        transform: 'rotate(-90 12 ' + (top + (height - top - bottom) / 2) + ')'
      },
          y_label));
  return {
    group,
    x,
    y,
    left,
    right: width - right,
    top,
    bottom: height - bottom,
    value: (at) => x_range[0] + (at - left) / (width - left - right) * (x_range[1] - x_range[0])
  };
}

/* The parts of a variable behind a drawing, every second one shaded; names where there is room. */
function addParts(drawing, parts, x, top, bottom) {
  parts.forEach(({label, from, to}, k) => {
    const room = x(to) - x(from);
    if (k % 2 === 0)
      drawing.append(
          svg('rect', {class: 'living-region', x: x(from), y: top, width: Math.max(room, 0), height: bottom - top}));
    if (label.length * 6.4 < room)
      drawing.append(
          svg('text', {class: 'living-region-name', x: (x(from) + x(to)) / 2, y: top + 13, 'text-anchor': 'middle'},
              label));
  });
}

/* A line with gaps where there is no force. */
function path(xs, ys, place) {
  let out = '', down = false;
  xs.forEach((x, i) => {
    if (ys[i] === null) {
      down = false;
      return;
    }
    out += (down ? 'L' : 'M') + place.x(x).toFixed(1) + ' ' + place.y(ys[i]).toFixed(1);
    down = true;
  });
  return out;
}
/* Drawings are as wide as their card, so that their text keeps its size. */
const widthOf = (holder) => Math.max(280, Math.min(holder.clientWidth || 700, 1100));
const named = (variable) =>
    labelOf(variable) + (variable.unit && variable.unit !== '1' ? ' (' + variable.unit + ')' : '');
