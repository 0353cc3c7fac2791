// Puts the panels together.
const living = document.getElementById('living-app');
living.append(
    el('div', {class: 'living-two'}, card('Inputs', '', FORCE_MODEL.inputs.map(inputRow)), forcePanel()), curvePanel(),
    whyPanel(), ...[mapPanel(), tubePanel()].filter((one) => one !== null), wordsPanel());
living.hidden = false;
window.addEventListener('resize', changed);
changed();
globalThis.livingStarted = true;
