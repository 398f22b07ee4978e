#pragma once

#include <functional>
#include <string>
#include <vector>

#include "collision_forge/attack/search/options.h"
#include "collision_forge/attack/search/recorded_traffic.h"
#include "collision_forge/attack/verify/visibility.h"
#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// An attack for which support vehicles are sought: vehicles that hide its attacker, or one that
/// stands ahead of it. Holds references: the referenced objects must outlive it.
struct HidingInput {
  const AttackerTrajectory& attacker;  ///< the attack's motion; must have points
  double contact = 0.0;                ///< s, scene clock: contact of attacker and ego
  const Future& future;    ///< of the ego that the attacker hits and of the recorded agents
  const Snapshot& past;    ///< recorded frames up to t0; support vehicles must fit into these, too
  const LaneIndex& lanes;  ///< the map
  Range visible_for;  ///< s, requested time from the first sight of the attacker to contact; not
                      ///< read for a vehicle ahead of the attacker
};

/// Returns the motion of a support vehicle of this id and kind that stands at `pose` (map frame)
/// from the first frame of `input.past` to the end of the attacker's motion.
AttackerTrajectory standingVehicle(const std::string& id, const AddedKind& kind, const Pose2& pose,
                                   const HidingInput& input);

/// When the attacker comes into view until the contact, and how long it was hidden right before.
struct Hiding {
  /// s from then to the contact; since t0 if it was never hidden, 0 if it is hidden to the end
  double visible_for = 0.0;
  /// number of consecutive steps of kSightStep right before that in which less than kSeenShare is
  /// in view; 0: never hidden
  int hidden = 0;
};

/// m; least distance between support vehicles and all agents but the ego.
inline constexpr double kSupportClearance = 0.3;

/// Tests whether support vehicles hide an attacker; shared by all searches for them. Immutable.
class HidingSearch {
 public:
  /// Adds the blocks of support vehicles at a time (s, scene clock) to a list.
  using AddBlocks = std::function<void(double, std::vector<Block>&)>;

  /// `input` must outlive this object.
  explicit HidingSearch(const HidingInput& input);

  /// Returns how the recorded agents and the blocks that `add` appends hide the attacker. `add` is
  /// called for steps of kSightStep from t0 to before the contact, latest first, until the answer
  /// is known; steps without an ego state are left out.
  Hiding hidingBy(const AddBlocks& add) const;

  /// Returns true if the attacker is hidden for at least 0.3 s and comes into view within the
  /// input's range.
  bool isInRange(const Hiding& hiding) const;

  /// Returns true if the block (map frame), standing there, hides the attacker by itself at a step
  /// within the input's range before the contact, or at most two steps earlier.
  bool mayHide(const Block& block) const;

  /// Returns the motion of all agents with the attacker, and of the ego up to t0, every 0.2 s from
  /// the first frame to the end of the ego's future or of the attack.
  const RecordedTraffic& traffic() const { return traffic_; }

  /// Returns true if the whole box is on the drivable area, and no part on a walkway.
  bool isOnRoad(const OrientedBox& box) const;

  /// Returns an id "PREFIX-N" that no agent of HidingInput::past or future has, with the smallest
  /// such N greater than `number`.
  std::string newId(const std::string& prefix, std::size_t number) const;

 private:
  /// The boxes at one time.
  struct Look {
    double time;
    Vector2 from;
    Block target;
    std::vector<Block> others;
  };
  void observe();

  const HidingInput& input_;
  RecordedTraffic traffic_;
  std::vector<Look> looks_;  // every kSightStep from t0 to before the contact
};

}  // namespace forge
