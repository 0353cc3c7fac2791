// The head of every screen, and the first screen.
function showStorage() {
  const line = document.getElementById('storage');
  if (!line) return;
  line.textContent = storage_works ? say('web.kept') : say('web.not_kept');
  line.classList.toggle('notice', !storage_works);
}

function pageHead(current) {
  const pick = (id, label, offers, chosen, onchange) => el('label', {class: 'pick', for: id}, el('span', {}, label),
      el('select', {id, onchange: (event) => onchange(event.target.value)}, offers.map(([value, text, lang]) =>
        el('option', {value, lang, selected: value === chosen}, text))));
  const again = (id) => { show(current); showPaper(); document.getElementById(id).focus(); };
  const languages = content.languages.map((one) => [one.id, languageNames[one.id] || one.id, one.id]);
  const sizes = [['100', say('wel.size_100')], ['125', say('wel.size_125')], ['150', say('wel.size_150')]];
  return el('header', {class: 'top'},
      content.languages.length > 1 ? pick('language', say('wel.language'), languages, language.id, (id) => {
        keepAnswerShown();
        setLanguage(id);
        memory.language = id;
        keep();
        again('language');
      }) : null,
      pick('text-size', say('wel.text_size'), sizes, String(memory.text_size || 100), (size) => {
        keepAnswerShown();
        memory.text_size = Number(size);
        keep();
        again('text-size');
      }));
}

// A word that is chosen but not yet confirmed stays chosen when the screen is drawn again.
let chosen_before = null;
function keepAnswerShown() { chosen_before = chosenIn('answer'); }

function show(name) {
  document.documentElement.style.fontSize = (memory.text_size || 100) + '%';
  const body = screens[name]();
  app.replaceChildren(pageHead(name), el('main', {class: 'screen-' + name}, body), el('p', {id: 'storage', class: 'hint'}));
  if (chosen_before !== null) {
    const card = app.querySelector('input[name="answer"][value="' + chosen_before + '"]');
    if (card) card.checked = true;
    chosen_before = null;
  }
  showStorage();
}

window.addEventListener('beforeprint', showPaper);
readStore();
const wanted = [memory.language].concat(navigator.languages || []).find((one) => one && content.languages.some(
    (offered) => offered.id === one || (/^zh/.test(one) && offered.id === (/Hant|TW|HK|MO/i.test(one) ? 'zh-Hant' : 'zh-Hans')) ||
                 one.split('-')[0] === offered.id));
setLanguage(wanted === undefined || content.languages.some((one) => one.id === wanted) ? wanted
    : /^zh/.test(wanted) ? (/Hant|TW|HK|MO/i.test(wanted) ? 'zh-Hant' : 'zh-Hans') : wanted.split('-')[0]);
app.hidden = false;
show('welcome');
showPaper();
