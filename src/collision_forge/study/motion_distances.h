#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "collision_forge/study/motion_windows.h"

namespace forge {

/// What is compared of two sets of windows, one distribution each.
enum class MotionQuantity {
  kSpeed,
  kAcceleration,
  kJerk,
  kYawRate,
  kYawAcceleration,
  kLateralAcceleration,
  kSteeringAngle,
  kSteeringRate,
};

inline constexpr std::array<MotionQuantity, 8> kMotionQuantities = {
    MotionQuantity::kSpeed,
    MotionQuantity::kAcceleration,
    MotionQuantity::kJerk,
    MotionQuantity::kYawRate,
    MotionQuantity::kYawAcceleration,
    MotionQuantity::kLateralAcceleration,
    MotionQuantity::kSteeringAngle,
    MotionQuantity::kSteeringRate};

/// Equal bins of a histogram; values outside count in the first and the last one.
struct HistogramBins {
  double min = 0.0;
  double max = 0.0;
  int count = 0;
};

/// For people: "acceleration", "m/s2".
const char* toString(MotionQuantity quantity);
const char* unitOf(MotionQuantity quantity);

/// Speed, acceleration, yaw rate and yaw acceleration as the Waymo Open Sim Agents Challenge has
/// them (waymo-research/waymo-open-dataset, wdl_limited/sim_agents_metrics, configuration of 2025);
/// it has none of the others, whose 20 bins hold 99.9 % of what recorded vehicles do.
HistogramBins binsOf(MotionQuantity quantity);

/// Empty for the steering of one who is too slow.
std::optional<double> valueOf(const MotionState& state, MotionQuantity quantity);

/// Vehicles that move alike.
enum class ClassGroup {
  kAll,    ///< all that canAttack()
  kCar,    ///< cars and emergency vehicles
  kTruck,  ///< trucks (in nuScenes pick-ups, too) and construction vehicles
  kBus,
};

/// By the speed at the middle of a window.
enum class SpeedBand {
  kAll,
  kSlow,    ///< 2 to 5 m/s
  kMedium,  ///< 5 to 10 m/s
  kFast,    ///< 10 m/s and more
};

inline constexpr std::array<ClassGroup, 4> kClassGroups = {ClassGroup::kAll, ClassGroup::kCar,
                                                           ClassGroup::kTruck, ClassGroup::kBus};
inline constexpr std::array<SpeedBand, 4> kSpeedBands = {SpeedBand::kAll, SpeedBand::kSlow,
                                                         SpeedBand::kMedium, SpeedBand::kFast};

/// For people: "truck", "5-10 m/s".
const char* toString(ClassGroup group);
const char* toString(SpeedBand band);

/// The smallest group of a class, kAll for one without a group of its own.
ClassGroup groupOf(AgentClass agent_class);
/// The band of a speed, m/s; kAll below 2 m/s.
SpeedBand bandOf(double speed);

/// A window's motion with what it is sorted by.
struct DescribedMotion {
  std::string scene;
  ClassGroup group = ClassGroup::kAll;
  SpeedBand band = SpeedBand::kAll;
  WindowMotion motion;
};

std::vector<DescribedMotion> describeMotion(const std::vector<MotionWindow>& windows,
                                            const MotionOptions& options);

/// Those of a group and a band, in their order; kAll takes all.
std::vector<DescribedMotion> ofGroupAndBand(const std::vector<DescribedMotion>& motions,
                                            ClassGroup group, SpeedBand band);

/// The values of a quantity at the inner samples of each window.
std::vector<double> valuesOf(const std::vector<DescribedMotion>& motions, MotionQuantity quantity);

/// Jensen-Shannon divergence of the histograms, base 2, in [0, 1]: half KL(p|m) + half KL(q|m),
/// m = (p + q) / 2 (Lin 1991). Blind to how far apart bins are. Throws std::invalid_argument
/// without values on a side.
double jensenShannon(const std::vector<double>& first, const std::vector<double>& second,
                     const HistogramBins& bins);

/// Wasserstein-1 distance, in the values' unit: the mean |difference| of `quantiles` quantiles, at
/// the middles of as many equal shares. Throws std::invalid_argument without values on a side.
double wassersteinOne(std::vector<double> first, std::vector<double> second, int quantiles);

/// Both of one quantity.
struct MotionDistance {
  double jensen_shannon = 0.0;  ///< bit
  double wasserstein = 0.0;     ///< in the quantity's unit
};

/// Empty where a side has no value.
std::optional<MotionDistance> distanceOf(const std::vector<DescribedMotion>& first,
                                         const std::vector<DescribedMotion>& second,
                                         MotionQuantity quantity, int quantiles);

/// What a measure gives between recorded and recorded.
struct RecordedFloor {
  double mean = 0.0;  ///< of the draws
  double max = 0.0;
};

/// Throws std::invalid_argument without draws.
RecordedFloor floorOf(const std::vector<double>& draws);

struct MotionDistanceFloor {
  RecordedFloor jensen_shannon;
  RecordedFloor wasserstein;
};

/// How the floor is drawn.
struct FloorDraws {
  int count = 0;
  std::size_t windows = 0;  ///< at most so many of the first half, as many as there are attacks
  std::uint64_t seed = 0;
};

/// Motion of each half.
using HalvedMotion = std::array<std::vector<DescribedMotion>, 2>;

/// Halves motion by scene, at random.
HalvedMotion drawHalves(const std::vector<DescribedMotion>& motions, std::mt19937_64& generator);

/// Two halves of recorded motion by scene, drawn at random, against each other. Small sets differ
/// by chance alone: from the first half `draws.windows` are drawn, so that the floor is that of as
/// many windows as what it is held against. For each of kMotionQuantities; empty where no draw has
/// values on both sides.
std::vector<std::optional<MotionDistanceFloor>> distanceFloors(
    const std::vector<DescribedMotion>& recorded, const FloorDraws& draws, int quantiles);

}  // namespace forge
