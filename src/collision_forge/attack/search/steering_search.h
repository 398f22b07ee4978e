#pragma once

#include <array>
#include <vector>

#include "collision_forge/attack/forecast/random.h"
#include "collision_forge/attack/search/options.h"
#include "collision_forge/attack/search/trajectory_family.h"
#include "collision_forge/base/geometry/oriented_box.h"

namespace forge {

/// What a motion should come to: the ego's box is touched on time, at a heading of the type, and
/// not before.
struct SteeringAim {
  std::vector<Pose2> ego;  ///< box middles, evenly spread from now to last_in_time, at least two
  BoxSize ego_size;
  BoxSize attacker_size;
  TypeDefinition band;         ///< of the heading at contact
  double first_in_time = 0.0;  ///< s from now
  double last_in_time = 0.0;   ///< s from now
  double depth = 0.0;          ///< m of overlap
};

/// Cross-entropy search over the knots that steer a bicycle (Kobilarov 2012, "Cross-entropy motion
/// planning"): draws many, looks how far each is from the aim, and draws the next round like the
/// best. Finds ways that no arrival drawn at random leads to, as turning round. The motions are
/// as coarse as the aim, and who else is in the way is not looked at.
class SteeringSearch {
 public:
  static constexpr int kWide = 16;        ///< motions are driven so many at a time
  static constexpr double kStep = 0.1;    ///< s between the states of a motion that are examined
  static constexpr int kConsidered = 20;  ///< motions that next() returns at most
  static constexpr double kNear = 0.8;    ///< m short of the aim; next() returns no farther ones

  /// Steers until last_in_time.
  SteeringSearch(const DriveStart& start, const SteeringAim& aim, const VehicleLimits& limits);

  /// One more round. Returns the motions that come within kNear of the aim, nearest first, at most
  /// kConsidered.
  std::vector<SteeringKnots> next(Random& random);

  /// How far the nearest one of the last round stays from the aim: the gap left in m, and headings
  /// beyond the band, earlier contact and coming too near as metres.
  double shortfall() const { return shortfall_; }

 private:
  static constexpr int kUnknowns = 2 * SteeringKnots::kCount;  // accelerations, then curvatures
  using Knots = std::array<float, kUnknowns>;
  using Shortfalls = std::array<float, kWide>;
  struct EgoBox {
    float x, y, cosine, sine;
  };

  /// How far the motions of kWide knots stay from the aim, m.
  Shortfalls drive(const Knots* knots) const;
  void drawLike(const std::vector<Knots>& best);

  VehicleLimits limits_;
  BoxSize ego_size_;
  BoxSize size_;
  TypeDefinition band_;
  float depth_;
  float step_;               // s
  int first_in_time_;        // steps
  float speed_;              // m/s, now
  std::vector<EgoBox> ego_;  // seen from where the attacker is now
  std::array<double, kUnknowns> mean_{};
  std::array<double, kUnknowns> deviation_{};
  bool begun_ = false;
  double shortfall_ = 0.0;
};

}  // namespace forge
