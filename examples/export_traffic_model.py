#!/usr/bin/env python3
"""usage: export_traffic_model.py OUT.pt: export a TorchScript traffic model for forge test --background model:OUT.pt.

Agents keep their heading; vehicles brake for the ego or the agent ahead by the intelligent driver model (IDM). Inputs
and output: docs/learned_planner.md. Export a trained network in the same way, with any torch of PyPI.
"""
import sys

import torch


class FollowAhead(torch.nn.Module):
    """Poses are in the current frame of the ego: metres, radians, x forward, y left."""

    def forward(self, ego_history, agents, agents_mask, lanes, lanes_mask, step):
        now = agents[:, -1]  # x, y, yaw, vx, vy, length, width, kind
        heading = torch.stack([torch.cos(now[:, 2]), torch.sin(now[:, 2])], 1)
        speed = (now[:, 3:5] * heading).sum(1).clamp(min=0.0)
        still = torch.zeros(1)  # the ego is the last of the possible leads
        places = torch.cat([now[:, 0:2], torch.zeros([1, 2])])
        velocities = torch.cat([now[:, 3:5], torch.stack([ego_history[-1, 3:4], still], 1)])
        offset = places.unsqueeze(0) - now[:, 0:2].unsqueeze(1)
        along = (offset * heading.unsqueeze(1)).sum(2)
        across = offset[:, :, 1] * heading[:, 0:1] - offset[:, :, 0] * heading[:, 1:2]
        is_there = torch.cat([agents_mask[:, -1], still + 1.0]).unsqueeze(0) > 0.5
        is_ahead = is_there & (along > 0.5) & (across.abs() < 2.0)
        gap, lead = torch.where(is_ahead, (along - 5.0).clamp(min=0.5), torch.full_like(along, 1000.0)).min(1)
        closing = speed - (velocities[lead] * heading).sum(1)
        wanted = (2.0 + 1.5 * speed + speed * closing / 3.46).clamp(min=0.0)  # IDM: 2 m, 1.5 s, 1 and 3 m/s2
        braking = torch.where(now[:, 7] < 1.5, (wanted / gap) ** 2, torch.zeros_like(gap))
        after = (speed - step * braking).clamp(min=0.0)
        return torch.cat([now[:, 0:2] + step * after.unsqueeze(1) * heading, now[:, 2:3]], 1)


def main(path):
    torch.jit.script(FollowAhead().eval()).save(path)
    print('{}: exported with torch {}'.format(path, torch.__version__))


if __name__ == '__main__':
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
