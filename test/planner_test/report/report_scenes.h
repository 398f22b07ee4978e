#pragma once

#include "collision_forge/base/scene/scene.h"
#include "collision_forge/io/scenarios/scenario_file.h"

namespace forge {

/// s, scene clock; t0.
inline constexpr double kNow = 1000.0;

/// The ego drives along the x axis at 10 m/s from kNow - 2 s to kNow + 6 s on a road 20 m wide.
inline Scene straightScene() {
  Scene scene;
  scene.name = "straight";
  scene.ego.id = kEgoId;
  scene.ego.size = {4.0, 1.7};
  for (int i = -4; i <= 12; ++i) {
    scene.frame_times.push_back(kNow + 0.5 * i);
    scene.ego.states.push_back({kNow + 0.5 * i, {5.0 * i, 0.0, 0.0}, {10.0, 0.0}});
  }
  auto map = std::make_shared<LaneMap>();
  map->drivable_area.push_back({{{-1e4, -10.0}, {1e4, -10.0}, {1e4, 10.0}, {-1e4, 10.0}}, {}});
  scene.map = map;
  return scene;
}

/// A rear-end collision in 2 s by a car that drives along the x axis.
inline Scenario rearEnd() {
  Scenario scenario;
  scenario.asked.scene = "straight";
  scenario.asked.now = kNow;
  scenario.asked.request.tta = 2.0;
  scenario.ego = {{4.0, 1.7}, 0.0};
  Attack& answer = scenario.answer;
  answer.trajectory.attacker_id = "a";
  answer.trajectory.size = {4.5, 1.8};
  for (int i = 0; i <= 40; ++i) {
    answer.trajectory.points.push_back({kNow + 0.1 * i, {30.0 + 0.1 * i, 0.0, 0.0}, 1.0, 0.0, 0.0});
  }
  answer.pattern.ego = {{20.0, 0.0, 0.0}, {4.0, 1.7}};
  answer.report.contact = answer.report.type_kept = answer.report.on_time = true;
  answer.report.limits_kept = true;
  answer.report.contact_time = kNow + 2.0;
  answer.report.impact_speed = 9.0;
  return scenario;
}

}  // namespace forge
