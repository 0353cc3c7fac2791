// The last screens: all answers, the simulator for teachers, the answer file.
function wordOf(answer) {
  if (!answer || isOpen(answer)) return say('web.open');
  return answer.status === 'cant_tell' ? say('w.cant_tell') : language.terms[answer.term] || answer.term;
}

// Items in a row that share a condition.
function itemGroups() {
  const groups = [];
  for (const item of content.items) {
    const last = groups[groups.length - 1];
    if (last && item.input && last[0].input === item.input && last[0].term === item.term) last.push(item);
    else if (last && !item.input && !last[0].input) last.push(item);
    else groups.push([item]);
  }
  return groups;
}

screens.review = () => {
  const open = openItems().length;
  const rows = itemGroups().map((group) => {
    const head = group[0].input
        ? say('s.' + group[0].input) + ': ' + say('s.' + group[0].input + '.' + group[0].term) : language.title;
    return el('section', {class: 'group'}, el('h2', {}, head), el('ul', {class: 'cells'}, group.map((item) => {
      const answer = run.answers[item.number];
      const place = item.region ? say('a.' + item.region) : situationOf(item);
      return el('li', {}, el('button', {
        type: 'button', class: 'cell' + (isOpen(answer) ? ' open' : ''),
        onclick: () => { run.returns = true; go('question', itemsInOrder().indexOf(item)); }},
        el('span', {class: 'place'}, item.number + '. ' + place), el('strong', {}, wordOf(answer))));
    })));
  });
  const body = [el('p', {}, say('rev.tap')), open ? el('p', {class: 'notice'}, say('rev.gaps', open)) : null, rows];
  const finish = () => { run.finished_ms = Date.now(); go('finish'); };
  const first = open ? el('button', {type: 'button', class: 'secondary', onclick: () => {
    run.returns = true;
    go('question', itemsInOrder().indexOf(openItems()[0]));
  }}, say('web.open') + ' (' + open + ')') : null;
  return screen(say('rev.title'), body, [first, button('web.finish', 'primary')], finish);
};

// What a teacher thinks of the simulator: seven points between two words.
screens.scale = () => {
  const name = (number) => 'scale-' + number;
  const groups = Object.entries(language.scale).map(([number, sentence]) => {
    const known = run.scale[number];
    return choices(name(number), sentence, pointOffers(language.points), known ? known.term : null, 'scale', (value) =>
      reply(run.scale, number, value, 'answered', shown_ms));
  });
  shown_ms = Date.now();
  return screen(say('u.begin'), [el('p', {class: 'lead'}, say('u.purpose')), el('p', {}, say('u.instructions')), groups],
      [button('nav.back', 'secondary', () => go('finish')), button('nav.next', 'primary')], () => {
        const missing = Object.keys(language.scale).find((number) => !run.scale[number]);
        if (missing) complain(say('err.points'), name(missing));
        else go('finish');
      });
};

// Only letters, digits, - and _ in a file's name.
const fileName = () => run.code.replace(/[^A-Za-z0-9_\u0080-\uffff-]+/g, '-') + '.tactus-answers.json';

screens.finish = () => {
  const file = answerFile();
  const text = JSON.stringify(file, null, 2) + '\n';
  const status = el('p', {class: 'status', role: 'status'});
  const save = () => {
    const link = el('a', {href: URL.createObjectURL(new Blob([text], {type: 'application/json'})), download: fileName()});
    document.body.append(link);
    link.click();
    link.remove();
    setTimeout(() => URL.revokeObjectURL(link.href), 60000);
    status.textContent = say('web.saved', fileName());
  };
  const area = el('textarea', {id: 'answer-text', readonly: true, rows: 6, 'aria-labelledby': 'copy-line'});
  area.value = text;
  const copy = async () => {
    area.focus();
    area.select();
    try {
      await navigator.clipboard.writeText(text);
    } catch (refused) {
      document.execCommand('copy');
    }
    copied.textContent = say('web.copied');
  };
  const copied = el('p', {class: 'status', role: 'status'});
  const remove = () => {
    if (!confirm(say('web.delete_ask'))) return;
    deleteRun();
    go('deleted');
  };
  const body = [
    el('p', {class: 'lead'}, say('web.save_line')),
    content.contact ? el('p', {}, say('con.contact', content.contact)) : null,
    el('section', {class: 'panel save'},
       el('button', {type: 'button', id: 'save', class: 'primary', onclick: save}, say('web.save')), status,
       el('h2', {}, say('web.check')), el('output', {id: 'check-code', class: 'check'}, file.check_code),
       el('p', {class: 'hint'}, say('web.check_line')),
       el('details', {}, el('summary', {id: 'copy-line'}, say('web.copy_line')), area,
          el('button', {type: 'button', class: 'secondary', onclick: copy}, say('web.copy')), copied)),
    el('div', {class: 'more'},
       !is_scale ? el('button', {type: 'button', class: 'secondary', id: 'teach', onclick: () => go('scale')}, say('u.begin')) : null,
       el('button', {type: 'button', class: 'secondary', onclick: () => window.print()}, say('thx.print')),
       el('button', {type: 'button', class: 'secondary', id: 'delete', onclick: remove}, say('web.delete'))),
  ];
  return screen(say('thx.title'), body, [button('nav.back', 'secondary', () => go('review'))], null);
};

screens.deleted = () => screen(say('web.deleted'), [el('p', {}, say('thx.line'))],
                               [button('nav.continue', 'secondary', () => go('welcome'))], null);

