// The table: only visible rows are elements, so that it scrolls with any number of rows.
import {amount, degrees, element, title} from './words.js';

const ROW_HEIGHT = 34; // pixels, as in the style

const hasTests = (rows, list) => list.some((row) => rows.isTest(row));
const hasAttacks = (rows, list) => !hasTests(rows, list);

const percentOf = (share) => share && 100 * share;

// Widths in rem. `isShown(rows, list)` returns whether the table of the rows in `list` has the column.
const COLUMNS = [
  {key: 'name', title: 'Line', wide: true, width: 7.4},
  {key: 'scene', title: 'Scene', wide: true, width: 7.2},
  {key: 'now_in_recording', title: 't0', unit: 's', digits: 2, wide: true, width: 4.8},
  {key: 'type', title: 'Type', show: title, width: 10},
  {key: 'tta', title: 'TTA', unit: 's', digits: 1, width: 4.2},
  {key: 'planner', title: 'Planner', wide: true, width: 12, isShown: hasTests},
  {key: 'planner', title: 'Method', wide: true, width: 10.8,
    isShown: (rows, list) => !hasTests(rows, list) && list.some((row) => rows.text('planner', row))},
  {key: 'outcome', title: 'Outcome', show: title, width: 12},
  {key: 'manoeuvre', title: 'Manoeuvre', show: title, wide: true, width: 11},
  {key: 'class', title: 'Attacker', show: title, wide: true, width: 6.6, isShown: hasAttacks},
  {key: 'contact_t', title: 'Contact', unit: 's', digits: 2, wide: true, width: 6.2},
  {key: 'impact_speed', title: 'Impact', unit: 'm/s', digits: 1, width: 6.8},
  {key: 'delta_v', title: 'Delta-v', unit: 'm/s', digits: 1, wide: true, width: 6.8},
  {key: 'mais3', title: 'MAIS 3+', unit: '%', digits: 1, width: 7, of: percentOf},
  {key: 'heading', title: 'Heading', unit: '°', digits: 0, wide: true, width: 6.4, of: degrees},
  {key: 'avoidable', title: 'Avoidable', show: title, wide: true, width: 6, isShown: hasTests},
  {key: 'avoided_by', title: 'Avoided by', wide: true, width: 12},
  {key: 'confidence', title: 'Confidence', unit: '%', digits: 0, wide: true, width: 8.2,
    of: percentOf, isShown: hasAttacks},
  {key: 'message', title: 'Reason', wide: true},
];
const LAST_WIDTH = 4.5; // rem, at least

const WITHOUT_DRIVE = ['declined', 'untested'];
const ALWAYS = () => true;

export class Table {
  /** `rows` has text(), number() and name() of a row; `onOpen` is called with the row. */
  constructor(place, rows, onOpen) {
    this.rows = rows;
    this.onOpen = onOpen;
    this.order = [];
    this.chosen = 0; // index in the order
    this.sorting = {key: 'name', falling: false};
    this.body = element('div', {className: 'rows'});
    this.scroller = element('div', {className: 'scroller', tabIndex: 0, role: 'grid', 'aria-label': 'Attacks'});
    this.headings = element('div', {className: 'row headings', role: 'row'});
    this.scroller.append(this.headings, this.body);
    place.append(this.scroller);
    this.scroller.addEventListener('scroll', () => this.drawIfMoved(), {passive: true});
    this.scroller.addEventListener('keydown', (event) => this.onKey(event));
    new ResizeObserver(() => this.drawIfMoved()).observe(this.scroller);
  }

  /** Selects the columns that the rows of this list need. */
  chooseColumns(list) {
    this.columns = COLUMNS.filter(({isShown}) => (isShown || ALWAYS)(this.rows, list));
    this.sorting = {key: 'name', falling: false};
    this.chosen = 0;
    this.scroller.scrollTop = 0;
    this.headings.replaceChildren(...this.columns.map((column) => element('button', {
      className: this.classOf(column), role: 'columnheader', type: 'button',
      onclick: () => this.sortBy(column.key),
    }, column.title, column.unit ? element('small', {}, ' [' + column.unit + ']') : null)));
    const widths = this.columns.map(({width}) => (width ? `${width}rem` : `minmax(${LAST_WIDTH}rem, 1fr)`));
    const sum = this.columns.reduce((total, {width}) => total + (width || LAST_WIDTH), 1);
    this.scroller.style.setProperty('--columns', widths.join(' '));
    this.scroller.style.setProperty('--columns-width', `${sum}rem`);
  }

  classOf(column) {
    return 'cell of-' + column.key + (column.wide ? ' wide' : '') + (column.digits === undefined ? '' : ' number');
  }

  valueOf(column, row) {
    if (column.key === 'name') return this.rows.name(row);
    if (column.digits === undefined) return this.rows.text(column.key, row);
    const value = this.rows.number(column.key, row);
    return column.of ? column.of(value) : value;
  }

  sortBy(key) {
    this.sorting = {key, falling: this.sorting.key === key && !this.sorting.falling};
    this.setRows(this.order);
  }

  /** Shows these rows, sorted. */
  setRows(list) {
    const column = this.columns.find(({key}) => key === this.sorting.key);
    const sign = this.sorting.falling ? -1 : 1;
    const order = Int32Array.from(list).sort();
    if (column.key !== 'name') {
      const values = new Map();
      for (const row of order) values.set(row, this.valueOf(column, row));
      const compare = (a, b) => {
        const [first, second] = [values.get(a), values.get(b)];
        if (first === second) return a - b;
        if (first === null || first === '') return 1; // missing values come last
        if (second === null || second === '') return -1;
        return sign * (first < second ? -1 : 1);
      };
      order.sort(compare);
    } else if (sign < 0) {
      order.reverse();
    }
    this.order = order;
    this.chosen = Math.min(this.chosen, Math.max(order.length - 1, 0));
    [...this.headings.children].forEach((cell, i) => cell.setAttribute('aria-sort',
      this.columns[i].key !== this.sorting.key ? 'none' : this.sorting.falling ? 'descending' : 'ascending'));
    this.scroller.setAttribute('aria-rowcount', order.length + 1);
    this.body.style.height = order.length * ROW_HEIGHT + 'px';
    this.draw();
  }

  /** Returns the first place in view and the one after the last. */
  placesInView() {
    const first = Math.max(0, Math.floor(this.scroller.scrollTop / ROW_HEIGHT) - 4);
    const count = Math.ceil(this.scroller.clientHeight / ROW_HEIGHT) + 8;
    return [first, Math.min(this.order.length, first + count)];
  }

  /** Keeps the rows, which a click may be under way to, unless others come into view. */
  drawIfMoved() {
    if (this.placesInView().join() !== this.drawn) this.draw();
  }

  draw() {
    const [first, last] = this.placesInView();
    this.drawn = [first, last].join();
    const shown = [];
    for (let place = first; place < last; ++place) shown.push(this.makeRow(place));
    this.body.replaceChildren(...shown);
    this.scroller.setAttribute('aria-activedescendant', this.order.length ? 'row-' + this.chosen : '');
  }

  makeRow(place) {
    const row = this.order[place];
    const made = element('div', {
      id: 'row-' + place, className: 'row', role: 'row', 'aria-rowindex': place + 2,
      'aria-selected': String(place === this.chosen),
      onclick: () => {
        this.choose(place);
        this.onOpen(row);
      },
    }, ...this.cellsOf(row));
    made.style.top = place * ROW_HEIGHT + 'px';
    return made;
  }

  /** Shows the reason in place of the contact columns if there is no drive. */
  cellsOf(row) {
    if (!WITHOUT_DRIVE.includes(this.rows.text('outcome', row))) {
      return this.columns.map((column) => this.makeCell(column, row));
    }
    const count = this.columns.findIndex(({key}) => key === 'outcome') + 1;
    const reason = this.makeCell(this.columns[this.columns.length - 1], row);
    reason.style.gridColumn = `${count + 1} / -1`;
    reason.setAttribute('aria-colspan', this.columns.length - count);
    return [...this.columns.slice(0, count).map((column) => this.makeCell(column, row)), reason];
  }

  makeCell(column, row) {
    const value = this.valueOf(column, row);
    const text = column.digits !== undefined ? amount(value, column.digits) : column.show ? column.show(value) : value;
    const cell = element('span', {className: this.classOf(column), role: 'gridcell', title: text}, text || '–');
    if (column.key === 'outcome') cell.prepend(element('i', {className: 'dot outcome-' + value}));
    return cell;
  }

  choose(place) {
    this.chosen = Math.min(Math.max(place, 0), this.order.length - 1);
    const top = this.chosen * ROW_HEIGHT;
    const {scrollTop, clientHeight} = this.scroller;
    if (top < scrollTop) this.scroller.scrollTop = top;
    const room = clientHeight - this.headings.offsetHeight - ROW_HEIGHT;
    if (top > scrollTop + room) this.scroller.scrollTop = top - room;
    this.draw();
  }

  /** Selects a row if it is shown. */
  chooseRow(row) {
    const place = this.order.indexOf(row);
    if (place >= 0) this.choose(place);
  }

  /** Selects and returns the row `step` places further in the order; null at the ends. */
  neighbour(step) {
    const place = this.chosen + step;
    if (place < 0 || place >= this.order.length) return null;
    this.choose(place);
    return this.order[place];
  }

  onKey(event) {
    const page = Math.floor(this.scroller.clientHeight / ROW_HEIGHT) - 2;
    const steps = {ArrowDown: 1, ArrowUp: -1, PageDown: page, PageUp: -page, Home: -Infinity, End: Infinity};
    if (event.target !== this.scroller) return;
    if (event.key in steps) this.choose(this.chosen + steps[event.key]);
    else if (event.key === 'Enter' && this.order.length) this.onOpen(this.order[this.chosen]);
    else return;
    event.preventDefault();
  }
}
