// One person's way through the form: what was answered, kept in the browser, and the answer file made of it.
const storeKey = 'tactus-form-' + content.form_sha256;
let memory = {current: null, runs: {}};  // as in the browser's storage
let run = null;                          // the current one of memory.runs
let storage_works = false;

function readStore() {
  try {
    const text = localStorage.getItem(storeKey);
    if (text) memory = JSON.parse(text);
    localStorage.setItem(storeKey, JSON.stringify(memory));
    storage_works = true;
  } catch (refused) {
    storage_works = false;
  }
}

function keep() {
  try {
    localStorage.setItem(storeKey, JSON.stringify(memory));
    storage_works = true;
  } catch (refused) {
    storage_works = false;
  }
  showStorage();
}

function newCode() {
  const {first, second} = content.codes;
  return first[drawn(first.length)] + '-' + second[drawn(second.length)];
}

// The places of the items in the order in which one person is asked: the form's, or drawn among all or within each
// block of the form (Fisher and Yates).
function itemOrder() {
  const order = content.items.map((item, place) => place);
  if (content.order === 'fixed') return order;
  const blockOf = (place) => (content.order === 'within_blocks' ? content.items[place].block : 1);
  for (let first = 0, end = 0; first < order.length; first = end) {
    while (end < order.length && blockOf(end) === blockOf(first)) ++end;
    for (let left = end - first; left > 1; --left) {
      const one = first + left - 1;
      const other = first + drawn(left);
      [order[one], order[other]] = [order[other], order[one]];
    }
  }
  return order;
}

const itemsInOrder = () => run.order.map((place) => content.items[place]);

// Begins a run with a code of the page's own, or with one that the researcher gave.
function beginRun(code) {
  run = {
    id: randomId(), code: code || newCode(), code_given: code ? 'typed' : 'page', consent: null,
    order: itemOrder(), profile: {}, answers: {}, scale: {}, screen: 'consent', item: 0, returns: false,
  };
  memory.runs[run.id] = run;
  memory.current = run.id;
  keep();
}

function sameCode(a, b) {
  const key = (code) => code.toLowerCase().replace(/[^a-z0-9\u0080-\uffff]/g, '');
  return key(a) === key(b);
}

function runWithCode(code) {
  return Object.values(memory.runs).find((one) => sameCode(one.code, code)) || null;
}

function deleteRun() {
  delete memory.runs[run.id];
  memory.current = null;
  run = null;
  keep();
}

const isOpen = (reply) => !reply || reply.status === 'skipped' || reply.status === 'cleared';
const openItems = () => itemsInOrder().filter((item) => isOpen(run.answers[item.number]));
const answeredCount = (one) => content.items.filter((item) => !isOpen(one.answers[item.number])).length;

// Keeps the reply to a question. A different one counts as a change.
function reply(replies, number, term, status, shown_ms) {
  const before = replies[number];
  if (before && before.term === term && before.status === status) return;
  const now = Date.now();
  replies[number] = {
    term, status, utc_ms: now,
    changes: before ? before.changes + (isOpen(before) ? 0 : 1) : 0,
    response_s: Math.max(0, Math.round((now - shown_ms) / 10) / 100),
  };
  keep();
}

function answerList(numbers, replies) {
  return numbers.map((item) => {
    const one = replies[item];
    if (!one) return {item, term: null, status: 'skipped', utc_ms: run.finished_ms, changes: 0, response_s: 0};
    return {item, term: one.term, status: one.status, utc_ms: one.utc_ms, changes: one.changes,
            response_s: one.response_s};
  });
}

// The lines of which the check code is made; docs/study-form.md names them.
function checkedText(file) {
  const lines = ['tactus-answers 1', file.study, file.form + ' ' + file.wording, file.form_sha256, file.language,
                 file.participant.code, file.participant.given + ' ' + file.participant.run,
                 file.consent.version, file.consent.time, file.consent.text];
  for (const key of Object.keys(file.profile)) lines.push(key + '=' + file.profile[key]);
  for (const list of [file.answers, file.usability]) {
    lines.push('answers ' + list.length);
    for (const one of list)
      lines.push([one.item, one.status, one.term === null ? '-' : one.term, one.utc_ms, one.changes].join(' '));
  }
  return lines.join('\n');
}

// Eight letters and digits, without those that look alike: five bits each of the hash.
function checkCode(file) {
  const letters = '0123456789ABCDEFGHJKMNPQRSTVWXYZ';
  const [high, low] = sha256(checkedText(file));
  let code = '';
  for (let i = 0; i < 6; ++i) code += letters[(high >>> (27 - 5 * i)) & 31];
  code += letters[((high & 3) << 3) | (low >>> 29)];
  code += letters[(low >>> 24) & 31];
  return code.slice(0, 4) + '-' + code.slice(4);
}

function answerFile() {
  const profile = {};
  for (const question of content.profile) profile[question.field] = run.profile[question.field] || '';
  const scale = Object.keys(language.scale).map(Number);
  const file = {
    format: 'tactus-answers', version: 1, study: content.study, form: content.form, wording: content.wording,
    form_sha256: content.form_sha256, language: language.id,
    participant: {code: run.code, given: run.code_given, run: run.id},
    consent: run.consent, profile,
    answers: answerList(itemsInOrder().map((item) => item.number), run.answers),
    usability: Object.keys(run.scale).length ? answerList(scale, run.scale) : [],
  };
  file.check_code = checkCode(file);
  return file;
}

