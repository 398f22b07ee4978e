"""The scenes and the routes of their ego cars."""
from dataclasses import dataclass

SCENE_STEPS = 200        # 20 s of 0.1 s steps; 201 poses
KEYFRAME_STEPS = 5       # 2 Hz


@dataclass(frozen=True)
class SceneSpec:
    """A drive along a route; halfway through, the ego car passes the landmark."""
    name: str
    location: str
    description: str
    route: tuple
    landmark: tuple      # in the right-hand town's coordinates


SCENES = (
    SceneSpec("scene-0001", "embedded-right",
              "signalised four-way junction, straight on, right-hand traffic",
              ("W_S", "S_E"), (650.0, 600.0)),
    SceneSpec("scene-0002", "embedded-right",
              "signalised four-way junction, left turn, right-hand traffic",
              ("D_S", "S_W"), (650.0, 600.0)),
    SceneSpec("scene-0003", "embedded-right",
              "unsignalised four-way junction, right turn, right-hand traffic",
              ("C_T", "U_N"), (650.0, 850.0)),
    SceneSpec("scene-0004", "embedded-right",
              "T-junction, right turn into the side road, right-hand traffic",
              ("Ae_U", "T_TS"), (880.0, 850.0)),
    SceneSpec("scene-0005", "embedded-right",
              "multi-lane road, three lanes each way, right-hand traffic",
              ("E_S", "S_W"), (800.0, 600.0)),
    SceneSpec("scene-0006", "embedded-right",
              "curve, right-hand traffic",
              ("C_T", "T_U"), (1006.8, 863.2)),
    SceneSpec("scene-0007", "embedded-left",
              "roundabout, straight across, left-hand traffic",
              ("U_Ae", "Aw_RW"), (400.0, 870.0)),
    SceneSpec("scene-0008", "embedded-left",
              "signalised four-way junction, straight on from a multi-lane road, left-hand traffic",
              ("E_S", "S_W"), (650.0, 600.0)),
    SceneSpec("scene-0009", "embedded-left",
              "unsignalised four-way junction, straight on, left-hand traffic",
              ("Ae_U", "U_T"), (650.0, 850.0)),
    SceneSpec("scene-0010", "embedded-left",
              "two-way road with parked cars, one lane each way, left-hand traffic",
              ("T_U", "U_Ae"), (560.0, 850.0)),
)


def ego_routes(location):
    """Return the (from, to) routes of ego candidates in a town."""
    return sorted({scene.route for scene in SCENES if scene.location == location})
