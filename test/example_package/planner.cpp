#include "collision_forge/planner_test/planners/planner.h"

#include <iostream>

/// Keeps speed and heading.
struct StraightOn : forge::Planner {
  void initialize(const forge::DrivingTask&) override {}

  std::vector<forge::TrajectoryPoint> plan(const forge::Observation& now) override {
    auto later = now.ego;
    later.time += 1.0;
    later.pose = forge::compose(now.ego.pose, {now.ego.speed, 0.0, 0.0});
    return {now.ego, later};
  }
};

int main() {
  forge::Observation now;
  now.ego.speed = 7.0;
  std::cout << StraightOn().plan(now).back().pose.x << "\n";
}
