#include "collision_forge/ros/injection/attacked_frames.h"

#include <rosbag/view.h>

#include <algorithm>
#include <cmath>

#include "collision_forge/base/scene/track.h"
#include "collision_forge/ros/bags/bag_file.h"
#include "collision_forge/ros/bags/older_message.h"
#include "collision_forge/ros/injection/finite_parts.h"
#include "collision_forge/ros/injection/frame_between.h"
#include "collision_forge/ros/messages/topic_names.h"

namespace forge {
namespace {

/// Returns the times of the additional frames between two frames, as shares of their interval:
/// evenly spaced, and the contact at `contact_share` if it is between the frames.
std::vector<double> sharesBetween(double gap, double frame_rate, double contact_share) {
  std::vector<double> shares;
  const double steps = std::ceil(gap * frame_rate - kSameTime);
  for (double i = 1.0; i < steps; ++i) shares.push_back(i / steps);
  const double margin = kSameTime / gap;
  const bool is_between = contact_share > margin && contact_share < 1.0 - margin;
  const bool is_there = std::any_of(shares.begin(), shares.end(), [=](double share) {
    return std::abs(share - contact_share) <= margin;
  });
  if (is_between && !is_there) shares.push_back(contact_share);
  return shares;
}

/// Returns true if a vehicle of the attack drives by its motion at `stamp`: a recorded one after
/// t0, an added one from the begin of its past on.
bool isMoving(const collision_forge::AttackerTrajectory& motion, const ros::Time& stamp) {
  return motion.past.empty() ? stamp > motion.header.stamp : stamp >= motion.past.front().stamp;
}

}  // namespace

AttackedFrames::AttackedFrames(const rosbag::Bag& source, const BagAttack& attack,
                               const RecordingContext& recording,
                               const std::optional<PostCrashMotion>& crash, const ros::Time& end)
    : attack_(attack) {
  const DriveLimitOptions& limits = recording.verification.drivable;
  for (const collision_forge::SupportVehicle& support : attack.attack.supports) {
    injectors_.emplace_back(support.motion, limits, AfterEnd::kLeave);
  }
  injectors_.emplace_back(attack.attack.trajectory, limits).setCrash(crash);
  collision_forge::AgentArray::Ptr before;
  const rosbag::TopicQuery topic(bagTopic(names::kAgents));
  for (const rosbag::MessageInstance& instance : rosbag::View(source, topic)) {
    const auto agents = readMessage<collision_forge::AgentArray>(instance);
    if (!agents) continue;
    const int left_out = keepFinite(*agents);
    left_out_ += left_out;
    header_ = instance.getConnectionHeader();
    clock_.add(agents->header.stamp, instance.getTime());
    if (attack.lidar) recorded_.push_back(*agents);
    addFrame({instance.getTime(), injected(*agents), true, left_out > 0});
    if (before && before->header.stamp >= attack.attack.trajectory.header.stamp) {
      addFramesBetween(*before, *agents, recording.options.frame_rate);
    }
    before = agents;
  }
  frames_.erase(frames_.upper_bound({end, ros::TIME_MAX}), frames_.end());
  std::stable_sort(recorded_.begin(), recorded_.end(),
                   [](const auto& a, const auto& b) { return a.header.stamp < b.header.stamp; });
}

bool AttackedFrames::isChangedAt(const ros::Time& stamp) const {
  const auto& supports = attack_.attack.supports;
  return isMoving(attack_.attack.trajectory, stamp) ||
         std::any_of(supports.begin(), supports.end(),
                     [&](const auto& support) { return isMoving(support.motion, stamp); });
}

std::vector<collision_forge::Agent> AttackedFrames::placedAt(const ros::Time& time) {
  collision_forge::AgentArray agents;
  agents.header.stamp = time;
  return injected(agents).agents;
}

std::vector<collision_forge::Agent> AttackedFrames::vacatedAt(const ros::Time& time) const {
  if (!isChangedAt(time)) return {};
  std::vector<collision_forge::Agent> agents = agentsAt(recorded_, time);
  const auto stays = [&](const collision_forge::Agent& agent) {
    const auto vacates = [&](const collision_forge::AttackerTrajectory& motion) {
      return motion.attacker_id == agent.id && isMoving(motion, time);
    };
    const auto& supports = attack_.attack.supports;
    return !vacates(attack_.attack.trajectory) &&
           std::none_of(supports.begin(), supports.end(),
                        [&](const auto& support) { return vacates(support.motion); });
  };
  agents.erase(std::remove_if(agents.begin(), agents.end(), stays), agents.end());
  return agents;
}

void AttackedFrames::addFrame(const AttackedFrame& frame) {
  frames_[{frame.agents.header.stamp, frame.recorded}] = frame;
}

collision_forge::AgentArray AttackedFrames::injected(collision_forge::AgentArray agents) {
  for (AttackerInjector& injector : injectors_) agents = injector.inject(std::move(agents));
  return agents;
}

void AttackedFrames::addFramesBetween(const collision_forge::AgentArray& before,
                                      const collision_forge::AgentArray& after, double frame_rate) {
  const double gap = (after.header.stamp - before.header.stamp).toSec();
  if (gap <= 0.0 || gap > kMaxGap) return;
  const auto& report = attack_.tested_report;
  const double contact =
      report.contact ? (report.contact_time - before.header.stamp).toSec() / gap : -1.0;
  for (const double share : sharesBetween(gap, frame_rate, contact)) {
    const auto frame = injected(frameBetween(before, after, share));
    addFrame({clock_.recordedAt(frame.header.stamp), frame, false, false});
  }
}

}  // namespace forge
