#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "collision_forge/planner_test/trials/planner_result.h"

namespace forge {

/// A row of a planner: a hit by the attacker at this speed (m/s), or no contact.
inline PlannerRow row(const std::string& planner, std::optional<double> impact_speed) {
  PlannerRow found{planner, {}, {}};
  if (impact_speed) {
    PlannerContact contact;
    contact.is_attacker = true;
    contact.impact_speed = *impact_speed;
    found.outcome.contact = contact;
  }
  return found;
}

/// A tested case.
inline PlannerTestResult result(const std::string& name, const std::string& scene,
                                std::vector<PlannerRow> rows) {
  PlannerTestResult one;
  one.name = name;
  one.scene = scene;
  one.status = "OK";
  one.rows = std::move(rows);
  return one;
}

}  // namespace forge
