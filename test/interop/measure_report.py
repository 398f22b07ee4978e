#!/usr/bin/python3
"""usage: measure_report.py SOURCE_DIR: see scripts/measure_report."""
import itertools
import os
import sys
import tempfile
from pathlib import Path

from pages import LOGS, attacks_of, forge, make_scenarios, open_browser, open_page, until

TRIES = 5
CLICKS = '''
const done = arguments[arguments.length - 1];
const times = [];
const chips = document.querySelectorAll('.chip');
for (let i = 0; i < 20; ++i) {
  const begin = performance.now();
  chips[i % chips.length].click();
  document.body.getBoundingClientRect(); // lays the page out
  times.push(performance.now() - begin);
}
document.getElementById('clear').click();
done(times);
'''
OPENING = '''
const done = arguments[arguments.length - 1];
const begin = performance.now();
document.querySelectorAll('.rows .row')[1].click();
const wait = () => (document.getElementById('detail').open ? done(performance.now() - begin) : setTimeout(wait, 0));
wait();
'''


def time_opening(browser, page):
    """ms from the begin of the navigation until the table is there and drawn."""
    open_page(browser, page)
    return until(browser, 'return performance.getEntriesByName("ready").length && '
                          'performance.getEntriesByName("ready")[0].startTime')


def measure(browser, lines, count, folder):
    scenarios = Path(folder, 'attacks_{}.jsonl'.format(count))
    repeated = itertools.islice(itertools.cycle(lines), count)
    scenarios.write_text('\n'.join(repeated) + '\n', encoding='utf-8')
    out = Path(folder, 'page_{}'.format(count))
    forge('report', str(scenarios), *LOGS, '--out', str(out))
    page = out / 'index.html'
    opened = sorted(time_opening(browser, page) for _ in range(TRIES))
    clicks = sorted(browser.execute_async_script(CLICKS))
    detail = browser.execute_async_script(OPENING)
    print('{:6} attacks: {:6.2f} MB; opens in {:.0f} ms (median of {}, at most {:.0f}); a filter takes {:.0f} ms '
          '(median of {}, at most {:.0f}); an attack opens in {:.0f} ms'.format(
              count, page.stat().st_size / 1e6, opened[TRIES // 2], TRIES, opened[-1], clicks[len(clicks) // 2],
              len(clicks), clicks[-1], detail))


def main(source_dir):
    os.chdir(source_dir)
    with tempfile.TemporaryDirectory() as folder:
        lines = attacks_of(make_scenarios(folder, 9))
        browser = open_browser()
        try:
            for count in (100, 10000):
                measure(browser, lines, count, folder)
        finally:
            browser.quit()


if __name__ == '__main__':
    main(sys.argv[1])
