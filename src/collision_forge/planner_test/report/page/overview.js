// Charts of the rows that are shown: planners and their outcomes; outcomes by type, time and manoeuvre; impact speeds.
import {OUTCOMES, amount, element, title} from './words.js';

const BREAKDOWNS = ['type', 'tta', 'manoeuvre'];
const SPEED_STEP = 2; // m/s per column

export class Overview {
  constructor(place, rows, filters) {
    this.place = place;
    this.rows = rows;
    this.filters = filters;
    const found = new Set(filters.list.map((row) => this.outcomeOf(row)));
    this.outcomes = OUTCOMES.filter((outcome) => found.has(outcome));
    this.planners = [...new Set(filters.list.map((row) => rows.text('planner', row)))].filter((name) => name).sort();
    this.hasTests = filters.list.some((row) => rows.isTest(row));
  }

  draw(shown) {
    const charts = BREAKDOWNS.map((key) => this.filters.facet(key)).filter((facet) => facet)
      .map((facet) => this.breakdown(facet, shown));
    const hasMatrix = this.hasTests || this.planners.length > 1;
    this.place.replaceChildren(hasMatrix ? this.matrix() : this.totals(shown), this.speeds(shown), ...charts);
  }

  outcomeOf(row) {
    return this.rows.text('outcome', row);
  }

  /**
   * A matrix of planners or methods (rows) and outcomes (columns); a click on a cell, row or column filters. Untested
   * cases are counted below.
   */
  matrix() {
    const counts = new Map(['', ...this.planners].map((planner) => [planner, new Map()]));
    for (const row of this.filters.passingBut(['planner', 'outcome'])) {
      const of = counts.get(this.rows.text('planner', row));
      of.set(this.outcomeOf(row), (of.get(this.outcomeOf(row)) || 0) + 1);
    }
    const button = (words, ...content) => element('button', {
      type: 'button', onclick: () => this.filters.toggleOnly(words),
      'aria-pressed': String(this.filters.areChosen(words)),
    }, ...content);
    const told = this.outcomes.filter((outcome) => this.planners.some((planner) => counts.get(planner).get(outcome)));
    const heads = told.map((outcome) => element('th', {scope: 'col'},
      button({outcome}, element('i', {className: 'dot outcome-' + outcome}), title(outcome))));
    const lines = this.planners.map((planner) => {
      const of = counts.get(planner);
      const sum = [...of.values()].reduce((total, count) => total + count, 0);
      const cells = told.map((outcome) => {
        const count = of.get(outcome) || 0;
        const share = count ? amount(100 * count / sum, 0, '%') : '';
        const cell = button({planner, outcome}, element('b', {}, String(count)), element('small', {}, share));
        const shade = element('i', {className: 'shade outcome-' + outcome});
        shade.style.opacity = count ? 0.1 + 0.5 * count / sum : 0;
        cell.prepend(shade);
        return element('td', {}, cell);
      });
      return element('tr', {}, element('th', {scope: 'row'}, button({planner}, planner)), ...cells,
        element('td', {className: 'sum'}, String(sum)));
    });
    const name = this.hasTests ? 'Planner' : 'Method';
    const card = this.card(`${name} and outcome`, element('table', {className: 'matrix'}, element('thead', {},
      element('tr', {}, element('th', {scope: 'col'}, name), ...heads, element('th', {scope: 'col'}, 'All'))),
    element('tbody', {}, ...lines)), this.untested(counts.get('')));
    card.classList.add('wide-card');
    return card;
  }

  untested(counts) {
    const sum = [...counts.values()].reduce((total, count) => total + count, 0);
    return sum ? element('p', {className: 'note'}, `${sum} more cases have no attack and were not tested.`) : null;
  }

  totals(shown) {
    const counts = new Map(this.outcomes.map((outcome) => [outcome, 0]));
    for (const row of shown) counts.set(this.outcomeOf(row), counts.get(this.outcomeOf(row)) + 1);
    const lines = this.outcomes.map((outcome) => element('div', {className: 'total'},
      element('i', {className: 'dot outcome-' + outcome}), element('b', {}, String(counts.get(outcome))),
      element('span', {}, title(outcome)),
      element('small', {}, amount(100 * counts.get(outcome) / Math.max(shown.length, 1), 0, '%'))));
    return this.card('Outcomes', ...lines);
  }

  /** Creates one bar per value, stacked by outcome; a click filters. */
  breakdown(facet, shown) {
    const counts = facet.words.map(() => new Map());
    for (const row of shown) {
      const of = counts[facet.ofRow[row]];
      of.set(this.outcomeOf(row), (of.get(this.outcomeOf(row)) || 0) + 1);
    }
    const sums = counts.map((of) => [...of.values()].reduce((sum, count) => sum + count, 0));
    const greatest = Math.max(1, ...sums);
    const bars = facet.words.map((word, i) => {
      const pieces = this.outcomes.filter((outcome) => counts[i].get(outcome)).map((outcome) => {
        const piece = element('i', {className: 'outcome-' + outcome});
        piece.style.width = 100 * counts[i].get(outcome) / greatest + '%';
        return piece;
      });
      const told = this.outcomes.filter((outcome) => counts[i].get(outcome))
        .map((outcome) => title(outcome) + ' ' + counts[i].get(outcome)).join(', ');
      return element('button', {
        type: 'button', className: 'bar', title: facet.show(word) + ': ' + (told || 'none'),
        onclick: () => this.filters.toggle(facet.key, i),
      }, element('span', {}, facet.show(word)), element('span', {className: 'track'}, ...pieces),
      element('small', {}, String(sums[i])));
    }).filter((bar, i) => sums[i] > 0);
    return this.card('By ' + facet.title.toLowerCase(), ...bars);
  }

  speeds(shown) {
    const counts = [];
    for (const row of shown) {
      const speed = this.rows.number('impact_speed', row);
      if (speed === null) continue;
      const place = Math.floor(speed / SPEED_STEP);
      counts[place] = (counts[place] || 0) + 1;
    }
    const greatest = Math.max(1, ...Array.from(counts, (count) => count || 0));
    const columns = Array.from(counts, (count, i) => {
      const column = element('i', {title: `${i * SPEED_STEP} to ${(i + 1) * SPEED_STEP} m/s: ${count || 0}`});
      column.style.height = 100 * (count || 0) / greatest + '%';
      return column;
    });
    const axis = element('div', {className: 'axis'}, element('span', {}, '0'),
      element('span', {}, counts.length * SPEED_STEP + '\u202fm/s'));
    return this.card('Impact speed', counts.length ? element('div', {className: 'histogram'}, ...columns)
      : element('p', {}, 'No contact in these rows.'), counts.length ? axis : null);
  }

  card(name, ...content) {
    return element('section', {className: 'card'}, element('h2', {}, name), ...content);
  }
}
