#include <cctype>
#include <filesystem>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "collision_forge/app/command_line.h"
#include "collision_forge/app/options.h"
#include "collision_forge/attack/verify/strict_outcome.h"
#include "collision_forge/base/files/output_lock.h"
#include "collision_forge/io/batch/progress_line.h"
#include "collision_forge/io/collide/collide_set.h"
#include "collision_forge/io/drawing/draw_grid.h"
#include "collision_forge/io/logs/city_maps.h"
#include "collision_forge/io/weights/pattern_network_file.h"
#include "collision_forge/study/commands/clip_options.h"
#include "collision_forge/study/commands/study_commands.h"
#include "collision_forge/study/evaluation/clip_aftermath.h"
#include "collision_forge/study/evaluation/clip_choice.h"
#include "collision_forge/study/evaluation/clip_question.h"
#include "collision_forge/study/settings/study_config.h"

namespace forge {
namespace {

namespace fs = std::filesystem;

constexpr double kMinTta = 2.0;  // s, of randomly drawn clips, long enough for the animation

struct Arguments {
  std::string collide;
  std::string dataroot;
  std::string split = "val";
  std::vector<std::string> methods;
  std::vector<std::string> clips;
  std::size_t count = 5;
  std::uint64_t seed = 0;
  Mode mode = Mode::kHistory;
  bool seen_scenes = false;
  std::string out;
  ConfigFolder config;
};

std::vector<std::string> pathsOf(const Arguments& arguments) {
  const std::vector<std::string> paths = listCollideClips(arguments.collide, arguments.split);
  if (arguments.clips.empty()) return drawClips(paths, arguments.count, kMinTta, arguments.seed);
  std::vector<std::string> named;
  for (const std::string& name : arguments.clips) named.push_back(clipNamed(paths, name));
  return named;
}

/// Checks the output folder before the methods run, which can take long.
void checkOut(const std::string& out) {
  const fs::path folder = fs::absolute(out).parent_path();
  if (!fs::is_directory(folder)) {
    throw std::runtime_error("cannot draw " + out + ".png: the folder " + folder.string() +
                             " does not exist");
  }
}

/// Returns the text of a cell without attack, as "no attack: low confidence".
std::string refusalText(StatusCode code) {
  std::string words = toString(code);
  for (char& letter : words) {
    letter = letter == '_' ? ' ' : static_cast<char>(std::tolower(letter));
  }
  return "no attack: " + words;
}

/// Runs one method on a clip and checks its attack against the recorded future.
GridCell cellOf(const CollideClip& clip, const ClipQuestion& question, const MethodMaker& maker,
                const Arguments& arguments, const StudyOptions& study) {
  const Moment& moment = question.moment();
  const Attack answer = question.answer(maker, *maker.make(), arguments.seed);
  GridCell cell;
  ScenarioView& view = cell.view;
  view.scene_name = clip.scene;
  view.tta = clip.nominalTta();
  view.mode = arguments.mode;
  view.snapshot = moment.snapshot;
  view.future = withAttackerStopped(clip, *moment.recorded);
  view.pattern.type = clip.type;
  view.pattern.attacker_id = clip.attacker_id;
  view.pattern.time = moment.snapshot.now + question.request().tta;
  if (answer.status.code != StatusCode::kOk) {
    cell.refusal = refusalText(answer.status.code);
    view.trajectory.attacker_id = clip.attacker_id;
    view.trajectory.size = study.evaluation.collide.box;
    return cell;
  }
  view.trajectory = answer.trajectory;
  const VerificationInput input{moment.snapshot, *moment.recorded, question.request(),
                                *moment.lanes};
  view.report = strictOutcome(answer.trajectory, input, study.attack.verification).report;
  view.crash = motionAfterContact(view.report, view.trajectory, moment.recorded->ego,
                                  study.attack.verification.drivable);
  return cell;
}

/// Returns the grid of views, one row per clip, one column per method.
ScenarioGrid gridOf(const std::vector<std::string>& paths, const Arguments& arguments,
                    const StudyConfig& config) {
  CityMaps maps(arguments.dataroot, config);
  const PredictionModels models = loadPredictionModels(config);
  const MethodRegistry methods = loadMethods(config);
  ScenarioGrid grid{arguments.methods, {}};
  ProgressLine progress("attacks");
  std::size_t done = 0;
  for (const std::string& path : paths) {
    const CollideClip clip = readCollideClip(path, config.input_limits);
    const ClipQuestion question(clip, maps.at(clip.city), arguments.mode, config);
    grid.rows.emplace_back();
    for (const std::string& name : arguments.methods) {
      const MethodMaker maker =
          clipMethod(name, clip, {methods, models, config}, arguments.seen_scenes);
      grid.rows.back().push_back(cellOf(clip, question, maker, arguments, config));
      grid.rows.back().back().view.seconds_after_stand = config.attacked_bag.seconds_after_stand;
      progress.show(++done, paths.size() * arguments.methods.size());
    }
  }
  return grid;
}

int compare(const Arguments& arguments) {
  checkOut(arguments.out);
  const OutputLock lock = OutputLock::ofFile(arguments.out + ".png");
  const StudyConfig config = loadStudyConfig(arguments.config);
  const std::vector<std::string> paths = pathsOf(arguments);
  const ScenarioGrid grid = gridOf(paths, arguments, config);
  drawScenarioGridPng(arguments.out + ".png", grid, config.drawing);
  {
    ProgressLine progress("pictures");
    drawScenarioGridGif(arguments.out + ".gif", grid, config.drawing,
                        [&](std::size_t done, std::size_t all) { progress.show(done, all); });
  }
  for (const std::string& path : paths) std::cout << fs::path(path).stem().string() << "\n";
  std::cout << "wrote " << arguments.out << ".png\nwrote " << arguments.out << ".gif\n";
  return kExitOk;
}

/// Throws CLI::ValidationError if a named clip does not exist or there are too few to draw from.
void checkClips(const Arguments& arguments) {
  try {
    pathsOf(arguments);
  } catch (const std::invalid_argument& error) {
    throw CLI::ValidationError(arguments.clips.empty() ? "--count" : "--clips", error.what());
  } catch (const std::runtime_error&) {
    return;  // the run lists the clips again and reports the error
  }
}

}  // namespace

void addCompare(CommandLine& line) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App& app = line.add(kMeasuring, "study compare",
                           "Draws the attacks of several methods on COLLIDE clips side by side.",
                           [arguments] { return compare(*arguments); });
  CLI::Option* collide = addCollide(app, arguments->collide)->required();
  addDataroot(app, arguments->dataroot);
  addSplit(app, arguments->split, collide);
  app.add_option("--methods", arguments->methods,
                 "methods of forge study evaluate, separated by commas; one column each")
      ->delimiter(',')
      ->required();
  CLI::Option* clips = app.add_option("--clips", arguments->clips,
                                      "names of clips, or unique parts of names; one row each; "
                                      "default: random clips");
  app.add_option("--count", arguments->count,
                 "number of random clips with a TTA of at least 2 s, types in turn")
      ->check(CLI::PositiveNumber)
      ->capture_default_str()
      ->excludes(clips);
  addSeed(app, arguments->seed, "random seed of the choice of clips and of the methods");
  addMode(app, arguments->mode, false);
  app.add_flag("--seen-scenes", arguments->seen_scenes,
               "use models trained on all scenes; default: on all except the clip's own");
  addOut(app, arguments->out, "output name; writes NAME.png and NAME.gif");
  addConfig(app, arguments->config);
  app.parse_complete_callback([arguments] {
    checkClipMethods(arguments->methods, arguments->config);
    checkClips(*arguments);
  });
}

}  // namespace forge
