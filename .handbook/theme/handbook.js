// The menu of small screens, and the search. The index is a script (search-index.js), since a page that was opened from
// a disk may not fetch other files.
'use strict';

const root = document.currentScript.dataset.root;
const menu = document.querySelector('.menu');
if (menu) {
    menu.addEventListener('click', () => {
        const open = document.querySelector('.pages').classList.toggle('open');
        menu.setAttribute('aria-expanded', String(open));
    });
}

const input = document.querySelector('.search input');
const list = document.querySelector('.search ol');

// How well a section matches all the words; 0 if one is missing.
function score(section, words) {
    let sum = 0;
    for (const word of words) {
        const title = section.lowTitle.indexOf(word);
        const text = section.lowText.indexOf(word);
        if (title < 0 && text < 0) return 0;
        if (title >= 0) sum += section.lowTitle === word ? 40 : title === 0 ? 20 : 10;
        if (text >= 0) sum += 1;
    }
    return sum;
}

function show() {
    list.replaceChildren();
    const words = input.value.toLowerCase().split(/\s+/).filter(Boolean);
    if (!words.length) return;
    for (const section of searchIndex) {
        section.lowTitle ??= section.title.toLowerCase();
        section.lowText ??= (section.page + ' ' + section.text).toLowerCase();
    }
    const found = searchIndex.map((section, at) => ({section, at, score: score(section, words)}))
        .filter((hit) => hit.score > 0).sort((a, b) => b.score - a.score || a.at - b.at).slice(0, 30);
    for (const {section} of found) {
        const link = document.createElement('a');
        link.href = root + section.url;
        link.append(section.title);
        const where = document.createElement('small');
        const at = Math.max(0, section.lowText.indexOf(words[0]) - section.page.length - 40);
        where.textContent = section.page + ' · ' + section.text.slice(at, at + 120);
        link.append(where);
        const item = document.createElement('li');
        item.append(link);
        list.append(item);
    }
    if (!found.length) list.append(Object.assign(document.createElement('li'), {textContent: 'Nothing found'}));
}
input.addEventListener('input', show);
input.addEventListener('focus', show);
document.addEventListener('keydown', (event) => {
    if (event.key === 'Escape') { list.replaceChildren(); input.blur(); }
    if (event.key === '/' && document.activeElement !== input) { event.preventDefault(); input.focus(); }
});
document.addEventListener('click', (event) => {
    if (!event.target.closest('.search')) list.replaceChildren();
});
