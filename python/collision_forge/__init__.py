"""Client of the running collision_forge suite, which turns safe driving logs into collision scenarios; see
docs/python.md."""
from collision_forge.client import AdaptiveAttack, CollisionForge
from collision_forge.errors import Code, Declined, ForgeError, NotReady, Unavailable
from collision_forge.player import Player
from collision_forge.results import (Agent, Answer, Attack, Contact, Effect, PlannerContact, PlannerOutcome, Point,
                                     Pose, PossibleCollision, Report, Scene)

__all__ = ['AdaptiveAttack', 'Agent', 'Answer', 'Attack', 'Code', 'CollisionForge', 'Contact', 'Declined', 'Effect',
           'ForgeError', 'NotReady', 'Player', 'PlannerContact', 'PlannerOutcome', 'Point', 'Pose', 'PossibleCollision',
           'Report', 'Scene', 'Unavailable']
