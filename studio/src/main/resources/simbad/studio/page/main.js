// Which view is shown: the address' hash says it, so that it can be kept and shared.
import { $, ask, fault } from './kit.js';
import { showFolders } from './folders.js';
import { wake } from './live.js';
import { leave, watch } from './watch.js';

function route() {
  const wanted = new URLSearchParams(location.hash.slice(1).replace(/^(folders|capture)$/, '$1='));
  const watched = wanted.has('capture'), folders = wanted.has('folders') || wanted.has('open');
  const shown = watched ? 'watch' : folders ? 'folders' : 'live';
  for (const name of ['live', 'folders', 'watch']) {
    $(name).hidden = name !== shown;
    if (name === shown) $('to-' + name).setAttribute('aria-current', 'page'); else $('to-' + name).removeAttribute('aria-current');
  }
  if (watched) $('to-watch').hidden = false;
  leave();
  fault('');
  if (watched) watch(wanted.get('capture')); else if (folders) showFolders(wanted.get('open'), wanted.get('with')); else wake();
}
addEventListener('hashchange', route);
route();
// Where the program makes a capture itself, its view can be found again.
ask('/views').then(views => { if (views.capture) $('to-watch').hidden = false; }).catch(() => {});
