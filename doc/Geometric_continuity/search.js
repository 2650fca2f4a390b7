// The search of the manual: a field beside the title, which finds sections that have all the words,
// anywhere in their text. It is read from search_index.js, so that it works without a server; that
// is loaded when the field is used first. An address that ends in ?search=WORDS opens with the
// answer.
(function () {
  'use strict';
  let sections; // [address, title of the page, title of the section, text] each
  const most = 40;

  const escaped = (text) => text.replace(/[.*+?^${}()|[\]\\]/g, '\\$&');
  // A word stands at the start of one of the text; in capitals, as STEP, it is found in capitals.
  const atStart = (word) => new RegExp((/^[A-Za-z0-9]/.test(word) ? '(?<![A-Za-z0-9])' : '') + escaped(word), /^[A-Z]{2,}$/.test(word) ? 'g' : 'gi');

  // Chapters come before the reference, which comes before examples; titles count more than text.
  function rank([address, page, title, text], words) {
    let sum = /^(class|struct|group|namespace)/.test(address) ? 0 : /-example\.html/.test(address) ? -20 : 20;
    for (const word of words) {
      const found = (where) => (where.match(word) || []).length;
      const inTitle = found(title), inPage = found(page), inText = found(text);
      if (inTitle + inPage + inText === 0) return -Infinity;
      sum += 40 * Math.min(inTitle, 1) + 20 * Math.min(inPage, 1) + Math.min(inText, 10);
    }
    return sum;
  }

  function append(parent, tag, text) {
    const element = document.createElement(tag);
    element.textContent = text;
    return parent.appendChild(element);
  }

  // A part of the text around the first of the words, which are bold in it.
  function excerpt(parent, text, words) {
    const places = words.map((word) => text.search(word)).filter((place) => place >= 0);
    const first = places.length === 0 ? 0 : text.lastIndexOf(' ', Math.max(0, Math.min(...places) - 60)) + 1;
    const part = (first > 0 ? '… ' : '') + text.substr(first, 200) + (first + 200 < text.length ? ' …' : '');
    let at = 0;
    const all = words.flatMap((word) => [...part.matchAll(word)]).sort((a, b) => a.index - b.index);
    for (const match of all.filter((found, i) => i === 0 || all[i - 1].index + all[i - 1][0].length <= found.index)) {
      parent.append(part.slice(at, match.index));
      append(parent, 'b', match[0]);
      at = match.index + match[0].length;
    }
    parent.append(part.slice(at));
  }

  function show(field, list) {
    list.textContent = '';
    const words = field.value.trim().split(/\s+/).filter((word) => word !== '').map(atStart);
    list.hidden = words.length === 0;
    if (list.hidden || !sections) return;
    const found = sections.map((section) => [rank(section, words), section]).filter(([sum]) => sum > -Infinity);
    found.sort((a, b) => b[0] - a[0]);
    for (const [, [address, page, title, text]] of found.slice(0, most)) {
      const link = append(append(list, 'li', ''), 'a', title === '' || title === page ? page : page + ': ' + title);
      link.href = address;
      excerpt(append(link.parentNode, 'div', ''), text, words);
    }
    append(list, 'li', found.length === 0 ? 'No section has all of these words.' : found.length > most ? 'and ' + (found.length - most) + ' more' : '');
  }

  function load(done) {
    if (sections) return done();
    window.manualIndex = (all) => { sections = all; };
    const script = document.createElement('script');
    script.src = 'search_index.js';
    script.onload = done;
    document.head.append(script);
  }

  document.addEventListener('DOMContentLoaded', () => {
    const box = document.createElement('div');
    box.id = 'search-manual';
    const field = append(box, 'input', ''), list = append(box, 'ol', '');
    field.type = 'search';
    field.placeholder = field.ariaLabel = 'Search the manual';
    field.addEventListener('input', () => load(() => show(field, list)));
    list.hidden = true;
    field.addEventListener('focus', () => { list.hidden = list.childElementCount === 0; });
    document.addEventListener('keydown', (event) => {
      if (event.key === 'Escape') list.hidden = true;
    });
    // A click on an answer closes the list, too: the address may be in the same page.
    document.addEventListener('click', (event) => {
      if (event.target !== field) list.hidden = true;
    });
    document.getElementById('titlearea').prepend(box);
    field.value = new URLSearchParams(location.search).get('search') || '';
    if (field.value !== '') load(() => show(field, list));
  });
})();
