#include "collision_forge/study/motion_distances.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "study/test_windows.h"

namespace forge {
namespace {

const ScorecardOptions kOptions = shippedScorecardOptions();
const HistogramBins kTwoBins{0.0, 2.0, 2};

std::vector<DescribedMotion> drawnMotion(int scenes, int each, double mean, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  return describeMotion(drawnWindows(scenes, each, mean, generator), kOptions.motion);
}

TEST(JensenShannon, IsNothingBetweenEqualSets) {
  EXPECT_EQ(jensenShannon({0.5, 1.5, 1.5}, {1.5, 0.5, 1.5}, kTwoBins), 0.0);
  EXPECT_NEAR(jensenShannon({0.5, 1.5}, {0.5, 0.5, 1.5, 1.5}, kTwoBins), 0.0, 1e-15);
}

TEST(JensenShannon, IsOneBitBetweenDisjointSets) {
  EXPECT_NEAR(jensenShannon({0.1, 0.2}, {1.1, 1.2, 1.3}, kTwoBins), 1.0, 1e-15);
}

TEST(JensenShannon, IsTheMeanOfBothDivergencesFromTheMixture) {
  // p = (1/2, 1/2), q = (1, 0), m = (3/4, 1/4).
  const double from_p = 0.5 * std::log2(0.5 / 0.75) + 0.5 * std::log2(0.5 / 0.25);
  const double from_q = std::log2(1.0 / 0.75);
  EXPECT_NEAR(jensenShannon({0.5, 1.5}, {0.5, 0.5}, kTwoBins), 0.5 * (from_p + from_q), 1e-15);
}

TEST(JensenShannon, CountsValuesOutsideInTheFirstAndTheLastBin) {
  EXPECT_EQ(jensenShannon({-100.0, 100.0}, {0.0, 2.0}, kTwoBins), 0.0);
}

TEST(Distances, NeedValuesOnBothSides) {
  EXPECT_THROW(jensenShannon({}, {1.0}, kTwoBins), std::invalid_argument);
  EXPECT_THROW(wassersteinOne({1.0}, {}, 10), std::invalid_argument);
}

TEST(WassersteinOne, OfAShiftIsTheShift) {
  std::vector<double> values, shifted;
  for (int i = 0; i < 57; ++i) {
    values.push_back(std::sin(i));
    shifted.push_back(std::sin(i) - 0.25);
  }
  EXPECT_NEAR(wassersteinOne(values, shifted, kOptions.quantiles), 0.25, 1e-12);
  EXPECT_EQ(wassersteinOne(values, values, kOptions.quantiles), 0.0);
}

TEST(WassersteinOne, OfTwiceTheWidthIsTheMeanDistanceFromTheMiddle) {
  // Uniform on [-1, 1] against [-2, 2]: the mean of |x| over [-1, 1].
  std::vector<double> narrow, wide;
  for (int i = -500; i <= 500; ++i) {
    narrow.push_back(i / 500.0);
    wide.push_back(i / 250.0);
  }
  EXPECT_NEAR(wassersteinOne(narrow, wide, kOptions.quantiles), 0.5, 1e-3);
}

TEST(ClassGroups, HoldWhoCanAttack) {
  EXPECT_EQ(groupOf(AgentClass::kEmergencyVehicle), ClassGroup::kCar);
  EXPECT_EQ(groupOf(AgentClass::kConstructionVehicle), ClassGroup::kTruck);
  EXPECT_EQ(groupOf(AgentClass::kBus), ClassGroup::kBus);
  EXPECT_EQ(groupOf(AgentClass::kPedestrian), ClassGroup::kAll);
}

TEST(SpeedBands, BeginAtTheirLowerEnd) {
  EXPECT_EQ(bandOf(1.99), SpeedBand::kAll);
  EXPECT_EQ(bandOf(2.0), SpeedBand::kSlow);
  EXPECT_EQ(bandOf(5.0), SpeedBand::kMedium);
  EXPECT_EQ(bandOf(10.0), SpeedBand::kFast);
}

TEST(OfGroupAndBand, TakesWhatHasBoth) {
  std::vector<MotionWindow> windows = {simpleWindow("a", 3.0, 0.0), simpleWindow("b", 7.0, 0.0),
                                       simpleWindow("c", 7.0, 0.0), simpleWindow("d", 1.5, 0.0)};
  windows[2].agent_class = AgentClass::kTruck;
  const auto motions = describeMotion(windows, kOptions.motion);
  EXPECT_EQ(ofGroupAndBand(motions, ClassGroup::kAll, SpeedBand::kAll).size(), 4u);
  EXPECT_EQ(ofGroupAndBand(motions, ClassGroup::kCar, SpeedBand::kAll).size(), 3u);
  EXPECT_EQ(ofGroupAndBand(motions, ClassGroup::kAll, SpeedBand::kMedium).size(), 2u);
  const auto one = ofGroupAndBand(motions, ClassGroup::kTruck, SpeedBand::kMedium);
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(one[0].scene, "c");
}

TEST(ValuesOf, AreThoseOfTheInnerSamplesWithoutTheSteeringOfTheSlow) {
  const auto slow = describeMotion({simpleWindow("a", 1.5, 0.0)}, kOptions.motion);
  EXPECT_EQ(valuesOf(slow, MotionQuantity::kYawRate).size(), 3u);
  EXPECT_TRUE(valuesOf(slow, MotionQuantity::kSteeringAngle).empty());
  EXPECT_FALSE(distanceOf(slow, slow, MotionQuantity::kSteeringRate, 10));
  // 8 m/s in the middle, 1 m/s more half a second later.
  const auto faster = describeMotion({simpleWindow("a", 8.0, 2.0)}, kOptions.motion);
  const auto speeds = valuesOf(faster, MotionQuantity::kSpeed);
  EXPECT_NEAR(speeds.front(), 7.0, 1e-9);
  EXPECT_NEAR(speeds.back(), 9.0, 1e-9);
}

TEST(DistanceOf, SeesTheQuantityThatDiffers) {
  std::vector<MotionWindow> calm, braking;
  for (int i = 0; i < 20; ++i) {
    calm.push_back(simpleWindow("a", 8.0, 0.0));
    braking.push_back(simpleWindow("a", 8.0, -3.0));
  }
  const auto first = describeMotion(calm, kOptions.motion);
  const auto second = describeMotion(braking, kOptions.motion);
  const auto braked = distanceOf(first, second, MotionQuantity::kAcceleration, 200);
  EXPECT_NEAR(braked->wasserstein, 3.0, 1e-9);
  EXPECT_NEAR(braked->jensen_shannon, 1.0, 1e-12);
  const auto turned = distanceOf(first, second, MotionQuantity::kYawRate, 200);
  EXPECT_NEAR(turned->wasserstein, 0.0, 1e-9);
  EXPECT_EQ(turned->jensen_shannon, 0.0);
}

TEST(FloorOf, IsMeanAndMax) {
  const RecordedFloor floor = floorOf({0.25, 0.5, 0.75});
  EXPECT_EQ(floor.mean, 0.5);
  EXPECT_EQ(floor.max, 0.75);
  EXPECT_THROW(floorOf({}), std::invalid_argument);
}

TEST(DrawHalves, KeepScenesWhole) {
  std::mt19937_64 generator(6);
  const HalvedMotion halves = drawHalves(drawnMotion(10, 3, 0.0, 6), generator);
  EXPECT_EQ(halves[0].size(), 15u);
  EXPECT_EQ(halves[1].size(), 15u);
  std::set<std::string> first;
  for (const DescribedMotion& motion : halves[0]) first.insert(motion.scene);
  for (const DescribedMotion& motion : halves[1]) EXPECT_EQ(first.count(motion.scene), 0u);
}

TEST(DistanceFloors, AreFarBelowARealDifferenceAndTheSameForASeed) {
  constexpr std::uint64_t kSeed = 8;
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  const auto recorded = drawnMotion(60, 10, 0.0, kSeed);
  const FloorDraws draws{10, 300, kSeed};
  const auto floors = distanceFloors(recorded, draws, 200);
  ASSERT_EQ(floors.size(), kMotionQuantities.size());
  const auto& acceleration = floors[1];
  ASSERT_TRUE(acceleration);
  EXPECT_GT(acceleration->wasserstein.mean, 0.0);
  EXPECT_LE(acceleration->wasserstein.mean, acceleration->wasserstein.max);
  const auto braking =
      distanceOf(drawnMotion(60, 10, -1.0, 9), recorded, MotionQuantity::kAcceleration, 200);
  EXPECT_LT(acceleration->wasserstein.max, 0.25 * braking->wasserstein);
  EXPECT_LT(acceleration->jensen_shannon.max, 0.25 * braking->jensen_shannon);
  EXPECT_EQ(distanceFloors(recorded, draws, 200)[1]->wasserstein.mean,
            acceleration->wasserstein.mean);
}

TEST(DistanceFloors, AreHigherOfFewWindows) {
  constexpr std::uint64_t kSeed = 10;
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  const auto recorded = drawnMotion(60, 10, 0.0, kSeed);
  const auto many = distanceFloors(recorded, {10, 300, kSeed}, 200);
  const auto few = distanceFloors(recorded, {10, 20, kSeed}, 200);
  for (std::size_t i = 0; i < many.size(); ++i) {
    EXPECT_GT(few[i]->wasserstein.mean, many[i]->wasserstein.mean) << i;
  }
}

TEST(DistanceFloors, AreEmptyOfOneScene) {
  for (const auto& floor : distanceFloors(drawnMotion(1, 10, 0.0, 1), {10, 5, 1}, 200)) {
    EXPECT_FALSE(floor);
  }
}

}  // namespace
}  // namespace forge
