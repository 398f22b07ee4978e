#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "collision_forge/app/command_line.h"
#include "collision_forge/app/options.h"
#include "collision_forge/attack/search/catalogue.h"
#include "collision_forge/attack/search/request_check.h"
#include "collision_forge/attack/search/request_list.h"
#include "collision_forge/base/files/output_lock.h"
#include "collision_forge/base/scene/number_words.h"
#include "collision_forge/io/answers/allowed_requests.h"
#include "collision_forge/io/batch/progress_line.h"
#include "collision_forge/io/logs/scene_source.h"
#include "collision_forge/io/scenarios/request_file.h"
#include "collision_forge/planner_test/settings/config.h"

namespace forge {
namespace {

constexpr double kMinStride = 0.01;  // s, below any frame interval

constexpr const char* kEach = "each";

struct Arguments {
  LogSource logs;
  std::vector<std::string> scenes;
  std::string out;
  ConfigFolder config;
  std::optional<double> stride;
  std::optional<double> min_ego_speed;
  std::vector<double> ttas;
  std::vector<std::string> types;
  std::string attackers = "any";
  RequestControls controls;
  std::uint64_t seed = 0;
  bool allowed_only = false;
  CatalogueChoice catalogue;
};

/// Counts the requests of a type, and how many of them the road geometry allows.
struct RoadCount {
  std::size_t all = 0;
  std::size_t allowed = 0;

  void print(const std::string& of) const {
    std::cout << of << ": the road allows " << allowed << " of " << all << " requests\n";
  }
};
using RoadCounts = std::map<CollisionType, RoadCount>;

/// Returns the distinct values in order of first occurrence.
template <typename Value>
std::vector<Value> withoutRepeats(const std::vector<Value>& values) {
  std::vector<Value> once;
  for (const Value& value : values) {
    if (std::find(once.begin(), once.end(), value) == once.end()) once.push_back(value);
  }
  return once;
}

RequestListOptions listOptions(const Arguments& arguments, const Config& config) {
  RequestListOptions options = config.requests;
  options.stride = arguments.stride.value_or(options.stride);
  if (options.stride < kMinStride) {
    std::ostringstream complaint;
    complaint << "--stride = " << options.stride << " s is below the minimum of " << kMinStride
              << " s";
    throw std::invalid_argument(complaint.str());
  }
  options.min_ego_speed = arguments.min_ego_speed.value_or(options.min_ego_speed);
  if (!arguments.ttas.empty()) options.ttas = arguments.ttas;
  if (!arguments.types.empty()) options.types.clear();
  for (const std::string& name : arguments.types) {
    options.types.push_back(collisionTypeFromString(name).value());
  }
  options.ttas = withoutRepeats(options.ttas);
  options.types = withoutRepeats(options.types);
  if (arguments.attackers == kEach) options.attackers = Attackers::kEach;
  options.seed = arguments.seed;
  return options;
}

/// Appends the requests of a scene to `requests` and counts them. `name`: of a scenario in a
/// catalogue, or empty. `allowed_only`: appends only requests that the road geometry allows.
void addRequestsOf(const IndexedScene& recording, const RequestListOptions& options,
                   const CollisionRequest& asked, const std::string& name, bool allowed_only,
                   const Config& config, std::vector<SceneRequest>& requests, RoadCounts& counts,
                   RequestTally& tally) {
  for (SceneRequest& listed : listRequests(recording.scene, options, config.attack.prediction,
                                           config.crash.time_tolerance, asked, &tally)) {
    listed.name = name;
    const bool allowed = roadAllowsRequest(listed, recording, config);
    RoadCount& count = counts[listed.request.type];
    ++count.all;
    count.allowed += allowed;
    if (allowed || !allowed_only) requests.push_back(std::move(listed));
  }
}

void print(const RoadCounts& counts) {
  RoadCount sum;
  for (const auto& [type, count] : counts) {
    count.print(toString(type));
    sum.all += count.all;
    sum.allowed += count.allowed;
  }
  sum.print("all");
}

/// Returns `asked` with the fields of the command line, which all requests share. Throws
/// std::invalid_argument if they contradict every one of `types`.
CollisionRequest withSharedFields(CollisionRequest asked, const Arguments& arguments,
                                  const Config& config, const std::vector<CollisionType>& types) {
  asked.crash = config.crash;
  arguments.controls.applyTo(asked);
  if (arguments.attackers != kEach) asked.choice = *attackerChoiceFromString(arguments.attackers);
  Status status;
  for (const CollisionType type : types) {
    asked.type = type;
    status = checkControls(asked);
    if (status.code == StatusCode::kOk) return asked;
  }
  throw std::invalid_argument(status.message);
}

std::string whyNoRequest(const RequestTally& tally, const RequestListOptions& options) {
  const std::size_t rest = tally.instants - tally.slow - tally.late;
  return "no request: " + counted(tally.instants, "instant") + ", " + std::to_string(tally.slow) +
         " with an ego below " + numberText(options.min_ego_speed) + " m/s (--min-ego-speed), " +
         std::to_string(tally.late) + " too close to the end of the recording for every --tta, " +
         std::to_string(rest) + " without a vehicle or a history for the request";
}

/// The fields that the requests of a list share. A cell of a catalogue sets them, or the command
/// line.
struct RequestKind {
  std::string name;  ///< of the cell; empty without a catalogue
  CollisionRequest asked;
  RequestListOptions options;
};

/// Returns the cells of the catalogue's scenarios, or the one kind that the other options give.
std::vector<RequestKind> kindsOf(const Arguments& arguments, const Config& config) {
  RequestListOptions options = listOptions(arguments, config);
  if (arguments.catalogue.name.empty()) {
    return {{"", withSharedFields({}, arguments, config, options.types), options}};
  }
  std::vector<RequestKind> kinds;
  for (const CatalogueEntry& entry : arguments.catalogue.entries(arguments.config)) {
    for (const CatalogueCell& cell : entry.cells) {
      options.types = {cell.request.type};
      kinds.push_back(
          {cell.name, withSharedFields(cell.request, arguments, config, options.types), options});
    }
  }
  if (kinds.empty()) {
    throw std::invalid_argument(
        "none of these scenarios can be requested; forge possible --catalogue gives the reasons");
  }
  return kinds;
}

int makeRequests(const Arguments& arguments) {
  const Config config = loadConfig(arguments.config);
  const OutputLock lock = OutputLock::ofFile(arguments.out);
  const std::vector<RequestKind> kinds = kindsOf(arguments, config);
  SceneSource scenes(arguments.logs, arguments.scenes, config, 1, printWarnings, showReading());
  const std::vector<std::string> names = scenes.names();
  std::vector<SceneRequest> requests;
  RoadCounts counts;
  RequestTally tally;
  ProgressLine progress("scenes");
  std::size_t done = 0;
  const std::vector<std::string> unreadable = scenes.forEach([&](const IndexedScene& scene) {
    for (const RequestKind& kind : kinds) {
      addRequestsOf(scene, kind.options, kind.asked, kind.name, arguments.allowed_only, config,
                    requests, counts, tally);
    }
    progress.show(++done, names.size());
  });
  if (unreadable.size() == names.size()) return exitAfterUnreadable(unreadable);
  if (requests.empty()) {
    const std::string reason =
        counts.empty() ? whyNoRequest(tally, kinds.front().options)
                       : "the road geometry of these scenes allows no request with these options; "
                         "omit --allowed-only to list them";
    throw std::runtime_error(reason + unreadableText(unreadable));
  }
  writeRequests(arguments.out, requests, config.crash);
  std::cout << counted(requests.size(), "request") << " over "
            << counted(names.size() - unreadable.size(), "scene") << " written to " << arguments.out
            << "\n";
  print(counts);
  return exitAfterUnreadable(unreadable);
}

/// Rejects NaN and infinity, which the range validators of CLI11 accept.
std::string checkFinite(const std::string& text) {
  double number = 0.0;
  const bool is_number = CLI::detail::lexical_cast(text, number);
  return is_number && std::isfinite(number) ? "" : text + " is not a finite number";
}

}  // namespace

void addRequests(CommandLine& line) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App& app =
      line.add(kMakingCollisions, "requests", "Lists collision requests for recorded scenes.",
               [arguments] { return makeRequests(*arguments); });
  addSource(app, arguments->logs)->required();
  addScenes(app, arguments->scenes);
  addOut(app, arguments->out, "output request list for forge generate, one JSON object per line");
  app.add_option("--stride", arguments->stride,
                 "time between two requests of a scene, s; default: requests.yaml")
      ->check(CLI::PositiveNumber)
      ->check(checkFinite);
  CLI::Option* types =
      app.add_option("--types", arguments->types,
                     "requested collision types; any: each request is for the most plausible type; "
                     "default: the "
                     "first five of " +
                         collisionTypeWords());
  types->check(checkType);
  addCatalogue(app, types, arguments->catalogue);
  app.add_option("--tta", arguments->ttas,
                 "times to attack, s: time from t0 to contact; default: requests.yaml")
      ->check(CLI::PositiveNumber)
      ->check(checkFinite);
  app.add_option("--min-ego-speed", arguments->min_ego_speed,
                 "minimum speed of the ego at t0, m/s; default: requests.yaml")
      ->check(CLI::NonNegativeNumber)
      ->check(checkFinite);
  app.add_option("--attackers", arguments->attackers,
                 "attacker; any: any vehicle; existing: a recorded vehicle; new: an added vehicle; "
                 "each: one request per recorded vehicle that can attack")
      ->transform(oneOf({"any", "existing", "new", kEach}))
      ->capture_default_str();
  addControls(app, arguments->controls);
  addAlternatives(app, arguments->controls);
  app.add_flag(
      "--allowed-only", arguments->allowed_only,
      "list only requests that the road geometry allows: a lane with the direction of the type "
      "passes the ego's position at t0 + TTA");
  addSeed(app, arguments->seed, "random seed of every request");
  addConfig(app, arguments->config);
}

}  // namespace forge
