#include "collision_forge/planner_test/settings/config.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "collision_forge/study/settings/study_config.h"
#include "io/logs/nuscenes_fixture.h"

namespace forge {
namespace {

namespace fs = std::filesystem;

const char* const kShipped = COLLISION_FORGE_SOURCE_DIR "/config";

/// A copy of the shipped configuration that a test may corrupt; removed after the test.
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
    fs::copy(kShipped, directory_, fs::copy_options::recursive);
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

  /// Name and text of every file that loading reads, as shipped.
  std::map<std::string, std::string> shippedFiles() const {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(kShipped)) {
      if (!entry.is_regular_file()) continue;
      const std::string file = fs::relative(entry.path(), kShipped).string();
      std::stringstream content;
      content << std::ifstream(entry.path()).rdbuf();
      write(file, "");
      if (!complaint().empty()) files[file] = content.str();
      write(file, content.str());
    }
    return files;
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
       {"study/dataset.yaml", "study/generators.yaml", "study/network_published.yaml",
        "study/speed_model_fit.yaml", "study/training.yaml"}) {
    ASSERT_TRUE(fs::remove(directory_ / file)) << file;
  }
  EXPECT_NO_THROW(loadConfig(directory_.string()));
  EXPECT_NE(complaint(), "");
}

/// The shipped configuration with an overlay.
class OverlaidConfig : public testing::Test {
 protected:
  Config load() const { return loadConfig({kShipped, overlay_.path()}); }

  std::string complaint() const {
    try {
      loadStudyConfig({kShipped, overlay_.path()});
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "";
  }

  TemporaryFolder overlay_;
};

TEST_F(OverlaidConfig, OnlyItsKeysDiffer) {
  const Config shipped = loadConfig(kShipped);
  overlay_.write("believability.yaml", "believability: {before_contact: 1.0}\n");
  const Config config = load();
  EXPECT_EQ(config.attack.verification.believability.before_contact, 1.0);
  EXPECT_EQ(config.attack.verification.believability.pull_out,
            shipped.attack.verification.believability.pull_out);
  EXPECT_EQ(config.pattern_network, shipped.pattern_network);
  EXPECT_EQ(config.planners.torchscript.file, shipped.planners.torchscript.file);
}

TEST(ShippedConfig, TrucksAreTypicallyAsLowAsVansUpToTheirLongestVan) {
  const double van = loadConfig(kShipped).attack.verification.drivable.van_length;
  EXPECT_LT(typicalHeight(AgentClass::kTruck, {van - 0.01, 2.0}),
            typicalHeight(AgentClass::kTruck, {van, 2.0}));
}

TEST_F(OverlaidConfig, AnEmptyOneChangesNothing) {
  overlay_.write("live.yaml", "# nothing yet\n");
  EXPECT_EQ(load().live.kept_for, loadConfig(kShipped).live.kept_for);
}

TEST_F(OverlaidConfig, ItsPathsAreRelativeToItsFolder) {
  overlay_.write("models.yaml", "models: {speed_model: mine.jsonl}\n");
  overlay_.write("methods.yaml", "libraries: [lib/mine.so]\n");
  EXPECT_EQ(load().speed_model, overlay_.path() + "/mine.jsonl");
  EXPECT_THAT(load().method_libraries, testing::ElementsAre(overlay_.path() + "/lib/mine.so"));
}

/// The overlay is a copied and edited configuration folder.
TEST_F(OverlaidConfig, RepeatedPathsStayRelativeToTheInstalledFolder) {
  fs::copy(kShipped, overlay_.path(), fs::copy_options::recursive);
  EXPECT_EQ(complaint(), "");
  EXPECT_EQ(load().speed_model, loadConfig(kShipped).speed_model);
  EXPECT_EQ(generatorWeights(load()), generatorWeights(loadConfig(kShipped)));
}

TEST_F(OverlaidConfig, AnUnknownFileIsRejectedWithASimilarName) {
  overlay_.write("serch.yaml", "search: {draws: 4}\n");
  EXPECT_THAT(complaint(),
              testing::StartsWith(overlay_.path() + "/serch.yaml: is not a file of the"));
  EXPECT_THAT(complaint(), testing::EndsWith("; did you mean search.yaml?"));
}

TEST_F(OverlaidConfig, AStudyFileInTheWrongFolderIsReportedWithItsFolder) {
  overlay_.write("dataset.yaml", "dataset: {max_length: 8.0}\n");
  EXPECT_THAT(complaint(), testing::EndsWith("; did you mean study/dataset.yaml?"));
}

TEST_F(OverlaidConfig, AnUnknownKeyIsRejectedWithItsFileAndASimilarName) {
  overlay_.write("believability.yaml", "believability: {befor_contact: 1.0}\n");
  EXPECT_EQ(complaint(), overlay_.path() +
                             "/believability.yaml: believability.befor_contact = 1.0 is an unknown "
                             "key; did you mean before_contact?");
}

TEST_F(OverlaidConfig, ABadValueIsRejectedWithItsFile) {
  overlay_.write("live.yaml", "live: {kept_for: -1}\n");
  EXPECT_EQ(complaint(), overlay_.path() + "/live.yaml: live.kept_for = -1 is not within 0 to inf");
}

TEST_F(OverlaidConfig, MappingsOfTopicsMayHaveAnyName) {
  overlay_.write("topics_mine.yaml", "ego: {}\n");
  EXPECT_EQ(complaint(), "");
}

TEST(ConfigFolder, AnOverlayMustBeAFolder) {
  EXPECT_THROW(loadConfig({kShipped, "/nowhere"}), ConfigError);
}

TEST_F(OverlaidConfig, ItsStudyFilesAreInStudy) {
  fs::create_directory(overlay_.path() + "/study");
  overlay_.write("study/dataset.yaml", "dataset: {max_length: 8.0}\n");
  EXPECT_EQ(loadStudyConfig({kShipped, overlay_.path()}).dataset.max_length, 8.0);
}

TEST_F(OverlaidConfig, NonCommercialWeightsCanBeDisabled) {
  overlay_.write("models.yaml", "models: {non_commercial_weights: false}\n");
  const Config config = load();
  EXPECT_EQ(config.pattern_network, "");
  EXPECT_EQ(config.speed_model, "");
  EXPECT_EQ(config.planners.torchscript.file, "");
  for (const auto& [model, files] : generatorWeights(config)) EXPECT_TRUE(files.empty()) << model;
  EXPECT_THAT(describeWeights(config),
              testing::HasSubstr("switched off by " + std::string(kNonCommercialKey)));
}

TEST_F(OverlaidConfig, ItsOwnWeightsStayWithNonCommercialOnesDisabled) {
  overlay_.write("models.yaml",
                 "models: {non_commercial_weights: false, speed_model: mine.jsonl}\n");
  EXPECT_EQ(load().speed_model, overlay_.path() + "/mine.jsonl");
}

TEST(DescribeWeights, NamesTheWeightsInUseAndTheKeyThatDisablesThem) {
  EXPECT_THAT(describeWeights(loadConfig(kShipped)),
              testing::AllOf(testing::HasSubstr("pattern_network.bin, speed_model.jsonl, "
                                                "planner.pt"),
                             testing::HasSubstr(std::string(kNonCommercialKey) + ": false")));
}

/// Inserts an unknown key into every section and every mapping of one.
TEST_F(SpoiltConfig, UnknownKeysAreRejected) {
  int tried = 0;
  for (const auto& [file, text] : shippedFiles()) {
    std::stringstream lines(text);
    std::string line;
    for (std::size_t end = 0; std::getline(lines, line);) {
      end += line.size() + 1;
      const std::string heading = line.substr(0, line.find_last_not_of(' ') + 1);
      if (heading.empty() || heading.back() != ':' || heading.find('#') != std::string::npos) {
        continue;
      }
      const std::size_t indent = heading.find_first_not_of(' ') + 2;
      if (text[text.find_first_not_of(" \n", end)] == '{') continue;
      write(file, std::string(text).insert(end, std::string(indent, ' ') + "stray: 7.5\n"));
      const std::string said = complaint();
      EXPECT_NE(said.find("stray"), std::string::npos) << file << ", " << heading << said;
      EXPECT_NE(said.find(file), std::string::npos) << said;
      ++tried;
    }
    write(file, text);
  }
  EXPECT_GT(tried, 20);
  expectComplaint("search.yaml", "\n", "\nstray: 7.5\n", {"stray", "7.5", "unknown"});
}

/// Renames every ninth key of all files.
TEST_F(SpoiltConfig, MissingKeysAreNamed) {
  int count = 0;
  for (const auto& [file, text] : shippedFiles()) {
    if (file == "export.yaml" || file == "locations.yaml") continue;  // keys are names of places
    if (file == "categories.yaml") continue;                          // keys are names of classes
    if (file == "study/generator_weights.yaml") continue;             // keys are names of methods
    std::size_t begin = 0;
    for (; begin < text.size(); begin = text.find('\n', begin) + 1) {
      const std::size_t key = text.find_first_not_of(' ', begin);
      const std::size_t colon = text.find_first_of(":#\n", key);
      if (key == begin || colon == std::string::npos || text[colon] != ':') continue;
      if (++count % 9 != 0) continue;
      write(file, std::string(text).insert(key, "other_"));
      EXPECT_NE(complaint().find(file), std::string::npos) << text.substr(key, colon - key);
    }
    write(file, text);
  }
  EXPECT_GT(count, 100);
  expectComplaint("planners.yaml", "\nrule_based:", "\nstrive:", {"rule_based is missing"});
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

TEST_F(SpoiltConfig, WrongValuesAreReportedWithTheAllowedRange) {
  expectComplaint("vehicle_limits.yaml", "max_speed: 36.0", "max_speed: 36.0 km/h",
                  {"vehicle_limits.drivable.car.max_speed", "36.0 km/h", "not a number"});
  expectComplaint("prediction.yaml", "history_frames: 8", "history_frames: 8.5",
                  {"prediction.history_frames", "8.5", "not an integer"});
  expectComplaint("prediction.yaml", "history_frames: 8", "history_frames: 0",
                  {"prediction.history_frames", "= 0", "within 1"});
  expectComplaint("crash_definition.yaml", "rules: full", "rules: some",
                  {"crash_definition.rules", "some", "not one of full, angle"});
  expectComplaint("crash_definition.yaml", "min_confidence: 0.05", "min_confidence: 1.1",
                  {"crash_definition.min_confidence", "1.1", "within 0 to 1"});
  expectComplaint("ego_vehicle.yaml", "length: 4.084", "length: .inf",
                  {"ego_vehicle.length", ".inf", "not finite"});
  expectComplaint("locations.yaml", "boston: right", "boston: middle",
                  {"locations.boston", "middle", "right"});
  expectComplaint("planners.yaml", "lateral_offsets: [0.0, -1.0, 1.0]",
                  "lateral_offsets: [0.0, 20.0]",
                  {"pdm.lateral_offsets", "20.0", "not within -10 to 10"});
}

TEST_F(SpoiltConfig, TypeRulesAreReadByName) {
  replace("crash_definition.yaml", "rules: full", "rules: angle");
  EXPECT_EQ(loadStudyConfig(directory_.string()).crash.rules, TypeRules::kAngle);
}

TEST_F(SpoiltConfig, ColorsHaveThreeSharesWithinZeroToOne) {
  const std::string shipped = "ego_color: [0.12, 0.40, 0.80]";
  for (const char* color : {"[0.68, 0.71]", "[0.68, 0.71, 0.74, 1.0]", "blue", "[0.68, 0.71, 255]",
                            "[-0.1, 0.71, 0.74]", "[.nan, 0.71, 0.74]", "[red, 0.71, 0.74]"}) {
    expectComplaint("drawing.yaml", shipped, std::string("ego_color: ") + color,
                    {"drawing.ego_color"});
  }
  expectComplaint("drawing.yaml", "png_width: 900", "png_width: 10",
                  {"drawing.png_width", "= 10", "within 64"});
}

TEST_F(SpoiltConfig, TheConfidenceCurveMustIncrease) {
  expectComplaint("search.yaml", "confidence_curve: [0.0", "confidence_curve: [0.5",
                  {"search.confidence_curve", "is below the previous value"});
  expectComplaint("search.yaml", "confidence_curve: [0.0", "confidence_curve: [-0.1",
                  {"search.confidence_curve", "-0.1"});
  expectComplaint("search.yaml", "confidence_curve: [0.0", "confidence_curve: 0.0 #",
                  {"search.confidence_curve", "is not a list of numbers"});
}

TEST_F(SpoiltConfig, PlanningIntervalMustBeAMultipleOfTheRolloutStep) {
  expectComplaint("planners.yaml", "rollout:\n  step: 0.1", "rollout:\n  step: 0.3",
                  {"planning.interval", "not a multiple of rollout.step", "0.3"});
}

/// Every number in these files has a restricted sign; -1 is outside all of their ranges.
TEST_F(SpoiltConfig, NegativeValuesAreRejectedWhereMeaningless) {
  for (const char* file : {"vehicle_limits.yaml", "prediction.yaml", "search.yaml", "encoding.yaml",
                           "crash_definition.yaml", "planners.yaml"}) {
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

TEST_F(SpoiltConfig, ContradictoryValuesAreRejected) {
  expectComplaint("prediction.yaml", "max_tta: 9.0", "max_tta: 0.4",
                  {"prediction.max_tta", "0.4", "within 0.5"});
  expectComplaint("crash_definition.yaml", "max_heading: 0.5236", "max_heading: 0.1",
                  {"crash_definition.types.lane_change.max_heading", "0.1", "within 0.1745"});
}

}  // namespace
}  // namespace forge
