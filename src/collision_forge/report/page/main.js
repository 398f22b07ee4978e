// Puts the page together.
import {Detail} from './detail.js';
import {Filters} from './filters.js';
import {Overview} from './overview.js';
import {Columns, Records, readIndex} from './records.js';
import {Table} from './table.js';

const find = (id) => document.getElementById(id);

// Colours of the ground in the dark; the light ones are those of config/drawing.yaml.
const DARK = {drivable: '#30353c', walkway: '#3d3627', lane: '#6a727c', connector: '#4a525b', agent: '#8795a5',
  ground: '#1b1f24', text: '#e6e9ed', mark: '#11141899', escape: '#4cc38a'};
const LIGHT = {ground: '#ffffff', text: '#21262e', mark: '#ffffffcc', escape: '#1d8a56'};

const css = (color) => `rgb(${color.map((share) => Math.round(255 * share)).join(' ')})`;
const lighter = (color) => color.map((share) => share + 0.35 * (1 - share));

/** Light, dark, or as the system has it; the colours of top view and style follow. */
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

/** Columns with a name for every row. */
class Rows extends Columns {
  constructor(index) {
    super(index);
    this.stems = index.files.map(({path}) => path.split('/').pop().replace(/\.[a-z]+$/, ''));
  }

  name(row) {
    return this.stems[this.number('file', row)] + ':' + this.number('line', row);
  }
}

function showIndex(index) {
  const rows = new Rows(index);
  const theme = new Theme(index.colors, find('theme'));
  const records = new Records(find('records').textContent);
  let overview = null;
  const table = new Table(find('table'), rows, (row) => open(row));
  const filters = new Filters(find('filters'), rows, (shown) => {
    table.setRows(shown);
    overview.draw(shown);
    find('count').textContent = shown.length === rows.length ? `${rows.length} rows`
      : `${shown.length} of ${rows.length} rows`;
    find('clear').hidden = filters.isEmpty();
  });
  overview = new Overview(find('overview'), rows, filters);
  const detail = new Detail(find('detail'), rows, records, index.files, (name) => theme.colors[name], (step) => {
    const row = table.neighbour(step);
    if (row !== null) open(row);
  });
  const open = (row) => {
    history.replaceState(null, '', '#' + row);
    return detail.open(row);
  };
  theme.onChange = () => detail.view.draw();
  find('detail').addEventListener('close', () => {
    history.replaceState(null, '', location.pathname + location.search);
    table.scroller.focus();
  });
  find('clear').addEventListener('click', () => filters.clear());
  find('source').textContent = index.files.map(({path}) => path).join(', ')
    + (index.source ? `; ${[index.source, index.version].filter(Boolean).join(', ')}` : '');
  filters.apply();
  if (/^#\d+$/.test(location.hash) && Number(location.hash.slice(1)) < rows.length) {
    open(Number(location.hash.slice(1)));
  }
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
  requestAnimationFrame(() => performance.mark('ready')); // for who measures
}).catch((error) => {
  find('count').textContent = 'This page cannot be shown: ' + error.message;
  document.body.dataset.state = 'failed';
});
