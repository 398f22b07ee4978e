// Entry point: creates the parts of the page and connects them.
import {Detail} from './detail.js';
import {Filters} from './filters.js';
import {Overview} from './overview.js';
import {Records, Rows, readIndex} from './records.js';
import {Table} from './table.js';
import {element} from './words.js';

const find = (id) => document.getElementById(id);

// Map colours of the dark theme; config/drawing.yaml has the light ones.
const DARK = {drivable: '#30353c', walkway: '#3d3627', lane: '#6a727c', connector: '#4a525b', agent: '#8795a5',
  ground: '#1b1f24', text: '#e6e9ed', mark: '#11141899', evasion: '#4cc38a'};
const LIGHT = {ground: '#ffffff', text: '#21262e', mark: '#ffffffcc', evasion: '#1d8a56'};

const css = (color) => `rgb(${color.map((share) => Math.round(255 * share)).join(' ')})`;
const lighter = (color) => color.map((share) => share + 0.35 * (1 - share));

/** Theme: light, dark, or the system's; sets the colours of the top view and the style. */
class Theme {
  constructor(colors, button) {
    this.given = colors;
    this.system = matchMedia('(prefers-color-scheme: dark)');
    this.isDark = this.system.matches;
    this.onChange = () => {};
    button.addEventListener('click', () => this.set(!this.isDark));
    this.system.addEventListener('change', () => this.set(this.system.matches));
    this.set(this.isDark);
  }

  set(isDark) {
    this.isDark = isDark;
    this.colors = isDark ? {...DARK} : {...LIGHT};
    for (const [name, color] of Object.entries(this.given)) {
      if (!(name in this.colors)) this.colors[name] = css(isDark ? lighter(color) : color);
    }
    document.documentElement.dataset.theme = isDark ? 'dark' : 'light';
    for (const [name, color] of Object.entries(this.colors)) {
      document.documentElement.style.setProperty('--' + name, color);
    }
    this.onChange();
  }
}

/** Returns the row name in the address; empty if there is none. */
function nameIn(hash) {
  try {
    return decodeURIComponent(hash.slice(1));
  } catch (error) {
    return '';
  }
}

/** Shows either the planner tests or the attacks; charts, filters and table contain one kind of rows. */
class Kinds {
  constructor(place, rows, table) {
    Object.assign(this, {rows, table});
    const all = Array.from({length: rows.length}, (_, row) => row);
    const tests = {title: 'Planner tests', list: all.filter((row) => rows.isTest(row))};
    const attacks = {title: 'Attacks', list: all.filter((row) => !rows.isTest(row))};
    this.kinds = [tests, attacks].filter(({list}) => list.length);
    for (const kind of this.kinds) {
      kind.button = element('button', {type: 'button', onclick: () => this.choose(kind)}, kind.title,
        element('small', {}, String(kind.list.length)));
    }
    if (this.kinds.length > 1) place.append(...this.kinds.map(({button}) => button));
    this.choose(this.kinds[0] || attacks);
  }

  choose(kind) {
    this.chosen = kind;
    this.kinds.forEach((each) => each.button.setAttribute('aria-pressed', String(each === kind)));
    this.table.chooseColumns(kind.list);
    this.filters = new Filters(find('filters'), this.rows, kind.list, (shown) => this.show(shown));
    this.overview = new Overview(find('overview'), this.rows, this.filters);
    this.filters.apply();
  }

  show(shown) {
    const {length} = this.chosen.list;
    this.table.setRows(shown);
    this.overview.draw(shown);
    find('count').textContent = shown.length === length ? `${length} rows` : `${shown.length} of ${length} rows`;
    find('clear').hidden = this.filters.isEmpty();
  }

  /** Shows the kind of rows that a row belongs to. */
  chooseFor(row) {
    const kind = this.kinds.find(({list}) => list.includes(row));
    if (kind !== this.chosen) this.choose(kind);
  }
}

function showIndex(index) {
  const rows = new Rows(index);
  const theme = new Theme(index.colors, find('theme'));
  const records = new Records(find('records').textContent);
  const table = new Table(find('table'), rows, (row) => open(row));
  const kinds = new Kinds(find('kinds'), rows, table);
  const detail = new Detail(find('detail'), rows, records, index.files, (name) => theme.colors[name], (step) => {
    const row = table.neighbour(step);
    if (row !== null) open(row);
  });
  const open = (row) => {
    history.replaceState(null, '', '#' + encodeURIComponent(rows.name(row)).replace(/%(3A|2F)/g, decodeURIComponent));
    return detail.open(row);
  };
  const openNamed = () => {
    const row = rows.named(nameIn(location.hash));
    if (row === null) return;
    kinds.chooseFor(row);
    table.chooseRow(row);
    open(row);
  };
  theme.onChange = () => detail.view.draw();
  find('detail').addEventListener('close', () => {
    history.replaceState(null, '', location.pathname + location.search);
    table.scroller.focus();
  });
  find('maps').append(...index.maps.map((data) => element('img', {
    src: 'data:image/png;base64,' + data, alt: 'Pass and fail of each planner over two fields of the request'})));
  find('clear').addEventListener('click', () => kinds.filters.clear());
  find('source').textContent = index.files.map(({path}) => path).join(', ')
    + (index.source ? `; ${[index.source, index.version].filter(Boolean).join(', ')}` : '');
  if (index.has_coverage) {
    find('source').append(' ', element('a', {href: 'coverage.html'}, 'Coverage of catalogues'));
  }
  window.addEventListener('hashchange', openNamed);
  openNamed();
}

function addHelp() {
  const help = find('help');
  const show = () => (help.open ? help.close() : help.showModal());
  find('keys').addEventListener('click', show);
  find('help-close').addEventListener('click', () => help.close());
  document.addEventListener('keydown', (event) => {
    if (event.key === '?' && event.target.type !== 'search') show();
    if (event.key === '/' && event.target.type !== 'search') {
      event.preventDefault();
      document.querySelector('input[type=search]').focus();
    }
  });
}

addHelp();
if (matchMedia('(max-width: 800px)').matches) find('filter-panel').open = false;
readIndex().then(showIndex).then(() => {
  document.body.dataset.state = 'ready';
  requestAnimationFrame(() => performance.mark('ready')); // for performance measurements
}).catch((error) => {
  find('count').textContent = 'This page cannot be shown: ' + error.message;
  document.body.dataset.state = 'failed';
});
