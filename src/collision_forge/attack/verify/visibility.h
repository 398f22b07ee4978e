#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collision_forge/base/geometry/oriented_box.h"
#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// The attacker counts as seen if at least this share of its angular width is in view: nuScenes'
/// lowest level of visibility is 0 to 40 %.
inline constexpr double kSeenShare = 0.4;
inline constexpr double kSightStep = 0.1;  ///< s between the times at which sightOf() looks

/// m above the ground from which the ego looks: the front camera of nuScenes' car.
inline constexpr double kEyeHeight = 1.5;
/// m; an agent counts as seen above a lower one if this much of its top is in view: a head.
inline constexpr double kHeadHeight = 0.2;

/// A box on flat ground with a height.
struct Block {
  OrientedBox box;
  double height = 0.0;  ///< m
};
/// Returns the agent's block at `pose`, with its typical height if its own is unknown.
Block blockAt(const Track& agent, const Pose2& pose);

/// The part of a box that an observer at a point sees.
struct BoxView {
  double visible = 1.0;  ///< share 0..1 of the angle under which the box appears
  /// Index into `others` of viewOf() of the box that covers most of the target; empty if none
  /// covers any.
  std::optional<std::size_t> coverer;
};

/// Returns the view from `from` (m, map frame) of `target` among `others`. Blocks are opaque, on
/// the ground plane and apart from each other. One of `others` that contains `from` covers nothing,
/// nor does one over whose roof an eye at kEyeHeight above `from` sees the upper kHeadHeight of
/// `target`; this is tested in the middle of the angle that both share. A target that contains
/// `from` is wholly visible. Exact apart from that: unites the angles that the boxes before
/// `target` cover.
BoxView viewOf(const Vector2& from, const Block& target, const std::vector<Block>& others);

/// Since when the ego sees the attacker.
struct Sight {
  /// s, clock of the trajectory: from then on the attacker is seen at every step until the contact;
  /// t0 if always, the contact if it is hidden at the last step.
  double seen_from = 0.0;
  /// Agent that covered most of the attacker one step before; empty if it was seen since t0.
  std::string hidden_by_id = {};
  /// Kind of that agent if it is a vehicle: kParkedVehicle if it moves at most 0.5 m between t0 and
  /// the contact, kLeader if it moves more and its heading is within 45 degrees of the ego's. Empty
  /// for any other agent.
  std::optional<Hider> hidden_by = {};
};

/// Looks from the middle of the ego's box at the attacker every kSightStep from t0, the time of the
/// first point, up to before `contact` (s, same clock). All agents of `future` but the attacker can
/// hide it. Times without an ego state count as seen. Neither the trajectory nor the ego's track
/// may be empty.
Sight sightOf(const AttackerTrajectory& trajectory, const Future& future, double contact);

}  // namespace forge
