#!/usr/bin/env python3
"""usage: export_planner.py OUT.pt: export a TorchScript planner for forge test, with any torch of PyPI.

The planner follows the route at its current speed and stops behind the nearest vehicle ahead. Inputs and outputs:
docs/learned_planner.md. Export a trained network in the same way.
"""
import sys

import torch


class FollowRoute(torch.nn.Module):
    """Inputs and output are in the current ego frame: metres, radians, x forward, y left."""

    def forward(self, ego_history, agents, agents_mask, lanes, lanes_mask, route):
        now = agents[:, -1]  # x, y, yaw, vx, vy, length, width, kind
        is_ahead = (agents_mask[:, -1] > 0.5) & (now[:, 0] > 0.0) & (now[:, 1].abs() < 2.0)
        far = torch.full_like(now[:, 0], 1000.0)
        gap = torch.where(is_ahead, now[:, 0] - 0.5 * now[:, 5], far).min() - 5.0
        times = 0.1 * torch.arange(1, 81, device=route.device).float()  # eighty poses
        along = torch.minimum(ego_history[-1, 3] * times, gap.clamp(min=0.0))
        return self.on_route(route, along)

    def on_route(self, route, along):
        """Return the poses at arc lengths `along` (m) of the route, points 2 m apart; the last pose beyond its end."""
        place = (along / 2.0).clamp(0.0, float(route.shape[0] - 1) - 0.001)
        before = place.floor().long()
        share = (place - before.float()).unsqueeze(1)
        start = route[before]
        turn = route[before + 1] - start
        half = 3.14159265
        yaw = torch.remainder(turn[:, 2:] + half, 2.0 * half) - half
        return start + share * torch.cat([turn[:, :2], yaw], 1)


def main(path):
    planner = torch.jit.script(FollowRoute().eval())
    planner.save(path)
    print('{}: exported with torch {}'.format(path, torch.__version__))


if __name__ == '__main__':
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
