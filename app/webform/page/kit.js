// Small tools of the page: elements, texts in the chosen language, SHA-256.
const content = JSON.parse(document.getElementById('content').textContent);
const app = document.getElementById('app');
// The study asks about the simulator alone.
const is_scale = content.form === 'usability-v1';
const paper = document.getElementById('paper');

// el('p', {class: 'lead'}, 'text', child): a listener is an attribute whose name begins with `on`.
function el(name, attributes, ...children) {
  const node = document.createElement(name);
  for (const [key, value] of Object.entries(attributes || {})) {
    if (value === null || value === undefined || value === false) continue;
    if (key.startsWith('on')) node.addEventListener(key.slice(2), value);
    else node.setAttribute(key, value === true ? '' : value);
  }
  for (const child of children.flat(Infinity)) {
    if (child !== null && child !== undefined) node.append(child);
  }
  return node;
}

const languageNames = {en: 'English', 'zh-Hant': '繁體中文', 'zh-Hans': '简体中文', de: 'Deutsch'};
let language = content.languages[0];

// The text with this id; %1, %2 and %n are replaced by the values.
function say(id, ...values) {
  let text = language.words[id];
  if (values.length === 1 && values[0] === 1 && language.words[id + '.one']) text = language.words[id + '.one'];
  values.forEach((value, i) => { text = text.split('%' + (i + 1)).join(value); });
  return text.split('%n').join(values[0]);
}

// Sentences follow each other without a space in Chinese.
function joined(...sentences) {
  return sentences.filter((one) => one).join(language.id.startsWith('zh') ? '' : ' ');
}

function setLanguage(id) {
  language = content.languages.find((one) => one.id === id) || content.languages[0];
  document.documentElement.lang = language.id;
  document.title = language.title;
}

// Random whole number from 0 to below `count`.
function drawn(count) {
  const room = Math.floor(4294967296 / count) * count;
  const bits = new Uint32Array(1);
  do crypto.getRandomValues(bits); while (bits[0] >= room);
  return bits[0] % count;
}

function randomId() {
  const bytes = crypto.getRandomValues(new Uint8Array(16));
  return Array.from(bytes, (byte) => byte.toString(16).padStart(2, '0')).join('');
}

// SHA-256 (FIPS 180-4) of a text in UTF-8, as 8 words of 32 bits. The browser's own is missing where a page is no
// secure place, as on some phones.
function sha256(text) {
  const primes = [];
  for (let n = 2; primes.length < 64; ++n) if (primes.every((p) => n % p)) primes.push(n);
  const fraction = (x) => Math.floor((x - Math.floor(x)) * 4294967296) | 0;
  const k = primes.map((p) => fraction(Math.cbrt(p)));
  const h = primes.slice(0, 8).map((p) => fraction(Math.sqrt(p)));
  const bytes = new TextEncoder().encode(text);
  const blocks = new DataView(new ArrayBuffer(Math.ceil((bytes.length + 9) / 64) * 64));
  bytes.forEach((byte, i) => blocks.setUint8(i, byte));
  blocks.setUint8(bytes.length, 0x80);
  blocks.setUint32(blocks.byteLength - 8, Math.floor(bytes.length / 536870912));
  blocks.setUint32(blocks.byteLength - 4, bytes.length * 8);
  const turn = (x, n) => (x >>> n) | (x << (32 - n));
  for (let at = 0; at < blocks.byteLength; at += 64) {
    const w = [];
    for (let i = 0; i < 64; ++i) {
      if (i < 16) { w.push(blocks.getInt32(at + 4 * i)); continue; }
      const a = w[i - 15], b = w[i - 2];
      const s0 = turn(a, 7) ^ turn(a, 18) ^ (a >>> 3);
      const s1 = turn(b, 17) ^ turn(b, 19) ^ (b >>> 10);
      w.push((w[i - 16] + s0 + w[i - 7] + s1) | 0);
    }
    let [a, b, c, d, e, f, g, i8] = h;
    for (let i = 0; i < 64; ++i) {
      const s1 = turn(e, 6) ^ turn(e, 11) ^ turn(e, 25);
      const t1 = (i8 + s1 + ((e & f) ^ (~e & g)) + k[i] + w[i]) | 0;
      const s0 = turn(a, 2) ^ turn(a, 13) ^ turn(a, 22);
      const t2 = (s0 + ((a & b) ^ (a & c) ^ (b & c))) | 0;
      i8 = g; g = f; f = e; e = (d + t1) | 0; d = c; c = b; b = a; a = (t1 + t2) | 0;
    }
    [a, b, c, d, e, f, g, i8].forEach((x, i) => { h[i] = (h[i] + x) | 0; });
  }
  return h.map((x) => x >>> 0);
}

