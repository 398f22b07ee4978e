#include "collision_forge/planner_test/report/write_report.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <set>
#include <stdexcept>
#include <utility>

#include "collision_forge/base/files/aside_file.h"
#include "collision_forge/io/batch/progress_line.h"
#include "collision_forge/io/logs/scene_source.h"
#include "collision_forge/planner_test/planners/planner_factory.h"
#include "collision_forge/planner_test/report/attack_record.h"
#include "collision_forge/planner_test/report/coverage_page.h"
#include "collision_forge/planner_test/report/deflated_text.h"
#include "collision_forge/planner_test/report/page_file.h"
#include "collision_forge/planner_test/report/pictures.h"
#include "collision_forge/planner_test/report/report_files.h"
#include "collision_forge/planner_test/report/report_row.h"
#include "collision_forge/planner_test/report/scene_record.h"
#include "collision_forge/planner_test/report/shell_commands.h"
#include "collision_forge/planner_test/report/weakness_files.h"
#include "collision_forge/planner_test/trials/planner_cases.h"
#include "collision_forge/planner_test/trials/planner_crash.h"
#include "collision_forge/planner_test/trials/planner_result_file.h"

namespace forge {
namespace {

namespace fs = std::filesystem;

/// An attack that planner tests may refer to.
struct ListedAttack {
  std::size_t row = 0;
  BoxSize ego;
  AttackerTrajectory attacker;  ///< without its motion
};

/// An attack replayed against the recording.
struct Judgement {
  StrictOutcome outcome;
  std::optional<ShownCrash> crash;  ///< set if there is a contact
};

bool isPlannerName(const std::string& name) {
  const std::vector<std::string>& names = plannerNames();
  return std::find(names.begin(), names.end(), name) != names.end();
}

void writeColor(JsonLineWriter& writer, const char* key, const Color& color) {
  writer.numbers(key, {color.red, color.green, color.blue});
}

/// Returns a picture in base64. Throws std::runtime_error if it cannot be read.
std::string mapData(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  if (bytes.empty()) throw std::runtime_error(path + ": cannot be read");
  return base64Text(bytes);
}

/// Reads the inputs in sequence and adds their records to the page.
class ReportBuilder {
 public:
  ReportBuilder(const ReportInputs& inputs, const std::string& folder,
                const ReportSettings& settings)
      : inputs_(inputs),
        folder_(folder),
        settings_(settings),
        page_((fs::path(folder) / "index.html").string()) {
    for (const std::string& path : inputs.files) {
      files_.push_back(openReportFile(path, settings.options.input_limits));
    }
    for (const std::string& path : scenarioPaths()) nameWeaknesses(path);
    if (!inputs.logs.path.empty()) openScenes();
  }

  std::size_t build() {
    // Scenario files come first, because tests refer to their attacks.
    for (const bool is_of_attacks : {true, false}) {
      for (std::size_t i = 0; i < files_.size(); ++i) {
        if (files_[i].kind == ReportFileKind::kMaps) continue;
        if ((files_[i].kind == ReportFileKind::kScenarios) == is_of_attacks) read(i);
      }
    }
    addScenes();
    page_.commit(index());
    if (!coverage_.empty()) {
      writeText((fs::path(folder_) / "coverage.html").string(), coverage_.page());
    }
    return rows_.size();
  }

 private:
  std::vector<std::string> scenarioPaths() const {
    std::vector<std::string> paths;
    for (const ReportFile& file : files_) {
      if (file.kind == ReportFileKind::kScenarios) paths.push_back(file.path);
    }
    return paths;
  }

  /// Maps the lines of weaknesses.jsonl to the case names of the results.
  void nameWeaknesses(const fs::path& path) {
    if (path.filename() != "weaknesses.jsonl") return;
    const std::string folder = path.has_parent_path() ? path.parent_path().string() : ".";
    std::size_t line = 0;
    for (const std::string& name : weaknessCases(folder, settings_.options.input_limits)) {
      lines_[name] = "weaknesses:" + std::to_string(++line);
    }
  }

  /// Returns FILE:LINE of a case's scenario.
  const std::string& lineOf(const std::string& name) const {
    const auto found = lines_.find(name);
    return found != lines_.end() ? found->second : name;
  }

  void openScenes() {
    const auto known = readSceneNames(inputs_.logs);
    known_.insert(known.begin(), known.end());
    std::vector<std::string> wanted;
    for (const std::string& scene : readScenes(scenarioPaths(), settings_.options.input_limits)) {
      if (known_.count(scene) > 0) wanted.push_back(scene);
    }
    if (wanted.empty()) return;
    scenes_ = std::make_unique<SceneSource>(inputs_.logs, wanted, settings_.options, 2);
  }

  void read(std::size_t place) {
    const ReportFile& file = files_[place];
    const TestPictures pictures =
        file.kind == ReportFileKind::kPlannerTests ? picturesOf(file) : TestPictures();
    ProgressLine progress(file.path);
    const auto take = [&](const std::string& where, std::size_t line, const std::string& text,
                          double share) {
      const std::size_t first = rows_.size();
      switch (file.kind) {
        case ReportFileKind::kScenarios:
          addScenario(where, text, fs::path(file.path).stem().string(), line);
          break;
        case ReportFileKind::kPlannerTests:
          addPlannerTest(where, text, pictures);
          break;
        case ReportFileKind::kMaps:
          break;
      }
      for (std::size_t i = first; i < rows_.size(); ++i) {
        rows_[i].file = place;
        rows_[i].line = line;
      }
      progress.show(share);
    };
    readReportLines(file, settings_.options.input_limits, take);
  }

  void addScenario(const std::string& where, const std::string& text, const std::string& source,
                   std::size_t line) {
    const Scenario scenario = readScenarioLine(where, text, settings_.options.input_limits);
    const std::string& scene = scenario.asked.scene;
    if (!inputs_.logs.path.empty() && known_.count(scene) == 0) {
      throw std::runtime_error(where + ": scene = \"" + scene + "\" is not in " +
                               inputs_.logs.described());
    }
    ListedAttack listed{rows_.size(), scenario.ego.size, scenario.answer.trajectory};
    listed.attacker.points.clear();
    attacks_.emplace(source + ":" + std::to_string(line), std::move(listed));
    int number = 1;
    const auto measured = addAttack(scenario, scenario.answer, number);
    coverage_.add(scenario, source + ":" + std::to_string(line), measured);
    for (const Attack& alternative : scenario.answer.alternatives) {
      addAttack(scenario, alternative, ++number);
    }
  }

  /// Returns the conditions of the contact in the recording; empty without one. `alternative`
  /// counts the attacks of the scenario from 1 on.
  std::optional<ContactConditions> addAttack(const Scenario& scenario, const Attack& attack,
                                             int alternative) {
    std::optional<Judgement> judgement;
    std::optional<double> now_in_recording;
    const bool is_attack = attack.status.code == StatusCode::kOk;
    if (scenes_) {
      if (is_attack) judgement = judge(scenario, attack);
      const Scene& scene = scenes_->at(scenario.asked.scene)->scene;
      if (!scene.frame_times.empty()) {
        now_in_recording = fromNow(scenario.asked.now, scene.frame_times.front());
      }
      include(scenario, attack, judgement ? judgement->crash : std::nullopt);
    }
    ReportRow& row = rows_.emplace_back(rowOfAttack(
        scenario, attack, judgement ? std::optional(judgement->outcome) : std::nullopt));
    row.now_in_recording = now_in_recording;
    row.commands = page_.add(commandsRecord(commandsOfAttack(
        scenario, alternative, now_in_recording, inputs_.logs, settings_.options.crash)));
    if (!is_attack) return std::nullopt;
    std::optional<RecordedOutcome> recorded;
    if (judgement) recorded = RecordedOutcome{judgement->outcome.report, judgement->crash};
    row.attack =
        page_.add(attackRecord(scenario, attack, recorded, settings_.options.attack.verification));
    if (!recorded || !recorded->report.contact) return std::nullopt;
    return recorded->report.conditions;
  }

  /// Extends the part of the scene that is shown by the attack.
  void include(const Scenario& scenario, const Attack& attack,
               const std::optional<ShownCrash>& crash) {
    const double now = scenario.asked.now;
    const std::vector<TrajectoryPoint>& points = attack.trajectory.points;
    double end = points.empty() ? now + scenario.asked.request.tta : points.back().time;
    if (crash) end = std::max(end, crash->motion.standTime() + crash->seconds_after_stand);
    extents_[scenario.asked.scene].include(now - settings_.report.seconds_before_now, end, points);
  }

  /// Returns nothing if there is no contact.
  /// `other_id`: the touched vehicle.
  std::optional<ShownCrash> shownCrash(const std::optional<PostCrashMotion>& motion,
                                       const std::string& other_id,
                                       const std::vector<Track>& agents) const {
    if (!motion) return std::nullopt;
    return ShownCrash{
        *motion, settings_.seconds_after_stand, {}, secondaryContacts(*motion, other_id, agents)};
  }

  /// Returns nothing if the recording has no frame at t0.
  std::optional<Judgement> judge(const Scenario& scenario, const Attack& attack) {
    Scenario judged{scenario.asked, scenario.ego, attack};
    const PlannerCase one =
        caseOfScenario(judged, *scenes_->at(scenario.asked.scene), settings_.options);
    if (one.status.code != StatusCode::kOk) return std::nullopt;
    const CrashScenario& crash = one.scenario;
    const VerificationOptions& options = settings_.options.attack.verification;
    const StrictOutcome outcome = strictOutcome(
        crash.attacker, {crash.snapshot, crash.recorded, one.request, *crash.lanes}, options);
    return Judgement{outcome, shownCrash(motionAfterContact(outcome.report, crash.attacker,
                                                            crash.recorded.ego, options.severity),
                                         crash.attacker.attacker_id, crash.recorded.agents)};
  }

  void addPlannerTest(const std::string& where, const std::string& text,
                      const TestPictures& pictures) {
    const PlannerTestResult result = readPlannerResultLine(where, text);
    coverage_.add(result);
    const auto found = attacks_.find(lineOf(result.name));
    const ListedAttack* attack = found != attacks_.end() ? &found->second : nullptr;
    const std::optional<ReportRow> known =
        attack ? std::optional(rows_[attack->row]) : std::nullopt;
    const ReportRow* known_row = known ? &*known : nullptr;
    if (result.rows.empty()) rows_.push_back(rowOfTest(result, nullptr, known_row));
    for (const PlannerRow& test : result.rows) {
      ReportRow& row = rows_.emplace_back(rowOfTest(result, &test, known_row));
      if (result.isTested()) {
        const auto links = pictures.find({result.name, rowName(test)});
        row.test = page_.add(plannerRecord(
            result, test,
            {attack != nullptr, attack ? crashOf(test, *attack, result.scene) : std::nullopt,
             links != pictures.end() ? linksTo(links->second) : std::vector<PictureLink>()}));
      }
      if (!known || !isPlannerName(test.planner)) continue;
      row.commands = page_.add(commandsRecord(
          {commandsOfTest(files_[known->file].path, known->line, keyOf(test), inputs_.logs)}));
    }
  }

  std::vector<PictureLink> linksTo(const std::vector<Picture>& pictures) const {
    std::vector<PictureLink> links;
    for (const Picture& picture : pictures) {
      links.push_back({picture.name, linkTo(picture.path, folder_)});
    }
    return links;
  }

  /// Finds the figures of all tests in the file.
  TestPictures picturesOf(const ReportFile& file) const {
    std::vector<PlannerTestResult> results;
    readReportLines(file, settings_.options.input_limits,
                    [&](const std::string& where, std::size_t, const std::string& text, double) {
                      dropMotions(results.emplace_back(readPlannerResultLine(where, text)));
                    });
    return picturesBeside(file.path, results, settings_.options.input_limits);
  }

  /// Returns nothing if the planner's ego has no contact, the drive is missing, or the touched
  /// vehicle's motion is unknown.
  std::optional<ShownCrash> crashOf(const PlannerRow& test, const ListedAttack& attack,
                                    const std::string& scene) const {
    RolloutOutcome outcome = test.outcome;
    if (outcome.driven.empty()) return std::nullopt;
    const std::vector<TrajectoryPoint> points = outcome.attacker.points;
    outcome.attacker = attack.attacker;
    outcome.attacker.points = points;
    const std::vector<Track> no_agents;
    const std::vector<Track>& agents = scenes_ ? scenes_->at(scene)->scene.agents : no_agents;
    const auto crash =
        forge::crashOf(outcome, attack.ego, agents, settings_.options.attack.verification.severity);
    if (!crash) return std::nullopt;
    std::optional<ShownCrash> shown = shownCrash(crash->motion, crash->other.id, agents);
    if (!outcome.contact->is_attacker) shown->other = crash->other;
    return shown;
  }

  void addScenes() {
    std::map<std::string, std::size_t> places;
    ProgressLine progress("scenes");
    for (const auto& [name, extent] : extents_) {
      places[name] = page_.add(sceneRecord(scenes_->at(name)->scene, extent, settings_.report));
      progress.show(places.size(), extents_.size());
    }
    for (ReportRow& row : rows_) {
      const auto place = places.find(row.scene);
      if (place != places.end() && row.now) row.place = place->second;
    }
  }

  std::string index() const {
    JsonLineWriter writer;
    writer.beginObject();
    writer.text("source", inputs_.logs.path);
    writer.text("version", inputs_.logs.version);
    writer.count("rows", rows_.size());
    writer.beginArray("files");
    for (const ReportFile& file : files_) {
      writer.beginObject();
      writer.text("path", file.path);
      writer.flag("has_tests", file.kind == ReportFileKind::kPlannerTests);
      writer.text("link", linkTo(file.path, folder_));
      writer.endObject();
    }
    writer.endArray();
    std::vector<std::string> maps;
    for (const ReportFile& file : files_) {
      if (file.kind == ReportFileKind::kMaps) maps.push_back(mapData(file.path));
    }
    writer.texts("maps", maps);
    writer.flag("has_coverage", !coverage_.empty());
    writeColors(writer);
    writeColumns(writer, rows_);
    writer.endObject();
    return writer.line();
  }

  void writeColors(JsonLineWriter& writer) const {
    const DrawingOptions& drawing = settings_.drawing;
    writer.beginObject("colors");
    writeColor(writer, "drivable", drawing.drivable_color);
    writeColor(writer, "walkway", drawing.walkway_color);
    writeColor(writer, "lane", drawing.lane_color);
    writeColor(writer, "connector", drawing.connector_color);
    writeColor(writer, "agent", drawing.agent_color);
    writeColor(writer, "support", drawing.support_color);
    writeColor(writer, "ego", drawing.ego_color);
    writeColor(writer, "attacker", drawing.attacker_color);
    writeColor(writer, "aim-ego", drawing.pattern_ego_color);
    writeColor(writer, "aim-attacker", drawing.pattern_attacker_color);
    writeColor(writer, "contact", drawing.contact_color);
    writeColor(writer, "passed", drawing.passed_color);
    writeColor(writer, "partial", drawing.partial_color);
    writeColor(writer, "failed", drawing.failed_color);
    writer.endObject();
  }

  const ReportInputs& inputs_;
  const std::string& folder_;
  const ReportSettings& settings_;
  PageFile page_;
  std::vector<ReportFile> files_;
  std::set<std::string> known_;          ///< names of the source's scenes
  std::unique_ptr<SceneSource> scenes_;  ///< of the scenario files; null without a source
  std::vector<ReportRow> rows_;
  Coverage coverage_{settings_.catalogue};
  std::map<std::string, ListedAttack> attacks_;  ///< by case name
  std::map<std::string, std::string> lines_;     ///< see lineOf()
  std::map<std::string, SceneExtent> extents_;   ///< by scene name
};

}  // namespace

std::size_t writeReportPage(const ReportInputs& inputs, const std::string& folder,
                            const ReportSettings& settings) {
  fs::create_directories(folder);
  return ReportBuilder(inputs, folder, settings).build();
}

}  // namespace forge
