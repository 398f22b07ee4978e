"""Turns safe driving logs into collision scenarios: a client of the running suite, told of in docs/python.md."""
from collision_forge.client import AdaptiveAttack, CollisionForge
from collision_forge.errors import Code, Declined, ForgeError, NotReady, Unavailable
from collision_forge.player import Player
from collision_forge.results import (Agent, Answer, Attack, Contact, PlannerContact, PlannerOutcome, Point, Pose,
                                     PossibleCollision, Report, Scene)

__all__ = ['AdaptiveAttack', 'Agent', 'Answer', 'Attack', 'Code', 'CollisionForge', 'Contact', 'Declined', 'ForgeError',
           'NotReady', 'Player', 'PlannerContact', 'PlannerOutcome', 'Point', 'Pose', 'PossibleCollision', 'Report',
           'Scene', 'Unavailable']
