#pragma once

#include <random>
#include <vector>

#include "collision_forge/study/motion_distances.h"
#include "collision_forge/study/two_sample_classifier.h"

namespace forge {

/// A row of distances: attackers against recorded vehicles of one class group and speed band.
struct DistanceRow {
  MotionQuantity quantity = MotionQuantity::kSpeed;
  ClassGroup group = ClassGroup::kAll;
  SpeedBand band = SpeedBand::kAll;
  std::size_t attacks = 0;  ///< windows
  std::size_t recorded = 0;
  MotionDistance distance;
  MotionDistance noisy;       ///< the same of attacks withRecordedNoise()
  MotionDistanceFloor floor;  ///< of as many windows as there are attacks
};

/// A row of two-sample tests: attackers of one class group against recorded vehicles.
struct ClassifierRow {
  ClassGroup group = ClassGroup::kAll;
  TwoSampleTest test;
  TwoSampleTest noisy;        ///< the same of attacks withRecordedNoise()
  std::size_t unmatched = 0;  ///< attacks left out, for no recorded window matches
  RecordedFloor logistic_floor;
  RecordedFloor forest_floor;
  RecordedFloor larger_floor;  ///< of TwoSampleTest::larger()
};

/// How alike attackers are to recorded vehicles. Rows with fewer windows on either side than
/// ScorecardOptions::min_windows are left out.
struct Scorecard {
  std::size_t attacks = 0;                 ///< windows that count
  std::size_t left_out = 0;                ///< windows with too few generated samples
  std::size_t recorded = 0;                ///< windows
  std::vector<DistanceRow> distances;      ///< by class group, speed band and quantity
  std::vector<ClassifierRow> classifiers;  ///< by class group
};

/// Attacks with the recorded motion that they are held against.
struct MatchedMotion {
  std::vector<DescribedMotion> attacks;  ///< those with a match
  std::vector<DescribedMotion> recorded;
  std::size_t unmatched = 0;  ///< attacks without
};

/// For each attack up to `wanted` recorded motions of its class group and speed band, each taken
/// once and drawn at random: of its scene first, then, for those who got too few there, of any.
MatchedMotion matchRecorded(const std::vector<DescribedMotion>& attacks,
                            const std::vector<DescribedMotion>& recorded, int wanted,
                            std::mt19937_64& generator);

/// The statistical half of how believable attackers are. `attacks` are windows of attackWindow(),
/// `recorded` those of recordedWindows() over the same scenes. Distances hold all attacks of a
/// group and band against all recorded windows of it; the two-sample test those that match. The
/// floors hold recorded against recorded windows, in random halves by scene: of as many windows (of
/// the same class groups and speed bands) on the side of the attacks. Both are
/// made twice, with the attacks as they are and withRecordedNoise(): recorded motion is noisy and
/// generated motion is not, by which a classifier can tell even recorded motion from the same
/// smoothed. The same arguments give the same scorecard.
Scorecard scorecardOf(const std::vector<MotionWindow>& attacks,
                      const std::vector<MotionWindow>& recorded, const ScorecardOptions& options);

}  // namespace forge
