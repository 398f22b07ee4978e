// Filters of the rows: values chosen per column, and a search text.
import {OUTCOMES, element, title} from './words.js';

const FACETS = [
  {key: 'outcome', title: 'Outcome', show: title},
  {key: 'type', title: 'Type', show: title},
  {key: 'tta', title: 'Time to attack', show: (word) => word + '\u202fs'},
  {key: 'planner', title: 'Planner, method', show: (word) => word || 'None'},
  {key: 'manoeuvre', title: 'Manoeuvre', show: (word) => title(word) || 'None'},
  {key: 'believable', title: 'Plausible', show: (word) => title(word) || 'Unknown'},
  {key: 'mode', title: 'Mode', show: (word) => title(word) || 'Unknown'},
];

/** Returns the values of a facet in the order of the page. */
function sortedWords(facet, words) {
  if (facet.key === 'outcome') return [...words].sort((a, b) => OUTCOMES.indexOf(a) - OUTCOMES.indexOf(b));
  if (facet.key === 'tta') return [...words].sort((a, b) => a - b);
  return [...words].sort();
}

export class Filters {
  /** Filters the rows in `list`; calls `onChange` with the rows that pass. */
  constructor(place, rows, list, onChange) {
    this.rows = rows;
    this.list = list;
    this.onChange = onChange;
    this.search = '';
    this.facets = FACETS.map((facet) => this.makeFacet(facet)).filter(({words}) => words.length > 1);
    this.input = element('input', {
      type: 'search', placeholder: 'Scene, line, reason …', 'aria-label': 'Search in scene, line and reason',
      oninput: () => {
        this.search = this.input.value.toLowerCase();
        this.apply();
      },
    });
    place.replaceChildren(element('label', {className: 'facet search'}, element('span', {}, 'Search'), this.input),
      ...this.facets.map(({fieldset}) => fieldset));
  }

  makeFacet(facet) {
    const found = new Set();
    const wordOf = (row) => (facet.key === 'tta'
      ? String(Math.round(10 * this.rows.number('tta', row)) / 10) : this.rows.text(facet.key, row));
    for (const row of this.list) found.add(wordOf(row));
    const words = sortedWords(facet, found);
    const places = new Map(words.map((word, i) => [word, i]));
    const made = {...facet, words, chosen: new Set(), ofRow: new Int32Array(this.rows.length)};
    for (const row of this.list) made.ofRow[row] = places.get(wordOf(row));
    made.buttons = words.map((word, i) => element('button', {
      type: 'button', className: 'chip', 'aria-pressed': 'false', onclick: () => this.toggle(facet.key, i),
    }, facet.show(word), element('small', {})));
    if (facet.key === 'outcome') {
      made.buttons.forEach((button, i) => button.prepend(element('i', {className: 'dot outcome-' + words[i]})));
    }
    made.fieldset = element('fieldset', {className: 'facet'}, element('legend', {}, facet.title), ...made.buttons);
    return made;
  }

  facet(key) {
    return this.facets.find((facet) => facet.key === key);
  }

  toggle(key, place) {
    const {chosen} = this.facet(key);
    if (!chosen.delete(place)) chosen.add(place);
    this.apply();
  }

  /** Selects only these values (by facet key); clears the selection if it is already the same. */
  toggleOnly(words) {
    const wanted = this.placesOf(words);
    const areChosen = wanted.every(([{chosen}, place]) => chosen.size === 1 && chosen.has(place));
    wanted.forEach(([{chosen}, place]) => {
      chosen.clear();
      if (!areChosen) chosen.add(place);
    });
    this.apply();
  }

  areChosen(words) {
    const wanted = this.placesOf(words);
    return wanted.length > 0 && wanted.every(([{chosen}, place]) => chosen.has(place));
  }

  /** Creates the facets and the indices of their values. A value that all rows share has no facet. */
  placesOf(words) {
    return Object.entries(words).map(([key, word]) => [this.facet(key), word]).filter(([facet]) => facet)
      .map(([facet, word]) => [facet, facet.words.indexOf(word)]);
  }

  /** Returns the rows that pass the search and all facets except these keys. */
  passingBut(keys) {
    const facets = this.facets.filter(({key}) => !keys.includes(key));
    return this.list.filter((row) => (!this.search || this.matchesSearch(row))
      && facets.every(({chosen, ofRow}) => chosen.size === 0 || chosen.has(ofRow[row])));
  }

  clear() {
    this.facets.forEach(({chosen}) => chosen.clear());
    this.search = this.input.value = '';
    this.apply();
  }

  isEmpty() {
    return !this.search && this.facets.every(({chosen}) => chosen.size === 0);
  }

  matchesSearch(row) {
    return [this.rows.text('scene', row), this.rows.name(row), this.rows.text('message', row),
      this.rows.text('status', row)].some((text) => text.toLowerCase().includes(this.search));
  }

  /** Calls `onChange` with the rows that pass; shows beside each value how many more rows it would add. */
  apply() {
    const passing = [];
    const counts = this.facets.map(({words}) => new Int32Array(words.length));
    for (const row of this.list) {
      if (this.search && !this.matchesSearch(row)) continue;
      let missed = -1;
      let misses = 0;
      this.facets.forEach((facet, i) => {
        if (facet.chosen.size === 0 || facet.chosen.has(facet.ofRow[row])) return;
        missed = i;
        ++misses;
      });
      if (misses === 0) passing.push(row);
      if (misses > 1) continue;
      this.facets.forEach((facet, i) => {
        if (misses === 0 || missed === i) ++counts[i][facet.ofRow[row]];
      });
    }
    this.facets.forEach((facet, i) => facet.buttons.forEach((button, k) => {
      button.setAttribute('aria-pressed', String(facet.chosen.has(k)));
      button.lastChild.textContent = counts[i][k];
    }));
    this.onChange(passing);
  }
}
