#include "collision_forge/planner_test/settings/config.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "collision_forge/study/settings/study_config.h"

namespace forge {
namespace {

namespace fs = std::filesystem;

const char* const kShipped = COLLISION_FORGE_SOURCE_DIR "/config";

/// A copy of the shipped files that a test may spoil; removed with the test.
class SpoiltConfig : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    directory_ = fs::path(testing::TempDir()) / (std::string("config_test_") + test->name());
    restore();
  }
  void TearDown() override { fs::remove_all(directory_); }

  void restore() const {
    fs::remove_all(directory_);
    fs::create_directories(directory_);
    for (const auto& entry : fs::directory_iterator(kShipped)) {
      fs::copy(entry.path(), directory_ / entry.path().filename());
    }
  }

  void write(const std::string& file, const std::string& text) const {
    std::ofstream(directory_ / file) << text;
  }

  /// Replaces the first `from` in a fresh copy of a file.
  void replace(const std::string& file, const std::string& from, const std::string& to) const {
    restore();
    std::stringstream content;
    content << std::ifstream(directory_ / file).rdbuf();
    std::string text = content.str();
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from << " is not in " << file;
    write(file, text.replace(at, from.size(), to));
  }

  /// What loading says; empty when it succeeds.
  std::string complaint() const {
    try {
      loadStudyConfig(directory_.string());
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "";
  }

  /// The complaint about a file after a replacement names all of `parts`.
  void expectComplaint(const std::string& file, const std::string& from, const std::string& to,
                       const std::vector<std::string>& parts) const {
    replace(file, from, to);
    const std::string text = complaint();
    EXPECT_NE(text.find(file), std::string::npos) << to << ": \"" << text << "\"";
    for (const std::string& part : parts) {
      EXPECT_NE(text.find(part), std::string::npos) << part << " in \"" << text << "\"";
    }
  }

  fs::path directory_;
};

TEST_F(SpoiltConfig, UnspoiltCopyLoads) { EXPECT_EQ(complaint(), ""); }

TEST_F(SpoiltConfig, TheProductNeedsNoFileOfTheStudy) {
  for (const char* file :
       {"dataset.yaml", "evaluation.yaml", "generators.yaml", "network_published.yaml",
        "planner_training.yaml", "speed_model_fit.yaml", "training.yaml"}) {
    ASSERT_TRUE(fs::remove(directory_ / file)) << file;
  }
  EXPECT_NO_THROW(loadConfig(directory_.string()));
  EXPECT_NE(complaint(), "");
}

TEST_F(SpoiltConfig, UnknownKeysAreRefused) {
  for (const auto& [file, section] :
       std::vector<std::pair<std::string, std::string>>{{"vehicle_limits.yaml", "vehicle_limits"},
                                                        {"ego_vehicle.yaml", "ego_vehicle"},
                                                        {"prediction.yaml", "prediction"},
                                                        {"encoding.yaml", "encoding"},
                                                        {"evaluation.yaml", "evaluation"},
                                                        {"dataset.yaml", "dataset"},
                                                        {"ego_futures.yaml", "ego_futures"},
                                                        {"speed_model_fit.yaml", "speed_model_fit"},
                                                        {"training.yaml", "training"},
                                                        {"conversion.yaml", "conversion"},
                                                        {"input_limits.yaml", "input_limits"},
                                                        {"models.yaml", "models"},
                                                        {"attacked_bag.yaml", "attacked_bag"},
                                                        {"drawing.yaml", "drawing"},
                                                        {"requests.yaml", "requests"},
                                                        {"search.yaml", "search"},
                                                        {"search.yaml", "bicycle_family"},
                                                        {"verification.yaml", "verification"},
                                                        {"believability.yaml", "believability"}}) {
    expectComplaint(file, "\n" + section + ":", "\n" + section + ":\n  stray: 7.5",
                    {section + ".stray", "7.5", "unknown"});
  }
  expectComplaint("crash_definition.yaml", "{min_heading: 0.1745",
                  "{stray: 7.5, min_heading: 0.1745",
                  {"crash_definition.types.lane_change.stray", "7.5", "unknown"});
  for (const std::string section : {"paths", "lateral", "no_profiles"}) {
    expectComplaint("ego_futures.yaml", "\n  " + section + ":",
                    "\n  " + section + ":\n    stray: 7.5",
                    {"ego_futures." + section + ".stray", "7.5", "unknown"});
  }
  expectComplaint("models.yaml", "\n      speed:", "\n      stray: 7.5\n      speed:",
                  {"models.recorded_speeds.feature_weights.stray", "7.5", "unknown"});
  expectComplaint("crash_definition.yaml", "    ltap:", "    u_turn: {}\n    ltap:",
                  {"crash_definition.types.u_turn", "unknown"});
}

TEST_F(SpoiltConfig, UnknownSectionsAreRefused) {
  for (const char* file : {"vehicle_limits.yaml",   "ego_vehicle.yaml", "locations.yaml",
                           "crash_definition.yaml", "prediction.yaml",  "search.yaml",
                           "verification.yaml",     "encoding.yaml",    "conversion.yaml",
                           "drawing.yaml",          "requests.yaml",    "evaluation.yaml",
                           "dataset.yaml",          "ego_futures.yaml", "methods.yaml",
                           "speed_model_fit.yaml",  "models.yaml",      "training.yaml",
                           "planner_training.yaml", "planners.yaml",    "believability.yaml",
                           "attacked_bag.yaml",     "input_limits.yaml"}) {
    expectComplaint(file, "\n", "\nstray: 7.5\n", {"stray", "7.5", "unknown"});
  }
}

TEST_F(SpoiltConfig, MissingKeysAreNamed) {
  expectComplaint("vehicle_limits.yaml", "max_curvature:", "#",
                  {"vehicle_limits.strict.max_curvature", "missing"});
  expectComplaint("ego_vehicle.yaml", "width:", "#", {"ego_vehicle.width", "missing"});
  expectComplaint("prediction.yaml", "  step:", "#", {"prediction.step", "missing"});
  expectComplaint("encoding.yaml", "max_lanes:", "#", {"encoding.max_lanes", "missing"});
  expectComplaint("search.yaml", "  draws:", "#", {"search.draws", "missing"});
  expectComplaint("search.yaml", "  max_miss:", "#", {"bicycle_family.max_miss", "missing"});
  expectComplaint("models.yaml", "neighbors:", "#",
                  {"models.recorded_speeds.neighbors", "missing"});
  expectComplaint("models.yaml", "bend_turn:", "#",
                  {"models.recorded_speeds.feature_weights.bend_turn", "missing"});
  expectComplaint("speed_model_fit.yaml", "centers:", "#", {"speed_model_fit.centers", "missing"});
  expectComplaint("models.yaml",
                  "pattern_network:", "other:", {"models.pattern_network", "missing"});
  expectComplaint("training.yaml", "  max_ways:", "#", {"features.max_ways", "missing"});
  expectComplaint("training.yaml", "  hidden:", "#", {"network.hidden", "missing"});
  expectComplaint("planner_training.yaml", "terms:", "#", {"planner_training.terms", "missing"});
  expectComplaint("planners.yaml", "start_timeout:", "#", {"torchscript.start_timeout", "missing"});
  expectComplaint("conversion.yaml", "map_radius:", "#", {"conversion.map_radius", "missing"});
  expectComplaint("attacked_bag.yaml", "frame_rate:", "#", {"attacked_bag.frame_rate", "missing"});
  expectComplaint("drawing.yaml", "view_margin:", "#", {"drawing.view_margin", "missing"});
  expectComplaint("requests.yaml", "stride:", "#", {"requests.stride", "missing"});
  expectComplaint("dataset.yaml", "sheet_rows:", "#", {"dataset.sheet_rows", "missing"});
  expectComplaint("dataset.yaml", "    ltap:", "#", {"dataset.attempts.ltap", "missing"});
  expectComplaint("planners.yaml", "wheelbase:", "#", {"car.wheelbase", "missing"});
  expectComplaint("planners.yaml", "tracker_wheelbase:", "#", {"pdm.tracker_wheelbase", "missing"});
  expectComplaint("planners.yaml", "max_yaw_rate:", "#",
                  {"pdm.scoring.comfort.max_yaw_rate", "missing"});
  expectComplaint("planners.yaml", "bend_length:", "#", {"rule_based.bend_length", "missing"});
  expectComplaint("planners.yaml", "\nrule_based:", "\nstrive:", {"rule_based is missing"});
  expectComplaint("planners.yaml", "margin:", "#", {"idm.standard.margin", "missing"});
  expectComplaint("planners.yaml", "behind_angle:", "#", {"pdm.scoring.behind_angle", "missing"});
  expectComplaint("planners.yaml", "timeout:", "#", {"external.timeout", "missing"});
  expectComplaint("planners.yaml", "draws:", "#", {"avoidability.draws", "missing"});
  expectComplaint("crash_definition.yaml", "rules:", "#", {"crash_definition.rules", "missing"});
  expectComplaint("crash_definition.yaml", "time_tolerance:", "#",
                  {"crash_definition.time_tolerance", "missing"});
  expectComplaint("crash_definition.yaml",
                  "    ltap:", "    turn:", {"crash_definition.types.ltap", "missing"});
  expectComplaint("crash_definition.yaml", ", nominal_heading: 0.0,", ",",
                  {"crash_definition.types.rear_end.nominal_heading", "missing"});
}

TEST_F(SpoiltConfig, MissingSectionsAreNamed) {
  write("locations.yaml", "places: {boston: right}\n");
  EXPECT_NE(complaint().find("locations.yaml: locations is missing"), std::string::npos);
  expectComplaint("search.yaml", "bicycle_family:", "tricycle:", {"bicycle_family is missing"});
}

TEST_F(SpoiltConfig, MissingAndEmptyAndMalformedFilesAreNamed) {
  fs::remove(directory_ / "encoding.yaml");
  EXPECT_NE(complaint().find("encoding.yaml"), std::string::npos);
  for (const char* text : {"", "encoding", "- 1\n- 2\n", "encoding: {lane_radius: [}\n"}) {
    write("encoding.yaml", text);
    EXPECT_NE(complaint().find("encoding.yaml"), std::string::npos) << text;
  }
  write("encoding.yaml", "encoding: 5\n");
  EXPECT_NE(complaint().find("encoding = 5 is not a mapping"), std::string::npos);
}

TEST_F(SpoiltConfig, KeysGivenTwiceAreRefused) {
  expectComplaint("prediction.yaml",
                  "min_tta:", "min_tta: 0.7\n  min_tta:", {"prediction.min_tta", "twice"});
}

TEST_F(SpoiltConfig, WrongTypesAreRefused) {
  expectComplaint("vehicle_limits.yaml", "max_speed: 36.0", "max_speed: fast",
                  {"vehicle_limits.drivable.car.max_speed", "fast", "not a number"});
  expectComplaint("vehicle_limits.yaml", "max_speed: 36.0", "max_speed: 36.0 km/h",
                  {"vehicle_limits.drivable.car.max_speed", "36.0 km/h", "not a number"});
  expectComplaint("ego_vehicle.yaml", "width: 1.730", "width: [1.73]",
                  {"ego_vehicle.width", "[1.73]", "not a number"});
  expectComplaint("prediction.yaml", "history_frames: 8 ", "history_frames: 8.5 ",
                  {"prediction.history_frames", "8.5", "not an integer"});
  expectComplaint("search.yaml", "draws: 8", "draws: ", {"search.draws", "not an integer"});
  expectComplaint("search.yaml", "depth: 0.25", "depth: deep",
                  {"search.depth", "deep", "not a number"});
  for (const char* rules : {"Full", "some", "[full]", "1"}) {
    expectComplaint("crash_definition.yaml", "rules: full", std::string("rules: ") + rules,
                    {"crash_definition.rules", rules, "none of full, angle"});
  }
  expectComplaint("ego_futures.yaml", "kept_offset: 0.3", "kept_offset: 1.3",
                  {"ego_futures.lateral.kept_offset", "1.3", "0 to 1"});
  expectComplaint("models.yaml", "closing: 22.8", "closing: -1.0",
                  {"models.recorded_speeds.feature_weights.closing", "-1.0"});
  expectComplaint("training.yaml", "head: region_proposal", "head: region",
                  {"features.head", "region", "none of"});
  expectComplaint("training.yaml", "agent_frames: 1", "agent_frames: 9",
                  {"features.agent_frames", "9", "8"});
  expectComplaint("training.yaml", "  dropout: 0.15", "  dropout: 1", {"training.dropout", "1"});
  expectComplaint("speed_model_fit.yaml", "folds: 5", "folds: 1",
                  {"speed_model_fit.folds", "1", "2 "});
  expectComplaint("speed_model_fit.yaml", "gain_ridge: 0.1", "gain_ridge: 0",
                  {"speed_model_fit.gain_ridge", "0", "not positive"});
  expectComplaint("locations.yaml", "boston: right", "boston: middle",
                  {"locations.boston", "middle", "right"});
  write("crash_definition.yaml",
        "crash_definition: {rules: full, time_tolerance: 1, min_confidence: 0, limits: strict, "
        "believable: false, types: {lane_change: 0.2}}");
  EXPECT_NE(complaint().find("crash_definition.types.lane_change = 0.2 is not a mapping"),
            std::string::npos);
}

TEST_F(SpoiltConfig, TypeRulesAreReadByName) {
  replace("crash_definition.yaml", "rules: full", "rules: angle");
  EXPECT_EQ(loadStudyConfig(directory_.string()).crash.rules, TypeRules::kAngle);
}

TEST_F(SpoiltConfig, ColorsAreThreeSharesOfOne) {
  const std::string shipped = "lane_color: [0.68, 0.71, 0.74]";
  for (const char* color : {"[0.68, 0.71]", "[0.68, 0.71, 0.74, 1.0]", "blue", "[0.68, 0.71, 255]",
                            "[-0.1, 0.71, 0.74]", "[.nan, 0.71, 0.74]", "[red, 0.71, 0.74]"}) {
    expectComplaint("drawing.yaml", shipped, std::string("lane_color: ") + color,
                    {"drawing.lane_color"});
  }
  expectComplaint("drawing.yaml", "png_width: 900", "png_width: 10",
                  {"drawing.png_width", "= 10", "within 64"});
}

TEST_F(SpoiltConfig, TheConfidenceCurveIsSharesThatRise) {
  expectComplaint("search.yaml", "confidence_curve: [0.0", "confidence_curve: [0.5",
                  {"search.confidence_curve", "is below the one before"});
  expectComplaint("search.yaml", "confidence_curve: [0.0", "confidence_curve: [-0.1",
                  {"search.confidence_curve", "-0.1"});
  expectComplaint("search.yaml", "confidence_curve: [0.0", "confidence_curve: 0.0 #",
                  {"search.confidence_curve", "is not a list of numbers"});
}

TEST_F(SpoiltConfig, ListsOfNumbersKeepTheirRange) {
  const std::string shipped = "lateral_offsets: [0.0, -1.0, 1.0]";
  expectComplaint("planners.yaml", shipped, "lateral_offsets: [0.0, 20.0]",
                  {"pdm.lateral_offsets", "20.0", "not within -10 to 10"});
  for (const char* offsets : {"[]", "0.0", "[left]"}) {
    expectComplaint("planners.yaml", shipped, std::string("lateral_offsets: ") + offsets,
                    {"pdm.lateral_offsets", "not a"});
  }
  expectComplaint("planners.yaml", "ahead_angle: 0.5236", "ahead_angle: 3.0",
                  {"pdm.scoring.behind_angle", "2.61799388", "not within 3 to"});
}

TEST_F(SpoiltConfig, PlannersAreCalledBetweenStepsOfARollout) {
  expectComplaint("planners.yaml", "rollout:\n  step: 0.1", "rollout:\n  step: 0.3",
                  {"planning.interval", "no multiple of rollout.step", "0.3"});
}

TEST_F(SpoiltConfig, NumbersThatAreNotFiniteAreRefused) {
  expectComplaint("vehicle_limits.yaml", "max_braking: 8.0", "max_braking: .inf",
                  {"vehicle_limits.drivable.car.max_braking", ".inf", "not finite"});
  expectComplaint("prediction.yaml", "tail: 2.0", "tail: .nan",
                  {"prediction.tail", ".nan", "not finite"});
  expectComplaint("ego_vehicle.yaml", "center_offset: 1.385", "center_offset: -.inf",
                  {"ego_vehicle.center_offset", "-.inf", "not finite"});
  expectComplaint("search.yaml", "depth: 0.25", "depth: .nan",
                  {"search.depth", ".nan", "not finite"});
}

/// Every number of these files has a sign; -1 is outside all of their domains.
TEST_F(SpoiltConfig, NegativeValuesAreRefusedWhereverTheyMakeNoSense) {
  for (const char* file : {"vehicle_limits.yaml", "prediction.yaml", "search.yaml", "encoding.yaml",
                           "methods.yaml", "crash_definition.yaml", "planners.yaml"}) {
    restore();
    std::stringstream content;
    content << std::ifstream(directory_ / file).rdbuf();
    const std::string text = content.str();
    int spoilt = 0;
    for (std::size_t at = text.find(": "); at != std::string::npos; at = text.find(": ", at + 1)) {
      const std::size_t end = text.find_first_of(" ,}\n", at + 2);
      const std::string value = text.substr(at + 2, end - at - 2);
      const std::size_t line = text.rfind('\n', at) + 1;
      if (text.substr(line, at - line).find('#') != std::string::npos) continue;
      if (value.empty() || value.find_first_not_of("0123456789.") != std::string::npos) continue;
      write(file, std::string(text).replace(at + 2, value.size(), "-1"));
      EXPECT_NE(complaint().find("-1"), std::string::npos) << text.substr(at - 20, 30);
      ++spoilt;
    }
    EXPECT_GE(spoilt, 3) << file;
  }
}

TEST_F(SpoiltConfig, ZeroIsRefusedWhereADivisionOrACountNeedsMore) {
  expectComplaint("prediction.yaml", "history_frames: 8", "history_frames: 0",
                  {"prediction.history_frames", "= 0", "within 1"});
  expectComplaint("prediction.yaml", "history_frames: 8", "history_frames: 257",
                  {"prediction.history_frames", "257"});
  expectComplaint("prediction.yaml", "  step: 0.1", "  step: 0.0", {"prediction.step", "0.0"});
  expectComplaint("prediction.yaml", "motion_frames: 4", "motion_frames: 1",
                  {"prediction.motion_frames", "= 1"});
  expectComplaint("prediction.yaml", "lane_return_distance: 15.0", "lane_return_distance: 0",
                  {"prediction.lane_return_distance", "= 0"});
  expectComplaint("requests.yaml", "stride: 2.0", "stride: 0.0", {"requests.stride", "0.0"});
  expectComplaint("dataset.yaml", "stride: 0.5", "stride: 0.0", {"dataset.begin_stride", "0.0"});
  expectComplaint("dataset.yaml", "min_length: 4.5", "min_length: 3.5", {"dataset.min_length"});
  expectComplaint("dataset.yaml", "max_length: 9.0", "max_length: 4.0", {"dataset.max_length"});
  expectComplaint("dataset.yaml", "rear_end: 1", "rear_end: -1", {"dataset.attempts.rear_end"});
  expectComplaint("dataset.yaml", "min_type_share: 0.02", "min_type_share: 0.21",
                  {"dataset.min_type_share"});
  expectComplaint("dataset.yaml", "max_tta_ratio: 2.0", "max_tta_ratio: 0.9",
                  {"dataset.max_tta_ratio"});
  expectComplaint("dataset.yaml", "val_share: 0.1", "val_share: 0.31", {"dataset.val_share"});
  expectComplaint("dataset.yaml", "time_tolerance: 0.1", "time_tolerance: 0.02",
                  {"dataset.time_tolerance"});
  for (const std::string beyond : {"0.02", "61", "1e308", ".inf"}) {
    expectComplaint("crash_definition.yaml", "time_tolerance: 0.5", "time_tolerance: " + beyond,
                    {"crash_definition.time_tolerance"});
  }
  expectComplaint("input_limits.yaml", "max_box: 50.0", "max_box: 0.05", {"input_limits.max_box"});
  expectComplaint("input_limits.yaml", "max_points: 5000", "max_points: 1",
                  {"input_limits.max_points"});
  expectComplaint("input_limits.yaml", "max_line: 16000000", "max_line: 0",
                  {"input_limits.max_line"});
  expectComplaint("requests.yaml", "[2.0,", "[-2.0,", {"requests.ttas", "-2.0"});
  expectComplaint("requests.yaml", "speed: 2.0", "speed: -1", {"requests.min_ego_speed", "-1"});
  expectComplaint("evaluation.yaml", "resamples: 1000", "resamples: 0",
                  {"evaluation.statistics.resamples", "= 0"});
  expectComplaint("evaluation.yaml", "steps_per_interval: 5", "steps_per_interval: 0",
                  {"evaluation.published.steps_per_interval", "= 0"});
  expectComplaint("evaluation.yaml", "box_width: 2.0", "box_width: 0.0",
                  {"evaluation.collide.box_width", "0.0"});
  expectComplaint("search.yaml", "  step: 0.1", "  step: 0", {"search.step", "= 0"});
  for (const std::string count : {"max_attackers: 24", "ego_poses: 3", "draws: 8", "kept: 10"}) {
    const std::string key = count.substr(0, count.find(':'));
    expectComplaint("search.yaml", count, key + ": 0", {"search." + key, "= 0", "within 1"});
  }
  expectComplaint("search.yaml", "iterations: 12", "iterations: 0",
                  {"bicycle_family.iterations", "= 0"});
  for (const std::string number :
       {"max_miss: 1.0", "position_scale: 0.1", "heading_scale: 0.03", "speed_scale: 3.0",
        "acceleration_scale: 40.0", "curvature_scale: 1.0"}) {
    const std::string key = number.substr(0, number.find(':'));
    expectComplaint("search.yaml", number, key + ": 0",
                    {"bicycle_family." + key, "= 0", "not positive"});
  }
  expectComplaint("encoding.yaml", "max_lanes: 128", "max_lanes: 0", {"encoding.max_lanes", "= 0"});
  for (const std::string number :
       {"spacing: 1.0", "desired_speed: 10.0", "timeout: 2.0", "return_time: 0.4"}) {
    const std::string key = number.substr(0, number.find(':'));
    expectComplaint("planners.yaml", number, key + ": 0 ", {key, "= 0", "not positive"});
  }
  for (const std::string step :
       {"rollout:\n  step: 0.1", "interval: 0.1", "interval: 0.5", "step: 0.2"}) {
    const std::size_t value = step.rfind(' ') + 1;
    const std::size_t key = step.rfind(' ', value - 2) + 1;
    expectComplaint("planners.yaml", step, step.substr(0, value) + "1e-9",
                    {step.substr(key, value - key - 2), "= 1e-9", "within 0.01"});
  }
  expectComplaint("planners.yaml", "[0.0, -2.0,", "[0.0, -9.0,",
                  {"avoidability.accelerations", "-9.0"});
  expectComplaint("ego_vehicle.yaml", "length: 4.084", "length: 0.0",
                  {"ego_vehicle.length", "0.0"});
}

TEST_F(SpoiltConfig, ValuesBeyondEachOtherOrTheirRangeAreRefused) {
  expectComplaint("prediction.yaml", "max_tta: 9.0", "max_tta: 0.4",
                  {"prediction.max_tta", "0.4", "within 0.5"});
  expectComplaint("prediction.yaml", "min_history_frames: 2", "min_history_frames: 9",
                  {"prediction.min_history_frames", "= 9", "to 8"});
  expectComplaint("crash_definition.yaml", "max_heading: 0.5236", "max_heading: 0.1",
                  {"crash_definition.types.lane_change.max_heading", "0.1", "within 0.1745"});
  expectComplaint("crash_definition.yaml", "nominal_heading: 0.2618", "nominal_heading: 0.6",
                  {"crash_definition.types.lane_change.nominal_heading", "0.6"});
  expectComplaint("crash_definition.yaml", "max_heading: 3.1416", "max_heading: 180",
                  {"crash_definition.types.opposite_direction.max_heading", "180"});
  for (const std::string share :
       {"limit_margin: 0.998", "good_share: 0.9", "good_off_road: 0.05", "closeness_weight: 0.2"}) {
    const std::string key = share.substr(0, share.find(':'));
    expectComplaint("search.yaml", share, key + ": 1.1", {"search." + key, "1.1", "within 0 to 1"});
  }
  expectComplaint("crash_definition.yaml", "min_confidence: 0.05", "min_confidence: 1.1",
                  {"crash_definition.min_confidence", "1.1", "within 0 to 1"});
  expectComplaint("methods.yaml", "libraries: []", "libraries: [1, \"\"]",
                  {"libraries", "is not a path"});
  expectComplaint(
      "crash_definition.yaml", "max_approach: 2.3562", "max_approach: 0.7",
      {"crash_definition.types.junction_crossing.max_approach", "0.7", "within 0.7854"});
  expectComplaint("evaluation.yaml", "confidence: 0.95", "confidence: 1.1",
                  {"evaluation.statistics.confidence", "1.1"});
  expectComplaint("evaluation.yaml", "min_overlap: 0.02", "min_overlap: 2",
                  {"evaluation.published.min_overlap", "= 2"});
  expectComplaint("search.yaml", "tail: 2.0", "tail: 0.05", {"search.tail", "0.05"});
  expectComplaint("ego_vehicle.yaml", "center_offset: 1.385", "center_offset: 2.1",
                  {"ego_vehicle.center_offset", "2.1"});
}

}  // namespace
}  // namespace forge
