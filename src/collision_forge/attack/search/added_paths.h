#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "collision_forge/attack/search/lane_paths.h"
#include "collision_forge/attack/search/options.h"
#include "collision_forge/attack/verify/believability.h"
#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/base/map/reference_path.h"
#include "collision_forge/base/scene/collision_request.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// The scene and request for which vehicles are added. Holds references: the referenced objects
/// must outlive it.
struct AddedVehicleInput {
  const Snapshot& snapshot;  ///< frames that methods observe, up to t0
  const Snapshot* past;      ///< Moment::past: all frames up to t0; null in live scenes
  const Future& future;      ///< ego and other agents from t0 on
  const CollisionRequest& request;
  const LaneIndex& lanes;  ///< the map

  /// Returns the lanes on which vehicles are added: drivenLanes().
  const LaneIndex& driven() const { return drivenLanes(request, lanes); }
  /// Returns the longest known history: `past`, or `snapshot` if that is null.
  const Snapshot& known() const { return past ? *past : snapshot; }
  /// Returns true in replay mode: the ego's future is recorded, not predicted.
  bool isFutureKnown() const { return future.ego_samples.empty(); }
};

/// Recorded motion of one vehicle along a path. Has at least two entries.
struct AddedFlow {
  std::vector<double> times;   ///< s after t0, increasing
  std::vector<double> alongs;  ///< m along the path, non-decreasing, one per time

  /// Returns true if `time` (s after t0) is within `times`.
  bool covers(double time) const { return time >= times.front() && time <= times.back(); }
  /// Returns m along the path at `time` (s after t0), linear between entries, constant beyond the
  /// ends.
  double at(double time) const;
  /// Returns the time (s after t0) at which the vehicle passes `along` (m), the last one if it
  /// stands there; empty if `along` is before the first or not before the last entry of `alongs`.
  std::optional<double> passing(double along) const;
};

/// A path along lanes to a place beside the ego, with the recorded traffic on it.
struct AddedPath {
  static constexpr double kStep = 0.1;  ///< s between the entries of `ego`
  /// m; a vehicle nearer to the path's middle is in its lane
  static constexpr double kInLane = 2.0;
  static constexpr double kMoving = 2.0;  ///< m/s; slower vehicles do not set traffic speeds
  /// m/s2, lateral acceleration in bends; 99 % of recorded cars stay below
  static constexpr double kLateral = 2.0;
  /// m/s2, deceleration before and acceleration after bends; 90 % of recorded cars stay below.
  static constexpr double kBraking = 1.4;

  /// `line`: m, map frame, in driving direction. AddedPaths sets the other fields.
  explicit AddedPath(const Polyline& line) : path(line) {}

  /// Returns the speed (m/s) that bends allow at `along` (m from the start), the entry of `caps` at
  /// or before it; constant beyond both ends. `caps` must be set.
  double cap(double along) const;

  ReferencePath path;
  /// m/s that bends allow, one per ReferencePath::kBendSpacing from the start
  std::vector<double> caps;
  std::vector<double> speeds;    ///< m/s of at most two recorded vehicles on it at t0
  std::vector<AddedFlow> flows;  ///< of at most three recorded vehicles that drive along it
  /// m along at which the ego was at t0, t0 - kStep, ..., as long as it drove along the path; empty
  /// if it does not do so at t0
  std::vector<double> ego;
  double ego_across = 0.0;  ///< m, left offset of the ego's box centre from the path at t0
};

/// Appends `speed` (m/s) to `speeds` unless an entry differs by less than 1 m/s.
void addSpeed(double speed, std::vector<double>& speeds);

/// Returns the number of steps of AddedPath::kStep from t0 back to the first frame of `past`,
/// rounded up. Its ego must have states.
std::size_t stepsBack(const Snapshot& past);

/// Builds the paths along which vehicles are added.
class AddedPaths {
 public:
  /// `input` and `options` must outlive this object.
  AddedPaths(const AddedVehicleInput& input, const AddedVehicleOptions& options);

  /// Returns at most four paths to a place on a lane of AddedVehicleInput::driven()
  /// (LanePaths::to()), straightest first, long enough for the fastest speed tried to be on them at
  /// the first frame (or from where the lanes begin), and to 40 m beyond the place. Built at the
  /// first call for a lane and kept: later calls for the same lane return the same paths, even for
  /// another place. The paths live as long as this object. Throws std::invalid_argument for a lane
  /// without a centreline.
  const std::vector<std::unique_ptr<AddedPath>>& to(const FittingLane& fitting);

 private:
  std::unique_ptr<AddedPath> wayOf(const Polyline& line) const;
  void addCaps(AddedPath& way) const;
  void followEgo(AddedPath& way) const;
  void addSpeeds(AddedPath& way) const;
  void addFlows(AddedPath& way) const;
  bool follow(const Track& track, const AddedPath& way, AddedFlow& flow) const;

  const AddedVehicleInput& input_;
  const AddedVehicleOptions& options_;
  const Snapshot& past_;
  std::size_t steps_back_;
  LanePaths ways_to_;
  std::map<std::size_t, std::vector<std::unique_ptr<AddedPath>>> ways_;  // by lane
};

}  // namespace forge
