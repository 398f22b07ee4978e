#pragma once

#include <optional>
#include <vector>

#include "collision_forge/planners/lane_areas.h"
#include "collision_forge/planners/pdm_forecast.h"
#include "collision_forge/planners/pdm_motion.h"
#include "collision_forge/planners/sampled_way.h"

namespace forge {

/// Whether a motion hits somebody by the ego's own fault.
struct PdmCollision {
  double score = 1.0;          ///< 0 with an agent, the static score with a static object
  std::optional<double> time;  ///< s from now, of the first
};

/// What a motion is worth; every term and the total in [0, 1], 1 is good.
struct PdmScore {
  PdmCollision collision;
  double drivable_area = 0.0;
  double driving_direction = 0.0;
  double progress = 0.0;
  double time_to_collision = 0.0;
  double comfort = 0.0;
  double total = 0.0;
};

/// What the motions of one planning step are held against. All must outlive the scorer.
struct PdmSurroundings {
  const PdmForecast& forecast;
  const LaneIndex& lanes;
  const SampledWay& way;
  std::size_t way_sample;  ///< where the ego is on the way, see SampledWay::Projection
  const EgoVehicle& ego;
  const KinematicBicycle& bicycle;
  Pose2 start;  ///< of the ego now
};

/// Scores motions as PDM-Closed does (Dauner et al. 2023), each term for itself.
class PdmScorer {
 public:
  PdmScorer(const PdmSurroundings& surroundings, double map_radius,
            const PdmScoringOptions& options);

  /// A collision is the ego's fault if the agent stands, or the ego's front hits it, or the ego's
  /// side while the ego is in several lanes or off the drivable area; never while the ego stands or
  /// with an agent behind it. Whom the ego touches without fault is let alone from then on.
  PdmCollision collision(const PdmMotion& motion) const;
  /// 0 when a corner of the box leaves the drivable area (by more than a margin for what is known
  /// of it), else 1.
  double drivableArea(const PdmMotion& motion) const;
  /// 1, less or 0, by how far the ego drives against the traffic within the time looked at.
  double drivingDirection(const PdmMotion& motion) const;
  /// 0 when the ego, going on straight at its speed, would at some time hit an agent ahead of it
  /// (or beside it, if it is in several lanes or off the drivable area) within the times looked
  /// ahead.
  double timeToCollision(const PdmMotion& motion) const;
  /// 0 when a limit of comfort is broken, else 1.
  double comfort(const PdmMotion& motion) const;
  /// Metres along the way; not negative.
  double progress(const PdmMotion& motion) const;

  /// All terms; progress is relative to the farthest of the motions that the first three terms do
  /// not rule out.
  std::vector<PdmScore> score(const std::vector<PdmMotion>& motions) const;

 private:
  bool isOffRoad(const OrientedBox& box) const;
  bool isInSeveralLanesOrOffRoad(const OrientedBox& box) const;
  bool isAtFault(const BicycleState& state, const OrientedBox& box, std::size_t agent,
                 std::size_t step) const;
  bool isTooClose(const PdmMotion& motion, std::size_t step, std::vector<bool>& let_alone) const;
  /// Cosine of the angle between the ego's heading and the way from its rear axle to the agent.
  double cosineTo(const BicycleState& state, std::size_t agent, std::size_t step) const;
  const LaneAreas& areas() const;

  PdmSurroundings surroundings_;
  double map_radius_;
  PdmScoringOptions options_;
  double ego_radius_;
  double ahead_cosine_;
  double behind_cosine_;
  std::vector<std::size_t> ttc_steps_;
  mutable std::optional<LaneAreas> areas_;  // when first asked for
};

}  // namespace forge
