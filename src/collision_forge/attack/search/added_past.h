#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "collision_forge/attack/search/added_drives.h"
#include "collision_forge/attack/search/added_paths.h"
#include "collision_forge/attack/search/options.h"
#include "collision_forge/attack/search/recorded_traffic.h"
#include "collision_forge/attack/search/track_driver.h"
#include "collision_forge/base/map/reference_path.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// Checks whether an added vehicle could have driven a motion in the recorded scene.
class AddedPast {
 public:
  /// `input` and `options` must outlive this object.
  AddedPast(const AddedVehicleInput& input, const AttackOptions& options);

  /// Drives the motion on `path` up to t0 within the limits of the class and size of `track`, which
  /// has no states, and appends its states at the recorded frames (box centres, global map frame,
  /// derived velocities) to it, from its first frame on. Requires that the vehicle exists since the
  /// first frame or appears outside the ego's view (live: is outside it at t0), keeps 0.3 m from
  /// all agents until t0, stays on its lane and on the road (unless parked, then outside junctions
  /// and not against the traffic), and touches no agent until 0.3 s before the contact. Returns
  /// null on success, else the reason, a string literal worded to follow a count ("no vehicle can
  /// be added: 3 REASON"). After a failure `track` is unspecified.
  const char* drive(const AddedDrive& drive, const ReferencePath& path, Track& track);

 private:
  bool touchesAhead(const AddedDrive& drive, const ReferencePath& path, const BoxSize& size) const;
  std::size_t clearSteps(const AddedDrive& drive, const ReferencePath& path,
                         const BoxSize& size) const;
  std::optional<std::size_t> firstFrame(const AddedDrive& drive, const ReferencePath& path,
                                        std::size_t clear) const;
  bool isUnseen(const AddedDrive& drive, const ReferencePath& path, double ago) const;
  const char* driveFrom(std::size_t frame, const AddedDrive& drive, const ReferencePath& path,
                        Track& track);
  bool facesTraffic(const Pose2& pose) const;
  bool isInJunction(const Pose2& pose) const;

  const AddedVehicleInput& input_;
  const AttackOptions& options_;
  const AddedVehicleOptions& added_;
  const Snapshot& past_;
  std::size_t steps_back_;
  RecordedTraffic traffic_;
  std::vector<PlannedStep> planned_;
  std::vector<TrajectoryPoint> points_;
};

}  // namespace forge
