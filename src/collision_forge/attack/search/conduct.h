#pragma once

#include <memory>
#include <vector>

#include "collision_forge/attack/search/options.h"
#include "collision_forge/attack/search/search_task.h"

namespace forge {

/// Where an attacker moves until the contact.
struct RoadVerdict {
  RoadUse road;
  bool is_believable = true;  ///< `road` is plausible, or need not be
};

/// How attackers of a kind move until the contact: vehicles drive on lanes, pedestrians walk beside
/// the road and step out.
class Conduct {
 public:
  virtual ~Conduct() = default;
  /// Returns times, s before the contact, at which an attacker that stands `distance` m before the
  /// meeting moves off.
  virtual std::vector<double> startsBefore(double distance) const = 0;
  /// Judges the motion `points` of a box of size `size` up to the contact (s, snapshot's clock).
  virtual RoadVerdict judge(const std::vector<TrajectoryPoint>& points, const BoxSize& size,
                            double contact) const = 0;
  /// Returns the cost of leaving the lane `departure` s before the contact, as a share of the
  /// futures.
  virtual double departureCost(double departure) const = 0;
};

/// Returns the conduct of the class. `input` and `options` must outlive it.
std::unique_ptr<const Conduct> conductOf(AgentClass agent_class, const SearchInput& input,
                                         const VerificationOptions& options);

}  // namespace forge
