#!/usr/bin/python3
"""The page of forge report in a headless Chromium."""
import json
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

from pages import LOGS, attacks_of, forge, make_scenarios, open_browser, open_page, until

SCREENSHOTS = Path('out', 'interop')
TIME = 'return Number(document.getElementById("time").value)'
INK = '''
const canvas = document.getElementById('view');
const data = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
const sums = {};
for (let i = 0; i < data.length; i += 4) {
  const key = data[i] > 190 && data[i + 1] < 70 ? 'red' : data[i + 2] > 180 && data[i] < 70 ? 'blue' : 'other';
  sums[key] = (sums[key] || 0) + 1;
}
return sums;
'''



class ReportTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.scenarios = make_scenarios(cls.folder.name, 23)
        cls.answers = [json.loads(line) for line in Path(cls.scenarios).read_text(encoding='utf-8').splitlines()]
        cls.page = cls.made('page', cls.scenarios, *LOGS)
        SCREENSHOTS.mkdir(parents=True, exist_ok=True)
        cls.browser = open_browser()
        cls.addClassCleanup(cls.browser.quit)

    @classmethod
    def made(cls, name, *words):
        """A page of these inputs, in a folder of that name."""
        out = Path(cls.folder.name, name)
        forge('report', *words, '--out', str(out))
        return out / 'index.html'

    def setUp(self):
        self.browser.set_window_size(1400, 950)
        open_page(self.browser, self.page)

    def tearDown(self):
        complaints = self.browser.get_log('browser')
        self.assertEqual(complaints, [])

    def find(self, selector):
        return self.browser.find_element(By.CSS_SELECTOR, selector)

    def find_all(self, selector):
        return self.browser.find_elements(By.CSS_SELECTOR, selector)

    def open_attack(self):
        self.chip('Crash as requested').click()
        self.find('.rows .row').click()
        until(self.browser, 'return document.getElementById("detail").open')

    def chip(self, words):
        return next(chip for chip in self.find_all('.chip') if chip.text.startswith(words))

    def press(self, keys):
        self.browser.switch_to.active_element.send_keys(keys)

    def shoot(self, name):
        self.browser.save_screenshot(str(SCREENSHOTS / (name + '.png')))

    def test_every_answer_is_a_row(self):
        self.assertEqual(self.find('#count').text, '{} rows'.format(len(self.answers)))
        self.assertEqual(self.find('.scroller').get_attribute('aria-rowcount'), str(len(self.answers) + 1))
        self.assertLessEqual(self.browser.execute_script('return document.documentElement.scrollWidth'), 1400)
        self.shoot('table')

    def test_a_filter_shows_the_matching_rows(self):
        wanted = sum(answer['request']['type'] == 'rear_end' for answer in self.answers)
        self.chip('Rear end').click()
        self.assertEqual(self.find('#count').text, '{} of {} rows'.format(wanted, len(self.answers)))
        self.assertTrue(all(cell.text == 'Rear end' for cell in self.find_all('.rows .of-type')))
        self.find('#clear').click()
        self.assertEqual(self.find('#count').text, '{} rows'.format(len(self.answers)))

    def test_a_heading_sorts_both_ways(self):
        heading = next(cell for cell in self.find_all('.headings .cell') if cell.text.startswith('Impact'))
        for order in ('ascending', 'descending'):
            heading.click()
            self.assertEqual(heading.get_attribute('aria-sort'), order)
            speeds = [float(cell.text) for cell in self.find_all('.rows .of-impact_speed') if cell.text != '–']
            self.assertEqual(speeds, sorted(speeds, reverse=order == 'descending'))
            self.assertGreater(len(speeds), 3)

    def test_an_attack_is_drawn_with_ego_and_attacker(self):
        self.open_attack()
        ink = self.browser.execute_script(INK)
        self.assertGreater(ink['red'], 300)
        self.assertGreater(ink['blue'], 300)
        self.assertEqual(len(self.find_all('.plot')), 3)
        self.shoot('attack')

    def test_the_time_line_scrubs(self):
        self.open_attack()
        plot = self.find('.plot svg')
        self.browser.execute_script('''
            const box = arguments[0].getBoundingClientRect();
            const at = {clientX: box.left + box.width * 0.75, clientY: box.top + 9, bubbles: true, pointerId: 1};
            HTMLElement.prototype.setPointerCapture = () => {}; // there is no such pointer
            arguments[0].dispatchEvent(new PointerEvent('pointerdown', at));''', plot)
        begin, end = (float(self.find('#time').get_attribute(name)) for name in ('min', 'max'))
        self.assertAlmostEqual(self.browser.execute_script(TIME), begin + 0.75 * (end - begin), delta=0.05)

    def test_keys_do_all(self):
        self.chip('Crash as requested').click()
        self.browser.execute_script('document.querySelector(".scroller").focus()')
        self.press(Keys.ARROW_DOWN)
        self.assertEqual(self.find('[aria-selected=true]').get_attribute('id'), 'row-1')
        self.press(Keys.ENTER)
        until(self.browser, 'return document.getElementById("detail").open')
        before = self.browser.execute_script(TIME)
        self.press(Keys.ARROW_RIGHT)
        self.assertAlmostEqual(self.browser.execute_script(TIME), before + 0.1, delta=0.011)
        self.press(' ')
        until(self.browser, 'return Number(document.getElementById("time").value) > {}'.format(before + 0.4))
        self.press(' ')
        self.assertEqual(self.find('#play').get_attribute('aria-label'), 'Play')
        self.press('f')
        self.assertEqual(self.find('#follow').get_attribute('aria-pressed'), 'true')
        self.press('+')
        title = self.find('#detail-title').text
        self.press('p')
        until(self.browser, 'return location.hash !== ""')
        self.assertTrue(title)
        self.press(Keys.ESCAPE)
        until(self.browser, 'return !document.getElementById("detail").open')
        self.press('?')
        self.assertTrue(self.find('#help').is_displayed())

    def test_a_rejected_request_has_a_reason(self):
        self.chip('Rejected').click()
        self.find('.rows .row').click()
        until(self.browser, 'return document.getElementById("detail").open')
        reason = self.find('.rows .of-message').get_attribute('textContent')
        self.assertIn(reason, self.find('#facts').text.replace('\n', ' '))
        self.assertEqual(self.browser.execute_script(
            'const cell = document.querySelector(".rows .of-message"); return cell.scrollWidth - cell.clientWidth'), 0)
        codes = {answer['status']['code'] for answer in self.answers} - {'OK'}
        self.assertTrue(any(code in self.find('#facts').text for code in codes))

    def open_row(self, page, name):
        open_page(self.browser, page, '#' + name)
        until(self.browser, 'return document.getElementById("detail").open')

    def test_an_address_opens_the_line_of_the_file(self):
        self.open_row(self.page, '11')
        self.assertTrue(self.find('#detail-title').text.startswith('scenarios:11, '))
        self.assertIn('line 11', self.find('#facts').text)
        self.assertEqual(self.find('[aria-selected=true] .of-name').get_attribute('textContent'), 'scenarios:11')
        self.assertTrue(self.browser.current_url.endswith('#scenarios:11'))
        self.browser.execute_script('location.hash = "scenarios:3"')
        until(self.browser, 'return document.getElementById("detail-title").textContent.startsWith("scenarios:3,")')

    def test_the_commands_of_a_row_make_it_again(self):
        number = 1 + next(i for i, answer in enumerate(self.answers) if answer['status']['code'] == 'OK')
        self.browser.execute_cdp_cmd('Browser.grantPermissions', {
            'permissions': ['clipboardReadWrite', 'clipboardSanitizedWrite']})
        self.open_row(self.page, str(number))
        for copy, lines in zip(self.find_all('.copy'), self.find_all('.commands pre')):
            copy.click()
            until(self.browser, 'return document.activeElement.textContent === "Copied"')
            copied = self.browser.execute_async_script(
                'navigator.clipboard.readText().then(arguments[arguments.length - 1])')
            self.assertEqual(copied, lines.get_attribute('textContent'))
        inject, generate = (pre.get_attribute('textContent') for pre in self.find_all('.commands pre'))
        folder = Path(self.folder.name, 'again')
        folder.mkdir()
        (folder / 'data').symlink_to(Path('data').resolve())
        printed = subprocess.run(['bash', '-ec', inject + '\n' + generate], cwd=folder, check=True, text=True,
                                 stdout=subprocess.PIPE).stdout
        again = json.loads((folder / 'answer.jsonl').read_text(encoding='utf-8'))
        self.assertEqual(again, self.answers[number - 1])
        for ending in ('bag', 'png', 'gif'):
            self.assertTrue((folder / ('attacked.' + ending)).is_file(), printed)

    def test_light_and_dark(self):
        self.browser.execute_cdp_cmd('Emulation.setEmulatedMedia',
                                     {'features': [{'name': 'prefers-color-scheme', 'value': 'dark'}]})
        try:
            open_page(self.browser, self.page)
            self.assertEqual(self.find('html').get_attribute('data-theme'), 'dark')
            self.shoot('dark')
            self.find('#theme').click()
            self.assertEqual(self.find('html').get_attribute('data-theme'), 'light')
        finally:
            self.browser.execute_cdp_cmd('Emulation.setEmulatedMedia', {'features': []})

    def test_a_phone_needs_no_sideways_scrolling(self):
        self.browser.execute_cdp_cmd('Emulation.setDeviceMetricsOverride',
                                     {'width': 390, 'height': 844, 'deviceScaleFactor': 2, 'mobile': True})
        try:
            open_page(self.browser, self.page)
            self.assertLessEqual(self.browser.execute_script('return document.documentElement.scrollWidth'), 390)
            self.shoot('phone')
            self.find('.rows .row').click()
            until(self.browser, 'return document.getElementById("detail").open')
            self.assertLessEqual(self.browser.execute_script('return document.documentElement.scrollWidth'), 390)
            self.shoot('phone_attack')
        finally:
            self.browser.execute_cdp_cmd('Emulation.clearDeviceMetricsOverride', {})

    def test_without_logs_the_attack_is_shown(self):
        open_page(self.browser, self.made('bare', self.scenarios))
        self.chip('Generated').click()
        self.find('.rows .row').click()
        until(self.browser, 'return document.getElementById("detail").open')
        self.assertIn('--source', self.find('#notice').text)
        self.assertGreater(self.browser.execute_script(INK)['red'], 300)

    def test_texts_of_files_are_no_markup(self):
        evil = '<script>document.title = "broken"</script><img src=x onerror="document.title=1">'
        scenario = json.loads(attacks_of(self.scenarios)[0])
        scenario['scene'] = evil
        scenario['attacker']['id'] = evil
        file = Path(self.folder.name, 'evil.jsonl')
        file.write_text(json.dumps(scenario) + '\n', encoding='utf-8')
        self.open_row(self.made('evil', str(file)), '1')
        self.assertEqual(self.browser.title, 'Collision scenarios')
        self.assertIn(evil, self.find('#facts').text)
        self.assertEqual(self.find_all('#detail img, #table img'), [])

    def test_planner_tests_show_the_planners_motion(self):
        out = Path(self.folder.name, 'tests')
        page = Path(self.folder.name, 'tests_page')
        some = Path(self.folder.name, 'some.jsonl')
        some.write_text('\n'.join(attacks_of(self.scenarios)[:12]) + '\n', encoding='utf-8')
        forge('test', *LOGS, '--scenarios', str(some), '--planners', 'idm', '--worst', '9', '--out', str(out),
              '--report', str(page))
        open_page(self.browser, page / 'index.html')
        self.assertEqual([button.text for button in self.find_all('#kinds button')], ['Planner tests12', 'Attacks12'])
        self.assertTrue(all(cell.text == 'idm' for cell in self.find_all('.rows .of-planner')))
        self.find('.matrix td button').click()
        self.assertEqual(self.find('#count').text.split(' ')[0], self.find('.matrix td [aria-pressed=true] b').text)
        self.shoot('matrix')
        self.find('.matrix td [aria-pressed=true]').click()
        self.assertEqual(self.find('#count').text, '12 rows')
        self.browser.execute_script('document.querySelector(".rows .row").click()')
        until(self.browser, 'return document.getElementById("detail").open')
        self.assertIn('Ego as the planner drives it', self.find('#legend').text)
        self.assertIn('Avoidable', self.find('#facts').text)
        self.shoot('planner')
        drawn = {file.name for file in (out / 'worst').glob('*.gif')}
        linked, legends = set(), ''
        for line in range(1, 13):
            self.open_row(page / 'index.html', 'results:{}'.format(line))
            legends += self.find('#legend').text
            for link in self.find_all('#facts a[href$=gif]'):
                self.assertTrue(Path(link.get_property('href')[len('file://'):]).is_file())
                linked.add(link.get_property('href').split('/')[-1])
        self.assertTrue(drawn)
        self.assertEqual(linked, drawn)
        self.assertIn('Evasive manoeuvre of the ego', legends)
        self.shoot('evasion')

    def test_tuning_and_draws_end_with_pages_that_show_the_drives(self):
        folder = Path(self.folder.name)
        by_scene = {}
        for line in attacks_of(self.scenarios):
            by_scene.setdefault(json.loads(line)['scene'], []).append(line)
        for name, lines in zip(('train', 'held'), list(by_scene.values())[-2:]):
            (folder / (name + '.jsonl')).write_text('\n'.join(lines) + '\n', encoding='utf-8')
        (folder / 'grid.yaml').write_text('idm:\n  idm.standard.min_gap: [1.0, 4.0]\n', encoding='utf-8')
        forge('tune', *LOGS, '--planner', 'idm', '--grid', str(folder / 'grid.yaml'), '--train',
              str(folder / 'train.jsonl'), '--test', str(folder / 'held.jsonl'), '--out', str(folder / 'tuning'),
              '--report', str(folder / 'tuning'))
        forge('test', *LOGS, '--until-hit', '--scene', 'scene-0001', 'scene-0005', '--tries', '12', '--planners', 'idm',
              '--worst', '1', '--out', str(folder / 'hits'), '--report', str(folder / 'hits'))
        attacks, witnesses, results = (
            [json.loads(line) for line in (folder / 'hits' / (name + '.jsonl')).read_text(encoding='utf-8').splitlines()]
            for name in ('weaknesses', 'witnesses', 'results'))
        hit = 1 + [result['name'] for result in results].index(witnesses[0]['name'])
        self.assertTrue(attacks)
        for name, row in (('tuning', 'test:1'), ('hits', 'results:{}'.format(hit))):
            self.open_row(folder / name / 'index.html', row)
            self.assertIn('Ego as the planner drives it', self.find('#legend').text)
            self.shoot(name)


if __name__ == '__main__':
    os.chdir(Path(__file__).parents[2])
    unittest.main()
