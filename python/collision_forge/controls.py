"""Optional constraints of a request."""
import difflib
import inspect
from typing import Any, Dict, Mapping, Optional, Tuple

Band = Optional[Tuple[float, float]]


def control_fields(*, attacker: str = '', choice: str = '', mode: str = '', seed: int = 0,
                   believable: Optional[bool] = None, limits: str = '', attacker_class: str = '', manoeuvre: str = '',
                   ego_side: str = '', impact_speed: Band = None, overlap: Band = None,
                   turning: str = '', from_side: str = '', attacker_speed: Band = None, deceleration: Band = None,
                   gap: Band = None, headway: Band = None, lateral_speed: Band = None, impact_location: Band = None,
                   departure_time: Band = None, hidden_by: str = '', visible_for: Band = None,
                   queue: bool = False, alternatives: int = 1) -> Dict[str, Any]:
    """Return the message fields of a request; srv/GenerateCollision.srv lists the allowed words.

    attacker: id of an agent; by default any that `choice` allows
    choice: existing (a recorded vehicle), new (one is added) or any
    mode: history (observations up to t0), replay (also the recorded future), adaptive (attacker replans every 0.1 s)
    seed: random seed of the search; the same scene and seed give the same result
    believable: require a plausible attacker, driving like recorded drivers until it attacks; default in config/
    limits: drivable (limits of the attacker's class) or strict; default in config/
    attacker_class, manoeuvre, ego_side: any by default
    impact_speed: (least, greatest), m/s, norm of the relative velocity at contact
    overlap: (least, greatest) share of the ego's touched side that the attacker covers, [0, 1]
    turning: vehicle that must turn: ego (ltap, junction_crossing, angle types) or attacker (default; ltap)
    from_side: side of the ego from which the attacker comes, left or right
    attacker_speed: (least, greatest), m/s at contact; the next six are pairs, too
    deceleration: m/s2, of the attacker, mean over the last 0.5 s before the contact
    gap, headway: between attacker and ego at t0, m and s
    lateral_speed: m/s, of the attacker across the ego's heading at contact
    impact_location: place on the ego's front, share of its width, 0 at the left edge
    departure_time: s after t0 at which an attacker that stands at t0 starts to move
    visible_for: s before contact from which on the ego sees the attacker; at most the time since t0
    hidden_by: what hides the attacker until then, parked_vehicle or leader
    queue: a second vehicle stands ahead of the attacker, which stands in its lane
    alternatives: number of attacks, which differ in attacker or manoeuvre, at most 16
    """
    slowest, fastest = _pair('impact_speed', impact_speed)
    narrowest, widest = _pair('overlap', overlap)
    bands = {'attacker_speed': attacker_speed, 'deceleration': deceleration, 'gap': gap, 'headway': headway,
             'lateral_speed': lateral_speed, 'impact_location': impact_location, 'departure_time': departure_time,
             'visible_for': visible_for}
    limits_of = {name: _pair(name, band) for name, band in bands.items()}
    return {'turning': turning, 'from_side': from_side, 'hidden_by': hidden_by, 'queue': queue,
            **{'min_' + name: pair[0] for name, pair in limits_of.items()},
            **{'max_' + name: pair[1] for name, pair in limits_of.items()},
            'attacker_id': attacker, 'choice': choice, 'mode': mode, 'seed': seed,
            'believable': '' if believable is None else str(believable).lower(), 'limits': limits,
            'attacker_class': attacker_class, 'manoeuvre': manoeuvre, 'ego_side': ego_side,
            'min_impact_speed': slowest, 'max_impact_speed': fastest, 'min_overlap': narrowest, 'max_overlap': widest,
            'alternatives': alternatives}


def fields_of(controls: Mapping[str, Any]) -> Dict[str, Any]:
    """Return `control_fields(**controls)`; raise TypeError with the known names for an unknown one."""
    known = list(inspect.signature(control_fields).parameters)
    for name in controls:
        if name not in known:
            near = difflib.get_close_matches(name, known, 1)
            raise TypeError('unknown control {!r}{}; the controls are {}'.format(
                name, '; did you mean {}?'.format(near[0]) if near else '', ', '.join(known)))
    return control_fields(**controls)


def _pair(name: str, band: Band) -> Tuple[float, float]:
    if band is None:
        return 0.0, 0.0
    try:
        least, greatest = band
    except (TypeError, ValueError):
        raise TypeError('{} = {!r} is not a pair (least, greatest) such as (1.0, 10.0)'.format(name, band)) from None
    return least, greatest
