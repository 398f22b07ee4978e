#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <boost/timer/progress_display.hpp>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <set>

#include "collision_forge/app/command_line.h"
#include "collision_forge/app/options.h"
#include "collision_forge/batch/dispatch.h"
#include "collision_forge/data/collide_export.h"
#include "collision_forge/data/pattern_network_file.h"
#include "collision_forge/data/request_file.h"
#include "collision_forge/files/resumable_file.h"
#include "collision_forge/settings/config_fingerprint.h"
#include "collision_forge/study/request_answerer.h"

namespace forge {
namespace {

namespace fs = std::filesystem;

enum class Format { kJsonl, kCsvCollide };

struct Arguments {
  std::string dataroot;
  std::string version;
  std::string requests;
  std::string out;
  std::string config;
  std::string method;
  Mode mode = Mode::kHistory;
  Format format = Format::kJsonl;
  int jobs = defaultJobs();

  /// The file of scenarios.
  std::string scenarios() const {
    return format == Format::kJsonl ? out : (fs::path(out) / "scenarios.jsonl").string();
  }
};

// What an interrupted run says; made beforehand, because a signal handler may not allocate.
std::string interruption_message;

/// Says what to do and lets the signal end the process: all that was taken is on the disk already.
void onInterruption(int signal) {
  [[maybe_unused]] const ssize_t count =
      ::write(STDERR_FILENO, interruption_message.data(), interruption_message.size());
  ::raise(signal);
}

/// A limit on file sizes becomes an error of write(); SIGINT, SIGTERM and SIGHUP get the message.
void prepareForInterruption(const Arguments& arguments) {
  const std::string kept = arguments.format == Format::kJsonl
                               ? "answered is in " + arguments.out + ".part"
                               : "answered and written is in " + arguments.out;
  interruption_message =
      "\nforge generate: interrupted; what was " + kept + ": run the same command again to go on\n";
  ::signal(SIGXFSZ, SIG_IGN);
  struct sigaction action = {};
  action.sa_handler = onInterruption;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) ::sigaction(signal, &action, nullptr);
}

/// What the answers depend on, for the resumption of the run.
ResumableFile::Options runOptions(const Arguments& arguments, const Config& config,
                                  const std::vector<SceneRequest>& requests) {
  ResumableFile::Options options = fingerprintsOf(config, arguments.config);
  options["dataroot"] = fs::canonical(arguments.dataroot).string();
  options["version"] = arguments.version;
  if (!arguments.method.empty()) options["method"] = arguments.method;
  options["mode"] = toString(arguments.mode);
  options["requests"] = fingerprintOf(requests);
  return options;
}

/// The list with the mode of this run, and the names of its scenes in the order they are needed.
struct RequestList {
  std::vector<SceneRequest> requests;
  std::vector<std::string> scenes;
};

RequestList readList(const Arguments& arguments) {
  const auto names = readSceneNames(arguments.dataroot, arguments.version);
  RequestList list;
  list.requests = readRequests(arguments.requests, {names.begin(), names.end()});
  std::set<std::string> seen;
  for (SceneRequest& request : list.requests) {
    request.request.mode = arguments.mode;
    if (seen.insert(request.scene).second) list.scenes.push_back(request.scene);
  }
  return list;
}

/// Refuses to go on after a line that answers something else.
void checkAnswers(const std::string& where, const std::string& line, const SceneRequest* request) {
  const SceneRequest asked = readScenarioLine(where, line).asked;
  if (request != nullptr && requestLine(asked) == requestLine(*request) &&
      asked.request.mode == request->request.mode) {
    return;
  }
  throw std::runtime_error(where + ": answers " + requestLine(asked) + ", not " +
                           (request ? requestLine(*request) : "any request of the list"));
}

std::size_t resume(ResumableFile& file, const std::vector<SceneRequest>& requests) {
  std::size_t index = 0;
  return file.resume([&](const std::string& where, const std::string& line) {
    checkAnswers(where, line, index < requests.size() ? &requests[index] : nullptr);
    ++index;
  });
}

/// The scenario file and the progress bar, which the master alone has.
class Output {
 public:
  Output(const Arguments& arguments, const Config& config, const RequestList& list)
      : file_(arguments.scenarios(), runOptions(arguments, config, list.requests)) {
    count_ = list.requests.size();
    first_ = file_.isComplete() ? count_ : resume(file_, list.requests);
    if (first_ > 0) {
      std::cerr << first_ << " of " << count_ << " requests were answered before\n";
    }
    bar_ = std::make_unique<boost::timer::progress_display>(count_, std::cerr);
    *bar_ += first_;
  }

  std::size_t first() const { return first_; }

  void take(const std::string& line) {
    file_.append(line);
    ++*bar_;
  }

  void complete() {
    if (!file_.isComplete()) file_.complete();
  }

 private:
  ResumableFile file_;
  std::size_t count_ = 0;
  std::size_t first_ = 0;
  std::unique_ptr<boost::timer::progress_display> bar_;
};

/// Makes the folder of the clips' format. Clips are written when all scenarios are: without these
/// they are of something else, and would be taken for clips of this run.
void prepareFolder(const Arguments& arguments) {
  const std::string clips = CollideExporter::folderIn(arguments.out);
  if (!fs::exists(arguments.scenarios()) && fs::exists(clips) && !fs::is_empty(clips)) {
    throw std::runtime_error(clips + ": holds clips already, but there is no " +
                             arguments.scenarios() +
                             " that they are of; remove them, or write elsewhere");
  }
  fs::create_directories(arguments.out);
}

/// The clips of all scenarios that have none yet.
void exportClips(const Arguments& arguments, std::size_t count, SceneSource& scenes) {
  const std::string path = arguments.scenarios();
  CollideExporter exporter(arguments.out);
  boost::timer::progress_display bar(count, std::cerr);
  std::ifstream file(path);
  int index = 0;
  for (std::string line; std::getline(file, line); ++index) {
    const Scenario scenario = readScenarioLine(path + ": line " + std::to_string(index + 1), line);
    if (scenario.answer.status.code == StatusCode::kOk) {
      exporter.add(scenario, scenes.at(scenario.asked.scene)->scene, index);
    }
    ++bar;
  }
  if (!exporter.complaint().empty()) std::cerr << exporter.complaint() << "\n";
  std::cout << exporter.clips() << " clips in " << CollideExporter::folderIn(arguments.out) << "\n";
}

int generate(const Arguments& arguments) {
  const bool is_master = isMaster();
  const Config config = loadConfig(arguments.config);
  const RequestList list = readList(arguments);
  std::unique_ptr<Output> output;
  if (is_master) {
    if (arguments.format == Format::kCsvCollide) prepareFolder(arguments);
    output = std::make_unique<Output>(arguments, config, list);
    prepareForInterruption(arguments);
  }
  SceneSource scenes(arguments.dataroot, arguments.version, list.scenes, config,
                     static_cast<std::size_t>(arguments.jobs) + 1,
                     is_master ? OnWarnings(printWarnings) : OnWarnings());
  const RequestAnswerer answerer(scenes, loadMethod(arguments.method, config, config.attack),
                                 config.crash, config.ego_vehicle);
  const auto work = [&](std::size_t index) {
    try {
      return scenarioLine(answerer.answer(list.requests[index]));
    } catch (const std::exception& error) {
      throw std::runtime_error(arguments.requests + ": line " + std::to_string(index + 1) +
                               " cannot be answered: " + error.what());
    }
  };
  dispatch(list.requests.size(), work,
           [&](std::size_t, const std::string& line) { output->take(line); },
           {arguments.jobs, is_master ? output->first() : 0});
  if (is_master) {
    output->complete();
    std::cout << list.requests.size() << " requests answered in " << arguments.scenarios() << "\n";
    if (arguments.format == Format::kCsvCollide) {
      exportClips(arguments, list.requests.size(), scenes);
    }
  }
  return kExitOk;
}

}  // namespace

void addGenerate(CommandLine& line) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App& app = line.add(kMakingCollisions, "generate",
                           "Answers a list of requests; goes on where a run stopped.",
                           [arguments] { return generate(*arguments); });
  addLogs(app, arguments->dataroot, arguments->version);
  app.add_option("--requests", arguments->requests, "list of forge requests")->required();
  addOut(app, arguments->out,
         "scenarios to write, a JSON line a request; with csv-collide a folder");
  addChoice<Format>(app, "--format", arguments->format,
                    {{"jsonl", Format::kJsonl}, {"csv-collide", Format::kCsvCollide}},
                    "jsonl; csv-collide: scenarios.jsonl and a clip of COLLIDE's layout an attack, "
                    "in trajectory/val");
  addMethod(app, arguments->method);
  addMode(app, arguments->mode);
  addJobs(app, arguments->jobs, "requests at a time, in every rank of mpirun");
  addConfig(app, arguments->config);
}

}  // namespace forge
