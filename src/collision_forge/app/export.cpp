#include <filesystem>
#include <iostream>
#include <memory>

#include "collision_forge/app/attack_source.h"
#include "collision_forge/app/command_line.h"
#include "collision_forge/app/export_mcap.h"
#include "collision_forge/app/options.h"
#include "collision_forge/base/scene/number_words.h"
#include "collision_forge/io/batch/dispatch.h"
#include "collision_forge/io/batch/output.h"
#include "collision_forge/io/batch/run.h"
#include "collision_forge/io/export/export_formats.h"
#include "collision_forge/io/json/json_line.h"
#include "collision_forge/planner_test/settings/config_fingerprint.h"

namespace forge {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMcap = "mcap";
constexpr const char* kRosbag2 = "rosbag2";
constexpr const char* kOpenScenario = "openscenario";

struct Arguments {
  std::string format;
  std::string scenarios;
  std::vector<std::string> bags;
  LogSource logs;
  bool ego_free = false;
  bool is_ros2 = false;    // --profile
  bool for_carla = false;  // --flavour
  std::string out;
  ConfigFolder config;
  int jobs = defaultJobs();
};

/// Returns true for the formats that are made from whole bags.
bool isOfBags(const std::string& format) { return format == kMcap || format == kRosbag2; }

/// A line of index.jsonl: one exported attack.
struct IndexEntry {
  std::size_t line = 0;  ///< AttackSource::numberOf()
  ExportedCrash crash;
  double now = 0.0;               ///< s, t0 on the record's clock
  std::optional<double> contact;  ///< s on that clock, with the recorded ego; empty: no contact
  std::vector<std::string> files;
};

std::string indexLine(const IndexEntry& entry) {
  JsonLineWriter writer;
  writer.beginObject();
  writer.count("line", entry.line);
  writer.text("name", entry.crash.name);
  writer.text("scene", entry.crash.scene);
  writer.text("location", entry.crash.location);
  writer.count("states", entry.crash.states);
  writer.number("now_t", entry.now);
  if (entry.contact) {
    writer.number("contact_t", *entry.contact);
  } else {
    writer.null("contact_t");
  }
  writer.texts("files", entry.files);
  writer.endObject();
  return writer.line();
}

IndexEntry readIndexLine(const std::string& where, const std::string& text) {
  const JsonLine line(where, text);
  JsonObject object = line.root();
  IndexEntry entry;
  entry.line = object.count("line");
  entry.crash = {object.text("name"), object.text("scene"), object.text("location"),
                 object.count("states")};
  entry.now = object.number("now_t");
  entry.contact = object.numberOrNull("contact_t");
  entry.files = object.texts("files");
  object.finish();
  return entry;
}

/// Exports all attacks of a source; resumes an interrupted run.
class CrashExport {
 public:
  CrashExport(const Arguments& arguments, const Config& config, AttackSource& attacks)
      : arguments_(arguments),
        config_(config),
        attacks_(attacks),
        writer_(makeCrashWriter(
            arguments.format,
            {arguments.out, arguments.ego_free, config.exports, config.attack.verification.drivable,
             readCatalogue(arguments.config, "all"), arguments.for_carla})) {}

  int run() {
    Run run;
    run.path = (fs::path(arguments_.out) / "index.jsonl").string();
    run.options = options();
    run.items = "attacks";
    run.count = attacks_.count();
    run.jobs = arguments_.jobs;
    run.work = [this](std::size_t index) { return write(index); };
    run.take = [this](std::size_t index, const std::string& where, const std::string& line) {
      take(index, readIndexLine(where, line), where);
    };
    carryOut(run);
    writer_->finish(crashes_);
    printSummary();
    return kExitOk;
  }

 private:
  /// Returns the fingerprints of all inputs of the files.
  ResumableFile::Options options() const {
    ResumableFile::Options options = fingerprintsOf(config_, config_.folder);
    for (const auto& [name, value] : attacks_.fingerprints()) options[name] = value;
    options["config/export.yaml"] = fingerprintOfValues(arguments_.config, "export.yaml");
    options["format"] = arguments_.format;
    options["ego"] = arguments_.ego_free ? "free" : "recorded";
    if (arguments_.for_carla) options["flavour"] = "carla";
    return options;
  }

  /// Writes the files of one attack and returns its line of index.jsonl.
  std::string write(std::size_t index) {
    try {
      const double history = arguments_.ego_free ? 0.0 : config_.exports.history;
      const CrashRecord record = attacks_.record(index, history);
      const ExportedCrash crash{record.name, record.scenario.asked.scene, record.lanes.location,
                                record.ego.states.size()};
      return indexLine(
          {attacks_.numberOf(index), crash, record.now, record.contact, writer_->write(record)});
    } catch (const std::exception& error) {
      const std::string what = error.what(), where = attacks_.where(index);
      const bool names_attack = what.compare(0, where.size(), where) == 0;
      throw std::runtime_error(names_attack ? what : where + " cannot be exported: " + what);
    }
  }

  void take(std::size_t index, const IndexEntry& entry, const std::string& where) {
    if (entry.line != attacks_.numberOf(index)) {
      throw std::runtime_error(where + ": line = " + std::to_string(entry.line) + " instead of " +
                               std::to_string(attacks_.numberOf(index)) + " (" +
                               attacks_.where(index) +
                               "): index.jsonl belongs to other attacks; choose another --out");
    }
    if (!entry.contact) ++without_contact_;
    crashes_.push_back(entry.crash);
  }

  void printSummary() const {
    std::cout << counted(crashes_.size(), "attack") << " of " << attacks_.described() << " in "
              << arguments_.out << "\n";
    if (without_contact_ == 0) return;
    std::cout << without_contact_ << " of them have no contact with the recorded ego and end with "
              << "the recording or the attacker's trajectory\n";
  }

  const Arguments& arguments_;
  const Config& config_;
  AttackSource& attacks_;
  const std::unique_ptr<CrashWriter> writer_;
  std::vector<ExportedCrash> crashes_;
  std::size_t without_contact_ = 0;
};

int exportAny(const Arguments& arguments) {
  const Config config = loadConfig(arguments.config);
  if (isOfBags(arguments.format)) {
    const BagExport format = arguments.format == kRosbag2 ? BagExport::kRosbag2
                             : arguments.is_ros2          ? BagExport::kRos2Mcap
                                                          : BagExport::kMcap;
    return exportBags(arguments.bags, arguments.out, format, config);
  }
  const OutputLocks locks = lockFolders({arguments.out});
  const auto attacks =
      arguments.bags.empty()
          ? openScenarioAttacks(arguments.scenarios, arguments.logs, arguments.jobs, config)
          : openBagAttacks(arguments.bags, config);
  return CrashExport(arguments, config, *attacks).run();
}

std::vector<std::string> formats() {
  std::vector<std::string> names = exportFormats();
  names.emplace_back(kMcap);
  names.emplace_back(kRosbag2);
  return names;
}

}  // namespace

void addExport(CommandLine& line) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App& app =
      line.add(kMakingCollisions, "export",
               "Exports attacks and bags to the formats of other tools; resumes interrupted runs.",
               [arguments] { return exportAny(*arguments); });
  app.add_option("--to", arguments->format, "output format")
      ->required()
      ->transform(oneOf(formats()));
  CLI::Option_group* source = app.add_option_group("input");
  CLI::Option* scenarios =
      source
          ->add_option("--scenarios", arguments->scenarios,
                       "scenario file of forge generate; not for mcap and rosbag2")
          ->check(CLI::ExistingFile);
  source
      ->add_option("--bag", arguments->bags,
                   "bags of forge inject; for mcap and rosbag2 also bags of forge convert")
      ->check(CLI::ExistingFile);
  source->require_option(1);
  scenarios->needs(addSource(app, arguments->logs, "recorded scenes of the scenario file"));
  addChoice<bool>(
      app, "--ego", arguments->ego_free, {{"recorded", false}, {"free", true}},
      "ego motion; recorded: replays the recording; free: the importing tool drives the ego from "
      "t0, where the file starts");
  addChoice<bool>(app, "--flavour", arguments->for_carla, {{"asam", false}, {"carla", true}},
                  "dialect of openscenario; asam: OpenSCENARIO 1.2; carla: the part of 1.0 that "
                  "CARLA's ScenarioRunner reads");
  addChoice<bool>(app, "--profile", arguments->is_ros2, {{"ros1", false}, {"ros2", true}},
                  "of mcap; ros1: messages unchanged; ros2: converted to ROS 2");
  app.parse_complete_callback([arguments] {
    if (arguments->for_carla && arguments->format != kOpenScenario) {
      throw CLI::ValidationError("--flavour", "carla is a flavour of --to openscenario");
    }
    if (!isOfBags(arguments->format)) {
      if (!arguments->is_ros2) return;
      throw CLI::ValidationError("--profile", "ros2 is for mcap, not for " + arguments->format);
    }
    if (arguments->scenarios.empty()) return;
    throw CLI::ValidationError(
        "--to", arguments->format + " needs --bag; it cannot be made from --scenarios");
  });
  addOut(app, arguments->out, "output folder; see docs/export.md");
  addJobs(app, arguments->jobs, "attacks exported in parallel");
  addConfig(app, arguments->config);
}

}  // namespace forge
