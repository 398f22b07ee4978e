#include <stdexcept>

#include "collision_forge/app/evaluation.h"
#include "collision_forge/app/tool_support.h"
#include "collision_forge/data/pattern_network_file.h"
#include "collision_forge/study/clip_methods.h"

namespace {

using namespace forge;

/// The command line, and which form of the tool it is for.
class CommandLine {
 public:
  explicit CommandLine(CLI::App& app) : app_(app) {
    addSource();
    addCommon();
    app.parse_complete_callback([this] { complete(); });
  }

  const EvaluationArguments& arguments() const { return arguments_; }

 private:
  void addSource() {
    CLI::Option_group* source = app_.add_option_group("what is evaluated");
    collide_ = source
                   ->add_option("--collide", arguments_.collide,
                                "clips: COLLIDE, with trajectory/SPLIT in it")
                   ->check(CLI::ExistingDirectory);
    requests_ = source
                    ->add_option("--requests", arguments_.requests,
                                 "logs: a list of make_requests, over the scenes of --version")
                    ->check(CLI::ExistingFile);
    source->require_option(1);
    app_.add_option("--split", arguments_.split, "which clips")
        ->check(CLI::IsMember({"train", "val", "test"}))
        ->capture_default_str()
        ->needs(collide_);
    app_.add_flag("--by-scene", arguments_.by_scene,
                  "deal published train and val anew, so that no scene is in both")
        ->needs(collide_);
    app_.add_flag("--seen-scenes", arguments_.plan.seen_scenes,
                  "foresee by what was learned from all scenes, as where splits share scenes; by "
                  "default without the clip's own")
        ->needs(collide_);
    app_.add_option("--limit", arguments_.limit, "the first clips only; 0 takes all")
        ->capture_default_str()
        ->needs(collide_);
    CLI::Option* version =
        app_.add_option("--version", arguments_.version, "folder of the tables, as v1.0-mini")
            ->needs(requests_);
    requests_->needs(version);
    app_.add_option("--scene", arguments_.scenes, "requests of these scenes only; all by default")
        ->needs(requests_);
  }

  void addCommon() {
    app_.add_option("--dataroot", arguments_.dataroot, "nuScenes root with maps/expansion in it")
        ->required()
        ->check(CLI::ExistingDirectory);
    app_.add_option("--out", arguments_.out,
                    "folder for results.csv, table.md and charts; a run that was interrupted goes "
                    "on there")
        ->required();
    app_.add_option("--protocol", protocol_, "how crashes are judged; of requests strict alone")
        ->check(CLI::IsMember({"published", "strict"}))
        ->capture_default_str();
    app_.add_option("--method", arguments_.plan.method,
                    "measured beside the baselines; recorded by default, of requests search");
    app_.add_option("--mode", mode_,
                    "history: use only what was seen up to now; replay: use the recorded future")
        ->check(CLI::IsMember({"history", "replay"}))
        ->capture_default_str();
    app_.add_option("--seeds", arguments_.plan.seeds,
                    "of a search, all pooled: 0 to this minus one; of requests counted from theirs")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    app_.add_option("--jobs", arguments_.jobs,
                    "clips or requests at a time, in every rank of mpirun")
        ->check(CLI::Range(1, 256))
        ->capture_default_str();
    addConfigOption(app_, arguments_.config);
  }

  void complete() {
    arguments_.plan.protocol = protocolFromString(protocol_).value();
    arguments_.plan.mode = modeFromString(mode_).value();
    const bool is_of_clips = requests_->count() == 0;
    if (!is_of_clips && app_.count("--method") == 0) arguments_.plan.method = "search";
    const Config config = loadConfig(arguments_.config);
    MethodRegistry methods = loadMethods(config);
    if (is_of_clips) methods = clipMethods(methods, nullptr, config.evaluation);
    try {
      arguments_.plan.is_seeded = methods.at(arguments_.plan.method).is_seeded;
    } catch (const std::invalid_argument& error) {
      throw CLI::ValidationError("--method", error.what());
    }
    if (is_of_clips) return;
    if (arguments_.plan.protocol != Protocol::kStrict) {
      throw CLI::ValidationError("--protocol", protocol_ + " is of clips alone");
    }
  }

  CLI::App& app_;
  CLI::Option* collide_ = nullptr;
  CLI::Option* requests_ = nullptr;
  std::string protocol_ = "strict";
  std::string mode_ = "history";
  EvaluationArguments arguments_;
};

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Measures a method on clips of COLLIDE, or on requests over nuScenes logs, and "
      "baselines beside it.",
      "evaluate");
  const CommandLine command_line(app);
  return runTool(app, argc, argv, [&] {
    const EvaluationArguments& arguments = command_line.arguments();
    return arguments.requests.empty() ? evaluateClips(arguments) : evaluateRequests(arguments);
  });
}
