// Runs before everything else: until the last script has checked the page, it counts as damaged.
(() => {
  const state = document.getElementById('living-state');
  state.className = 'living-state wrong';
  state.textContent = 'Do not trust this page: its scripts did not run to their end, so its model was not checked.';
})();
