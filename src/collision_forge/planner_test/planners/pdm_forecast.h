#pragma once

#include <set>
#include <string>
#include <vector>

#include "collision_forge/base/scene/scene.h"
#include "collision_forge/planner_test/planners/pdm_options.h"

namespace forge {

/// An agent forecast to drive straight at constant speed: along its heading, or against it if its
/// velocity points backwards.
struct ForecastAgent {
  std::string id;      ///< Track::id
  OrientedBox box;     ///< at t0
  double speed = 0.0;  ///< m/s, norm of the observed velocity
  /// m/s, global map frame: `speed` along the heading or against it.
  Vector2 velocity = Vector2::Zero();
  double radius = 0.0;            ///< m, of the box's circumcircle
  bool is_static_object = false;  ///< of AgentClass::kStaticObject
  bool is_red_light = false;      ///< a lead of proposals; collisions with it are not scored
  /// No faster than PdmAgentOptions::standing_speed; static objects always.
  bool is_standing = false;
};

/// PDM-Closed's forecast of the agents around the ego at every step. As published, positions change
/// only at every second step: an odd step has the positions of the step before. Global map frame.
class PdmForecast {
 public:
  /// Forecasts the nearest agents of each kind within `options.radius` of the ego's middle, in the
  /// order of `agents`, over `steps` steps of `step` seconds. `ego`: the ego's box at t0; the
  /// newest state of an agent counts as t0. Agents among these that touch the ego's box are added
  /// to `ignored` (ids). Leaves out agents in `ignored` and agents without states.
  PdmForecast(const std::vector<Track>& agents, const OrientedBox& ego, double step, int steps,
              const PdmAgentOptions& options, std::set<std::string>& ignored);

  double step() const { return step_; }  ///< s between two steps
  /// Returns the forecast agents; their order gives the indices below.
  const std::vector<ForecastAgent>& agents() const { return agents_; }
  /// Returns the positions of all agents (middle of the box, m) after `step` steps, in the order of
  /// agents(). `step` must not exceed the constructor's `steps`.
  const std::vector<Vector2>& positions(std::size_t step) const;
  /// Returns the box of the agent with index `agent` in agents() after `step` steps.
  OrientedBox box(std::size_t agent, std::size_t step) const;

  /// Calls visit(agent) in ascending order for each agent (index in agents()) whose box touches
  /// `box` after `step` steps. `box_radius`: m, circumradius of `box`.
  template <typename Visit>
  void forTouching(const OrientedBox& box, double box_radius, std::size_t step, Visit visit) const {
    const std::vector<Vector2>& positions = this->positions(step);
    const Vector2 middle = box.center.position();
    for (std::size_t i = 0; i < positions.size(); ++i) {
      const double reach = agents_[i].radius + box_radius;
      if ((positions[i] - middle).squaredNorm() > reach * reach) continue;
      if (overlaps(box, this->box(i, step))) visit(i);
    }
  }

 private:
  double step_;
  std::vector<ForecastAgent> agents_;
  std::vector<std::vector<Vector2>> positions_;  // by renewal, then agent
};

}  // namespace forge
