// The screens up to the last question. Each is a function that returns what stands between head and foot.
const screens = {};
let shown_ms = 0;

const steps = ['welcome', 'consent', 'about', 'glossary', 'question', 'review', 'finish'];

function go(screen, item) {
  if (run) {
    run.screen = screen;
    if (item !== undefined) run.item = item;
    keep();
  }
  show(screen);
  const title = app.querySelector('h1');
  window.scrollTo(0, 0);
  if (title) title.focus({preventScroll: true});
}

// A radio group: {value, label, extra}. `chosen`: its value now.
function choices(name, legend, offers, chosen, kind, onchange) {
  const cards = offers.map((offer) => el('label', {class: 'card' + (offer.quiet ? ' quiet' : '')},
      el('input', {type: 'radio', name, value: offer.value, checked: offer.value === chosen,
                   'aria-label': offer.name, onchange: () => onchange && onchange(offer.value)}),
      offer.picture, offer.label ? el('span', {class: 'word'}, offer.label) : null));
  const ends = offers.ends ? el('p', {class: 'ends', 'aria-hidden': 'true'}, offers.ends.map((end) => el('span', {}, end))) : null;
  return el('fieldset', {class: 'choices ' + kind}, el('legend', {}, legend), el('div', {class: 'cards'}, cards), ends);
}

// The points of a scale, of which the first and the last have words.
function pointOffers(points) {
  const offers = Object.entries(points).map(([value, label]) => (
      {value, name: label ? value + ' ' + label : value, picture: el('span', {class: 'point'}, value)}));
  const words = Object.values(points);
  offers.ends = [words[0], words[words.length - 1]];
  return offers;
}

const chosenIn = (name) => {
  const found = app.querySelector('input[name="' + name + '"]:checked');
  return found ? found.value : null;
};

// Says what is missing where it can be seen and heard, and leads there.
function complain(text, name) {
  const place = app.querySelector('.error');
  place.textContent = text;
  place.hidden = false;
  const field = app.querySelector('[name="' + name + '"]');
  if (!field) return;
  field.closest('fieldset, .field').before(place);
  field.focus();
}

function button(id, kind, onclick) {
  return el('button', {type: kind === 'primary' && !onclick ? 'submit' : 'button', class: kind, onclick}, say(id));
}

// A screen: its title, what it shows, and the buttons at the foot. `next` runs on Enter too.
function screen(title, body, buttons, next) {
  const form = el('form', {novalidate: true, onsubmit: (event) => { event.preventDefault(); if (next) next(); }},
                  el('h1', {tabindex: -1}, title), body,
                  el('p', {class: 'error', role: 'alert', hidden: true}),
                  el('div', {class: 'foot'}, buttons));
  return form;
}

screens.welcome = () => {
  const kept = memory.current && memory.runs[memory.current];
  const count = kept ? answeredCount(kept) : 0;
  const parts = [el('p', {class: 'lead'}, language.title), el('p', {}, say('wel.line', content.minutes))];
  if (!content.consent_version) parts.push(el('p', {class: 'notice'}, say('web.trial')));
  const begin = (code) => { beginRun(code); go('consent'); };
  if (kept) {
    parts.push(el('section', {class: 'panel'},
        el('h2', {}, say('code.back', count)), el('p', {}, say('web.resume_code', kept.code)),
        button('nav.continue', 'primary', () => { run = kept; go(run.screen); })));
  }
  parts.push(el('section', {class: 'panel'},
      button('code.new', kept ? 'secondary' : 'primary', () => begin(null)),
      el('div', {class: 'field'},
         el('label', {for: 'code'}, say('code.have')),
         el('p', {class: 'hint', id: 'code-hint'}, say('web.code_given')),
         el('div', {class: 'row'},
            el('input', {id: 'code', name: 'code', autocomplete: 'off', autocapitalize: 'none', spellcheck: 'false',
                         maxlength: 40, 'aria-describedby': 'code-hint'}),
            el('button', {type: 'submit', class: 'secondary'}, say('nav.continue'))))));
  return screen(say('wel.title'), parts, [], () => {
    const code = document.getElementById('code').value.trim();
    if (!/^[A-Za-z0-9\u0080-\uffff]+([ _-]?[A-Za-z0-9\u0080-\uffff]+){0,3}$/.test(code)) {
      complain(say('web.code_wrong'), 'code');
      return;
    }
    const known = runWithCode(code);
    if (!known) { begin(code); return; }
    run = known;
    memory.current = run.id;
    go(run.screen);
  });
};

screens.consent = () => {
  const agree = () => {
    run.consent = {version: content.consent_version, time: new Date().toISOString(), language: language.id,
                   text: language.consent.join('\n')};
    go('about');
  };
  const body = [el('p', {class: 'code-line'}, say('code.yours', run.code))];
  if (!content.consent_version) body.push(el('p', {class: 'notice'}, say('web.trial')));
  body.push(el('ul', {class: 'consent'}, language.consent.map((line) => el('li', {}, line))));
  return screen(say('con.title'), body,
      [button('con.decline', 'secondary', () => { deleteRun(); go('declined'); }), button('con.agree', 'primary')], agree);
};

screens.declined = () => screen(say('con.declined'), [], [button('nav.back', 'secondary', () => go('welcome'))], null);

screens.about = () => {
  const groups = content.profile.map((question) => {
    const offers = question.offers.map((offer) => ({value: offer.stored, label: say(offer.words)}));
    if (question.may_not_say) offers.push({value: 'not_say', label: say('you.not_say'), quiet: true});
    const known = run.profile[question.field];
    return choices(question.field, say(question.words), offers, known === '' ? 'not_say' : known, 'list', (value) => {
      run.profile[question.field] = value === 'not_say' ? '' : value;
      keep();
    });
  });
  return screen(say('you.title'), groups,
      [button('nav.back', 'secondary', () => go('consent')), button('nav.next', 'primary')], () => {
        const missing = content.profile.find((question) => run.profile[question.field] === undefined);
        if (missing) complain(say('web.missing', say(missing.words)), missing.field);
        else go('glossary');
      });
};

screens.glossary = () => {
  const has_regions = content.items.some((item) => item.region);
  const body = [el('p', {class: 'lead'}, language.instructions)];
  if (has_regions) {
    body.push(el('h2', {}, say('glo.way')));
    body.push(el('ol', {class: 'way'}, content.regions.map((region) => el('li', {},
        headPicture(content.usual, [{region}], isFar(region), say('a.' + region)), el('span', {}, say('a.' + region))))));
    body.push(el('ul', {class: 'words'}, content.glossary.map(
        (id) => el('li', {}, say(id)))));
  }
  body.push(el('p', {class: 'hint keys'}, say('web.keys')));
  return screen(say('glo.title'), body,
      [button('nav.back', 'secondary', () => go('about')), button('nav.next', 'primary')],
      () => go('question', run.item));
};

// A bar whose height is the word's place among the five.
const bar = (place) => el('span', {class: 'bar bar' + place, 'aria-hidden': 'true'});

// Text of an item before its question.
const situationOf = (item) => language.items[item.number];

function termOffers() {
  const terms = Object.entries(language.terms);
  const forces = !is_scale;
  const words = (value, label, i) => ({value, label: label || value, picture: bar(i + 1)});
  const offers = forces ? terms.map(([value, label], i) => words(value, label, i)) : pointOffers(language.terms);
  return {offers, forces};
}

screens.question = () => {
  const item = itemsInOrder()[run.item];
  const known = run.answers[item.number];
  const {offers, forces} = termOffers();
  if (forces) offers.push({value: 'cant_tell', label: say('w.cant_tell'), quiet: true});
  const chosen = known ? (known.status === 'cant_tell' ? 'cant_tell' : known.term) : null;
  const sentence = joined(situationOf(item), language.question);
  const legend = [el('span', {class: 'situation'}, situationOf(item)), ' ',
                  el('strong', {}, language.question || (forces ? '' : say('u.instructions')))];
  const leave = (reply_needed) => {
    const value = chosenIn('answer');
    if (value === 'cant_tell') reply(run.answers, item.number, null, 'cant_tell', shown_ms);
    else if (value !== null) reply(run.answers, item.number, value, 'answered', shown_ms);
    else if (reply_needed) { complain(say('err.choose'), 'answer'); return; }
    else if (!known) reply(run.answers, item.number, null, 'skipped', shown_ms);
    const last = run.item + 1 === content.items.length;
    if (run.returns || last) go('review');
    else go('question', run.item + 1);
  };
  const back = () => {
    if (run.returns) go('review');
    else if (run.item === 0) go('glossary');
    else go('question', run.item - 1);
  };
  shown_ms = Date.now();
  const body = el('div', {class: 'question'}, itemPicture(item, situationOf(item)),
      el('div', {class: 'asked'}, choices('answer', legend, offers, chosen, forces ? 'force' : 'scale'),
         known && !isOpen(known) ? null : el('button', {type: 'button', class: 'link skip', onclick: () => leave(false)},
                                             say('web.skip'))));
  const out = screen(say('web.question', run.item + 1, content.items.length), body,
      [button('nav.back', 'secondary', back), button('nav.next', 'primary')], () => leave(true));
  const done = answeredCount(run);
  out.prepend(el('progress', {max: content.items.length, value: done,
                              'aria-label': say('web.progress', done, content.items.length)}));
  return out;
};

// 1 to 5 choose a word, 0 stands for "I can't tell"; Enter is the form's own.
document.addEventListener('keydown', (event) => {
  if (event.ctrlKey || event.altKey || event.metaKey || !/^[0-9]$/.test(event.key)) return;
  if (event.target.matches && event.target.matches('input:not([type=radio]), textarea')) return;
  const cards = Array.from(app.querySelectorAll('input[name="answer"]'));
  const card = event.key === '0' ? cards.find((one) => one.value === 'cant_tell')
                                 : cards.filter((one) => one.value !== 'cant_tell')[Number(event.key) - 1];
  if (!card) return;
  card.checked = true;
  card.focus();
  event.preventDefault();
});

