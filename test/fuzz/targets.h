#pragma once

#include <map>
#include <string>
#include <vector>

namespace forge {

/// A kind of input and its reader.
struct FuzzTarget {
  const char* name;
  /// Reads the bytes. Returns true if they were accepted, false if they were rejected as the
  /// reader's header documents. Throws Finding otherwise.
  bool (*read)(const std::string& input);
};

bool fuzzBags(const std::string& input);
bool fuzzClips(const std::string& input);
bool fuzzClouds(const std::string& input);
bool fuzzCommonroad(const std::string& input);
bool fuzzConfig(const std::string& input);
bool fuzzDefinitions(const std::string& input);
bool fuzzLanelets(const std::string& input);
bool fuzzMap(const std::string& input);
bool fuzzMessages(const std::string& input);
bool fuzzNumbers(const std::string& input);
bool fuzzRealize(const std::string& input);
bool fuzzRequests(const std::string& input);
bool fuzzRuns(const std::string& input);
bool fuzzScenarios(const std::string& input);
bool fuzzSpeeds(const std::string& input);
bool fuzzTables(const std::string& input);
bool fuzzWeights(const std::string& input);

inline constexpr FuzzTarget kFuzzTargets[] = {
    {"bags", fuzzBags},         {"clips", fuzzClips},
    {"clouds", fuzzClouds},     {"commonroad", fuzzCommonroad},
    {"config", fuzzConfig},     {"definitions", fuzzDefinitions},
    {"lanelets", fuzzLanelets}, {"map", fuzzMap},
    {"messages", fuzzMessages}, {"numbers", fuzzNumbers},
    {"realize", fuzzRealize},   {"requests", fuzzRequests},
    {"runs", fuzzRuns},         {"scenarios", fuzzScenarios},
    {"speeds", fuzzSpeeds},     {"tables", fuzzTables},
    {"weights", fuzzWeights},
};

/// Functions that return small valid inputs, by target name.
using SeedMakers = std::map<std::string, std::vector<std::string> (*)()>;
const SeedMakers& seedMakers();

// Some of these functions.

std::vector<std::string> bagSeeds();
std::vector<std::string> cloudSeeds();
std::vector<std::string> messageSeeds();
std::vector<std::string> realizeSeeds();
std::vector<std::string> runSeeds();

}  // namespace forge
