// Verification and search give the same results in a scene that is turned, moved, mirrored or at
// another time.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "properties/plane_change.h"

namespace forge {
namespace {

// m and s. Contacts are located to 1 mm; a clock step, 0.24 us, is 6 um at 25 m/s.
constexpr double kSame = 1e-3;

bool isSame(const AttackerTrajectory& a, const AttackerTrajectory& b) {
  return a.attacker_id == b.attacker_id &&
         std::equal(a.points.begin(), a.points.end(), b.points.begin(), b.points.end(),
                    [](const TrajectoryPoint& p, const TrajectoryPoint& q) {
                      return (p.pose.position() - q.pose.position()).norm() <= kSame &&
                             std::abs(angleBetween(p.pose.yaw, q.pose.yaw)) <= kSame &&
                             std::abs(p.time - q.time) <= kSame;
                    });
}

/// Minimum shares of requests with the same status in the changed scene, and of attacks that are
/// the same if both scenes have one.
struct LeastShares {
  double status;
  double attack;
};

void expectSameAnswers(const LeastShares& least, MakeChange make) {
  int attacks = 0, same = 0;
  forMostCases(least.status, [&](Random& random) {
    const AskedMoment asked = randomRequest(random, kBothModes);
    const PlaneChange change = make(random);
    const Attack here = answerTo(asked), there = answerTo(change.asked(asked));
    if (here.status.code != there.status.code) return false;
    if (here.status.code != StatusCode::kOk) return true;
    ++attacks;
    same += isSame(change.trajectory(here.trajectory), there.trajectory) ? 1 : 0;
    return true;
  });
  std::cout << same << " of " << attacks << " attacks are the same" << std::endl;
  EXPECT_GE(same, least.attack * attacks);
}

TEST(ChangedScenes, AChangedAttackInAChangedSceneKeepsItsVerdict) {
  forChangedAnswers(
      kBothModes, anyChange,
      [](const AskedMoment& asked, const Scenario& scenario, const PlaneChange& change) {
        const Attack& answer = scenario.answer;
        if (answer.status.code != StatusCode::kOk) return;
        const CollisionReport here = change.report(testedReport(answer.trajectory, asked));
        const CollisionReport there =
            testedReport(change.trajectory(answer.trajectory), change.asked(asked));
        EXPECT_EQ(there.verified(), here.verified());
        EXPECT_EQ(there.type_kept, here.type_kept);
        EXPECT_EQ(there.on_time, here.on_time);
        EXPECT_EQ(there.limits_kept, here.limits_kept) << there.broken_limit << here.broken_limit;
        EXPECT_EQ(there.first_other_id, here.first_other_id);
        ASSERT_EQ(there.contact, here.contact);
        if (!here.contact) return;
        EXPECT_NEAR(there.contact_time, here.contact_time, kSame);
        EXPECT_NEAR(there.relative_heading, here.relative_heading, kSame);
        EXPECT_NEAR(there.impact_speed, here.impact_speed, kSame);
      });
}

// Rounding changes some choices of the search, so the shares are below 1.
TEST(ChangedScenes, ShiftedScenesGetTheSameAttacks) { expectSameAnswers({0.98, 0.85}, elsewhere); }

// Areas are cells of 0.5 m along the axes of the map: the edge of the road moves by up to half a
// cell, and so do choices that depend on it.
TEST(ChangedScenes, TurnedScenesMostlyGetTheSameAttacks) {
  expectSameAnswers({0.93, 0.65}, turned);
}

// Random draws are not mirrored, so attacks differ.
TEST(ChangedScenes, MirroredScenesMostlyGetTheSameStatus) {
  expectSameAnswers({0.8, 0.0}, mirrored);
}

}  // namespace
}  // namespace forge
