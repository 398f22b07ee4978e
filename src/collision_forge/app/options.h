#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "collision_forge/base/config/nearest_names.h"
#include "collision_forge/base/files/resumable_file.h"
#include "collision_forge/base/scene/collision_request.h"
#include "collision_forge/base/scene/request_words.h"
#include "collision_forge/io/logs/log_source.h"
#include "collision_forge/io/logs/nuscenes_rows.h"
#include "collision_forge/planner_test/settings/config.h"
#include "collision_forge/planner_test/trials/traffic.h"

/// Options that several commands have, each defined once.
namespace forge {

/// Returns a check of an option that takes one of a few words, in capitals or not. As a transform
/// it hands on the word as it stands in `words`. The complaint about another word lists the words,
/// and names the one that was most likely meant.
CLI::Validator oneOf(const std::vector<std::string>& words);

/// One of a few words, in capitals or not, each with its value; the value that `value` has is the
/// default.
template <typename Value>
CLI::Option* addChoice(CLI::App& app, const std::string& name, Value& value,
                       const std::vector<std::pair<std::string, Value>>& choices,
                       const std::string& text) {
  std::vector<std::string> words;
  std::string default_word;
  for (const auto& [word, meaning] : choices) {
    words.push_back(word);
    if (meaning == value) default_word = word;
  }
  const auto take = [&value, choices](const std::string& given) {
    const auto is_given = [&](const auto& choice) { return choice.first == lowered(given); };
    value = std::find_if(choices.begin(), choices.end(), is_given)->second;
  };
  return app.add_option_function<std::string>(name, take, text)
      ->check(oneOf(words))
      ->default_str(default_word);
}

/// What the command line says about requests; what is empty stays as it is.
struct RequestControls {
  std::string attacker;  ///< an id, or any, existing or new
  std::optional<bool> believable;
  std::optional<LimitSet> limits;
  std::optional<AgentClass> attacker_class;
  std::optional<Manoeuvre> manoeuvre;
  std::optional<Side> ego_side;
  std::optional<Range> impact_speed;
  std::optional<Range> overlap;
  std::optional<int> alternatives;

  /// Says so in the request.
  void applyTo(CollisionRequest& request) const;
};
/// --attacker.
void addAttacker(CLI::App& app, RequestControls& controls);
/// --believable, --limits, --attacker-class, --manoeuvre, --ego-side, --impact-speed, --overlap.
void addControls(CLI::App& app, RequestControls& controls);

/// --alternatives.
void addAlternatives(CLI::App& app, RequestControls& controls);

/// --source, whose older name is --dataroot, and --version. Gives the first; required by none.
CLI::Option* addSource(CLI::App& app, LogSource& logs, const std::string& text = "recorded scenes");
/// --scene, all by default.
CLI::Option* addScenes(CLI::App& app, std::vector<std::string>& scenes);

/// The package's own configuration; empty where ROS does not know the package (its environment is
/// not sourced), or in a build without ROS.
std::optional<ConfigFolder> installedConfig();
/// --config, a folder that is laid over the installedConfig(). Without one the option is required
/// and names a complete folder.
void addConfig(CLI::App& app, ConfigFolder& config);
/// --out, required.
void addOut(CLI::App& app, std::string& out, const std::string& text);
/// --jobs, from 1 to 256.
void addJobs(CLI::App& app, int& jobs, const std::string& text);
/// --seed.
CLI::Option* addSeed(CLI::App& app, std::uint64_t& seed, const std::string& text);
/// Says what is wrong with the name of a collision type, for a check of an option.
std::string checkType(const std::string& name);
/// --mode, history or replay; the value that `mode` has is the default. Commands that make
/// collisions of recordings default to replay, commands that measure methods to history.
/// `may_adapt`: mode adaptive is one of them.
void addMode(CLI::App& app, Mode& mode, bool may_adapt);
/// --method of attack, one that the configuration knows; empty: the suite's own. Both must outlive
/// the reading of the line.
CLI::Option* addMethod(CLI::App& app, std::string& method, const ConfigFolder& config);
/// Throws CLI::ValidationError for an unknown method of that option, naming the known ones.
void checkMethod(const std::string& option, const std::string& method, const ConfigFolder& config);
/// --planner-file: a learned planner in place of the one that the configuration names.
void addPlannerFile(CLI::App& app, std::string& file);
/// Puts the file of --planner-file, if one is given and its licence is allowed, into the options of
/// planners. Where one of the planners is learned, its file is tried: throws PlannerFileError
/// before the work begins.
void usePlannerFile(const std::string& file, const std::vector<std::string>& planners,
                    Config& config);
/// What results of these planners depend on besides the configuration: the learned one's file.
void addPlannerFingerprint(ResumableFile::Options& options,
                           const std::vector<std::string>& planners,
                           const PlannerOptions& settings);
/// --background of tests of planners, replay or idm.
void addBackground(CLI::App& app, Background& background);

/// What every result over logs depends on: configuration, models and the source of logs.
ResumableFile::Options inputsOf(const Config& config, const LogSource& logs);
/// Adds the weights of a learned baseline, which its results depend on besides; nothing for other
/// methods.
void addWeightsOf(const std::string& method, const Config& config, ResumableFile::Options& options);

/// Shows on stderr how far the reading of nuScenes tables is; nothing on other ranks than the
/// master.
NuScenesProgress showReading();

/// Says on stderr what is odd about something that was read.
void printWarnings(const std::string& subject, const std::vector<std::string>& warnings);

}  // namespace forge
