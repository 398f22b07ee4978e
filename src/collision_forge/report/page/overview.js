// Charts of the rows that are shown: outcomes by type, time, planner and manoeuvre, and impact speeds.
import {OUTCOMES, amount, element, title} from './words.js';

const BREAKDOWNS = ['type', 'tta', 'planner', 'manoeuvre'];
const SPEED_STEP = 2; // m/s a column

export class Overview {
  constructor(place, rows, filters) {
    this.place = place;
    this.rows = rows;
    this.filters = filters;
    this.outcomes = OUTCOMES.filter((outcome) => rows.columns.outcome.words.includes(outcome));
  }

  draw(shown) {
    const charts = BREAKDOWNS.map((key) => this.filters.facet(key)).filter((facet) => facet)
      .map((facet) => this.breakdown(facet, shown));
    this.place.replaceChildren(this.totals(shown), this.speeds(shown), ...charts);
  }

  outcomeOf(row) {
    return this.rows.text('outcome', row);
  }

  totals(shown) {
    const counts = new Map(this.outcomes.map((outcome) => [outcome, 0]));
    for (const row of shown) counts.set(this.outcomeOf(row), counts.get(this.outcomeOf(row)) + 1);
    const lines = this.outcomes.map((outcome) => element('div', {className: 'total'},
      element('i', {className: 'dot outcome-' + outcome}), element('b', {}, String(counts.get(outcome))),
      element('span', {}, title(outcome)),
      element('small', {}, amount(100 * counts.get(outcome) / Math.max(shown.length, 1), 1, '%'))));
    return this.card('Outcomes', ...lines);
  }

  /** A bar a word, stacked by outcome; a click filters. */
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
      : element('p', {}, 'No contact among these.'), counts.length ? axis : null);
  }

  card(name, ...content) {
    return element('section', {className: 'card'}, element('h2', {}, name), ...content);
  }
}
