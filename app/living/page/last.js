// The last script: compares all scripts with their checksum, computes the checks again, and says so.
(() => {
  const section = document.getElementById('living');
  const state = document.getElementById('living-state');
  const say = (good, text) => {
    state.className = 'living-state ' + (good ? 'right' : 'wrong');
    state.textContent = text;
  };
  const all = Array.from(section.querySelectorAll('script'), (script) => script.textContent).join('\n');
  if (livingNumbers.crc32(all) !== section.dataset.crc32) {
    say(false,
        'Do not trust this page: it is not as it was written. Its scripts, its model or its checks were changed.');
    return;
  }
  const checks = JSON.parse(document.getElementById('living-data').textContent).checks;
  const found = livingNumbers.checkAll(FORCE_MODEL, checks, {forceModel, forceModelExpert});
  const unit = ' ' + FORCE_MODEL.output.unit, count = found.count.toLocaleString('en');
  if (found.wrong > 0) {
    say(false,
        'Do not trust this page: ' + found.wrong.toLocaleString('en') + ' of ' + count +
            ' checks are further off than ' + found.limit + unit + ', the worst by ' + found.worst.toPrecision(2) +
            unit + '.');
  } else if (!globalThis.livingStarted) {
    say(false,
        'Part of this page did not start in this browser. Its model is right (' + count +
            ' checks), what is drawn may not be.');
  } else {
    say(true, count + ' checks: all within ' + found.limit + unit);
  }
})();
