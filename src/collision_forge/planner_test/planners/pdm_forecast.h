#pragma once

#include <set>
#include <string>
#include <vector>

#include "collision_forge/base/scene/scene.h"
#include "collision_forge/planner_test/planners/pdm_options.h"

namespace forge {

/// An agent that drives straight on: along its heading, or against it if its velocity points
/// backwards.
struct ForecastAgent {
  std::string id;
  OrientedBox box;                     ///< now
  double speed = 0.0;                  ///< m/s, not negative
  Vector2 velocity = Vector2::Zero();  ///< m/s, along or against the heading
  double radius = 0.0;                 ///< of the box, metres
  bool is_static_object = false;
  bool is_standing = false;  ///< static objects always are
};

/// Where the agents around the ego will be, as PDM-Closed forecasts them: every `step`, but renewed
/// at every other alone. Global map frame.
class PdmForecast {
 public:
  /// The nearest of each kind within options.radius of the ego's middle, in the order of `agents`.
  /// The ids of those that touch the ego's box now are added to `ignored`; these, and agents
  /// without a state, are left out.
  PdmForecast(const std::vector<Track>& agents, const OrientedBox& ego, double step, int steps,
              const PdmAgentOptions& options, std::set<std::string>& ignored);

  double step() const { return step_; }
  const std::vector<ForecastAgent>& agents() const { return agents_; }
  /// Of all agents, after `step` steps (at most those asked for).
  const std::vector<Vector2>& positions(std::size_t step) const;
  OrientedBox box(std::size_t agent, std::size_t step) const;

  /// Calls visit(agent) for the agents whose boxes touch `box` after `step` steps, in order.
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
