// The pictures of a question: the body with the tube, and a sign for the level of a condition.
const SVG = 'http://www.w3.org/2000/svg';

function svg(name, attributes, ...children) {
  const node = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes || {})) node.setAttribute(key, value);
  node.append(...children.flat());
  return node;
}

const drawings = {};
function drawingOf(posture) {
  drawings[posture] = drawings[posture] ||
      'data:image/svg+xml;charset=utf-8,' + encodeURIComponent(content.pictures[posture].drawing);
  return drawings[posture];
}

const isLeftHanded = () => run !== null && run.profile.handedness === 'left';

// The body in a posture. `tips`: {region, label}; the tube goes to the deepest. `name`: what a screen reader says.
function headPicture(posture, tips, whole, name) {
  const picture = content.pictures[posture];
  const [x, y, width, height] = whole ? picture.box : picture.near;
  const mirrored = isLeftHanded();
  const parts = [svg('image', {href: drawingOf(posture), x: picture.box[0], y: picture.box[1],
                               width: picture.box[2], height: picture.box[3]})];
  const regions = tips.map((tip) => picture.regions[tip.region]);
  for (const region of regions)
    parts.push(svg('path', {d: region.outline, fill: '#FFC247', stroke: '#6B4500', 'stroke-width': 1.3}));
  const deepest = regions.reduce((a, b) => (a && a.end > b.end ? a : b), null);
  if (deepest) {
    const scale = height / 260;
    const points = picture.tube.slice(0, 2 * (deepest.end + 1)).concat(deepest.tip).join(' ');
    for (const [stroke, w] of [['#FFFFFF', 6.5], ['#0B659E', 4], ['#7DB9DC', 1]]) {
      parts.push(svg('polyline', {points, fill: 'none', stroke, 'stroke-width': w * scale, 'stroke-linecap': 'round',
                                  'stroke-linejoin': 'round'}));
    }
    tips.forEach((tip, i) => {
      const [cx, cy] = regions[i].tip;
      parts.push(svg('circle', {cx, cy, r: 4.5 * scale, fill: '#0B659E', stroke: '#FFFFFF', 'stroke-width': 2 * scale}));
      if (!tip.label) return;
      const at = cx + 20 * scale;
      parts.push(svg('line', {x1: cx, y1: cy, x2: at, y2: cy, stroke: '#1F2933', 'stroke-width': scale}));
      parts.push(svg('circle', {cx: at, cy, r: 9 * scale, fill: '#FFFFFF', stroke: '#1F2933', 'stroke-width': scale}));
      const text = svg('text', {x: mirrored ? -at : at, y: cy + 4 * scale, 'font-size': 11 * scale,
                                'text-anchor': 'middle', 'font-weight': 700, fill: '#1F2933'}, String(tip.label));
      if (mirrored) text.setAttribute('transform', 'scale(-1 1)');
      parts.push(text);
    });
  }
  const all = svg('g', mirrored ? {transform: 'matrix(-1 0 0 1 ' + (2 * x + width) + ' 0)'} : {}, parts);
  const out = svg('svg', {viewBox: [x, y, width, height].join(' '), class: 'head', role: 'img'}, all);
  out.setAttribute('aria-label', name);
  return out;
}

// Drops, arrows or bars, of which as many are full as the level; the words say the same.
function signOf(item) {
  const shapes = {drop: 'M12 3C16 9 19 12 19 16A7 7 0 0 1 5 16C5 12 8 9 12 3Z', arrow: 'M4 4L20 12L4 20L9 12Z',
                  bar: 'M5 4H19V20H5Z'};
  const sign = content.signs[item.input];
  if (!sign) return null;
  const parts = Array.from({length: sign.of}, (_, i) => svg('path', {
    d: shapes[sign.shape], transform: 'translate(' + 24 * i + ' 0)', 'stroke-width': 1.6, stroke: '#085285',
    fill: i < item.level ? '#085285' : '#FFFFFF'}));
  return svg('svg', {viewBox: '0 0 ' + 24 * sign.of + ' 24', class: 'sign', 'aria-hidden': 'true'}, parts);
}

// Whether a region lies outside the part of the picture that most questions are about.
const isFar = (region) => content.pictures[content.usual].regions[region].far;

// Head and sign of an item, with the name of the region below.
function itemPicture(item, sentence) {
  if (!item.region) return null;
  return el('figure', {class: 'picture'},
            headPicture(item.posture || content.usual, [{region: item.region}], isFar(item.region), sentence),
            signOf(item),
            el('figcaption', {'aria-hidden': 'true'}, say('a.' + item.region)));
}

