// Looks for all words of what is typed in titles and texts; works from a folder, without a server.
// Keys: / goes to the search, arrows go through what was found, Enter opens the first, Escape ends it.
const box = document.getElementById('search');
const found = document.getElementById('found');
const MOST = 12;

function score(page, words) {
  const title = page.t.toLowerCase();
  const text = page.w.toLowerCase();
  let sum = 0;
  for (const word of words) {
    const times = text.split(word).length - 1;
    if (times === 0 && !title.includes(word)) return 0;
    sum += Math.min(times, 20) + (title.includes(word) ? 100 : 0);
  }
  return sum;
}

function excerpt(page, word) {
  const at = Math.max(0, page.w.toLowerCase().indexOf(word));
  return page.w.slice(Math.max(0, at - 40), at + 80);
}

function show() {
  const words = box.value.toLowerCase().split(/\s+/).filter(word => word !== '');
  const hits = words.length === 0 ? [] : PAGES
    .map(page => [score(page, words), page])
    .filter(hit => hit[0] > 0)
    .sort((one, other) => other[0] - one[0])
    .slice(0, MOST);
  found.replaceChildren(...hits.map(([, page]) => {
    const item = document.createElement('li');
    const link = document.createElement('a');
    link.href = box.dataset.root + page.f;
    link.textContent = page.t;
    const around = document.createElement('small');
    around.textContent = excerpt(page, words[0]);
    item.append(link, around);
    return item;
  }));
  if (words.length > 0 && hits.length === 0) {
    const nothing = document.createElement('li');
    nothing.textContent = 'No page has all of these words.';
    found.replaceChildren(nothing);
  }
}

/** Goes from the box or a hit to the next one or the one before. */
function move(step) {
  const places = [box, ...found.querySelectorAll('a')];
  const at = places.indexOf(document.activeElement);
  places[Math.min(Math.max(at + step, 0), places.length - 1)].focus();
}

function key(event) {
  const inside = event.target === box || found.contains(event.target);
  const first = found.querySelector('a');
  if (event.key === '/' && !inside && !event.ctrlKey && !event.metaKey && !event.altKey) box.focus();
  else if (inside && event.key === 'ArrowDown') move(1);
  else if (inside && event.key === 'ArrowUp') move(-1);
  else if (event.key === 'Enter' && event.target === box && first) first.click();
  else if (inside && event.key === 'Escape') { box.value = ''; show(); box.focus(); }
  else return;
  event.preventDefault();
}

/** What is wider than the page can be scrolled with the keyboard as well. */
function reachable() {
  for (const wide of document.querySelectorAll('pre, table')) {
    if (wide.scrollWidth > wide.clientWidth) wide.tabIndex = 0; else wide.removeAttribute('tabindex');
  }
}

box.addEventListener('input', show);
document.addEventListener('keydown', key);
addEventListener('resize', reachable);
reachable();
// On a phone the list of pages would stand before every page.
if (matchMedia('(max-width: 50rem)').matches) document.getElementById('pages').open = false;
