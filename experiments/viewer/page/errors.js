'use strict';
// Whatever goes wrong is shown, and kept for the tests.
const errors = [];
function trouble(message)
{
  errors.push(String(message));
  const line = document.getElementById('trouble');
  line.hidden = false;
  line.textContent = String(message);
  document.getElementById('state').textContent = JSON.stringify({ready: false, errors});
}
window.addEventListener('error', event => trouble(event.message));
window.addEventListener('unhandledrejection', event => trouble(event.reason));
for (const level of ['error', 'warn']) {
  const say = console[level];
  console[level] = (...words) => { errors.push(words.join(' ')); say.apply(console, words); };
}
