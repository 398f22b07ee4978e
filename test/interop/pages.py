"""Pages of forge report over the embedded scenes, and a browser that looks at them."""
import json
import subprocess
from pathlib import Path

from selenium import webdriver
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.support.ui import WebDriverWait

LOGS = ['--dataroot', 'data/embedded', '--version', 'v1.0-embedded']
SECONDS = 60  # timeout of every step


def forge(*words):
    """Run forge; on failure raise an error with its stderr."""
    done = subprocess.run(['forge', *words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    if done.returncode:
        raise RuntimeError('forge {}: {}'.format(' '.join(words), done.stdout))
    return done.stdout


def make_scenarios(folder, every, mode='history'):
    """Write scenarios for every n-th feasible request in the embedded scenes."""
    listed, wanted, made = (str(Path(folder, name)) for name in ('all.jsonl', 'requests.jsonl', 'scenarios.jsonl'))
    forge('requests', *LOGS, '--out', listed)
    lines = Path(listed).read_text(encoding='utf-8').splitlines()[::every]
    Path(wanted).write_text('\n'.join(lines) + '\n', encoding='utf-8')
    forge('generate', *LOGS, '--requests', wanted, '--mode', mode, '--out', made)
    return made


def attacks_of(scenarios):
    """Return the lines with an attack."""
    lines = Path(scenarios).read_text(encoding='utf-8').splitlines()
    return [line for line in lines if json.loads(line)['status']['code'] == 'OK']


def open_browser(width=1400, height=950):
    options = webdriver.ChromeOptions()
    for word in ('--headless=new', '--no-sandbox', '--disable-dev-shm-usage', '--hide-scrollbars',
                 '--window-size={},{}'.format(width, height)):
        options.add_argument(word)
    options.set_capability('goog:loggingPrefs', {'browser': 'ALL'})
    return webdriver.Chrome(options=options, service=Service('/usr/bin/chromedriver'))


def open_page(browser, page, place=''):
    browser.get('about:blank')
    browser.get(Path(page).resolve().as_uri() + place)
    until(browser, 'return document.body.dataset.state === "ready"')


def until(browser, script):
    """Waits until the script returns something true, and returns it."""
    return WebDriverWait(browser, SECONDS, 0.05).until(lambda _: browser.execute_script(script))
