// Which view is shown: the address' hash says it, so that it can be kept and shared.
import { $ } from './kit.js';
import { showFolders } from './folders.js';
import { wake } from './live.js';

function route() {
  const wanted = new URLSearchParams(location.hash.slice(1).replace(/^folders$/, 'folders='));
  const folders = wanted.has('folders') || wanted.has('open');
  $('live').hidden = folders;
  $('folders').hidden = !folders;
  $('to-live').toggleAttribute('aria-current', !folders);
  $('to-folders').toggleAttribute('aria-current', folders);
  for (const link of [$('to-live'), $('to-folders')]) if (link.hasAttribute('aria-current')) link.setAttribute('aria-current', 'page');
  if (folders) showFolders(wanted.get('open'), wanted.get('with')); else wake();
}
addEventListener('hashchange', route);
route();
