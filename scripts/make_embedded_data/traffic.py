"""The traffic of a town as a SUMO route file: vehicle types, trips and walks."""
import random
from dataclasses import dataclass

WARM_UP = 120.0     # seconds before anything is recorded
RECORDED = 420.0    # seconds recorded


@dataclass(frozen=True)
class Kind:
    """A road user's body and its nuScenes category. Lengths are in metres."""
    category: str
    sumo_class: str
    length: float
    width: float
    height: float
    rear_overhang: float
    wheelbase: float
    max_speed: float
    accel: float = 2.2
    decel: float = 3.5


EGO = "ego"
PEDESTRIAN = "pedestrian"
PARKED = "parked"       # prefix of the names of parked cars
KINDS = {
    EGO: Kind("vehicle.car", "passenger", 4.084, 1.730, 1.562, 0.657, 2.588, 20.0),
    "car_small": Kind("vehicle.car", "passenger", 4.21, 1.77, 1.49, 0.75, 2.58, 20.0, 2.4),
    "car_compact": Kind("vehicle.car", "passenger", 4.43, 1.80, 1.46, 0.88, 2.66, 20.0, 2.4),
    "car_estate": Kind("vehicle.car", "passenger", 4.68, 1.83, 1.51, 1.02, 2.73, 20.0),
    "car_saloon": Kind("vehicle.car", "passenger", 4.87, 1.85, 1.45, 1.10, 2.83, 20.0),
    "car_suv": Kind("vehicle.car", "passenger", 4.72, 1.93, 1.71, 0.98, 2.79, 20.0),
    "truck_box": Kind("vehicle.truck", "truck", 7.40, 2.40, 3.20, 1.90, 4.10, 18.0, 1.4),
    "truck_long": Kind("vehicle.truck", "truck", 9.60, 2.50, 3.60, 2.50, 5.40, 18.0, 1.2),
    "bus_city": Kind("vehicle.bus.rigid", "bus", 11.95, 2.55, 3.10, 3.30, 5.90, 18.0, 1.2),
    "bus_midi": Kind("vehicle.bus.rigid", "bus", 11.00, 2.60, 3.05, 3.00, 5.40, 18.0, 1.2),
    "bicycle": Kind("vehicle.bicycle", "bicycle", 1.70, 0.60, 1.70, 0.33, 1.04, 5.5, 1.0, 2.5),
    PEDESTRIAN: Kind("human.pedestrian.adult", "pedestrian", 0.70, 0.70, 1.75, 0.0, 0.0, 1.4),
}
MIX = (("car_small", 18), ("car_compact", 20), ("car_estate", 16), ("car_saloon", 14),
       ("car_suv", 15), ("truck_box", 6), ("truck_long", 4), ("bus_city", 4), ("bus_midi", 3))

# From, to, vehicles an hour for each lane of the arterial.
ARTERIAL_DEMAND = (("W_S", "S_E", 430), ("E_S", "S_W", 430))
# From, to, vehicles an hour.
DEMAND = (
    ("W_S", "S_D", 100), ("W_S", "S_U", 90), ("E_S", "S_D", 90), ("E_S", "S_U", 110),
    ("D_S", "S_U", 170), ("D_S", "S_W", 90), ("D_S", "S_E", 90),
    ("N_U", "U_S", 130), ("N_U", "U_T", 60), ("N_U", "U_Ae", 60),
    ("RW_Aw", "U_T", 200), ("RW_Aw", "T_C", 160), ("RW_Aw", "U_N", 70), ("RW_Aw", "As_RS", 70),
    ("RN_An", "As_RS", 110), ("RN_An", "T_C", 120), ("RN_An", "Aw_RW", 90),
    ("RS_As", "An_RN", 110), ("RS_As", "T_C", 90), ("RS_As", "Aw_RW", 90),
    ("C_T", "Aw_RW", 270), ("C_T", "An_RN", 110), ("C_T", "U_S", 60), ("C_T", "T_TS", 90),
    ("TS_T", "Aw_RW", 90), ("TS_T", "T_C", 80),
)
BICYCLE_DEMAND = (("W_S", "S_E", 150), ("E_S", "S_W", 150), ("RW_Aw", "T_C", 12),
                  ("N_U", "U_S", 12), ("C_T", "U_N", 8))
WALK_DEMAND = (("W_S", "S_U", 100), ("W_S", "S_D", 100), ("E_S", "S_D", 100), ("S_U", "U_N", 120),
               ("N_U", "U_S", 120), ("S_W", "S_E", 100), ("S_D", "S_U", 60), ("E_S", "S_W", 60))
EGO_PERIOD = 24.0   # seconds between ego candidates on one route


def vehicle_types():
    """Yield SUMO's vType elements, one for each kind."""
    for name, kind in KINDS.items():
        motion = f'maxSpeed="{kind.max_speed}"'
        if name != PEDESTRIAN:
            motion += (f' accel="{kind.accel}" decel="{kind.decel}" emergencyDecel="7" '
                       f'sigma="0.1" tau="1.1" minGap="2.0" jmTimegapMinor="1.5"')
        yield (f'<vType id="{name}" vClass="{kind.sumo_class}" length="{kind.length}" '
               f'width="{kind.width}" {motion}/>')


def departures(rng, per_hour):
    """Yield departure times of a flow: a constant period with random shifts of up to a quarter."""
    period = 3600.0 / per_hour
    time = rng.uniform(0.0, period)
    while time < WARM_UP + RECORDED:
        yield round(time + rng.uniform(-0.25, 0.25) * period, 1)
        time += period


def pick_kind(rng):
    return rng.choices([name for name, _ in MIX], [weight for _, weight in MIX])[0]


def vehicle_trips(town, rng):
    """Yield (departure, kind, from, to) of all vehicles but the ego candidates."""
    demand = [(a, b, n * town.arterial_lanes) for a, b, n in ARTERIAL_DEMAND] + list(DEMAND)
    for start, end, per_hour in demand:
        for time in departures(rng, per_hour):
            yield time, pick_kind(rng), start, end
    for start, end, per_hour in BICYCLE_DEMAND:
        for time in departures(rng, per_hour):
            yield time, "bicycle", start, end


def traffic_xml(town, ego_routes):
    """Return the route file. Ego candidates are named ego:FROM:TO:NUMBER."""
    rng = random.Random(town.seed)
    rows = []
    for number, (time, kind, start, end) in enumerate(vehicle_trips(town, rng)):
        rows.append((max(time, 0.0), f"v{number}", kind, start, end))
    for index, (start, end) in enumerate(ego_routes):
        count = int((WARM_UP + RECORDED) / EGO_PERIOD)
        for number in range(count):
            time = round(number * EGO_PERIOD + 5.0 * (index % 4), 1)
            rows.append((time, f"ego:{start}:{end}:{number}", EGO, start, end))
    elements = [(time, f'<trip id="{name}" type="{kind}" depart="{time}" from="{start}" '
                       f'to="{end}" departLane="best" departSpeed="max" departPos="base"/>')
                for time, name, kind, start, end in rows]
    for index, (start, end, per_hour) in enumerate(WALK_DEMAND):
        for number, time in enumerate(departures(rng, per_hour)):
            time = max(time, 0.0)
            elements.append((time, f'<person id="p{index}.{number}" type="{PEDESTRIAN}" '
                                   f'depart="{time}" departPos="{rng.uniform(20, 200):.1f}">'
                                   f'<walk from="{start}" to="{end}"/></person>'))
    elements.sort()
    return "\n".join(["<routes>", *vehicle_types(), *(row for _, row in elements), "</routes>", ""])
