#include "collision_forge/attack/search/alternatives.h"

#include <gtest/gtest.h>

#include <set>

#include "attack/search/test_scenes.h"
#include "collision_forge/attack/search/generate_collision.h"
#include "collision_forge/attack/search/judge.h"
#include "collision_forge/attack/search/request_check.h"

namespace forge {
namespace {

/// Returns an attack for every request: with the requested vehicle, class and manoeuvre; by default
/// by "near" with follower_closes.
class WillingMethod : public AttackMethod {
 public:
  mutable std::vector<CollisionRequest> asked;

  Realization answer(const Moment&, const CollisionRequest& request) const override {
    asked.push_back(request);
    Realization answer;
    CollisionReport& report = answer.report;
    report.contact = report.type_kept = report.on_time = report.limits_kept = true;
    report.manoeuvre = request.manoeuvre.value_or(Manoeuvre::kFollowerCloses);
    report.confidence = report.manoeuvre == Manoeuvre::kLeadSlow ? 0.9 : 0.5;
    AttackerTrajectory& trajectory = answer.trajectory;
    trajectory.attacker_id = request.attacker.value_or("near");
    trajectory.agent_class = request.attacker_class.value_or(AgentClass::kCar);
    trajectory.size = kCarSize;
    trajectory.points = {{kNow, {-20.0, 0.0, 0.0}}};
    if (request.choice == AttackerChoice::kNew) {
      trajectory.attacker_id = "added-1";
      trajectory.past = {{}};
    }
    return answer;
  }
};

struct Case {
  std::shared_ptr<LaneMap> map = twoLaneRoad();
  Moment moment{snapshotOf(pastTrack(kEgoId, kEgoSize, {}, 10.0),
                           {pastTrack("far", kCarSize, {-40.0, 0.0, 0.0}, 12.0),
                            pastTrack("near", kCarSize, {-20.0, 0.0, 0.0}, 12.0)},
                           map),
                std::nullopt, std::make_shared<const LaneIndex>(map)};
  CollisionRequest request = requestFor();
  WillingMethod method;

  Case() { request.alternatives = kMaxAlternatives; }

  Realization answer() const {
    return generateCollision(method, moment, request, shippedOptions().prediction);
  }
  /// Attacker, class and manoeuvre of each attack, the first one included.
  std::set<std::string> names() const {
    const Realization first = answer();
    std::set<std::string> names = {nameOf(first)};
    for (const Realization& other : first.alternatives) names.insert(nameOf(other));
    return names;
  }
  static std::string nameOf(const Realization& attack) {
    const AttackerTrajectory& trajectory = attack.trajectory;
    return (trajectory.isAdded() ? std::string("added ") + toString(trajectory.agent_class)
                                 : trajectory.attacker_id) +
           " " + toString(attack.report.manoeuvre);
  }
};

const std::set<std::string> kManoeuvresOfNear = {"near follower_closes", "near lead_brakes",
                                                 "near lead_slow", "near lead_stopped"};

TEST(FindAlternatives, RequestsOtherManoeuvresVehiclesAndClasses) {
  std::set<std::string> expected = kManoeuvresOfNear;
  expected.insert({"far follower_closes", "added car follower_closes",
                   "added truck follower_closes", "added bus follower_closes",
                   "added construction_vehicle follower_closes",
                   "added emergency_vehicle follower_closes", "added motorcycle follower_closes"});
  EXPECT_EQ(Case().names(), expected);
}

TEST(FindAlternatives, RequestsNothingThatTheRequestForbids) {
  Case named;
  named.request.attacker = "near";
  EXPECT_EQ(named.names(), kManoeuvresOfNear);
  Case existing;
  existing.request.choice = AttackerChoice::kExisting;
  existing.request.manoeuvre = Manoeuvre::kLeadSlow;
  EXPECT_EQ(existing.names(), (std::set<std::string>{"near lead_slow", "far lead_slow"}));
  Case added;
  added.request.choice = AttackerChoice::kNew;
  added.request.attacker_class = AgentClass::kBus;
  for (const std::string& name : added.names()) EXPECT_EQ(name.rfind("added bus ", 0), 0u) << name;
}

TEST(FindAlternatives, UsesNoWrongWayDrivingForBelievableAttacks) {
  Case oncoming;
  oncoming.request.type = CollisionType::kOppositeDirection;
  oncoming.request.crash.believable = true;
  oncoming.answer();
  const auto wrongWay = [](const CollisionRequest& asked) {
    return asked.manoeuvre == Manoeuvre::kWrongWay;
  };
  const auto& asked = oncoming.method.asked;
  EXPECT_EQ(std::count_if(asked.begin(), asked.end(), wrongWay), 0);
  oncoming.method.asked.clear();
  oncoming.request.crash.believable = false;
  oncoming.answer();
  EXPECT_EQ(std::count_if(asked.begin(), asked.end(), wrongWay), 1);
}

TEST(FindAlternatives, StopsWhenThereAreEnough) {
  Case one;
  one.request.alternatives = 1;
  EXPECT_TRUE(one.answer().alternatives.empty());
  EXPECT_EQ(one.method.asked.size(), 1u);
  Case three;
  three.request.alternatives = 3;
  EXPECT_EQ(three.answer().alternatives.size(), 2u);
  EXPECT_EQ(three.method.asked.size(), 3u);
}

TEST(FindAlternatives, SortsByConfidenceWithoutNestedAlternatives) {
  const std::vector<Realization> found = Case().answer().alternatives;
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found.front().report.manoeuvre, Manoeuvre::kLeadSlow);
  for (const Realization& other : found) EXPECT_TRUE(other.alternatives.empty());
}

TEST(AttackOf, ReturnsEachAttackAndRejectsNumbersBeyondTheLast) {
  const Realization answer = Case().answer();
  const std::size_t count = 1 + answer.alternatives.size();
  EXPECT_EQ(Case::nameOf(attackOf(answer, 1)), Case::nameOf(answer));
  EXPECT_EQ(Case::nameOf(attackOf(answer, count)), Case::nameOf(answer.alternatives.back()));
  EXPECT_TRUE(attackOf(answer, 1).alternatives.empty());
  for (const std::size_t number : {std::size_t{0}, count + 1}) {
    EXPECT_EQ(attackOf(answer, number).status.code, StatusCode::kNoAttackWithinLimits);
  }
  const Status nobody{StatusCode::kNoCandidate, "nobody"};
  EXPECT_EQ(attackOf(declined(nobody), 2).status.message, "nobody");
}

TEST(AreDistinct, ByManoeuvreOrAttackerAddedVehiclesByClassOrSide) {
  const Case scene;
  const auto attack = [](const std::string& id, Manoeuvre manoeuvre) {
    Realization attack;
    attack.trajectory.attacker_id = id;
    attack.trajectory.size = kCarSize;
    attack.trajectory.points = {{kNow, {-20.0, 0.0, 0.0}}};
    attack.report.manoeuvre = manoeuvre;
    return attack;
  };
  const auto distinct = [&](const Realization& a, const Realization& b) {
    EXPECT_EQ(areDistinct(a, b, scene.moment.snapshot), areDistinct(b, a, scene.moment.snapshot));
    return areDistinct(a, b, scene.moment.snapshot);
  };
  const Realization recorded = attack("a", Manoeuvre::kCutIn);
  EXPECT_FALSE(distinct(recorded, recorded));
  EXPECT_TRUE(distinct(recorded, attack("b", Manoeuvre::kCutIn)));
  EXPECT_TRUE(distinct(recorded, attack("a", Manoeuvre::kMerge)));
  Realization added = attack("added-1", Manoeuvre::kCutIn);
  added.trajectory.past = {{}};
  EXPECT_TRUE(distinct(recorded, added));
  Realization other = added;
  other.trajectory.attacker_id = "added-2";
  EXPECT_FALSE(distinct(added, other));
  other.trajectory.points.front().pose = {0.0, 6.0, 0.0};
  EXPECT_TRUE(distinct(added, other)) << "from the left, not from behind";
  other = added;
  other.trajectory.agent_class = AgentClass::kBus;
  EXPECT_TRUE(distinct(added, other));
}

}  // namespace
}  // namespace forge
