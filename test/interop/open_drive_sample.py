"""An OpenDRIVE file with every geometry, polynomial widths and offsets, and lanes of several types."""
import math

STEPS = 20000  # of the integration along one piece


def end_of(pose, length, curvature_at):
    """Pose after a piece, integrated in small steps; `curvature_at` is a function of the share 0..1."""
    x, y, heading = pose
    step = length / STEPS
    for i in range(STEPS):
        turn = step * curvature_at((i + 0.5) / STEPS)
        x += step * math.cos(heading + turn / 2)
        y += step * math.sin(heading + turn / 2)
        heading += turn
    return x, y, heading


def end_of_cubic(pose, coefficients):
    """Pose after a normalised paramPoly3 with the coefficients a, b, c, d of U and V."""
    (x, y, heading), (u, v) = pose, coefficients
    along, across = sum(u), sum(v)
    turn = math.atan2(v[1] + 2 * v[2] + 3 * v[3], u[1] + 2 * u[2] + 3 * u[3])
    return (x + along * math.cos(heading) - across * math.sin(heading),
            y + along * math.sin(heading) + across * math.cos(heading), heading + turn)


def length_of_cubic(coefficients):
    (_, ub, uc, ud), (_, vb, vc, vd) = coefficients
    speed = lambda p: math.hypot(ub + 2 * uc * p + 3 * ud * p * p, vb + 2 * vc * p + 3 * vd * p * p)  # noqa: E731
    return sum(speed((i + 0.5) / STEPS) for i in range(STEPS)) / STEPS


def polynomial(name, begin_name, begin, *coefficients):
    return '<{} {}="{}" {}/>'.format(name, begin_name, begin, ' '.join(
        '{}="{!r}"'.format(letter, value) for letter, value in zip('abcd', coefficients)))


def lane(number, kind, width, predecessor=None, successor=None):
    links = ''.join('<{} id="{}"/>'.format(name, target)
                    for name, target in (('predecessor', predecessor), ('successor', successor)) if target)
    return '<lane id="{}" type="{}" level="false"><link>{}</link>{}</lane>'.format(number, kind, links, width)


def section(begin, left, right):
    side = '<{0}>{1}</{0}>'.format
    return '<laneSection s="{!r}">{}<center><lane id="0" type="none"/></center>{}</laneSection>'.format(
        begin, side('left', ''.join(left)), side('right', ''.join(right)))


def plan(pieces):
    """The elements <geometry> from the origin on, and the length."""
    pose, begin, elements = (0.0, 0.0, 0.3), 0.0, []
    for length, shape, end in pieces:
        x, y, heading = pose
        elements.append('<geometry s="{!r}" x="{!r}" y="{!r}" hdg="{!r}" length="{!r}">{}</geometry>'.format(
            begin, x, y, heading, length, shape))
        pose, begin = end(pose), begin + length
    return ''.join(elements), begin


def sample(rule='RHT', kinds=('line', 'spiral', 'arc', 'paramPoly3')):
    """The text of a file with one road of pieces of these kinds, in two lane sections."""
    cubic = ((0.0, 40.0, 0.0, 0.0), (0.0, 0.0, 12.0, -6.0))
    known = {
        'line': [(50.0, '<line/>', lambda pose: end_of(pose, 50.0, lambda share: 0.0))],
        'spiral': [(45.0, '<spiral curvStart="0" curvEnd="0.03"/>',
                    lambda pose: end_of(pose, 45.0, lambda share: 0.03 * share))],
        'arc': [(40.0, '<arc curvature="0.03"/>', lambda pose: end_of(pose, 40.0, lambda share: 0.03)),
                (60.0, '<spiral curvStart="0.03" curvEnd="-0.02"/>',
                 lambda pose: end_of(pose, 60.0, lambda share: 0.03 - 0.05 * share))],
        'paramPoly3': [(length_of_cubic(cubic), '<paramPoly3 pRange="normalized" {} {}/>'.format(
            *(' '.join('{}{}="{!r}"'.format(letter, axis, value) for letter, value in zip('abcd', values))
              for axis, values in zip('UV', cubic))), lambda pose: end_of_cubic(pose, cubic))],
    }
    geometry, length = plan([piece for kind in kinds for piece in known[kind]])
    half = length / 2
    width = lambda *coefficients: polynomial('width', 'sOffset', 0, *coefficients)  # noqa: E731
    steady, opening = width(3.5, 0, 0, 0), width(0, 0, 3 * 3.5 / half ** 2, -2 * 3.5 / half ** 3)
    lanes = ''.join((
        polynomial('laneOffset', 's', 0, 0.0, 0.0, 0.0, 0.0), polynomial('laneOffset', 's', 20, 0.0, 0.0, 1e-4, 0.0),
        section(0.0, [lane(1, 'driving', steady, successor=1), lane(2, 'sidewalk', width(2, 0, 0, 0), successor=2)],
                [lane(-1, 'driving', steady, successor=-1), lane(-2, 'shoulder', width(1, 0.005, 0, 0), successor=-3)]),
        section(half, [lane(1, 'driving', steady, predecessor=1), lane(2, 'sidewalk', width(2, 0, 0, 0), predecessor=2)],
                [lane(-1, 'driving', steady, predecessor=-1), lane(-2, 'driving', opening),
                 lane(-3, 'shoulder', width(1, 0, 0, 0), predecessor=-2)])))
    return ('<?xml version="1.0" encoding="UTF-8"?><OpenDRIVE><header revMajor="1" revMinor="6" name="sample" '
            'version="1" date="2020-01-01T00:00:00" north="0" south="0" east="0" west="0"/>'
            '<road name="sample" length="{!r}" id="1" junction="-1" rule="{}"><link/>'
            '<type s="0" type="town"><speed max="50" unit="km/h"/></type><planView>{}</planView>'
            '<elevationProfile/><lateralProfile/><lanes>{}</lanes></road></OpenDRIVE>').format(
                length, rule, geometry, lanes)
