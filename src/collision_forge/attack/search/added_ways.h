#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "collision_forge/attack/search/lane_ways.h"
#include "collision_forge/attack/search/options.h"
#include "collision_forge/attack/verify/believability.h"
#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/base/map/reference_path.h"
#include "collision_forge/base/scene/collision_request.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// What vehicles are added to.
struct AddedVehicleInput {
  const Snapshot& snapshot;
  const Snapshot* past;  ///< Moment::past; null live
  const Future& future;
  const CollisionRequest& request;
  const LaneIndex& lanes;

  /// Those that vehicles are added on.
  const LaneIndex& driven() const { return drivenLanes(request, lanes); }
  /// All that is known up to now.
  const Snapshot& known() const { return past ? *past : snapshot; }
  /// The ego's future is, rather than predicted.
  bool isFutureKnown() const { return future.ego_samples.empty(); }
};

/// Where somebody is along a way. It has two entries at least.
struct AddedFlow {
  std::vector<double> times;   ///< s from now, rising
  std::vector<double> alongs;  ///< m, never falling; one a time

  bool covers(double time) const { return time >= times.front() && time <= times.back(); }
  /// m along the way, linear between the entries; the ends beyond them.
  double at(double time) const;
  /// When it passes a place, s from now; empty where it does not move past it.
  std::optional<double> passing(double along) const;
};

/// A way along lanes to a place beside the ego, and who drove along it.
struct AddedWay {
  static constexpr double kStep = 0.1;     ///< s
  static constexpr double kInLane = 2.0;   ///< m from the middle of a way: in its lane
  static constexpr double kMoving = 2.0;   ///< m/s; slower vehicles tell no speed of the traffic
  static constexpr double kLateral = 2.0;  ///< m/s2 in bends; 99 % of recorded cars stay below
  /// m/s2 before and after bends; 90 % of recorded cars stay below.
  static constexpr double kBraking = 1.4;

  explicit AddedWay(const Polyline& line) : path(line) {}

  /// m/s that bends allow at a place, m along; beyond the way as at its end.
  double cap(double along) const;

  ReferencePath path;
  std::vector<double> caps;      ///< m/s in bends, an entry every ReferencePath::kBendSpacing
  std::vector<double> speeds;    ///< m/s, of vehicles that are on it now
  std::vector<AddedFlow> flows;  ///< of vehicles that drive along it, now or then
  std::vector<double> ego;  ///< m along it that the ego was now, kStep before, ...; while it was
  double ego_across = 0.0;  ///< m to the left of its middle that the ego is now
};

/// Adds a speed (m/s) to those that differ by 1 m/s or more; nothing if one of them is nearer.
void addSpeed(double speed, std::vector<double>& speeds);

/// The steps of AddedWay::kStep back from now that reach the first frame of a snapshot.
std::size_t stepsBack(const Snapshot& past);

/// Makes the ways that lead to lanes.
class AddedWays {
 public:
  /// All must outlive it.
  AddedWays(const AddedVehicleInput& input, const AddedVehicleOptions& options);

  /// The ways to a place on a lane, LaneWays::to(), so long that the fastest that is tried was on
  /// it at the first frame. They are made when the lane is first asked for and stay where they are;
  /// asked for again, they are those to the first place. Throws std::invalid_argument for a lane
  /// without a centreline.
  const std::vector<std::unique_ptr<AddedWay>>& to(const FittingLane& fitting);

 private:
  std::unique_ptr<AddedWay> wayOf(const Polyline& line) const;
  void addCaps(AddedWay& way) const;
  void followEgo(AddedWay& way) const;
  void addSpeeds(AddedWay& way) const;
  void addFlows(AddedWay& way) const;
  bool follow(const Track& track, const AddedWay& way, AddedFlow& flow) const;

  const AddedVehicleInput& input_;
  const AddedVehicleOptions& options_;
  const Snapshot& past_;
  std::size_t steps_back_;
  LaneWays ways_to_;
  std::map<std::size_t, std::vector<std::unique_ptr<AddedWay>>> ways_;  // by lane
};

}  // namespace forge
