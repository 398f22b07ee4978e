#!/usr/bin/python3
"""usage: scenarios_to_csv.py SCENARIOS OUT: write the attacker trajectory of each scenario as CSV."""
import csv
import json
import sys

columns = ['t', 'x', 'y', 'yaw', 'v', 'a', 'kappa']  # s from t0, m, rad, m/s, m/s2, 1/m
with open(sys.argv[1]) as scenarios, open(sys.argv[2], 'w', newline='') as out:
    writer = csv.writer(out)
    writer.writerow(['line', 'scene', 'type', 'attacker'] + columns)
    for number, line in enumerate(scenarios, 1):
        scenario = json.loads(line)
        if (scenario['format'], scenario['version']) != ('collision_forge/scenario', 7):
            sys.exit('line {}: not a scenario of version 7'.format(number))
        attacker = scenario['attacker']  # null if the request was rejected
        for point in attacker['trajectory'] if attacker else []:
            writer.writerow([number, scenario['scene'], scenario['request']['type'], attacker['id']] +
                            [point[column] for column in columns])
