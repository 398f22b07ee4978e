#pragma once

#include <collision_forge/Attack.h>
#include <collision_forge/AttackRequest.h>
#include <collision_forge/CollisionReport.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "collision_forge/attack/verify/options.h"
#include "collision_forge/base/scene/scene.h"
#include "collision_forge/io/lidar/options.h"
#include "collision_forge/io/logs/options.h"
#include "collision_forge/ros/injection/after_contact.h"

namespace forge {

/// The lidar clouds that show the attack.
struct LidarRequest {
  std::vector<std::string> topics;  ///< topics of the clouds with leading slash; or kAllClouds
  LidarOptions options;
  std::uint64_t seed = 0;  ///< of the noise, of lost returns and of the vehicles' brightness
};

/// The attack to insert into a bag.
struct BagAttack {
  collision_forge::Attack attack;                  ///< with a trajectory; header stamp: t0
  collision_forge::CollisionReport tested_report;  ///< outcome against the recorded ego
  collision_forge::AttackRequest request;          ///< as attackRequest() returns it
  AfterContact after_contact = AfterContact::kStop;
  std::optional<LidarRequest> lidar;  ///< empty: clouds are copied
};

/// Properties of the recording in a bag and of its vehicles. References must outlive
/// injectIntoBag().
struct RecordingContext {
  const Track& ego;      ///< recorded track (box centres, map frame, clock of the header stamps)
  double center_offset;  ///< m, as in EgoVehicle
  const VerificationOptions& verification;
  const AttackedBagOptions& options;
};

/// Throws BagError with the topic if the bag at `path` already has an attack (a message on /attack,
/// /tested_report, /attack_request, /attack_path, /attack_ego_path or /attack_markers), and if the
/// bag cannot be read; else does nothing.
void requireNoAttack(const std::string& path);

}  // namespace forge
