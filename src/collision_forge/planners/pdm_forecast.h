#pragma once

#include <set>
#include <string>
#include <vector>

#include "collision_forge/planners/pdm_options.h"
#include "collision_forge/scene/scene.h"

namespace forge {

/// An agent that drives straight on at its velocity.
struct ForecastAgent {
  OrientedBox box;             ///< now
  Vector2 velocity{0.0, 0.0};  ///< m/s
  double radius = 0.0;         ///< of the box, metres
  bool is_static_object = false;
  bool is_standing = false;
};

/// Where the agents around the ego will be, every step. Global map frame.
class PdmForecast {
 public:
  /// The nearest of each kind, in the order of `agents`, for `steps` steps of `step` seconds. The
  /// ids of agents that touch the ego's box now are added to `ignored`; these, and agents without a
  /// state, are left out.
  PdmForecast(const std::vector<Track>& agents, const OrientedBox& ego, double step, int steps,
              const PdmAgentOptions& options, std::set<std::string>& ignored);

  double step() const { return step_; }
  std::size_t stepCount() const { return positions_.size(); }
  const std::vector<ForecastAgent>& agents() const { return agents_; }
  /// Of all agents, after `step` steps.
  const std::vector<Vector2>& positions(std::size_t step) const { return positions_[step]; }
  OrientedBox box(std::size_t agent, std::size_t step) const;

  /// Calls visit(agent) for the agents whose boxes touch `box` after `step` steps, in order.
  template <typename Visit>
  void forTouching(const OrientedBox& box, double box_radius, std::size_t step, Visit visit) const {
    const std::vector<Vector2>& positions = positions_[step];
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
  std::vector<std::vector<Vector2>> positions_;  // by step, then agent
};

}  // namespace forge
