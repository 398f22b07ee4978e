#include "collision_forge/attack/search/steering_search.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "collision_forge/base/geometry/wide_vectors.h"

namespace forge {
namespace {

constexpr int kFirstPopulation = 3008;  // motions drawn in the first round
constexpr int kPopulation = 704;        // motions drawn in each later round
constexpr int kElites = 30;             // best motions, whose distribution the next round samples
static_assert(kElites < kPopulation && SteeringSearch::kConsidered <= kPopulation);
// Standard deviations of the knots in the first round, and their lower bounds in later rounds.
constexpr double kAccelerationDeviation = 4.0;        // m/s2
constexpr double kCurvatureDeviation = 0.3;           // 1/m
constexpr double kLeastAccelerationDeviation = 0.05;  // m/s2
constexpr double kLeastCurvatureDeviation = 0.001;    // 1/m
constexpr double kHeadingWeight = 8.0;  // m; cost per radian beyond the type's heading band
constexpr double kClearance = 0.4;      // m to keep from the ego before the first allowed contact
constexpr int kKnots = SteeringKnots::kCount;
constexpr int kWide = SteeringSearch::kWide;
constexpr float kFar = 1e6F;    // m
constexpr float kTiny = 1e-6F;  // m2/s2

// Branch-free, for vectorisation.
inline float lower(float a, float b) { return a < b ? a : b; }
inline float higher(float a, float b) { return a > b ? a : b; }
inline float bounded(float value, float low, float high) { return lower(higher(value, low), high); }

/// The ends of a band of headings.
struct Band {
  float cos_min, sin_min, cos_max, sin_max;

  /// Returns the squared chord of the angle beyond the band, from a heading's cosine and absolute
  /// sine.
  float beyond(float cosine, float sine) const {
    const float above = 2.0F - 2.0F * (cosine * cos_max + sine * sin_max);
    const float below = 2.0F - 2.0F * (cosine * cos_min + sine * sin_min);
    const float beyond_max = cosine < cos_max ? above : 0.0F;
    const float beyond_min = cosine > cos_min ? below : 0.0F;
    return higher(higher(beyond_max, beyond_min), 0.0F);
  }
};

Band bandOf(const TypeDefinition& type) {
  return {static_cast<float>(std::cos(type.min_heading)),
          static_cast<float>(std::sin(type.min_heading)),
          static_cast<float>(std::cos(type.max_heading)),
          static_cast<float>(std::sin(type.max_heading))};
}

/// Half the dimensions of a box.
struct Half {
  float length, width;
};

Half halfOf(const BoxSize& size) {
  return {static_cast<float>(0.5 * size.length), static_cast<float>(0.5 * size.width)};
}

/// kWide motions at one instant, relative to their start.
struct Motions {
  float x[kWide] = {};
  float y[kWide] = {};
  float cosine[kWide];  // of the heading
  float sine[kWide] = {};
  float speed[kWide];
  float best[kWide];        // smallest shortfall so far, m
  float wrong[kWide] = {};  // penalty of wrong contacts so far, m

  explicit Motions(float speed_now) {
    std::fill_n(cosine, kWide, 1.0F);
    std::fill_n(speed, kWide, speed_now);
    std::fill_n(best, kWide, kFar);
  }
};

}  // namespace

SteeringSearch::SteeringSearch(const DriveStart& start, const SteeringAim& aim,
                               const VehicleLimits& limits)
    : limits_(limits),
      ego_size_(aim.ego_size),
      size_(aim.attacker_size),
      band_(aim.band),
      depth_(static_cast<float>(aim.depth)),
      step_(static_cast<float>(aim.last_in_time / static_cast<double>(aim.ego.size() - 1))),
      first_in_time_(static_cast<int>(std::ceil(aim.first_in_time / step_))),
      speed_(static_cast<float>(std::max(0.0, start.motion.speed))) {
  for (const Pose2& pose : aim.ego) {
    const Pose2 seen = relativeTo(start.motion.pose, pose);
    ego_.push_back({static_cast<float>(seen.x), static_cast<float>(seen.y),
                    static_cast<float>(std::cos(seen.yaw)),
                    static_cast<float>(std::sin(seen.yaw))});
  }
  std::fill_n(deviation_.begin(), kKnots, kAccelerationDeviation);
  std::fill_n(deviation_.begin() + kKnots, kKnots, kCurvatureDeviation);
}

std::vector<SteeringKnots> SteeringSearch::next(Random& random) {
  const int wanted = begun_ ? kPopulation : kFirstPopulation;
  const auto count = static_cast<std::size_t>((wanted + kWide - 1) / kWide * kWide);
  begun_ = true;
  std::vector<Knots> drawn(count);
  for (Knots& knots : drawn) {
    for (std::size_t i = 0; i < knots.size(); ++i) {
      knots[i] = static_cast<float>(mean_[i] + random.bell(deviation_[i]));
    }
  }
  std::vector<std::pair<float, std::size_t>> nearest;
  for (std::size_t i = 0; i < count; i += kWide) {
    for (const float shortfall : drive(&drawn[i])) nearest.emplace_back(shortfall, nearest.size());
  }
  const auto elites = std::min(count, static_cast<std::size_t>(kElites));
  std::partial_sort(nearest.begin(), nearest.begin() + static_cast<std::ptrdiff_t>(elites),
                    nearest.end());
  nearest.resize(elites);
  shortfall_ = nearest.front().first;
  std::vector<SteeringKnots> near;
  std::vector<Knots> best;
  for (const auto& [shortfall, i] : nearest) {
    best.push_back(drawn[i]);
    if (shortfall > kNear || static_cast<int>(near.size()) >= kConsidered) continue;
    SteeringKnots& steering = near.emplace_back();
    std::copy_n(drawn[i].begin(), kKnots, steering.acceleration.begin());
    std::copy_n(drawn[i].begin() + kKnots, kKnots, steering.curvature.begin());
  }
  drawLike(best);
  return near;
}

void SteeringSearch::drawLike(const std::vector<Knots>& best) {
  const auto count = static_cast<double>(best.size());
  for (std::size_t i = 0; i < mean_.size(); ++i) {
    double sum = 0.0;
    double squares = 0.0;
    for (const Knots& knots : best) {
      sum += knots[i];
      squares += static_cast<double>(knots[i]) * knots[i];
    }
    mean_[i] = sum / count;
    const double least = i < kKnots ? kLeastAccelerationDeviation : kLeastCurvatureDeviation;
    const double variance = squares / count - mean_[i] * mean_[i];
    deviation_[i] = std::max(least, std::sqrt(std::max(0.0, variance)));
  }
}

FORGE_WIDE_VECTORS SteeringSearch::Shortfalls SteeringSearch::drive(const Knots* knots) const {
  const Half ego_half = halfOf(ego_size_);
  const Half half = halfOf(size_);
  const Band band = bandOf(band_);
  const auto heading_weight = static_cast<float>(kHeadingWeight);
  const auto clearance = static_cast<float>(kClearance);
  const auto max_forward = static_cast<float>(limits_.max_forward_acceleration);
  const auto max_braking = static_cast<float>(limits_.max_braking);
  const auto max_speed = static_cast<float>(limits_.max_speed);
  const auto max_curvature = static_cast<float>(limits_.max_curvature);
  const auto total =
      static_cast<float>(limits_.max_total_acceleration * limits_.max_total_acceleration);
  Motions motions(speed_);
  const int last = static_cast<int>(ego_.size()) - 1;
  for (int i = 0; i <= last; ++i) {
    // Distance of each motion to the aim.
    const EgoBox& ego = ego_[static_cast<std::size_t>(i)];
    const bool in_time = i >= first_in_time_;
    const float no_contact_yet = in_time ? 0.0F : kFar;
    const float too_early = in_time ? 0.0F : 1.0F;
    for (int lane = 0; lane < kWide; ++lane) {
      const float dx = motions.x[lane] - ego.x;
      const float dy = motions.y[lane] - ego.y;
      const float along = std::fabs(dx * ego.cosine + dy * ego.sine);
      const float across = std::fabs(dy * ego.cosine - dx * ego.sine);
      const float cos_between = motions.cosine[lane] * ego.cosine + motions.sine[lane] * ego.sine;
      const float sin_between =
          std::fabs(motions.sine[lane] * ego.cosine - motions.cosine[lane] * ego.sine);
      const float cos_size = std::fabs(cos_between);
      const float gap =
          higher(along - (ego_half.length + half.length * cos_size + half.width * sin_between),
                 across - (ego_half.width + half.length * sin_between + half.width * cos_size));
      const float turned = heading_weight * std::sqrt(band.beyond(cos_between, sin_between));
      const float shortfall = higher(gap + depth_, 0.0F) + turned + motions.wrong[lane];
      motions.best[lane] = lower(motions.best[lane], shortfall + no_contact_yet);
      const float touching = gap < 0.0F ? turned : 0.0F;
      motions.wrong[lane] += too_early * higher(clearance - gap, 0.0F) + touching;
    }
    // One step of the bicycle, as in BicycleFamily::roll().
    const float place = static_cast<float>(i * (kKnots - 1)) / static_cast<float>(last);
    const int first = std::min(static_cast<int>(place), kKnots - 2);
    const float part = place - static_cast<float>(first);
    float acceleration[kWide];
    float curvature[kWide];
    for (int lane = 0; lane < kWide; ++lane) {
      const float* knot = knots[lane].data() + first;
      acceleration[lane] = knot[0] + part * (knot[1] - knot[0]);
      curvature[lane] = knot[kKnots] + part * (knot[kKnots + 1] - knot[kKnots]);
    }
    for (int lane = 0; lane < kWide; ++lane) {
      const float speed = motions.speed[lane];
      const float held = bounded(acceleration[lane], -max_braking, max_forward);
      const float change = bounded(held, -speed / step_, (max_speed - speed) / step_);
      const float next_speed = speed + change * step_;
      const float fastest = higher(speed, next_speed);
      const float across = std::sqrt(higher(total - change * change, 0.0F));
      const float tightest = lower(max_curvature, across / (fastest * fastest + kTiny));
      const float distance = 0.5F * (speed + next_speed) * step_;
      // Half the turn by its tangent (Cayley): keeps the heading of unit length.
      const float half_turn = 0.5F * bounded(curvature[lane], -tightest, tightest) * distance;
      const float scale = 1.0F / (1.0F + half_turn * half_turn);
      const float turn_cosine = (1.0F - half_turn * half_turn) * scale;
      const float turn_sine = 2.0F * half_turn * scale;
      const float cosine = motions.cosine[lane] * turn_cosine - motions.sine[lane] * turn_sine;
      const float sine = motions.sine[lane] * turn_cosine + motions.cosine[lane] * turn_sine;
      motions.x[lane] += 0.5F * distance * (motions.cosine[lane] + cosine);
      motions.y[lane] += 0.5F * distance * (motions.sine[lane] + sine);
      motions.cosine[lane] = cosine;
      motions.sine[lane] = sine;
      motions.speed[lane] = next_speed;
    }
  }
  Shortfalls shortfalls;
  std::copy_n(motions.best, kWide, shortfalls.begin());
  return shortfalls;
}

}  // namespace forge
