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
  std::string id;
  OrientedBox box;                     ///< at t0
  double speed = 0.0;                  ///< m/s, not negative
  Vector2 velocity = Vector2::Zero();  ///< m/s, along or against the heading
  double radius = 0.0;                 ///< m, of the box's circumcircle
  bool is_static_object = false;
  bool is_red_light = false;  ///< a lead of proposals; collisions with it are not scored
  bool is_standing = false;   ///< static objects always are
};

/// PDM-Closed's forecast of the agents around the ego at every step. As published, positions change
/// only at every second step. Global map frame.
class PdmForecast {
 public:
  /// Forecasts the nearest agents of each kind within `options.radius` of the ego's middle, in the
  /// order of `agents`, over `steps` steps of `step` seconds. Agents that touch the ego's box at t0
  /// are added to `ignored`. Leaves out ignored agents and agents without states.
  PdmForecast(const std::vector<Track>& agents, const OrientedBox& ego, double step, int steps,
              const PdmAgentOptions& options, std::set<std::string>& ignored);

  double step() const { return step_; }  ///< s between two steps
  const std::vector<ForecastAgent>& agents() const { return agents_; }
  /// Returns the positions of all agents after `step` steps, which must not exceed the
  /// constructor's `steps`.
  const std::vector<Vector2>& positions(std::size_t step) const;
  /// Returns the box of the agent with index `agent` after `step` steps.
  OrientedBox box(std::size_t agent, std::size_t step) const;

  /// Calls visit(agent) in ascending order for each agent (index) whose box touches `box` after
  /// `step` steps. `box_radius`: m, circumradius of `box`.
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
