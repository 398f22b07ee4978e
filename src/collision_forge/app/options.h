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

/// Command-line options that several commands share. Each function add...() adds the options named
/// in its comment to the command `app`. Parsing stores the values in the function's reference
/// arguments, which must live until the command has run; their content before is the default.
/// `text` is the help of the option. Functions that return an option return the first one that they
/// add.
namespace forge {

/// Returns a case-insensitive CLI11 validator for an option whose value is one of `words`. Used as
/// a transform, it replaces the value by its spelling in `words`. The error for another value lists
/// `words` and suggests the nearest one.
CLI::Validator oneOf(const std::vector<std::string>& words);

/// Adds the option `name` ("--mode"), which accepts one of the words of `choices` (pairs of a word
/// in lower case and its value; case-insensitive on the command line) and stores the value paired
/// with it. The current content of `value` is the default; the help shows its word, if it has one.
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

/// Request fields that the command line overrides; they are fields of CollisionRequest
/// (`believable` and `limits`: of its crash definition). Empty fields leave the request unchanged.
struct RequestControls {
  /// Agent id, full or short, or an AttackerChoice ("any", "existing", "new"), which clears the id.
  std::string attacker;
  std::optional<bool> believable;            ///< attacker must drive plausibly until it attacks
  std::optional<LimitSet> limits;            ///< vehicle limits of the attacker
  std::optional<AgentClass> attacker_class;  ///< class that the attacker must have
  std::optional<Manoeuvre> manoeuvre;        ///< manoeuvre that the attacker must drive
  std::optional<Side> ego_side;              ///< side of the ego's box that is hit
  std::optional<Range> impact_speed;         ///< m/s, relative speed at contact
  std::optional<Range> overlap;              ///< share 0..1 of the ego's hit side that is covered
  std::optional<Turning> turning;            ///< vehicle that must turn
  std::optional<Side> from_side;   ///< kLeft or kRight of the ego: where the attacker comes from
  std::optional<Hider> hidden_by;  ///< vehicle that hides the attacker until it comes into view
  std::optional<bool> queue;       ///< a second vehicle stands ahead of the attacker
  /// Elements of kRangeControls with the interval given for each, in the element's unit.
  std::vector<std::pair<const RangeControl*, Range>> ranges;
  std::optional<int> alternatives;  ///< number of attacks per request, from 1

  /// Overwrites the fields of `request` for which a value was given; unchecked, see
  /// checkControls().
  void applyTo(CollisionRequest& request) const;
};
/// --attacker.
void addAttacker(CLI::App& app, RequestControls& controls);
/// --believable, --limits, --attacker-class, --manoeuvre, --ego-side, --impact-speed, --overlap,
/// --turning, --from-side, --hidden-by, --queue and an option for each of kRangeControls.
void addControls(CLI::App& app, RequestControls& controls);

/// --alternatives.
void addAlternatives(CLI::App& app, RequestControls& controls);

/// --source (older name: --dataroot), --version and --ego-obstacle. Returns the option --source,
/// which is optional; a command that needs it calls required() on it. `text` begins its help.
CLI::Option* addSource(CLI::App& app, LogSource& logs, const std::string& text = "recorded scenes");
/// --scene, the names of one or several scenes, unchecked; `scenes` stays empty without the option,
/// which means all.
CLI::Option* addScenes(CLI::App& app, std::vector<std::string>& scenes);

/// Returns the configuration that is installed with the package, or nullopt if ROS does not find
/// the package (its environment is not sourced) and in a build without ROS.
std::optional<ConfigFolder> installedConfig();
/// --config, a folder whose files and keys override installedConfig(), to which `config` is set at
/// once. Without an installed configuration the option is required and names a complete folder.
void addConfig(CLI::App& app, ConfigFolder& config);
/// --out, the output file or folder; required.
void addOut(CLI::App& app, std::string& out, const std::string& text);
/// --jobs, number of threads, 1 to 256; optional.
void addJobs(CLI::App& app, int& jobs, const std::string& text);
/// --seed, a random seed from 0; optional.
CLI::Option* addSeed(CLI::App& app, std::uint64_t& seed, const std::string& text);
/// CLI11 validator: returns "" for the name of a collision type or "any", else the error message.
std::string checkType(const std::string& name);
/// Returns the types that `names` mean, each once, in order of first use; "any" means all types.
/// The names must have passed checkType(). Returns none for no names.
std::vector<CollisionType> typesNamed(const std::vector<std::string>& names);
/// --attacker-policy, "fixed", "adaptive" or both, separated by commas, stored in the order given;
/// `policies` is unchanged without the option. `fallback`: words of the help on the default.
void addPolicies(CLI::App& app, std::vector<std::string>& policies, const std::string& fallback);
/// --mode; the current content of `mode` is the default. Commands that make collisions default to
/// replay, commands that measure methods to history. `may_adapt`: adaptive is allowed, too.
void addMode(CLI::App& app, Mode& mode, bool may_adapt);
/// Scenarios of a catalogue, selected on the command line.
struct CatalogueChoice {
  std::string name;                    ///< catalogue, or "all"; empty: no catalogue selected
  std::vector<std::string> scenarios;  ///< names of entries, as in namedEntries(); empty: all

  /// Returns the selected entries of the configuration. `name` must not be empty. Throws as
  /// readCatalogue() and namedEntries().
  std::vector<CatalogueEntry> entries(const ConfigFolder& folder) const;
};

/// --catalogue and --name (only with --catalogue), unchecked until entries(). The command line may
/// not have both --catalogue and `types`, the option for collision types.
void addCatalogue(CLI::App& app, CLI::Option* types, CatalogueChoice& choice);
/// --method, the name of an attack method; empty: the built-in default. When all options are
/// parsed, checkMethod() checks it with `config`, which --config may have set.
CLI::Option* addMethod(CLI::App& app, std::string& method, const ConfigFolder& config);
/// Throws CLI::ValidationError, naming `option` and the known methods, if `method` is neither built
/// in nor listed in methods.yaml. Ignores an invalid configuration, which the run itself reports.
void checkMethod(const std::string& option, const std::string& method, const ConfigFolder& config);
/// Planners of the user; empty texts: none was given. At most one of `command` and `node` is set.
struct OwnPlanners {
  std::string file;     ///< planner torchscript: file that replaces the file in planners.yaml
  std::string command;  ///< planner external: shell command of a process with the line protocol
  std::string node;     ///< planner external: shell command that starts a ROS node
};
/// --planner-file, --planner-command, --planner-node.
void addOwnPlanners(CLI::App& app, OwnPlanners& own);
/// Stores the user's planners in config.planners, with "" for a file whose licence the
/// configuration excludes (allowedWeights()). `planners`: names of the planners under test. Starts
/// each of them that runs outside this process once, so that an unusable one throws
/// PlannerFileError before the work begins.
void useOwnPlanners(const OwnPlanners& own, const std::vector<std::string>& planners,
                    Config& config);
/// Adds the fingerprints of the user's planners that are in `planners` (names) to `options`: of the
/// TorchScript file as "planner_file"; and as "planner_command" or "planner_node" the text of the
/// command with the fingerprint of each of its words (split at white space) that is the path of an
/// existing file. `settings`: config.planners after useOwnPlanners().
void addPlannerFingerprints(ResumableFile::Options& options,
                            const std::vector<std::string>& planners,
                            const PlannerOptions& settings);
/// How other agents move in a planner test; each case is tested with each background.
struct BackgroundChoice {
  std::vector<Background> backgrounds = {Background::kReplay};  ///< at least one, each once
  std::string model;  ///< TorchScript file of Background::kModel; empty without kModel

  /// Returns the names, as "replay,idm".
  std::string text() const;
};
/// --background: at most `most` of replay, idm and model:FILE (sets `model`), separated by commas,
/// each once, stored in the order given; another value is rejected while parsing.
void addBackground(CLI::App& app, BackgroundChoice& choice, std::size_t most);
/// Stores the model's file in config.planners.traffic_model, or "" if the configuration excludes
/// its licence, and loads it once, so that an unusable file throws PlannerFileError before the work
/// begins. Does nothing without a model.
void useBackground(const BackgroundChoice& choice, Config& config);
/// Adds the names of the backgrounds, in their order, as "background" to `options`, and the
/// fingerprint of the model's file, if there is one, as "background_model".
void addBackgroundFingerprints(ResumableFile::Options& options, const BackgroundChoice& choice);

/// Returns the fingerprints of all inputs of a run over logs: configuration, models, logs. A run is
/// resumed only if they are unchanged.
ResumableFile::Options inputsOf(const Config& config, const LogSource& logs);
/// Adds the fingerprint of the weights of `method` (name; "": the default) to `options` if it is a
/// learned baseline; else does nothing.
void addWeightsOf(const std::string& method, const Config& config, ResumableFile::Options& options);

/// Returns a callback that shows on stderr which share of the nuScenes tables was read.
NuScenesProgress showReading();

/// Prints each warning on stderr as "warning: SUBJECT: WARNING".
void printWarnings(const std::string& subject, const std::vector<std::string>& warnings);

}  // namespace forge
