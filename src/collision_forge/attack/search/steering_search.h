#pragma once

#include <array>
#include <vector>

#include "collision_forge/attack/forecast/random.h"
#include "collision_forge/attack/search/options.h"
#include "collision_forge/attack/search/trajectory_family.h"
#include "collision_forge/base/geometry/oriented_box.h"

namespace forge {

/// Target of a steering search: the first contact with the ego's box is on time and at a heading of
/// the type.
struct SteeringAim {
  /// box centres, map frame, evenly spaced from t0 to last_in_time, at least two
  std::vector<Pose2> ego;
  BoxSize ego_size;
  BoxSize attacker_size;
  TypeDefinition band;         ///< its heading band at the contact is used
  double first_in_time = 0.0;  ///< s after t0, first allowed contact
  double last_in_time = 0.0;   ///< s after t0, last allowed contact
  double depth = 0.0;          ///< m of overlap that the contact should have
};

/// Cross-entropy search over the knots that steer a bicycle (Kobilarov 2012, "Cross-entropy motion
/// planning"): samples many, measures their distance to the aim, and samples the next round around
/// the best. Finds motions that random arrivals miss, such as U-turns. Motions are as coarse as the
/// aim, and other agents are ignored. Not thread-safe.
class SteeringSearch {
 public:
  static constexpr int kWide = 16;  ///< number of motions driven at a time, for SIMD
  /// s; largest spacing that SteeringAim::ego should have; motions are examined at that spacing
  static constexpr double kStep = 0.1;
  static constexpr int kConsidered = 20;  ///< most motions that next() returns
  /// m; next() returns only motions whose shortfall() is at most this
  static constexpr double kNear = 0.8;

  /// Steers the attacker that starts at `start` until aim.last_in_time. Copies its arguments.
  SteeringSearch(const DriveStart& start, const SteeringAim& aim, const VehicleLimits& limits);

  /// Runs one round (3008 motions in the first, 704 in each later one). Returns the motions within
  /// kNear of the aim, nearest first, at most kConsidered; empty if there is none. The knots span
  /// t0 to aim.last_in_time.
  std::vector<SteeringKnots> next(Random& random);

  /// Returns the distance (m) of the last round's best motion to the aim: gap left to an overlap of
  /// `depth`, plus 8 m per rad of heading error, plus the metres by which 0.4 m of clearance were
  /// missed before first_in_time (summed over steps); 0 before the first round.
  double shortfall() const { return shortfall_; }

 private:
  static constexpr int kUnknowns = 2 * SteeringKnots::kCount;  // accelerations, then curvatures
  using Knots = std::array<float, kUnknowns>;
  using Shortfalls = std::array<float, kWide>;
  struct EgoBox {
    float x, y, cosine, sine;
  };

  /// Returns the distance to the aim of the motions of kWide knots, m.
  Shortfalls drive(const Knots* knots) const;
  void drawLike(const std::vector<Knots>& best);

  VehicleLimits limits_;
  BoxSize ego_size_;
  BoxSize size_;
  TypeDefinition band_;
  float depth_;
  float step_;               // s
  int first_in_time_;        // steps
  float speed_;              // m/s at t0
  std::vector<EgoBox> ego_;  // relative to the attacker at t0
  std::array<double, kUnknowns> mean_{};
  std::array<double, kUnknowns> deviation_{};
  bool begun_ = false;
  double shortfall_ = 0.0;
};

}  // namespace forge
