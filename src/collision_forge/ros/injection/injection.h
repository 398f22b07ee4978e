#pragma once

#include <collision_forge/Attack.h>
#include <collision_forge/AttackRequest.h>
#include <collision_forge/CollisionReport.h>

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "collision_forge/attack/verify/drive_limits.h"
#include "collision_forge/base/scene/scene.h"
#include "collision_forge/io/logs/options.h"

namespace forge {

/// Content of an attacked bag after the contact with the recorded ego.
enum class AfterContact {
  kStop,  ///< both move as of PostCrashMotion; /tf and odom are rewritten; the bag ends when both
          ///< have stood for AttackedBagOptions::seconds_after_stand
  kEnd,   ///< the bag ends shortly after
  kDriveOn,  ///< the ego drives as recorded, the attacker its trajectory to the end
};

/// "stop", "end", "drive_on".
const char* toString(AfterContact after);

/// Returns the value for a live replay, kStop or kDriveOn (a replay has no end to set). Throws
/// std::invalid_argument naming both for another word.
AfterContact liveAfterContact(const std::string& word);

/// The attack to write into a bag.
struct BagAttack {
  collision_forge::Attack attack;
  collision_forge::CollisionReport tested_report;  ///< against the recorded ego
  collision_forge::AttackRequest request;
  AfterContact after_contact = AfterContact::kStop;
};

/// Recorded ego and parameters that the injection needs.
struct RecordingContext {
  const Track& ego;      ///< the recorded one
  double center_offset;  ///< as of EgoVehicle
  const DriveLimitOptions& limits;
  const AttackedBagOptions& options;
};

/// Throws BagError, naming the topic, for a bag that has an attack already.
void requireNoAttack(const std::string& path);

/// Copies the bag at `in`, in which there is no attack, to `out`. In /agents and
/// /annotation_markers the attacker's recorded future is replaced (one that was added is there from
/// the first state of its past on); from now on they have frames in between, sent by
/// names::kInBetween, and one at the contact. Attack, request and the paths of attacker and
/// recorded ego are added, latched, at the trajectory's start, the report against the recording at
/// the contact (without one at the trajectory's end), and markers of map, ego and attack. The
/// markers of the map come every second. /agent_objects comes with every frame of agents, in place
/// of one that is there. After the contact with the recorded ego, if there is one, the bag goes on
/// as `after_contact` says; where it rewrites /tf and odom, they have one more message at the
/// contact. Every other message is copied byte for byte with its connection. Agents, transforms and
/// odometry with values that are not finite are left out (ros/injection/finite_parts.h); the
/// function returns a line for each topic with such values. `on_progress` receives the share that
/// is done. Throws BagError.
///
/// All times are header stamps; the record times of the bag may be of another clock. A new message
/// is recorded when a frame of agents with its stamp would be (RecordClock). A copied message keeps
/// its record time. Messages that do not show agents or the ego end with the frames of agents that
/// are recorded at the same time.
std::vector<std::string> injectIntoBag(
    const std::string& in, const std::string& out, const BagAttack& attack,
    const RecordingContext& recording,
    const std::function<void(double)>& on_progress = [](double) {});

}  // namespace forge
