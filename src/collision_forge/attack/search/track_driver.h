#pragma once

#include <cmath>
#include <vector>

#include "collision_forge/attack/verify/drive_limits.h"
#include "collision_forge/base/scene/attack.h"

namespace forge {

inline constexpr double kPreview = 0.8;  ///< s that the steering looks ahead
/// Share of every limit of the class that is used: programs that round poses must not find a
/// violation.
inline constexpr double kLimitShare = 0.93;

/// One step of a planned motion: the state of the box centre.
struct PlannedStep {
  PlannedStep() = default;
  /// `middle`: box centre, m, map frame; `heading`: unit vector; `speed` in m/s.
  PlannedStep(const Vector2& middle, const Vector2& heading, double speed)
      : middle(middle), heading(heading), speed(speed) {}
  /// `pose`: box centre, map frame; `speed` in m/s.
  PlannedStep(const Pose2& pose, double speed)
      : PlannedStep(pose.position(), pose.heading(), speed) {}

  /// Returns the pose of the box centre, map frame.
  Pose2 pose() const { return {middle.x(), middle.y(), std::atan2(heading.y(), heading.x())}; }

  Vector2 middle = Vector2::Zero();    ///< m, box centre, map frame
  Vector2 heading = Vector2::UnitX();  ///< unit vector, map frame
  double speed = 0.0;                  ///< m/s along the heading
};

/// Drives a single-track vehicle along a plan within its limits. Steers the rear axle towards its
/// planned position `preview` s ahead (pure pursuit; Coulter 1992, CMU-RI-TR-92-01) at a limited
/// rate; the acceleration follows the plan plus errors in speed and distance, at limited jerk. The
/// result passes findBrokenDrive() unless the plan demands a bend that cannot be driven at its
/// speed. Immutable.
class TrackDriver {
 public:
  /// `margin`: share 0..1 of every limit that is used. `preview` (rounded to whole steps, at least
  /// one) and `step` in s.
  TrackDriver(const DriveLimits& limits, double margin, double preview, double step);

  /// Returns the limits of the constructor times `margin`, which the driver keeps.
  const DriveLimits& limits() const { return limits_; }

  /// Overwrites `points` (box centres, map frame) with one point per step of `plan`, from the
  /// vehicle's state `start` at `now` (s, scene clock) on. `plan` has one entry per `step` of the
  /// constructor, the first at `now`. For the preview, the plan is extended straight beyond its
  /// end. An empty plan gives no points.
  void drive(const DriveState& start, double now, const std::vector<PlannedStep>& plan,
             std::vector<TrajectoryPoint>& points) const;

 private:
  double steeringTo(const DriveState& state, const Vector2& heading,
                    const PlannedStep& target) const;
  double nextSteering(double wanted, const DriveState& state) const;
  /// `tangent` and `next_tangent`: tangent of the steering angle at this and the next step.
  double nextAcceleration(double wanted, double tangent, double next_tangent,
                          const DriveState& state) const;

  DriveLimits limits_;
  double max_tangent_;   // of the steering angle
  std::size_t preview_;  // steps
  double step_;          // s
};

}  // namespace forge
