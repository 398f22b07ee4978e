#pragma once

#include <collision_forge/Attack.h>
#include <collision_forge/AttackRequest.h>
#include <collision_forge/CollisionReport.h>

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "collision_forge/attack/verify/options.h"
#include "collision_forge/base/scene/scene.h"
#include "collision_forge/io/lidar/options.h"
#include "collision_forge/io/logs/options.h"

namespace forge {

/// Content of an attacked bag after the contact with the recorded ego.
enum class AfterContact {
  kStop,  ///< both move by PostCrashMotion; /tf and odom are rewritten; the bag ends when both have
          ///< stood for AttackedBagOptions::seconds_after_stand
  kEnd,   ///< the bag ends shortly after
  kDriveOn,  ///< the ego moves as recorded, the attacker by its whole trajectory
};

/// Returns "stop", "end" or "drive_on".
const char* toString(AfterContact after);

/// Parses the value for a live replay, whose end cannot be set: kStop or kDriveOn. Throws
/// std::invalid_argument for any other word, with both in the message.
AfterContact liveAfterContact(const std::string& word);

/// The lidar clouds that show the attack.
struct LidarRequest {
  std::vector<std::string> topics;  ///< or kAllClouds
  LidarOptions options;
  std::uint64_t seed = 0;
};

/// The attack to insert into a bag.
struct BagAttack {
  collision_forge::Attack attack;
  collision_forge::CollisionReport tested_report;  ///< outcome against the recorded ego
  collision_forge::AttackRequest request;
  AfterContact after_contact = AfterContact::kStop;
  std::optional<LidarRequest> lidar;  ///< empty: clouds are copied
};

/// One line each.
struct InjectionNotes {
  std::vector<std::string> warnings;  ///< per topic with values that were left out or not changed
  std::vector<std::string> lidar;     ///< what was changed in the clouds
  std::vector<std::string> cameras;   ///< boxes on the pictures of each camera
};

/// Properties of the recording in a bag and of its vehicles.
struct RecordingContext {
  const Track& ego;      ///< recorded track
  double center_offset;  ///< m, as in EgoVehicle
  const VerificationOptions& verification;
  const AttackedBagOptions& options;
};

/// Throws BagError with the topic if the bag at `path` already has an attack.
void requireNoAttack(const std::string& path);

/// Copies the bag at `in`, which must not contain an attack, to `out` and inserts `attack`:
/// - /agents, /annotation_markers: the attacker replaces its recorded future (an added attacker is
///   present from the first state of its past). After t0 there are additional frames, with caller
///   id names::kInBetween, and one at the contact.
/// - Attack, request and the paths of attacker and recorded ego: added, latched, at t0.
/// - Report against the recording: added at the contact, or at the end of the trajectory.
/// - Markers of map (every second), ego and attack: added.
/// - /agent_objects: written with every frame of agents; replaces an existing topic.
/// - /tf, odom: rewritten after the contact if `after_contact` is kStop; one message is added at
///   the contact.
/// - Clouds of `lidar`: show the attacker and not its recorded place (LidarInjection). With a
///   contact, sensors_match_until has its stamp: the ego's sensors do not feel the crash.
/// - attack_box beside each camera_info: box of the attacker on the pictures (CameraBoxes), until
///   the contact if `after_contact` is kStop. Pictures are copied.
/// All other messages are copied byte by byte with their connections. Non-finite agents, transforms
/// and odometry are dropped (ros/injection/finite_parts.h). `on_progress` receives the completed
/// share 0..1. Throws BagError.
///
/// All times are header stamps; the record times may be of another clock. A new message gets the
/// record time of a frame of agents with its stamp (RecordClock); a copied one keeps its own.
/// Messages without agents or ego end at the record time of the last frame of agents.
InjectionNotes injectIntoBag(
    const std::string& in, const std::string& out, const BagAttack& attack,
    const RecordingContext& recording,
    const std::function<void(double)>& on_progress = [](double) {});

}  // namespace forge
