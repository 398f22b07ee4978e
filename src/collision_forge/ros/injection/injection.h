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

/// Content of an attacked bag after the contact with the recorded ego. Without such a contact each
/// value means the content of kDriveOn.
enum class AfterContact {
  kStop,     ///< ego and attacker move by PostCrashMotion; /tf and odom are rewritten; the bag ends
             ///< when both have stood for AttackedBagOptions::seconds_after_stand
  kEnd,      ///< the bag ends AttackedBagOptions::end_time after the contact
  kDriveOn,  ///< the ego moves as recorded, the attacker by its whole trajectory, then it brakes;
             ///< the bag ends like the recording
};

/// Returns "stop", "end" or "drive_on".
const char* toString(AfterContact after);

/// Parses the value for a live replay, whose end cannot be set: kStop or kDriveOn. Throws
/// std::invalid_argument for any other word, with both in the message.
AfterContact liveAfterContact(const std::string& word);

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

/// Lines for the user.
struct InjectionNotes {
  std::vector<std::string> warnings;  ///< one per topic and kind of values left out or not changed
  std::vector<std::string> lidar;     ///< LidarInjection::summary(); empty without `lidar`
  std::vector<std::string> cameras;   ///< CameraBoxes::summary(); empty without cameras
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

/// Copies the bag at `in`, which must not contain an attack, to `out` and inserts `attack`:
/// - /agents, /annotation_markers: the attacker replaces its recorded future (an added attacker is
///   present from the first state of its past). After t0 there are additional frames at
///   AttackedBagOptions::frame_rate, with caller id names::kInBetween, and one at the contact.
/// - Attack, request and the paths of attacker and recorded ego: added, latched, at t0.
/// - Report against the recording: added at the contact, or without one at the end of the
///   trajectory; at the latest with the last message.
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
/// share 0..1 before each message of `in` and 1 at the end, in the calling thread. `out` gets its
/// name only when it is complete. Throws BagError, MessageError for an invalid trajectory in
/// `attack`, and std::runtime_error if `out` cannot be created.
///
/// All times are header stamps; the record times may be of another clock. A new message gets the
/// record time of a frame of agents with its stamp (RecordClock); a copied one keeps its own.
/// If the new bag ends earlier, a message without agents or ego is left out if its record time
/// corresponds to a header stamp (RecordClock::stampAt()) after the end.
InjectionNotes injectIntoBag(
    const std::string& in, const std::string& out, const BagAttack& attack,
    const RecordingContext& recording,
    const std::function<void(double)>& on_progress = [](double) {});

}  // namespace forge
