// Puts the page together: the data, the tools, the keys, the large drawing.

const data = JSON.parse(document.getElementById('data').textContent);
wholeName = data.whole;
numbered = data.numbered;
joinPage = data.page;
const gradeNames = Object.keys(data.counts); // the worst first
const byId = (id) => document.getElementById(id);

const curves = data.curves.map((c) => ({ dimension: data.dimension, points: c.points, weights: c.weights, group: c.group, link: c.link }));
const groups = new Map(); // the curves of each contour, and the small map of it
for (const curve of curves) {
  if (!groups.has(curve.group)) groups.set(curve.group, { curves: [] });
  groups.get(curve.group).curves.push(curve);
}
const items = data.joins.map((j) => ({ ...j, left: curves[j.left], right: curves[j.right] }));
const model = data.model ? new Model(data.model) : null;
const roads = data.roads ? new Roads(data.roads) : null;
const overview = { zoom: 1, shift: [0, 0] }; // of the roads
const camera = { azimuth: -Math.PI / 3, elevation: 0.4, zoom: 1 };
let zoom = 1;

// The theme: that of the system, until the user asks for the other one.
const systemDark = window.matchMedia('(prefers-color-scheme: dark)');
let theme = null;
function applyTheme() {
  document.documentElement.classList.toggle('dark', theme === null ? systemDark.matches : theme === 'dark');
  readColours();
}
function switchTheme() {
  theme = document.documentElement.classList.contains('dark') ? 'light' : 'dark';
  applyTheme();
  list.redraw();
  showModel();
  large.draw();
}
applyTheme();

function drawItem(canvas, item, view) {
  if (model) {
    const edge = model.edges[item.edge];
    const near = model.edges.map((_, i) => i).filter((i) => model.edges[i].patches.some((p) => edge.patches.includes(p)));
    drawModel(canvas, model, { camera: { ...camera, zoom: 1 }, frame: model.frameAround(edge), patches: edge.patches, edges: near,
      chosen: item.edge, fill: true, zoom: view.zoom });
  } else if (roads) {
    const isLarge = canvas.clientHeight > 320;
    drawRoads(canvas, roads, { centre: item.xy, reach: 60, zoom: view.zoom, shift: view.shift, item, items: isLarge ? items : [],
      profiles: isLarge ? 90 : 0 });
  } else {
    const group = groups.get(item.left.group);
    drawJoin(canvas, item, { ...view, down: data.down, curves: group.curves,
      locator: group.curves.length > 2 && canvas.clientWidth > 260 ? group : null });
  }
}

let redrawing = false;
function showModel() {
  if (!(model || roads) || redrawing) return;
  redrawing = true;
  requestAnimationFrame(() => {
    redrawing = false;
    if (roads) {
      drawRoads(byId('model').querySelector('canvas'), roads, { ...overview, item: list.item, items: items.filter((i) => !['G1', 'G2'].includes(i.grade)),
        fill: byId('fill').checked });
      return;
    }
    drawModel(byId('model').querySelector('canvas'), model, { camera, frame: model.frame, patches: model.all,
      chosen: list.item ? list.item.edge : -1, fill: byId('fill').checked });
  });
}

// The large drawing of one join, which is moved and zoomed.
const large = {
  box: byId('large'),
  item: null, zoom: 1, shift: [0, 0],
  get canvas() { return this.box.querySelector('canvas'); },
  open(item) {
    if (!item) return;
    this.item = item;
    this.zoom = zoom;
    this.shift = [0, 0];
    this.box.querySelector('h2').textContent = item.place;
    this.box.querySelector('.below').replaceChildren(textOf(item));
    if (!this.box.open) this.box.showModal();
    this.canvas.focus();
    this.draw();
  },
  draw() {
    if (this.box.open)
      drawItem(this.canvas, this.item, { zoom: this.zoom, shift: this.shift, comb: Math.pow(2, Number(byId('comb').value)) });
  },
  by(factor) {
    const next = Math.max(0.25, Math.min(1e6, this.zoom * factor));
    if (this.zoom > 1 && next > 1) this.shift = this.shift.map((x) => x * next / this.zoom); // the join keeps its place
    this.zoom = next;
    this.draw();
  },
};

const list = new JoinList(items, {
  draw: (canvas, item) => drawItem(canvas, item, { zoom }),
  chosen: (item) => {
    byId('shown').textContent = list.shown.length === items.length ? `${count(items.length)} shown`
      : `${count(list.shown.length)} of ${count(items.length)} shown`;
    byId('empty').hidden = list.shown.length !== 0;
    showModel();
    if (large.box.open && item && item !== large.item) large.open(item);
  },
  opened: (item) => large.open(item),
});

function count(n) { return String(n).replace(/\B(?=(\d{3})+$)/g, '\u202f'); }

function setZoom(z) {
  zoom = Math.max(0.25, Math.min(1e4, z));
  list.redraw();
}

// The head of the page.
document.title = data.title;
byId('title').textContent = data.title;
byId('summary').textContent = data.summary;
byId('notes').append(...data.notes.map((n) => element('li', '', n)));
byId('notes').hidden = data.notes.length === 0;
byId('empty').textContent = items.length === 0 ? data.empty : 'No join passes the filter.';
for (const grade of gradeNames) {
  if (!data.counts[grade]) continue;
  const here = items.filter((i) => i.grade === grade).length; // the list holds the worst ones only
  const button = element('button', 'grade ' + grade, grade, element('b', '', count(here)));
  if (here < data.counts[grade]) {
    button.append(element('small', '', `of ${count(data.counts[grade])}`));
    button.title = `${count(data.counts[grade] - here)} of them are not in the list`;
  }
  if (here === 0) button.disabled = true;
  button.type = 'button';
  button.setAttribute('aria-pressed', 'true');
  button.addEventListener('click', () => {
    const off = !list.hidden.delete(grade);
    if (off) list.hidden.add(grade);
    button.setAttribute('aria-pressed', String(!off));
    list.update();
  });
  byId('grades').append(button);
}
byId('filter').addEventListener('input', (e) => {
  list.words = e.target.value.toLowerCase().split(/\s+/).filter((w) => w !== '');
  list.update();
});
byId('sort').addEventListener('change', (e) => { list.order = e.target.value; list.update(false); });
byId('theme').addEventListener('click', switchTheme);
byId('help').addEventListener('click', () => byId('keys').showModal());
systemDark.addEventListener('change', () => { applyTheme(); list.redraw(); showModel(); });

if (model) {
  const section = byId('model'), canvas = section.querySelector('canvas');
  section.hidden = false;
  document.querySelector('main').classList.add('with-model');
  const grades = new Set(model.edges.map((e) => e.grade));
  byId('legend').append(...[...gradeNames, 'boundary', 'collapsed'].filter((g) => grades.has(g)).map((g) => element('span', 'grade ' + g, g)));
  turnWith(canvas, camera, () => { showModel(); list.redraw(); });
  byId('fill').addEventListener('change', showModel);
  new ResizeObserver(showModel).observe(canvas);
}

if (roads) {
  const section = byId('model'), canvas = section.querySelector('canvas');
  section.hidden = false;
  section.setAttribute('aria-label', 'The roads');
  canvas.setAttribute('aria-label', 'The roads in plan with their lanes; the wheel zooms, the mouse moves them');
  byId('fill').parentElement.lastChild.textContent = ' lanes';
  document.querySelector('main').classList.add('with-model');
  canvas.addEventListener('wheel', (e) => {
    e.preventDefault();
    const next = Math.max(0.5, Math.min(1e5, overview.zoom * Math.exp(-0.0015 * e.deltaY))), factor = next / overview.zoom;
    const from = [e.offsetX - canvas.clientWidth / 2, e.offsetY - canvas.clientHeight / 2]; // which keeps its place
    overview.shift = overview.shift.map((x, i) => from[i] + factor * (x - from[i]));
    overview.zoom = next;
    showModel();
  }, { passive: false });
  canvas.addEventListener('pointerdown', (e) => canvas.setPointerCapture(e.pointerId));
  canvas.addEventListener('pointermove', (e) => {
    if (!canvas.hasPointerCapture(e.pointerId)) return;
    overview.shift = [overview.shift[0] + e.movementX, overview.shift[1] + e.movementY];
    showModel();
  });
  byId('fill').addEventListener('change', showModel);
  new ResizeObserver(showModel).observe(canvas);
}

// The large drawing: buttons, wheel and mouse.
byId('comb').addEventListener('input', () => large.draw());
for (const button of large.box.querySelectorAll('[data-step]'))
  button.addEventListener('click', () => list.step(Number(button.dataset.step)));
large.box.querySelector('[data-close]').addEventListener('click', () => large.box.close());
large.box.addEventListener('close', () => list.box.focus());
large.canvas.addEventListener('wheel', (e) => { e.preventDefault(); large.by(Math.exp(-0.0015 * e.deltaY)); }, { passive: false });
if (model) turnWith(large.canvas, camera, () => { showModel(); large.draw(); list.redraw(); });
else {
  large.canvas.addEventListener('pointerdown', (e) => large.canvas.setPointerCapture(e.pointerId));
  large.canvas.addEventListener('pointermove', (e) => {
    if (!large.canvas.hasPointerCapture(e.pointerId)) return;
    large.shift = [large.shift[0] + e.movementX, large.shift[1] + e.movementY];
    large.draw();
  });
}
new ResizeObserver(() => large.draw()).observe(large.canvas);

// The keys.
const orders = [...byId('sort').options].map((o) => o.value);
const keys = {
  j: () => list.step(1), k: () => list.step(-1), ArrowDown: () => list.step(1), ArrowUp: () => list.step(-1),
  PageDown: () => list.page(1), PageUp: () => list.page(-1), Home: () => list.choose(0), End: () => list.choose(list.shown.length - 1),
  Enter: () => large.open(list.item),
  '+': () => setZoom(zoom * 1.25), '=': () => setZoom(zoom * 1.25), '-': () => setZoom(zoom / 1.25), 0: () => setZoom(1),
  '/': () => byId('filter').focus(),
  s: () => {
    byId('sort').value = list.order = orders[(orders.indexOf(list.order) + 1) % orders.length];
    list.update(false);
  },
  t: switchTheme,
  '?': () => byId('keys').showModal(),
};
const largeKeys = {
  ...keys, Enter: () => large.box.close(), '+': () => large.by(1.25), '=': () => large.by(1.25), '-': () => large.by(0.8),
  0: () => { large.zoom = 1; large.shift = [0, 0]; large.draw(); },
};
delete largeKeys['/'];
delete largeKeys['?'];
document.addEventListener('keydown', (e) => {
  if (e.ctrlKey || e.metaKey || e.altKey || byId('keys').open) return;
  const field = e.target.closest('input, select');
  if (field && e.key === 'Escape' && !large.box.open) list.box.focus();
  if (field) return;
  if (e.target.closest('button, a') && (e.key === 'Enter' || e.key === ' ')) return;
  const action = (large.box.open ? largeKeys : keys)[e.key];
  if (!action) return;
  e.preventDefault();
  action();
});

list.update();
list.box.focus({ preventScroll: true });
