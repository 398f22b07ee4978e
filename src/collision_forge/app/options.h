#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "collision_forge/attack/search/catalogue.h"
#include "collision_forge/base/config/nearest_names.h"
#include "collision_forge/base/files/resumable_file.h"
#include "collision_forge/base/scene/collision_request.h"
#include "collision_forge/base/scene/contact_conditions.h"
#include "collision_forge/base/scene/request_words.h"
#include "collision_forge/io/logs/log_source.h"
#include "collision_forge/io/logs/nuscenes_rows.h"
#include "collision_forge/planner_test/settings/config.h"
#include "collision_forge/planner_test/trials/traffic.h"

/// Command-line options that several commands share. Each function adds the options named in its
/// comment and stores parsed values in the argument, which must outlive the parsing.
namespace forge {

/// Returns a case-insensitive CLI11 validator for an option whose value is one of `words`. Used as
/// a transform, it replaces the value by its spelling in `words`. The error for another value lists
/// `words` and suggests the nearest one.
CLI::Validator oneOf(const std::vector<std::string>& words);

/// Adds an option that accepts one of the words of `choices` (case-insensitive) and stores the
/// value paired with it. The current content of `value` is the default.
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

/// Request fields that the command line overrides. Empty fields leave the request unchanged.
struct RequestControls {
  std::string attacker;            ///< agent id, or "any", "existing", "new"; empty: unchanged
  std::optional<bool> believable;  ///< attacker must drive plausibly until it attacks
  std::optional<LimitSet> limits;  ///< vehicle limits of the attacker
  std::optional<AgentClass> attacker_class;
  std::optional<Manoeuvre> manoeuvre;  ///< of the attacker
  std::optional<Side> ego_side;        ///< side of the ego that is hit
  std::optional<Range> impact_speed;   ///< m/s, relative speed at contact
  std::optional<Range> overlap;        ///< share 0..1 of the ego's hit side that is covered
  std::optional<Turning> turning;      ///< vehicle that turns, of type ltap
  std::optional<Side> from_side;       ///< side from which the attacker comes
  std::optional<Hider> hidden_by;      ///< what hides the attacker
  std::optional<bool> queue;           ///< a second vehicle stands ahead of the attacker
  std::vector<std::pair<const RangeControl*, Range>> ranges;  ///< given ones of kRangeControls
  std::optional<int> alternatives;                            ///< number of attacks per request

  /// Overwrites the fields of `request` for which a value was given.
  void applyTo(CollisionRequest& request) const;
};
/// --attacker.
void addAttacker(CLI::App& app, RequestControls& controls);
/// --believable, --limits, --attacker-class, --manoeuvre, --ego-side, --impact-speed, --overlap,
/// --turning, --from-side and an option for each of kRangeControls.
void addControls(CLI::App& app, RequestControls& controls);

/// --alternatives.
void addAlternatives(CLI::App& app, RequestControls& controls);

/// --source (older name: --dataroot) and --version. Returns the option --source, which is optional;
/// a command that needs it calls required() on it. `text` begins its help.
CLI::Option* addSource(CLI::App& app, LogSource& logs, const std::string& text = "recorded scenes");
/// --scene, the names of scenes; empty: all.
CLI::Option* addScenes(CLI::App& app, std::vector<std::string>& scenes);

/// Returns the configuration that is installed with the package, or nullopt if ROS does not find
/// the package (its environment is not sourced) and in a build without ROS.
std::optional<ConfigFolder> installedConfig();
/// --config, a folder whose files and keys override installedConfig(). Without an installed
/// configuration the option is required and names a complete folder.
void addConfig(CLI::App& app, ConfigFolder& config);
/// --out, required.
void addOut(CLI::App& app, std::string& out, const std::string& text);
/// --jobs, number of threads, 1 to 256.
void addJobs(CLI::App& app, int& jobs, const std::string& text);
/// --seed.
CLI::Option* addSeed(CLI::App& app, std::uint64_t& seed, const std::string& text);
/// CLI11 validator: returns "" for the name of a collision type, else the error message.
std::string checkType(const std::string& name);
/// Returns the types that `names`, which passed checkType(), mean in a list of types, each once:
/// "any" means all.
std::vector<CollisionType> typesNamed(const std::vector<std::string>& names);
/// --attacker-policy; `fallback`: the default in words.
void addPolicies(CLI::App& app, std::vector<std::string>& policies, const std::string& fallback);
/// --mode; the current content of `mode` is the default. Commands that make collisions default to
/// replay, commands that measure methods to history. `may_adapt`: adaptive is allowed, too.
void addMode(CLI::App& app, Mode& mode, bool may_adapt);
/// The scenarios of a catalogue that a command is for.
struct CatalogueChoice {
  std::string name;                    ///< of the catalogue, or "all"; empty without one
  std::vector<std::string> scenarios;  ///< empty: all

  /// Returns the chosen entries. Throws as readCatalogue() and namedEntries().
  std::vector<CatalogueEntry> entries(const ConfigFolder& folder) const;
};

/// --catalogue, which excludes the option `types`, and --name.
void addCatalogue(CLI::App& app, CLI::Option* types, CatalogueChoice& choice);
/// --method, checked by checkMethod() when all options are parsed; empty: the built-in default.
CLI::Option* addMethod(CLI::App& app, std::string& method, const ConfigFolder& config);
/// Throws CLI::ValidationError, naming `option` and the known methods, if `method` is neither built
/// in nor listed in methods.yaml. Ignores an invalid configuration, which the run itself reports.
void checkMethod(const std::string& option, const std::string& method, const ConfigFolder& config);
/// Planners of the user; empty texts: none was given.
struct OwnPlanners {
  std::string file;     ///< TorchScript file that replaces the file in planners.yaml
  std::string command;  ///< of a process that uses the line protocol
  std::string node;     ///< command that starts a ROS node
};
/// --planner-file, --planner-command, --planner-node.
void addOwnPlanners(CLI::App& app, OwnPlanners& own);
/// Stores the user's planners in config.planners after checking that the licence of the file is
/// allowed. Starts each of `planners` that runs outside this process once, so that an unusable one
/// throws PlannerFileError before the work begins.
void useOwnPlanners(const OwnPlanners& own, const std::vector<std::string>& planners,
                    Config& config);
/// Adds the fingerprints of the user's planners that are in `planners` to `options`: of the
/// TorchScript file, and of the command with the files that it names.
void addPlannerFingerprints(ResumableFile::Options& options,
                            const std::vector<std::string>& planners,
                            const PlannerOptions& settings);
/// How other agents move in a planner test.
struct BackgroundChoice {
  std::vector<Background> backgrounds = {Background::kReplay};
  std::string model;  ///< TorchScript file of Background::kModel

  /// Returns the names, separated by commas.
  std::string text() const;
};
/// --background: at most `most` of replay, idm and model:FILE, separated by commas.
void addBackground(CLI::App& app, BackgroundChoice& choice, std::size_t most);
/// Stores the model's file in config.planners after checking its licence, and loads it once, so
/// that an unusable file throws PlannerFileError before the work begins.
void useBackground(const BackgroundChoice& choice, Config& config);
/// Adds the fingerprints of the choice to `options`.
void addBackgroundFingerprints(ResumableFile::Options& options, const BackgroundChoice& choice);

/// Returns the fingerprints of all inputs of a run over logs: configuration, models, logs. A run is
/// resumed only if they are unchanged.
ResumableFile::Options inputsOf(const Config& config, const LogSource& logs);
/// Adds the fingerprint of the weights of `method` if it is a learned baseline.
void addWeightsOf(const std::string& method, const Config& config, ResumableFile::Options& options);

/// Returns a callback that shows the progress of reading nuScenes tables on stderr.
NuScenesProgress showReading();

/// Prints each warning on stderr as "warning: SUBJECT: WARNING".
void printWarnings(const std::string& subject, const std::vector<std::string>& warnings);

}  // namespace forge
