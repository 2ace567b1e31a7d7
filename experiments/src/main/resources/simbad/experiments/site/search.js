// Looks for all words of what is typed in titles and texts; works from a folder, without a server.
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

box.addEventListener('input', show);
