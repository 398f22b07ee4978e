#include "collision_forge/ros/markers/live_scene.h"

#include <algorithm>

#include "collision_forge/base/geometry/touch_point.h"
#include "collision_forge/ros/markers/crash_words.h"
#include "collision_forge/ros/markers/label_places.h"
#include "collision_forge/ros/markers/marker_parts.h"
#include "collision_forge/ros/markers/shown_motion.h"
#include "collision_forge/ros/messages/conversions.h"

namespace forge {
namespace {

using collision_forge::AgentTrack;

constexpr double kTrailHeight = 0.1;    // m
constexpr double kTrailWidth = 0.2;     // m
constexpr double kShortestTrail = 1.0;  // m; a shorter one is under its box
constexpr double kLabelRange = 40.0;    // m from the ego
constexpr float kTrailAlpha = 0.5F;
constexpr float kRecordedAlpha = 0.35F;  // beside the scenario

bool isHere(const AgentTrack& track, const LiveScene& live) {
  return !track.states.empty() && track.states.back().stamp >= live.scene->header.stamp;
}

OrientedBox shownBox(const AgentTrack& track, const LiveScene& live) {
  return {shownPose(track, live.now), sizeOf(track.size)};
}

/// As recorded.
OrientedBox egoBox(const LiveScene& live) {
  const AgentTrack& ego = live.scene->ego;
  return {live.ego ? *live.ego : shownPose(ego, live.now), sizeOf(ego.size)};
}

/// For kCrashView after a contact the picture stays there.
bool isCrashWatched(const LiveScene& live) {
  return live.crash && live.now.toSec() - live.crash->contactTime() < kCrashView;
}

/// The ego's pose in the picture; for kCrashView after a contact the pose of the crashed ego. Empty
/// if no ego is in the scene.
std::optional<Pose2> viewedEgo(const LiveScene& live) {
  if (isCrashWatched(live)) return live.crash->egoAt(live.now.toSec()).pose;
  if (!isHere(live.scene->ego, live)) return std::nullopt;
  return egoBox(live).center;
}

bool isAttacker(const AgentTrack& track, const LiveScene& live) {
  return live.attack && track.id == live.attack->trajectory.attacker_id;
}

/// Ego and attacker after their contact.
struct CrashedBoxes {
  OrientedBox ego;
  OrientedBox attacker;
};

CrashedBoxes crashedAt(double time, const LiveScene& live) {
  return {{live.crash->egoAt(time).pose, sizeOf(live.attack->pattern.ego_size)},
          {live.crash->attackerAt(time).pose, sizeOf(live.attack->trajectory.size)}};
}

std::optional<OrientedBox> attackerBox(const LiveScene& live) {
  if (!live.attack) return std::nullopt;
  if (live.crash) return crashedAt(live.now.toSec(), live).attacker;
  const auto pose = drivenPose(live.attack->trajectory, live.now);
  if (!pose) return std::nullopt;
  return OrientedBox{*pose, sizeOf(live.attack->trajectory.size)};
}

/// Up to the box.
void addTrail(const AgentTrack& track, const OrientedBox& box, const colors::MarkerColor& color,
              MarkerList& markers) {
  std::vector<Vector2> trail;
  for (const auto& state : track.states) trail.emplace_back(state.pose.x, state.pose.y);
  trail.push_back(box.center.position());
  if ((trail.back() - trail.front()).norm() < kShortestTrail) return;
  std::vector<Vector2> lines;
  appendPolyline(trail, lines);
  markers.addLines("trails", lines, kTrailWidth, kTrailHeight,
                   colors::withAlpha(color, kTrailAlpha));
}

void addTrack(const std::string& name_space, const AgentTrack& track, const OrientedBox& box,
              const colors::MarkerColor& color, MarkerList& markers) {
  addTrail(track, box, color, markers);
  markers.addBox(name_space, box, kVehicleHeight, color);
}

/// A pale slab on the road: the box of the scenario, where it stands on the slab, hides it and
/// keeps its colour.
void addRecorded(const AgentTrack& track, const OrientedBox& box, const colors::MarkerColor& color,
                 MarkerList& markers) {
  addTrail(track, box, color, markers);
  markers.addSlab("recorded", box, kGhostHeight, colors::withAlpha(color, kRecordedAlpha));
}

OrientedBox framedBox(const AgentTrack& track) {
  return {fromMessage(track.states.back()).pose, sizeOf(track.size)};
}

/// Adds the ids of the agents near the ego that can attack.
void addIds(const LiveScene& live, double scale, MarkerList& markers) {
  std::vector<OrientedBox> obstacles;
  for (const AgentTrack& agent : live.scene->agents) {
    if (isHere(agent, live)) obstacles.push_back(framedBox(agent));
  }
  if (isHere(live.scene->ego, live)) obstacles.push_back(framedBox(live.scene->ego));
  for (const AgentTrack& agent : live.scene->agents) {
    if (!isHere(agent, live) || !canAttackClass(agent.agent_class)) continue;
    const OrientedBox box = shownBox(agent, live);
    const auto ego = viewedEgo(live);
    if (ego && (box.center.position() - ego->position()).norm() > kLabelRange) continue;
    addId(agent.id, framedBox(agent), box, scale, obstacles, markers);
  }
}

void addAgents(const LiveScene& live, MarkerList& markers) {
  for (const AgentTrack& agent : live.scene->agents) {
    if (!isHere(agent, live)) continue;
    const colors::MarkerColor color = colors::agentColor(agent.agent_class);
    if (isAttacker(agent, live)) {
      addRecorded(agent, shownBox(agent, live), color, markers);
    } else if (!live.attack || !isSupport(agent.id, *live.attack)) {
      addTrack("agents", agent, shownBox(agent, live), color, markers);
    }
  }
}

/// Adds the support vehicles where the attack has them; one that moves on is gone at its end.
void addSupports(const LiveScene& live, MarkerList& markers) {
  if (!live.attack) return;
  for (const collision_forge::SupportVehicle& support : live.attack->supports) {
    const auto& points = support.motion.points;
    if (points.empty()) continue;
    if (live.now > points.back().stamp && points.back().speed != 0.0) continue;
    const Pose2 pose = poseAt(fromMessage(support.motion), live.now.toSec());
    markers.addBox("supports", {pose, sizeOf(support.motion.size)}, kVehicleHeight,
                   colors::kSupport);
  }
}

void addEgo(const LiveScene& live, MarkerList& markers) {
  const AgentTrack& ego = live.scene->ego;
  const bool is_crashed = live.attack && live.crash;
  if (isHere(ego, live)) {
    if (is_crashed) {
      addRecorded(ego, egoBox(live), colors::kEgo, markers);
    } else {
      addTrack("ego", ego, egoBox(live), colors::kEgo, markers);
    }
  }
  if (!is_crashed) return;
  markers.addBox("ego", crashedAt(live.now.toSec(), live).ego, kVehicleHeight, colors::kEgo);
}

/// After a contact the place where the attacker comes to a stand; before it the predicted contact,
/// or the attacker if no contact is predicted.
OrientedBox placeOfWords(const LiveScene& live, const OrientedBox& attacker) {
  if (live.crash) return crashedAt(live.crash->standTime(), live).attacker;
  if (live.verdict || !live.attack->report.contact) return attacker;
  return {fromMessage(live.attack->report.attacker_at_contact), attacker.size};
}

void addWords(const LiveScene& live, const OrientedBox& attacker, double scale,
              MarkerList& markers) {
  if (live.crash) {
    const auto [ego, attacker_then] = crashedAt(live.crash->contactTime(), live);
    markers.addDisc("contact", touchPoint(ego, attacker_then), kContactDiameter, kContactHeight,
                    colors::kContact);
  }
  const std::string words = live.crash && !live.verdict
                                ? std::string(kContactWords)
                                : crashWords(*live.attack, live.verdict, live.now);
  addAttackWords(*live.attack, {placeOfWords(live, attacker), live.words_obstacles}, attacker,
                 words, scale, markers);
}

}  // namespace

std::vector<OrientedBox> coveredByOthers(const LiveScene& live) {
  double duration = kCrashView;
  if (!live.crash && live.attack->report.contact) {
    duration += std::max(0.0, (live.attack->report.contact_time - live.now).toSec());
  }
  std::vector<OrientedBox> covered;
  for (const AgentTrack& agent : live.scene->agents) {
    if (!isHere(agent, live) || isAttacker(agent, live)) continue;
    const Vector2 velocity = fromMessage(agent.states.back()).velocity;
    covered.push_back(sweptBox(shownBox(agent, live), velocity, duration));
  }
  return covered;
}

visualization_msgs::MarkerArray liveMarkers(const LiveScene& live) {
  MarkerList markers(live.scene->header);
  addAgents(live, markers);
  addSupports(live, markers);
  addEgo(live, markers);
  const auto area = shownArea(live);
  const double scale = area ? letterScale(*area) : 1.0;
  if (const auto attacker = attackerBox(live)) {
    markers.addBox("attacker", *attacker, kVehicleHeight, colors::kAttacker);
    addWords(live, *attacker, scale, markers);
  } else {
    addIds(live, scale, markers);
  }
  return markers.take();
}

std::optional<ShownArea> shownArea(const LiveScene& live) {
  const std::optional<Pose2> ego = viewedEgo(live);
  if (!ego) return std::nullopt;
  const BoxSize size = sizeOf(live.scene->ego.size);
  const std::optional<OrientedBox> attacker = attackerBox(live);
  const bool is_over = live.crash ? !isCrashWatched(live) : live.verdict != nullptr;
  if (!attacker || is_over) return areaAround({{*ego, size}}, kUsualWidth);
  std::vector<OrientedBox> boxes{{*ego, size}, *attacker};
  const auto& predicted = live.attack->report;
  if (live.crash) {
    const CrashedBoxes standing = crashedAt(live.crash->standTime(), live);
    boxes.insert(boxes.end(), {standing.ego, standing.attacker});
  } else if (predicted.contact) {
    boxes.push_back({fromMessage(predicted.ego_at_contact), size});
    boxes.push_back({fromMessage(predicted.attacker_at_contact), attacker->size});
  }
  const double scale = letterScale(areaAround(boxes, kCrashWidth));
  boxes.push_back(
      wordsBox(*live.attack, {placeOfWords(live, *attacker), live.words_obstacles}, scale));
  return areaAround(boxes, kCrashWidth);
}

}  // namespace forge
