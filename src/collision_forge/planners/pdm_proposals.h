#pragma once

#include <array>
#include <map>
#include <utility>
#include <vector>

#include "collision_forge/planners/pdm_forecast.h"
#include "collision_forge/planners/sampled_way.h"

namespace forge {

/// A way and speeds along it that the ego might drive, before its dynamics; one entry a step, the
/// first now. Places are the rear axle's.
struct PdmProposal {
  double lateral_offset = 0.0;      ///< m left of the way
  std::vector<double> arc_lengths;  ///< m along the way
  std::vector<double> speeds;       ///< m/s
};

/// Drives along a way by the intelligent driver model, behind the nearest agent whose forecast box
/// reaches into the corridor of the ego's width, looked for every few steps.
class PdmProposer {
 public:
  /// `way`, `forecast` and `options` must outlive the proposer. `max_braking` (m/s2) bounds how the
  /// model brakes.
  PdmProposer(const SampledWay& way, const PdmForecast& forecast, const EgoVehicle& ego,
              double max_braking, const PdmOptions& options);

  /// `steps` steps from an arc length and speed, no faster than `desired_speed`, `lateral_offset`
  /// metres left of the way.
  PdmProposal propose(double arc_length, double speed, double lateral_offset, double desired_speed,
                      int steps);

  std::vector<Pose2> poses(const PdmProposal& proposal) const;

 private:
  /// An agent's box along the way: its corners as arc length and lateral.
  struct BoxOnWay {
    std::array<Vector2, 4> corners;
    double speed = 0.0;  // m/s along the way
  };
  /// What an agent takes up of a corridor.
  struct Stretch {
    double start = 0.0;  // m along the way
    double end = 0.0;
    double speed = 0.0;  // m/s along the way
  };
  using Stretches = std::vector<Stretch>;

  const std::vector<BoxOnWay>& boxesAt(std::size_t step);
  const Stretches& stretchesAt(std::size_t step, double lateral_offset);
  double acceleration(const PdmProposal& proposal, const IdmParameters& idm,
                      const Stretches& stretches, double elapsed) const;

  const SampledWay& way_;
  const PdmForecast& forecast_;
  EgoVehicle ego_;
  double max_braking_;
  const PdmOptions& options_;
  std::vector<std::size_t> hints_;                      // of each agent's projection
  std::vector<std::vector<BoxOnWay>> boxes_;            // by step in lead intervals
  std::map<double, std::vector<Stretches>> stretches_;  // by offset, then step in lead intervals
};

}  // namespace forge
