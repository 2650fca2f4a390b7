// The list of joins: filtered, sorted, and only those rows are in the page that can be seen.

let wholeName = 'whole', numbered = true, joinPage = '';

// An element with a class and children; texts become text nodes, so that nothing from a file is
// ever read as markup.
function element(name, className, ...children) {
  const node = document.createElement(name);
  if (className) node.className = className;
  node.append(...children);
  return node;
}

// Bounds [lower, upper] are texts, rounded outwards where they were computed; equal ones are the
// number itself.
function boundTexts(bounds, unit) {
  if (!bounds) return ['not known', ''];
  const [lower, upper] = bounds;
  return lower === upper ? [upper + unit, ''] : ['\u2264 ' + upper + unit, '\u2265 ' + lower + unit];
}
const upperBound = (bounds) => (bounds ? Number(bounds[1]) : -1);

function numbersOf(item) {
  const list = element('dl', 'numbers');
  const add = (name, [value, more]) => {
    const dd = element('dd', '', value);
    if (more) dd.append(element('small', '', more));
    dd.title = value + (more ? ', ' + more : '');
    list.append(element('dt', '', name), dd);
  };
  if (item.angle || !item.gap) add('Angle', boundTexts(item.angle, '\u00b0'));
  if (item.jump) add('Curvature jump', boundTexts(item.jump, ' %'));
  if (item.gap) add('Gap', boundTexts(item.gap, roads ? ' m' : ''));
  if (item.offset) add(item.grade === 'kink' ? 'Handle is off by' : 'Off by', boundTexts(item.offset, wholeName === 'em' ? ' units' : ''));
  if (item.at) add('At', ['(' + item.at.join(', ') + ')', item.parameter ? 'parameter ' + item.parameter : '']);
  if (item.severity) add('Severity', ['about ' + item.severity + ' \u2030', 'of the ' + wholeName + ', angle \u00d7 handle']);
  return list;
}

// The join in the page of joins, its control points as they are.
function linkOf(item) {
  const sides = ['left', 'right'].map((side) => [side, item[side] && item[side].link]);
  if (!joinPage || !sides.every(([, link]) => link)) return [];
  const query = sides.flatMap(([side, link]) => [`${side}=${link.points}`, ...['weights', 'domain'].filter((k) => link[k]).map((k) => `${side}_${k}=${link[k]}`)]);
  const a = element('a', 'link', 'Drag its points');
  a.setAttribute('href', `${joinPage}#join?${query.join('&')}`);
  return [a];
}

function textOf(item) {
  const top = element('div', 'topline', element('span', 'grade ' + item.grade, item.grade),
    ...(item.marks || []).map((m) => element('span', 'mark', m)));
  if (numbered) top.append(element('span', 'number', '#' + item.number));
  top.append(...linkOf(item));
  const place = element('div', 'place', item.place);
  place.title = item.place;
  return element('div', 'text', top, place, element('div', 'verdict', item.verdict), numbersOf(item));
}

class JoinList {
  // draw(canvas, item) draws a row; chosen(item) is called when another row is chosen; opened(item)
  // for Enter and clicks.
  constructor(items, { draw, chosen, opened }) {
    this.items = items;
    this.draw = draw;
    this.chosen = chosen;
    this.opened = opened;
    this.box = document.getElementById('list');
    this.body = document.getElementById('rows');
    this.hidden = new Set();
    this.words = [];
    this.order = 'worst';
    this.shown = [];
    this.position = 0;
    this.rows = new Map();
    this.pitch = 300;
    this.texts = items.map((i) => [i.grade, i.place, i.verdict, ...(i.marks || []), ...(numbered ? ['#' + i.number] : [])].join('\n').toLowerCase());
    this.box.addEventListener('scroll', () => this.render(), { passive: true });
    new ResizeObserver(() => this.measure()).observe(this.box);
  }

  get item() { return this.items[this.shown[this.position]]; }

  // Applies filter and order. The chosen join stays chosen where it is still shown and `keep` says
  // so, otherwise it is the first.
  update(keep = true) {
    const before = keep ? this.shown[this.position] : undefined;
    this.shown = this.items.map((_, i) => i).filter((i) =>
      !this.hidden.has(this.items[i].grade) && this.words.every((w) => this.texts[i].includes(w)));
    const key = {
      order: (i) => this.items[i].number,
      angle: (i) => -upperBound(this.items[i].angle),
      jump: (i) => -upperBound(this.items[i].jump),
      gap: (i) => -upperBound(this.items[i].gap),
    }[this.order];
    if (key) { // sorting is stable: equal ones stay worst first
      const keys = new Map(this.shown.map((i) => [i, key(i)]));
      this.shown.sort((i, j) => keys.get(i) - keys.get(j));
    }
    this.clear();
    this.position = Math.max(0, this.shown.indexOf(before));
    this.box.scrollTop = before === undefined ? 0 : this.position * this.pitch;
    this.measure();
    this.chosen(this.item);
  }

  clear() {
    for (const row of this.rows.values()) row.remove();
    this.rows.clear();
  }

  // The height of a row depends on the width of the window.
  measure() {
    if (this.shown.length === 0) this.body.style.height = '0';
    this.render();
    const row = this.rows.values().next().value;
    if (row && row.offsetHeight + 12 !== this.pitch) {
      const top = this.box.scrollTop / this.pitch;
      this.pitch = row.offsetHeight + 12;
      this.clear();
      this.body.style.height = this.pitch * this.shown.length + 12 + 'px';
      this.box.scrollTop = top * this.pitch;
      this.render();
    } else this.redraw();
  }

  render() {
    this.body.style.height = this.pitch * this.shown.length + 12 + 'px';
    const first = Math.max(0, Math.floor(this.box.scrollTop / this.pitch) - 1);
    const last = Math.min(this.shown.length, Math.ceil((this.box.scrollTop + this.box.clientHeight) / this.pitch) + 1);
    for (const [position, row] of this.rows)
      if (position < first || position >= last) { row.remove(); this.rows.delete(position); }
    for (let position = first; position < last; ++position)
      if (!this.rows.has(position)) this.add(position);
    this.mark();
  }

  add(position) {
    const item = this.items[this.shown[position]], canvas = element('canvas');
    canvas.setAttribute('role', 'img');
    canvas.setAttribute('aria-label', 'Drawing of the join');
    const row = element('div', 'join ' + item.grade, canvas, textOf(item));
    row.id = 'join-' + this.shown[position];
    row.setAttribute('role', 'option');
    row.setAttribute('aria-posinset', position + 1);
    row.setAttribute('aria-setsize', this.shown.length);
    row.style.top = 12 + position * this.pitch + 'px';
    row.addEventListener('click', () => this.choose(position, false));
    canvas.addEventListener('click', () => { this.choose(position, false); this.opened(item); });
    this.rows.set(position, row);
    this.body.append(row);
    this.draw(canvas, item);
  }

  redraw() {
    for (const [position, row] of this.rows) this.draw(row.firstChild, this.items[this.shown[position]]);
  }

  mark() {
    for (const [position, row] of this.rows) row.setAttribute('aria-selected', position === this.position);
    const row = this.rows.get(this.position);
    if (row) this.box.setAttribute('aria-activedescendant', row.id);
    else this.box.removeAttribute('aria-activedescendant');
  }

  // Chooses a row, and scrolls so that it is seen as a whole.
  choose(position, scroll = true) {
    if (this.shown.length === 0) return;
    this.position = Math.max(0, Math.min(this.shown.length - 1, position));
    const top = this.position * this.pitch, bottom = top + this.pitch + 12;
    if (scroll && top < this.box.scrollTop) this.box.scrollTop = top;
    if (scroll && bottom > this.box.scrollTop + this.box.clientHeight) this.box.scrollTop = bottom - this.box.clientHeight;
    this.render();
    this.chosen(this.item);
  }
  step(rows) { this.choose(this.position + rows); }
  page(pages) { this.step(pages * Math.max(1, Math.floor(this.box.clientHeight / this.pitch))); }
}
