#include "collision_forge/study/motion_distances.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>
#include <stdexcept>

#include "collision_forge/statistics/statistics.h"
#include "collision_forge/study/scene_halves.h"

namespace forge {
namespace {

/// All that is known of a quantity.
struct QuantityTraits {
  MotionQuantity quantity;
  const char* name;
  const char* unit;
  HistogramBins bins;
};

constexpr QuantityTraits kTraits[] = {
    {MotionQuantity::kSpeed, "speed", "m/s", {0.0, 25.0, 10}},
    {MotionQuantity::kAcceleration, "acceleration", "m/s2", {-12.0, 12.0, 11}},
    {MotionQuantity::kJerk, "jerk", "m/s3", {-10.0, 10.0, 20}},
    {MotionQuantity::kYawRate, "yaw rate", "rad/s", {-0.628, 0.628, 11}},
    {MotionQuantity::kYawAcceleration, "yaw acceleration", "rad/s2", {-3.14, 3.14, 11}},
    {MotionQuantity::kLateralAcceleration, "lateral acceleration", "m/s2", {-4.0, 4.0, 20}},
    {MotionQuantity::kSteeringAngle, "steering angle", "rad", {-0.6, 0.6, 20}},
    {MotionQuantity::kSteeringRate, "steering rate", "rad/s", {-0.4, 0.4, 20}},
};

const QuantityTraits& traitsOf(MotionQuantity quantity) {
  return *std::find_if(std::begin(kTraits), std::end(kTraits),
                       [=](const QuantityTraits& traits) { return traits.quantity == quantity; });
}

void requireValues(const std::vector<double>& first, const std::vector<double>& second) {
  if (first.empty() || second.empty()) {
    throw std::invalid_argument("no distance between sets of which one has no value");
  }
}

/// The share of the values in each bin.
std::vector<double> histogramOf(const std::vector<double>& values, const HistogramBins& bins) {
  std::vector<double> shares(static_cast<std::size_t>(bins.count), 0.0);
  const double width = (bins.max - bins.min) / bins.count;
  for (const double value : values) {
    const double place = std::clamp((value - bins.min) / width, 0.0, bins.count - 1.0);
    shares[static_cast<std::size_t>(place)] += 1.0 / static_cast<double>(values.size());
  }
  return shares;
}

double divergenceTerm(double share, double mixed) {
  return share > 0.0 ? share * std::log2(share / mixed) : 0.0;
}

}  // namespace

const char* toString(MotionQuantity quantity) { return traitsOf(quantity).name; }

const char* unitOf(MotionQuantity quantity) { return traitsOf(quantity).unit; }

HistogramBins binsOf(MotionQuantity quantity) { return traitsOf(quantity).bins; }

std::optional<double> valueOf(const MotionState& state, MotionQuantity quantity) {
  switch (quantity) {
    case MotionQuantity::kSpeed:
      return state.speed;
    case MotionQuantity::kAcceleration:
      return state.acceleration;
    case MotionQuantity::kJerk:
      return state.jerk;
    case MotionQuantity::kYawRate:
      return state.yaw_rate;
    case MotionQuantity::kYawAcceleration:
      return state.yaw_acceleration;
    case MotionQuantity::kLateralAcceleration:
      return state.lateral_acceleration;
    case MotionQuantity::kSteeringAngle:
      if (state.steering) return state.steering->angle;
      return std::nullopt;
    case MotionQuantity::kSteeringRate:
      if (state.steering) return state.steering->rate;
      return std::nullopt;
  }
  return std::nullopt;
}

const char* toString(ClassGroup group) {
  switch (group) {
    case ClassGroup::kAll:
      return "all";
    case ClassGroup::kCar:
      return "car";
    case ClassGroup::kTruck:
      return "truck";
    case ClassGroup::kBus:
      return "bus";
  }
  return "unknown";
}

const char* toString(SpeedBand band) {
  switch (band) {
    case SpeedBand::kAll:
      return "all";
    case SpeedBand::kSlow:
      return "2-5 m/s";
    case SpeedBand::kMedium:
      return "5-10 m/s";
    case SpeedBand::kFast:
      return "10+ m/s";
  }
  return "unknown";
}

ClassGroup groupOf(AgentClass agent_class) {
  switch (agent_class) {
    case AgentClass::kCar:
    case AgentClass::kEmergencyVehicle:
      return ClassGroup::kCar;
    case AgentClass::kTruck:
    case AgentClass::kConstructionVehicle:
      return ClassGroup::kTruck;
    case AgentClass::kBus:
      return ClassGroup::kBus;
    default:
      return ClassGroup::kAll;
  }
}

SpeedBand bandOf(double speed) {
  if (speed < 2.0) return SpeedBand::kAll;
  if (speed < 5.0) return SpeedBand::kSlow;
  return speed < 10.0 ? SpeedBand::kMedium : SpeedBand::kFast;
}

std::vector<DescribedMotion> describeMotion(const std::vector<MotionWindow>& windows,
                                            const MotionOptions& options) {
  std::vector<DescribedMotion> motions;
  motions.reserve(windows.size());
  for (const MotionWindow& window : windows) {
    const WindowMotion motion = motionOf(window, options);
    motions.push_back({window.scene, groupOf(window.agent_class),
                       bandOf(motion[kWindowSamples / 2].speed), motion});
  }
  return motions;
}

std::vector<DescribedMotion> ofGroupAndBand(const std::vector<DescribedMotion>& motions,
                                            ClassGroup group, SpeedBand band) {
  std::vector<DescribedMotion> found;
  std::copy_if(motions.begin(), motions.end(), std::back_inserter(found),
               [=](const DescribedMotion& motion) {
                 return (group == ClassGroup::kAll || motion.group == group) &&
                        (band == SpeedBand::kAll || motion.band == band);
               });
  return found;
}

std::vector<double> valuesOf(const std::vector<DescribedMotion>& motions, MotionQuantity quantity) {
  std::vector<double> values;
  for (const DescribedMotion& motion : motions) {
    for (std::size_t i = kFirstInner; i <= kLastInner; ++i) {
      const std::optional<double> value = valueOf(motion.motion[i], quantity);
      if (value) values.push_back(*value);
    }
  }
  return values;
}

double jensenShannon(const std::vector<double>& first, const std::vector<double>& second,
                     const HistogramBins& bins) {
  requireValues(first, second);
  const std::vector<double> p = histogramOf(first, bins);
  const std::vector<double> q = histogramOf(second, bins);
  double divergence = 0.0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double mixed = 0.5 * (p[i] + q[i]);
    divergence += 0.5 * (divergenceTerm(p[i], mixed) + divergenceTerm(q[i], mixed));
  }
  return std::clamp(divergence, 0.0, 1.0);
}

double wassersteinOne(std::vector<double> first, std::vector<double> second, int quantiles) {
  requireValues(first, second);
  std::sort(first.begin(), first.end());
  std::sort(second.begin(), second.end());
  double sum = 0.0;
  for (int i = 0; i < quantiles; ++i) {
    const double share = (i + 0.5) / quantiles;
    sum += std::abs(quantile(first, share) - quantile(second, share));
  }
  return sum / quantiles;
}

std::optional<MotionDistance> distanceOf(const std::vector<DescribedMotion>& first,
                                         const std::vector<DescribedMotion>& second,
                                         MotionQuantity quantity, int quantiles) {
  std::vector<double> first_values = valuesOf(first, quantity);
  std::vector<double> second_values = valuesOf(second, quantity);
  if (first_values.empty() || second_values.empty()) return std::nullopt;
  MotionDistance distance;
  distance.jensen_shannon = jensenShannon(first_values, second_values, binsOf(quantity));
  distance.wasserstein =
      wassersteinOne(std::move(first_values), std::move(second_values), quantiles);
  return distance;
}

RecordedFloor floorOf(const std::vector<double>& draws) {
  if (draws.empty()) throw std::invalid_argument("no floor without draws");
  RecordedFloor floor{0.0, draws.front()};
  for (const double draw : draws) {
    floor.mean += draw / static_cast<double>(draws.size());
    floor.max = std::max(floor.max, draw);
  }
  return floor;
}

HalvedMotion drawHalves(const std::vector<DescribedMotion>& motions, std::mt19937_64& generator) {
  std::vector<std::string> scenes;
  for (const DescribedMotion& motion : motions) scenes.push_back(motion.scene);
  const SceneHalves half_of = drawSceneHalves(std::move(scenes), generator);
  HalvedMotion halves;
  for (const DescribedMotion& motion : motions) {
    halves[static_cast<std::size_t>(half_of.at(motion.scene))].push_back(motion);
  }
  return halves;
}

std::vector<std::optional<MotionDistanceFloor>> distanceFloors(
    const std::vector<DescribedMotion>& recorded, const FloorDraws& draws, int quantiles) {
  std::mt19937_64 generator(draws.seed);
  std::array<std::vector<double>, kMotionQuantities.size()> divergences, wassersteins;
  for (int draw = 0; draw < draws.count; ++draw) {
    HalvedMotion halves = drawHalves(recorded, generator);
    if (halves[0].size() > draws.windows) {
      shuffle(halves[0], generator);
      halves[0].resize(draws.windows);
    }
    for (std::size_t i = 0; i < kMotionQuantities.size(); ++i) {
      const auto distance = distanceOf(halves[0], halves[1], kMotionQuantities[i], quantiles);
      if (!distance) continue;
      divergences[i].push_back(distance->jensen_shannon);
      wassersteins[i].push_back(distance->wasserstein);
    }
  }
  std::vector<std::optional<MotionDistanceFloor>> floors;
  for (std::size_t i = 0; i < kMotionQuantities.size(); ++i) {
    floors.emplace_back();
    if (divergences[i].empty()) continue;
    floors.back() = MotionDistanceFloor{floorOf(divergences[i]), floorOf(wassersteins[i])};
  }
  return floors;
}

}  // namespace forge
