// The form on paper: a cover, the words and regions, then one page for each condition with two questions a picture.
function paperChoice(label, marked) {
  return el('span', {class: 'mark'}, el('span', {class: 'ring' + (marked ? ' full' : ''), 'aria-hidden': 'true'}), label);
}

function paperPage(title, number, count, ...body) {
  return el('section', {class: 'sheet'},
      el('header', {}, el('span', {}, language.title),
         el('span', {}, say('code.field') + ': ', el('span', {class: 'line'}, run ? run.code : ''))),
      el('h1', {}, title), body, el('footer', {}, say('web.page', number, count)));
}

function paperCover() {
  const profile = content.profile.map((question) => el('div', {class: 'ask'}, el('p', {}, say(question.words)),
      el('p', {class: 'marks'}, question.offers.map((offer) =>
        paperChoice(say(offer.words), run !== null && run.profile[question.field] === offer.stored)))));
  return [
    content.consent_version ? null : el('p', {class: 'notice'}, say('web.trial')),
    el('ul', {class: 'consent'}, language.consent.filter((line) => line !== say('web.sends')).map((line) => el('li', {}, line))),
    el('p', {class: 'marks'}, paperChoice(say('con.agree'), run !== null && run.consent !== null),
       el('span', {}, say('web.date') + ': ', el('span', {class: 'line'}, ''))),
    el('h2', {}, say('you.title')), profile];
}

function paperItem(item) {
  const answer = run ? run.answers[item.number] : null;
  const term = answer && answer.status === 'answered' ? answer.term : null;
  const {forces} = termOffers();
  const marks = Object.entries(language.terms).map(([value, label]) => paperChoice(
      forces ? label : value + (label ? ' ' + label : ''), term === value));
  if (forces) marks.push(paperChoice(say('w.cant_tell'), Boolean(answer) && answer.status === 'cant_tell'));
  return el('div', {class: 'item'},
      el('p', {}, el('strong', {class: 'number'}, item.number + '.'), ' ', situationOf(item), ' ',
         el('strong', {}, language.question)),
      el('p', {class: 'marks'}, marks));
}

function paperItems(group) {
  const blocks = [];
  if (!group[0].region) return group.map(paperItem);
  for (let i = 0; i < group.length; i += 2) {
    const pair = group.slice(i, i + 2);
    const whole = pair.some((item) => isFar(item.region));
    const tips = pair.map((item) => ({region: item.region, label: item.number}));
    blocks.push(el('div', {class: 'pair'},
        el('figure', {}, headPicture(pair[0].posture || content.usual, tips, whole, pair.map(situationOf).join(' ')), signOf(pair[0])),
        el('div', {}, pair.map(paperItem))));
  }
  return blocks;
}

function showPaper() {
  const groups = itemGroups();
  const has_regions = content.items.some((item) => item.region);
  const count = groups.length + 1 + (has_regions ? 1 : 0);
  let number = 0;
  const pages = [paperPage(say('con.title'), ++number, count, paperCover())];
  if (has_regions) {
    pages.push(paperPage(say('glo.title'), ++number, count, el('p', {}, language.instructions), el('p', {}, say('web.pen')),
        el('h2', {}, say('glo.way')),
        el('div', {class: 'regions'},
           headPicture(content.usual, content.regions.map((region, i) => ({region, label: i + 1})), true, say('glo.way')),
           el('ol', {}, content.regions.map((region) => el('li', {}, say('a.' + region))))),
        el('ul', {}, content.glossary.map((id) => el('li', {}, say(id)))),
        el('p', {}, say('web.two_tips'))));
  }
  for (const group of groups) {
    const title = group[0].input
        ? say('s.' + group[0].input) + ': ' + say('s.' + group[0].input + '.' + group[0].term) : language.title;
    pages.push(paperPage(title, ++number, count, paperItems(group)));
  }
  paper.replaceChildren(...pages);
}

