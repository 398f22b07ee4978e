#include "collision_forge/ros/live_scene.h"

#include <algorithm>

#include "collision_forge/geometry/touch_point.h"
#include "collision_forge/ros/conversions.h"
#include "collision_forge/ros/crash_words.h"
#include "collision_forge/ros/marker_parts.h"
#include "collision_forge/ros/shown_motion.h"

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

struct Named {
  std::string id;
  OrientedBox box;
};

/// Of the attacker; where there is none, of those near the ego that can be one.
std::vector<Named> namedIn(const LiveScene& live) {
  std::vector<Named> named;
  if (const auto attacker = attackerBox(live)) {
    return {{live.attack->trajectory.attacker_id, *attacker}};
  }
  for (const AgentTrack& agent : live.scene->agents) {
    if (!isHere(agent, live) || !canAttackClass(agent.agent_class)) continue;
    const OrientedBox box = shownBox(agent, live);
    const auto ego = viewedEgo(live);
    if (ego && (box.center.position() - ego->position()).norm() > kLabelRange) continue;
    named.push_back({agent.id, box});
  }
  return named;
}

void addAgents(const LiveScene& live, std::vector<OrientedBox>& boxes, MarkerList& markers) {
  for (const AgentTrack& agent : live.scene->agents) {
    if (!isHere(agent, live)) continue;
    const colors::MarkerColor color = colors::agentColor(agent.agent_class);
    const bool attacks = isAttacker(agent, live);
    boxes.push_back(shownBox(agent, live));
    addTrack(attacks ? "recorded" : "agents", agent, boxes.back(),
             attacks ? colors::withAlpha(color, kRecordedAlpha) : color, markers);
  }
}

void addEgo(const LiveScene& live, std::vector<OrientedBox>& boxes, MarkerList& markers) {
  const AgentTrack& ego = live.scene->ego;
  const bool is_crashed = live.attack && live.crash;
  if (isHere(ego, live)) {
    boxes.push_back(egoBox(live));
    addTrack(is_crashed ? "recorded" : "ego", ego, boxes.back(),
             is_crashed ? colors::withAlpha(colors::kEgo, kRecordedAlpha) : colors::kEgo, markers);
  }
  if (!is_crashed) return;
  boxes.push_back(crashedAt(live.now.toSec(), live).ego);
  markers.addBox("ego", boxes.back(), kVehicleHeight, colors::kEgo);
}

/// After a contact beside the place where the attacker comes to a stand; before it beside the
/// predicted contact, or beside the attacker where none is predicted.
void addWords(const LiveScene& live, const OrientedBox& attacker, std::vector<OrientedBox>& boxes,
              MarkerList& markers) {
  OrientedBox place = attacker;
  if (live.crash) {
    const auto [ego, attacker_then] = crashedAt(live.crash->contactTime(), live);
    markers.addDisc("contact", touchPoint(ego, attacker_then), kContactDiameter, kContactHeight,
                    colors::kContact);
    place = crashedAt(live.crash->standTime(), live).attacker;
  } else if (live.attack->report.contact && !live.verdict) {
    place.center = fromMessage(live.attack->report.attacker_at_contact);
  }
  const std::string words = live.crash && !live.verdict
                                ? std::string(kContactWords)
                                : crashWords(*live.attack, live.verdict, live.now);
  addWordsBeside(place, words, boxes, markers);
}

}  // namespace

visualization_msgs::MarkerArray liveMarkers(const LiveScene& live) {
  MarkerList markers(live.scene->header);
  std::vector<OrientedBox> boxes;
  addAgents(live, boxes, markers);
  addEgo(live, boxes, markers);
  const std::optional<OrientedBox> attacker = attackerBox(live);
  if (attacker) {
    boxes.push_back(*attacker);
    markers.addBox("attacker", *attacker, kVehicleHeight, colors::kAttacker);
    addWords(live, *attacker, boxes, markers);
  }
  for (const Named& named : namedIn(live)) addId(named.id, named.box, boxes, markers);
  return markers.take();
}

std::optional<Pose2> viewedEgo(const LiveScene& live) {
  const double now = live.now.toSec();
  if (live.crash && now - live.crash->contactTime() < kCrashView)
    return live.crash->egoAt(now).pose;
  if (!isHere(live.scene->ego, live)) return std::nullopt;
  return egoBox(live).center;
}

}  // namespace forge
