#pragma once

#include <functional>
#include <string>
#include <vector>

#include "collision_forge/ros/injection/bag_attack.h"

namespace forge {

/// Lines for the user.
struct InjectionNotes {
  std::vector<std::string> warnings;  ///< one per topic and kind of values left out or not changed
  std::vector<std::string> lidar;     ///< LidarInjection::summary(); empty without `lidar`
  std::vector<std::string> cameras;   ///< CameraBoxes::summary(); empty without cameras
};

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
/// - CameraBoxes::boxTopic() of each camera: box of the attacker on the pictures (CameraBoxes),
///   until the contact if `after_contact` is kStop. Pictures are copied.
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
