#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "collision_forge/attack/search/added_drives.h"
#include "collision_forge/attack/search/added_ways.h"
#include "collision_forge/attack/search/options.h"
#include "collision_forge/attack/search/recorded_traffic.h"
#include "collision_forge/attack/search/track_driver.h"
#include "collision_forge/base/map/reference_path.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// Tells whether somebody could have come along a drive in the scene as it was recorded.
class AddedPast {
 public:
  /// All must outlive it.
  AddedPast(const AddedVehicleInput& input, const AttackOptions& options);

  /// Drives until now as planned, within the limits of the track's class and size. The track gets
  /// its states at the frames from its first to now, global map frame. It was there at the first
  /// frame or came out of sight of the ego, touched nobody, and touches nobody until shortly before
  /// the contact. Null, or why nobody can have come so, in words that go on from "no
  /// vehicle can be added: 3 "; then the track is of no use.
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
