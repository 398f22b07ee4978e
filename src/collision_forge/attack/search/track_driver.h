#pragma once

#include <cmath>
#include <vector>

#include "collision_forge/attack/verify/drive_limits.h"
#include "collision_forge/base/scene/attack.h"

namespace forge {

inline constexpr double kPreview = 0.8;  ///< s that the steering looks ahead
/// Share of every limit of the class that is used; the rest allows for readers that round poses.
inline constexpr double kLimitShare = 0.93;

/// One step of a plan that is to be driven: the state that the middle of the box should have.
struct PlannedStep {
  PlannedStep() = default;
  PlannedStep(const Vector2& middle, const Vector2& heading, double speed)
      : middle(middle), heading(heading), speed(speed) {}
  PlannedStep(const Pose2& pose, double speed)
      : PlannedStep(pose.position(), pose.heading(), speed) {}

  Pose2 pose() const { return {middle.x(), middle.y(), std::atan2(heading.y(), heading.x())}; }

  Vector2 middle = Vector2::Zero();    ///< m, map frame
  Vector2 heading = Vector2::UnitX();  ///< unit vector, map frame
  double speed = 0.0;                  ///< m/s along the heading
};

/// Drives a single track along a plan, within the limits of its vehicle: the front wheels are
/// turned so that the rear axle comes to where the plan has it `preview` seconds later (pure
/// pursuit; Coulter 1992, CMU-RI-TR-92-01), at most as fast as they can be; the acceleration is the
/// plan's, with what is missing in speed and way, and changes by at most the greatest jerk. The
/// motion keeps findBrokenDrive() unless the plan asks for a bend that nobody can take at its
/// speed. Immutable.
class TrackDriver {
 public:
  /// `margin`: share of every limit that is used.
  TrackDriver(const DriveLimits& limits, double margin, double preview, double step);

  const DriveLimits& limits() const { return limits_; }

  /// `points` are overwritten: one a step of the plan, from `now` on; where the plan ends, the last
  /// points aim straight on.
  void drive(const DriveState& start, double now, const std::vector<PlannedStep>& plan,
             std::vector<TrajectoryPoint>& points) const;

 private:
  double steeringTo(const DriveState& state, const Vector2& heading,
                    const PlannedStep& target) const;
  double nextSteering(double wanted, const DriveState& state) const;
  /// Both tangents are of the steering angle, now and a step later.
  double nextAcceleration(double wanted, double tangent, double next_tangent,
                          const DriveState& state) const;

  DriveLimits limits_;
  double max_tangent_;   // of the steering angle
  std::size_t preview_;  // steps
  double step_;          // s
};

}  // namespace forge
