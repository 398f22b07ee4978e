#!/usr/bin/python3
"""usage: asam_checks.py FOLDER: ASAM's rules over all .xodr and .xosc of a folder, in an environment that has them.

Prints what is wrong, a line each, then how many files were checked. asam-qc-opendrive and asam-qc-openscenarioxml end
with 0 whatever they find, so their results are read: an error is an issue of level 1 or a rule that failed to run, and
every file must have passed its schema.
"""
import logging
import sys
from pathlib import Path

import qc_opendrive.main
import qc_openscenario.main
from qc_baselib import Configuration, Result

ENDINGS = {'.xodr': (qc_opendrive.main, 'xodrBundle', 'check_asam_xodr_xml_valid_schema'),
           '.xosc': (qc_openscenario.main, 'xoscBundle', 'check_asam_xosc_xml_valid_schema')}
ERROR = 1


def complaints(path):
    program, bundle, schema = ENDINGS[path.suffix]
    configuration, result = Configuration(), Result()
    configuration.set_config_param('InputFile', str(path.absolute()))
    configuration.register_checker_bundle(bundle)
    result.register_checker_bundle(name=bundle, description='', version='1', summary='')
    result.set_result_version('1')
    program.run_checks(configuration, result)
    statuses = {}
    for checker in next(one for one in result._report_results.checker_bundles if one.name == bundle).checkers:
        statuses[checker.checker_id] = checker.status.name
        for issue in checker.issues:
            if issue.level == ERROR:
                yield '{}: {}: {}'.format(path.name, checker.checker_id, issue.description)
        if checker.status.name == 'ERROR':
            yield '{}: {} did not run: {}'.format(path.name, checker.checker_id, checker.summary)
    if statuses.get(schema) != 'COMPLETED':
        yield '{}: {} is {}'.format(path.name, schema, statuses.get(schema))


def main(folder):
    logging.disable(logging.CRITICAL)
    paths = [path for path in sorted(Path(folder).iterdir()) if path.suffix in ENDINGS]
    found = 0
    for path in paths:
        for line in complaints(path):
            found += 1
            print(line)
    print('{} files checked'.format(len(paths)))
    return 1 if found else 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1]))
