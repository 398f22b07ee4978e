#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "collision_forge/planner_test/planners/rule_based_choice.h"
#include "collision_forge/study/settings/study_config.h"
#include "parity/parity_fixture.h"

namespace forge {
namespace {

constexpr double kTolerance = 2e-6;

const ParityFixture& fixture() {
  static const ParityFixture loaded("strive_rule_based.json");
  return loaded;
}

const TrialOptions& shipped() {
  static const StudyConfig config = loadStudyConfig(COLLISION_FORGE_SOURCE_DIR "/config");
  return config.planners;
}

/// The set of parameters of a case, over what the configuration has.
RuleBasedOptions optionsOf(const std::string& name) {
  RuleBasedOptions options = name == "tuned" ? shipped().tuned_rule_based : shipped().rule_based;
  const rapidjson::Value& given = memberOf(fixture().at("parameters"), name.c_str());
  options.max_speed = numberOf(given, "smax");
  options.max_acceleration = numberOf(given, "accmax");
  options.distance_weight = numberOf(given, "score_wmin");
  options.distance_weight_rate = numberOf(given, "score_wfac");
  options.step = numberOf(given, "dt");
  options.steps = static_cast<int>(numberOf(given, "nsteps"));
  options.middle_speeds = options.end_speeds = static_cast<int>(numberOf(given, "plannspeeds"));
  options.interaction_radius = numberOf(given, "interacdist");
  options.speed_shares = numbersOf(memberOf(given, "predsfacs"));
  options.acceleration_shares = numbersOf(memberOf(given, "predafacs"));
  options.on_lane_distance = numberOf(given, "xydistmax");
  options.on_lane_heading = numberOf(given, "cdistang") * M_PI / 180.0;
  options.max_probability = numberOf(given, "col_plim");
  return options;
}

void expectEqual(const RuleBasedOptions& ours, const RuleBasedOptions& published) {
  EXPECT_EQ(ours.max_speed, published.max_speed);
  EXPECT_EQ(ours.max_acceleration, published.max_acceleration);
  EXPECT_EQ(ours.distance_weight, published.distance_weight);
  EXPECT_EQ(ours.distance_weight_rate, published.distance_weight_rate);
  EXPECT_EQ(ours.step, published.step);
  EXPECT_EQ(ours.steps, published.steps);
  EXPECT_EQ(ours.middle_speeds, published.middle_speeds);
  EXPECT_EQ(ours.end_speeds, published.end_speeds);
  EXPECT_EQ(ours.interaction_radius, published.interaction_radius);
  EXPECT_EQ(ours.speed_shares, published.speed_shares);
  EXPECT_EQ(ours.acceleration_shares, published.acceleration_shares);
  EXPECT_EQ(ours.on_lane_distance, published.on_lane_distance);
  EXPECT_NEAR(ours.on_lane_heading, published.on_lane_heading, 1e-6);
  EXPECT_EQ(ours.max_probability, published.max_probability);
  EXPECT_EQ(ours.ego_way, EgoWay::kFirst);
}

DrivenBox boxOf(const rapidjson::Value& object) {
  return {{numberOf(object, "x"), numberOf(object, "y"), numberOf(object, "heading")},
          numberOf(object, "speed"),
          {numberOf(object, "length"), numberOf(object, "width")}};
}

/// [x, y, heading, length, width].
DrivenBox standingBox(const rapidjson::Value& values) {
  const std::vector<double> box = numbersOf(values);
  return {{box[0], box[1], box[2]}, 0.0, {box[3], box[4]}};
}

PlacedCircles placedCircles(const DrivenBox& box) {
  return placed(circlesOf(box.size), box.pose.position(), box.pose.heading());
}

/// A way of constant curvature as the worlds have it.
LaneSpline arc(const Pose2& start, double curvature) {
  std::vector<LaneSpline::Knot> knots;
  for (int i = -8; i <= 26; ++i) {
    const double length = 5.0 * i;
    const double heading = start.yaw + curvature * length;
    // The chord of an arc: sin(x) / x of its length, at half of its angle.
    const double half = 0.5 * curvature * length;
    const double chord = half == 0.0 ? length : length * std::sin(half) / half;
    const Vector2 position =
        start.position() + chord * Vector2(std::cos(start.yaw + half), std::sin(start.yaw + half));
    knots.push_back({length, {position, {std::cos(heading), std::sin(heading)}}});
  }
  return LaneSpline(knots);
}

/// The greatest difference of numbers; infinite where there are not as many.
double difference(const std::vector<double>& ours, const std::vector<double>& published) {
  if (ours.size() != published.size()) return std::numeric_limits<double>::infinity();
  double greatest = 0.0;
  for (std::size_t i = 0; i < ours.size(); ++i) {
    greatest = std::max(greatest, std::abs(ours[i] - published[i]));
  }
  return greatest;
}

std::vector<double> probabilities(const RuleBasedChoice& choice) {
  std::vector<double> values;
  for (const WeighedProfile& weighed : choice.profiles) values.push_back(weighed.probability);
  return values;
}

bool isFragile(const rapidjson::Value& out) {
  return out.HasMember("fragile") && out["fragile"].GetBool();
}

/// What the worlds and the lane worlds say of a plan.
void expectPlan(const Pose2& ego, const LaneSpline& way, const RuleBasedChoice& choice,
                std::size_t other_futures, const rapidjson::Value& out) {
  EXPECT_EQ(other_futures, static_cast<std::size_t>(numberOf(out, "other_futures")));
  const auto published = static_cast<std::size_t>(numberOf(out, "chosen"));
  if (!isFragile(out)) {
    EXPECT_EQ(choice.chosen, published);
  }
  // Of a fragile choice the published one is compared.
  const WeighedProfile& chosen = choice.profiles[published];
  EXPECT_NEAR(chosen.profile.middle_speed, numberOf(out, "s1"), kTolerance);
  EXPECT_NEAR(chosen.profile.end_speed, numberOf(out, "s2"), kTolerance);
  EXPECT_NEAR(chosen.profile.plan.distances.back(), numberOf(out, "distance"), kTolerance);
  const Pose2 next = poseAfterStep(ego, way, chosen.profile.plan);
  const Pose2 expected = poseOf(memberOf(out, "next_x_y_heading"));
  EXPECT_NEAR(next.x, expected.x, kTolerance);
  EXPECT_NEAR(next.y, expected.y, kTolerance);
  EXPECT_NEAR(angleBetween(next.yaw, expected.yaw), 0.0, kTolerance);
  if (out.HasMember("chosen_min_distance")) {
    const double least = *std::min_element(chosen.gaps.begin(), chosen.gaps.end());
    EXPECT_NEAR(least, numberOf(out["chosen_min_distance"]), kTolerance);
  }
  if (out.HasMember("distance_of_chosen_every_step")) {
    EXPECT_LE(difference(chosen.gaps, numbersOf(out["distance_of_chosen_every_step"])), kTolerance);
  }
  if (out.HasMember("probability_of_chosen")) {
    EXPECT_NEAR(chosen.probability, numberOf(out["probability_of_chosen"]), kTolerance);
  }
  if (out.HasMember("probabilities") && !out["probabilities"].Empty()) {
    EXPECT_LE(difference(probabilities(choice), numbersOf(out["probabilities"])), kTolerance);
  }
}

void expectWorld(const rapidjson::Value& in, const rapidjson::Value& out,
                 const RuleBasedOptions& options) {
  const DrivenBox ego = boxOf(memberOf(in, "ego"));
  const LaneSpline way = arc(ego.pose, numberOf(memberOf(in, "ego"), "curvature"));
  const bool is_on_lane = memberOf(memberOf(in, "ego"), "lane_matched").GetBool();
  std::vector<ExpectedBox> expected;
  for (const auto& other : memberOf(in, "others").GetArray()) {
    const DrivenBox box = boxOf(other);
    if (!isNear(ego.pose, box.pose, options)) continue;
    std::vector<LaneSpline> ways;
    for (const double curvature : numbersOf(memberOf(other, "curvatures"))) {
      ways.push_back(arc(box.pose, curvature));
    }
    const auto boxes = expectedBoxes(box, ways, expectedSpeeds(box.speed, options));
    expected.insert(expected.end(), boxes.begin(), boxes.end());
  }
  expectPlan(ego.pose, way, chooseProfile(ego, way, is_on_lane, expected, options), expected.size(),
             out);
}

LaneGraph laneGraph() {
  std::vector<Vector2> nodes;
  for (const auto& point : memberOf(fixture().at("lane_graph"), "xy").GetArray()) {
    nodes.emplace_back(numberOf(point[0]), numberOf(point[1]));
  }
  std::vector<LaneGraph::Edge> edges;
  for (const auto& edge : memberOf(fixture().at("lane_graph"), "edges").GetArray()) {
    edges.emplace_back(edge[0].GetUint64(), edge[1].GetUint64());
  }
  return {nodes, edges};
}

void expectMatches(const LaneGraph& graph, const std::vector<EdgeMatch>& matches,
                   const rapidjson::Value& out) {
  const rapidjson::Value& edges = memberOf(out, "matched_edges");
  ASSERT_EQ(matches.size(), edges.Size());
  for (rapidjson::SizeType i = 0; i < edges.Size(); ++i) {
    EXPECT_EQ(graph.edges()[matches[i].edge],
              LaneGraph::Edge(edges[i][0].GetUint64(), edges[i][1].GetUint64()));
    const std::vector<double> closest = numbersOf(memberOf(out, "closest")[i]);
    EXPECT_NEAR(matches[i].closest.x(), closest[0], kTolerance);
    EXPECT_NEAR(matches[i].closest.y(), closest[1], kTolerance);
  }
}

void expectSplines(const std::vector<LaneSpline>& splines, const rapidjson::Value& published) {
  ASSERT_EQ(splines.size(), published.Size());
  const double lengths[] = {0.0, 1.0, 6.0, 25.0, 60.0};
  for (rapidjson::SizeType i = 0; i < published.Size(); ++i) {
    for (rapidjson::SizeType k = 0; k < published[i].Size(); ++k) {
      const LaneSpline::Point point = splines[i].at(lengths[k]);
      EXPECT_LE(
          difference({point.position.x(), point.position.y(), point.heading.x(), point.heading.y()},
                     numbersOf(published[i][k])),
          kTolerance)
          << "way " << i << " after " << lengths[k] << " m";
    }
  }
}

TEST(RuleBasedParity, TheConfigurationHasThePublishedParameters) {
  SKIP_WITHOUT(fixture());
  expectEqual(shipped().rule_based, optionsOf("default"));
  expectEqual(shipped().tuned_rule_based, optionsOf("tuned"));
}

TEST(RuleBasedParity, SpeedProfiles) {
  SKIP_WITHOUT(fixture());
  for (const rapidjson::Value* test : fixture().cases("speed_profiles")) {
    const rapidjson::Value& in = memberOf(*test, "in");
    const rapidjson::Value& out = memberOf(*test, "out");
    SCOPED_TRACE("speed " + std::to_string(numberOf(in, "speed")));
    const auto profiles = speedProfiles(numberOf(in, "speed"), optionsOf(textOf(in, "parameters")));
    const rapidjson::Value& published = memberOf(out, "s1_s2_distance");
    ASSERT_EQ(profiles.size(), published.Size());
    for (rapidjson::SizeType i = 0; i < published.Size(); ++i) {
      EXPECT_LE(difference({profiles[i].middle_speed, profiles[i].end_speed,
                            profiles[i].plan.distances.back()},
                           numbersOf(published[i])),
                kTolerance)
          << "profile " << i;
    }
    const SpeedPlan& plan = profiles.at(7).plan;
    EXPECT_LE(difference(plan.speeds, numbersOf(memberOf(out, "speeds_of_profile_7"))), kTolerance);
    EXPECT_LE(difference(plan.distances, numbersOf(memberOf(out, "distances_of_profile_7"))),
              kTolerance);
  }
}

TEST(RuleBasedParity, BoxDistances) {
  SKIP_WITHOUT(fixture());
  for (const rapidjson::Value* test : fixture().cases("box_distances")) {
    const rapidjson::Value& in = memberOf(*test, "in");
    const rapidjson::Value& out = memberOf(*test, "out");
    const DrivenBox first = standingBox(memberOf(in, "first_x_y_heading_length_width"));
    const DrivenBox second = standingBox(memberOf(in, "second_x_y_heading_length_width"));
    const double gap = gapBetween(circlesOf(first.size), placedCircles(first),
                                  circlesOf(second.size), placedCircles(second));
    EXPECT_NEAR(gap, numberOf(out, "distance"), kTolerance);
    RuleBasedOptions options;
    options.distance_weight = numberOf(in, "wmin");
    options.distance_weight_rate = numberOf(in, "wfac");
    std::vector<double> ours;
    for (const int step : {0, 5, 25}) ours.push_back(collisionProbability(gap, step, options));
    EXPECT_LE(difference(ours, numbersOf(memberOf(out, "probability_at_steps_0_5_25"))),
              kTolerance);
  }
}

TEST(RuleBasedParity, Circles) {
  SKIP_WITHOUT(fixture());
  for (const rapidjson::Value* test : fixture().cases("box_distances")) {
    const rapidjson::Value& out = memberOf(*test, "out");
    if (!out.HasMember("circles_of_first")) continue;
    const DrivenBox box =
        standingBox(memberOf(memberOf(*test, "in"), "first_x_y_heading_length_width"));
    const BoxCircles circles = circlesOf(box.size);
    const PlacedCircles there = placedCircles(box);
    std::vector<std::vector<double>> ours = {
        {there.middle.x(), there.middle.y(), circles.middle_radius}};
    for (const Vector2& corner : there.corners) {
      ours.push_back({corner.x(), corner.y(), circles.corner_radius});
    }
    ASSERT_EQ(ours.size(), out["circles_of_first"].Size());
    for (const auto& circle : out["circles_of_first"].GetArray()) {
      double nearest = std::numeric_limits<double>::infinity();
      for (const auto& mine : ours) {
        nearest = std::min(nearest, difference(mine, numbersOf(circle)));
      }
      EXPECT_LE(nearest, kTolerance);
    }
  }
}

TEST(RuleBasedParity, Worlds) {
  SKIP_WITHOUT(fixture());
  int number = 0;
  for (const rapidjson::Value* test : fixture().cases("worlds")) {
    for (const auto& result : memberOf(*test, "out").GetObject()) {
      const std::string name = result.name.GetString();
      SCOPED_TRACE("world " + std::to_string(number) + ", " + name);
      expectWorld(memberOf(*test, "in"), result.value, optionsOf(name));
    }
    ++number;
  }
}

TEST(RuleBasedParity, WaysOnALaneGraph) {
  SKIP_WITHOUT(fixture());
  const LaneGraph graph = laneGraph();
  int number = 0;
  for (const rapidjson::Value* test : fixture().cases("lane_worlds")) {
    const rapidjson::Value& in = memberOf(*test, "in");
    const RuleBasedOptions options = optionsOf(textOf(in, "parameters"));
    for (const auto& object : memberOf(in, "objects").GetArray()) {
      const std::string id = textOf(object, "id");
      SCOPED_TRACE("lane world " + std::to_string(number) + ", " + id);
      const DrivenBox box = boxOf(object);
      const rapidjson::Value& out =
          memberOf(memberOf(memberOf(*test, "out"), "objects"), id.c_str());
      const std::vector<EdgeMatch> matches = matchedEdges(graph, box.pose, options);
      expectMatches(graph, matches, out);
      expectSplines(laneSplinesOf(graph, matches, box.pose, box.speed, {60.0, 0.0}, options),
                    memberOf(out, "splines_x_y_hcos_hsin_at_0_1_6_25_60"));
    }
    ++number;
  }
}

TEST(RuleBasedParity, LaneWorlds) {
  SKIP_WITHOUT(fixture());
  const LaneGraph graph = laneGraph();
  int number = 0;
  for (const rapidjson::Value* test : fixture().cases("lane_worlds")) {
    SCOPED_TRACE("lane world " + std::to_string(number++));
    const rapidjson::Value& in = memberOf(*test, "in");
    DrivenBox ego;
    std::vector<DrivenBox> others;
    for (const auto& object : memberOf(in, "objects").GetArray()) {
      if (textOf(object, "id") == "ego") {
        ego = boxOf(object);
      } else {
        others.push_back(boxOf(object));
      }
    }
    const RuleBasedPlan plan =
        planOnLanes(ego, others, graph, nullptr, optionsOf(textOf(in, "parameters")));
    expectPlan(ego.pose, plan.way, plan.choice, plan.other_futures,
               memberOf(memberOf(*test, "out"), "plan"));
  }
}

}  // namespace
}  // namespace forge
