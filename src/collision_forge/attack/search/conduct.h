#pragma once

#include <memory>
#include <vector>

#include "collision_forge/attack/search/options.h"
#include "collision_forge/attack/search/search_task.h"

namespace forge {

/// Road use of an attacker until the contact, and whether it is acceptable.
struct RoadVerdict {
  RoadUse road;               ///< as roadUseOfAttack(); of a person on foot, and of a vehicle that
                              ///< reverses, only on_lane = 1 is set
  bool is_believable = true;  ///< the motion is plausible, or the request does not require it
};

/// How attackers of a kind move until the contact: vehicles drive on lanes or reverse out of a bay,
/// people on foot walk beside the road and step out. Immutable.
class Conduct {
 public:
  virtual ~Conduct() = default;
  /// Returns times, s before the contact (three, none negative), at which an attacker that stands
  /// `distance` m along its path before the meeting may start to move; for vehicles that drive
  /// forward they do not depend on `distance`.
  virtual std::vector<double> startsBefore(double distance) const = 0;
  /// Judges the motion `points` (box centres, from its first point) of a box of size `size` up to
  /// the contact (s, scene clock).
  virtual RoadVerdict judge(const std::vector<TrajectoryPoint>& points, const BoxSize& size,
                            double contact) const = 0;
  /// Returns the cost of leaving the lane `departure` s before the contact, as a share of the
  /// futures: 0 up to BelievabilityOptions::before_contact, then 0.2 per s; always 0 for
  /// people on foot and vehicles that reverse.
  virtual double departureCost(double departure) const = 0;
};

/// Returns the conduct of the class. `input` and `options` must outlive it. Never null.
std::unique_ptr<const Conduct> conductOf(AgentClass agent_class, const SearchInput& input,
                                         const VerificationOptions& options);

}  // namespace forge
