#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <random>
#include <stdexcept>

#include "collision_forge/io/scenarios/request_file.h"
#include "collision_forge/io/scenarios/scenario_file.h"
#include "collision_forge/io/weights/pattern_network_file.h"
#include "fuzz/mutation.h"
#include "fuzz/reading.h"
#include "fuzz/targets.h"

namespace forge {

void PrintTo(const FuzzTarget& target, std::ostream* out) { *out << target.name; }

namespace {

using testing::HasSubstr;

namespace fs = std::filesystem;

/// Returns the number of mutants per target; the environment variable COLLISION_FORGE_MUTANTS
/// overrides it.
std::size_t mutantCount() {
  const char* const given = std::getenv("COLLISION_FORGE_MUTANTS");
  return given ? std::stoul(given) : 1000;
}

/// Returns the message of the target's Finding; "" if it accepts or rejects the input correctly.
std::string findingIn(const FuzzTarget& target, const std::string& input) {
  try {
    target.read(input);
  } catch (const Finding& finding) {
    return finding.what();
  }
  return "";
}

std::string pathOfCase(const std::string& name) {
  return COLLISION_FORGE_SOURCE_DIR "/test/fuzz/cases/" + name;
}

std::vector<SceneRequest> readRequestCase(const std::string& name) {
  return readRequests(pathOfCase(name), {"scene-0001"}, configuration().input_limits);
}

Scenario readScenarioCase(const std::string& name) {
  return readScenarioLine(name, bytesOf(pathOfCase(name)), configuration().input_limits);
}

void readWeightsCase(const std::string& name) { loadPatternNetwork(pathOfCase(name)); }

/// A case that must be rejected, with the field and the value that the message must name.
struct RefusedCase {
  const char* name;
  std::function<void(const std::string& name)> read;
  const char* words;
};

const RefusedCase kRefusedCases[] = {
    {"requests/zero_in_a_name", readRequestCase,
     R"(field mano\u0000uvre = "cut_in" is an unknown field)"},
    {"scenarios/length_1e7.jsonl", readScenarioCase,
     "field attacker.length = 10000000.0 is outside"},
    {"scenarios/length_1e9.jsonl", readScenarioCase,
     "field attacker.length = 1000000000.0 is outside"},
    {"scenarios/t_1e9.jsonl", readScenarioCase,
     "field attacker.trajectory[1].t = 1000000000.0 is outside"},
    {"weights/steep_spacing.bin", readWeightsCase,
     "field features.spacing_exponent = 118446744073709550000.0 is outside"}};

class FuzzTargets : public testing::TestWithParam<FuzzTarget> {};

INSTANTIATE_TEST_SUITE_P(All, FuzzTargets, testing::ValuesIn(kFuzzTargets),
                         [](const auto& info) { return std::string(info.param.name); });

TEST_P(FuzzTargets, TakeTheirSeeds) {
  const std::vector<std::string> seeds = seedMakers().at(GetParam().name)();
  ASSERT_FALSE(seeds.empty());
  for (const std::string& seed : seeds) {
    EXPECT_TRUE(GetParam().read(seed)) << seed.substr(0, 300);
  }
}

TEST(FuzzCases, AreTakenOrRefused) {
  std::size_t count = 0;
  for (const auto& folder : fs::directory_iterator(COLLISION_FORGE_SOURCE_DIR "/test/fuzz/cases")) {
    const auto target =
        std::find_if(std::begin(kFuzzTargets), std::end(kFuzzTargets),
                     [&](const FuzzTarget& one) { return folder.path().filename() == one.name; });
    ASSERT_NE(target, std::end(kFuzzTargets)) << folder.path();
    for (const auto& entry : fs::directory_iterator(folder)) {
      EXPECT_EQ(findingIn(*target, bytesOf(entry.path().string())), "") << entry.path();
      ++count;
    }
  }
  EXPECT_GT(count, 0u);
}

TEST(FuzzCases, AreRefusedForTheirDefectAndNothingBeforeIt) {
  for (const auto& [name, read, words] : kRefusedCases) {
    try {
      read(name);
      ADD_FAILURE() << name << " is taken";
    } catch (const std::runtime_error& error) {
      EXPECT_THAT(error.what(), HasSubstr(words)) << name;
    }
  }
}

/// 1e-349 is nearer to 0 than to the smallest positive double, 4.9e-324.
TEST(FuzzCases, NumbersOfHundredsOfZerosAreRead) {
  EXPECT_EQ(readRequestCase("requests/short_number.jsonl").at(0).request.tta, 0.0);
  EXPECT_EQ(readScenarioCase("scenarios/short_number_1.jsonl").asked.request.tta, 0.0);
}

TEST_P(FuzzTargets, FindNothingInMutants) {
  const std::vector<std::string> seeds = seedMakers().at(GetParam().name)();
  const fs::path path = fs::path(testing::TempDir()) / (std::string("mutant_") + GetParam().name);
  const unsigned seed = 20261125;
  std::mt19937_64 random(seed);
  std::cout << "seed " << seed << ", the mutant on trial is " << path << std::endl;
  std::size_t taken = 0;
  double slowest = 0.0;  // s
  const std::size_t count = mutantCount();
  for (std::size_t i = 0; i < count; ++i) {
    const std::string mutant = mutantOf(seeds, random);
    std::ofstream(path, std::ios::binary) << mutant;
    const auto begin = std::chrono::steady_clock::now();
    ASSERT_NO_THROW(taken += GetParam().read(mutant) ? 1 : 0) << "mutant " << i << ": " << path;
    const std::chrono::duration<double> lasted = std::chrono::steady_clock::now() - begin;
    slowest = std::max(slowest, lasted.count());
  }
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  std::cout << count << " mutants of " << GetParam().name << ": " << taken << " taken, "
            << count - taken << " refused; the slowest took " << slowest << " s; "
            << used.ru_maxrss / 1024 << " MiB at most so far" << std::endl;
  EXPECT_LT(taken, count) << "what is never refused is not checked";
  fs::remove(path);
}

TEST(FuzzReading, DistinguishesRejectionsFromFindings) {
  EXPECT_TRUE(isTaken("file", [] {}));
  EXPECT_FALSE(isTaken("file", [] { throw std::runtime_error("file: is damaged"); }));
  EXPECT_FALSE(isTaken("file", [] { throw ConfigError("file: a.b = 3 is unknown"); }));
  EXPECT_THROW(isTaken("file", [] { throw std::runtime_error("is damaged"); }), Finding);
  EXPECT_THROW(isTaken("", [] { static_cast<void>(std::stoi("a")); }), Finding);
  EXPECT_THROW(isTaken("", [] { throw std::bad_alloc(); }), Finding);
  EXPECT_THROW(isTaken("", [] { throw std::out_of_range("file: it is far"); }), Finding);
  EXPECT_THROW(isTaken("file", [] { throw std::runtime_error("file: stoi"); }), BareMessage);
  EXPECT_THROW(requireSame("one", "other"), Finding);
  EXPECT_NO_THROW(requireSame("one", "one"));
}

TEST(FuzzReading, PartsComeBack) {
  const Parts parts = {{"part", "a line\n"}, {"sums", "b\n=== \nc"}, {"options", ""}};
  EXPECT_EQ(partsOf(joined(parts)), parts);
  EXPECT_TRUE(partsOf("=== ../evil\nx").empty());
}

TEST(FuzzMutation, TheSameRandomNumbersGiveTheSameMutants) {
  const std::vector<std::string> seeds = {R"({"a": 1.5, "b": [2, 3]})", "some words"};
  std::mt19937_64 one(1);
  std::mt19937_64 other(1);
  std::size_t changed = 0;
  for (int i = 0; i < 100; ++i) {
    const std::string mutant = mutantOf(seeds, one);
    EXPECT_EQ(mutant, mutantOf(seeds, other));
    changed += mutant != seeds[0] && mutant != seeds[1] ? 1 : 0;
  }
  EXPECT_GT(changed, 80u);
}

}  // namespace
}  // namespace forge
