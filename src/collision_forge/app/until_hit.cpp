#include "collision_forge/app/until_hit.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <set>

#include "collision_forge/app/planner_pictures.h"
#include "collision_forge/base/files/aside_file.h"
#include "collision_forge/base/scene/formatted.h"
#include "collision_forge/base/scene/number_words.h"
#include "collision_forge/io/json/json_line.h"
#include "collision_forge/io/scenarios/scenario_file.h"
#include "collision_forge/planner_test/trials/avoidance_words.h"
#include "collision_forge/planner_test/trials/evasion.h"
#include "collision_forge/planner_test/trials/weaknesses.h"

namespace forge {
namespace {

namespace fs = std::filesystem;

/// The hardest collision of a weakness.
struct Shown {
  Scenario scenario;
  PlannerCase one;
  PlannerRow row;
};

Shown show(const Weakness& weakness, const RequestCases& cases, const KeptDrives& drives) {
  const std::size_t hardest = weakness.results.front();
  Shown shown{cases.scenario(hardest), {}, {}};
  shown.one = cases.caseOf(shown.scenario, hardest);
  shown.row = drives.rowOf(shown.one, hardest, weakness.row);
  return shown;
}

void writeMotion(JsonLineWriter& writer, const char* key,
                 const std::vector<TrajectoryPoint>& points, double now) {
  writer.beginArray(key);
  for (const TrajectoryPoint& point : points) {
    writer.beginObject();
    writer.number("t", fromNow(point.time, now));
    writer.number("x", point.pose.x);
    writer.number("y", point.pose.y);
    writer.number("yaw", point.pose.yaw);
    writer.number("speed", point.speed);
    writer.endObject();
  }
  writer.endArray();
}

std::string witnessLine(const Weakness& weakness, const Shown& shown) {
  const double now = shown.one.scenario.snapshot.now;
  const Avoidance& evasion = shown.row.evasion_drive->ego;
  JsonLineWriter writer;
  writer.beginObject();
  writer.text("name", shown.one.name);
  writer.text("planner", weakness.row.planner);
  writer.text("policy", toString(weakness.row.policy));
  writer.text("background", toString(weakness.row.background));
  writer.text("manoeuvre", toString(evasion.manoeuvre));
  writer.number("start_t", fromNow(evasion.start, now));
  writeMotion(writer, "ego", wholeEvasion(shown.row.outcome.driven, evasion), now);
  writeMotion(writer, "attacker", shown.row.evasion_drive->attacker.points, now);
  writer.endObject();
  return writer.line();
}

std::string tableRow(int rank, const Weakness& weakness, const Shown& shown) {
  const PlannerContact& contact = *shown.row.outcome.contact;
  const Avoidance& evasion = shown.row.evasion_drive->ego;
  const std::string numbers =
      formatted("%.1f m/s | %.1f %% | %.1f s | %s, up to %.1f s before | %zu", contact.impact_speed,
                100.0 * contact.severity.worse().mais3,
                fromNow(contact.time, shown.one.scenario.snapshot.now), toString(evasion.manoeuvre),
                contact.time - evasion.start, weakness.results.size());
  return "| " + std::to_string(rank) + " | " + rowName(weakness.row) + " | " + shown.one.name +
         " | " + toString(weakness.manoeuvre) + " | " +
         (weakness.at_fault ? "planner" : "attacker") + " | " + toString(weakness.place) + " | " +
         numbers + " |\n";
}

/// Returns the number of tries up to the first collision of the weakness that was found last.
std::size_t triesTo(const std::vector<Weakness>& weaknesses) {
  std::size_t last = 0;
  for (const Weakness& weakness : weaknesses) {
    const auto& results = weakness.results;
    last = std::max(last, *std::min_element(results.begin(), results.end()) + 1);
  }
  return last;
}

/// Returns the line that describes the weakness on the terminal.
std::string printedLine(int rank, const Weakness& weakness, const Shown& shown) {
  const PlannerContact& contact = *shown.row.outcome.contact;
  const Avoidance& evasion = shown.row.evasion_drive->ego;
  const double now = shown.one.scenario.snapshot.now;
  return "  " + std::to_string(rank) + " " + rowName(weakness.row) + ": " +
         toString(weakness.manoeuvre) + " (" + toString(weakness.place) + ", " +
         (weakness.at_fault ? "planner" : "attacker") + " at fault)" +
         formatted(" after %.1f s at %.1f m/s, avoidable ", fromNow(contact.time, now),
                   contact.impact_speed) +
         avoidanceText(evasion.manoeuvre, fromNow(evasion.start, now), true) + "; " +
         counted(weakness.results.size(), "hit") + ", the most severe in " + shown.one.name + "\n";
}

std::string headOf(const std::vector<Weakness>& weaknesses, std::size_t tries) {
  const std::string tried = counted(tries, "try", "tries");
  if (weaknesses.empty()) return "No weakness in " + tried + ".\n";
  return counted(weaknesses.size(), "weakness", "weaknesses") +
         ", most severe first; the last new one was found in try " +
         std::to_string(triesTo(weaknesses)) + " of " + std::to_string(tries) + ".\n";
}

/// Formats the weaknesses: a Markdown table of all, and lines for the terminal.
class WeaknessList {
 public:
  WeaknessList(const std::vector<Weakness>& weaknesses, std::size_t tries)
      : head_(headOf(weaknesses, tries)) {}

  void add(const Weakness& weakness, const Shown& shown) {
    ++count_;
    rows_ += tableRow(count_, weakness, shown);
    if (count_ <= kPrinted) lines_ += printedLine(count_, weakness, shown);
  }

  int count() const { return count_; }

  std::string table() const {
    if (count_ == 0) return head_;
    return head_ +
           "\n| | planner | hardest hit | manoeuvre | at fault | place | impact | MAIS 3+ | after "
           "| evasive "
           "manoeuvre | hits |\n|---|---|---|---|---|---|---|---|---|---|\n" +
           rows_;
  }

  std::string printed(const std::string& folder) const {
    const std::string more =
        count_ > kPrinted ? "  and " + std::to_string(count_ - kPrinted) + " more\n" : "";
    if (count_ == 0) return head_;
    return head_ + lines_ + more + "in " + folder +
           ": weaknesses.md, weaknesses/ (pictures), weaknesses.jsonl (scenarios)\n";
  }

 private:
  static constexpr int kPrinted = 5;  // lines on the terminal

  std::string head_;
  std::string rows_;
  std::string lines_;
  int count_ = 0;
};

}  // namespace

void reportWeaknesses(const RequestCases& cases, const std::vector<PlannerTestResult>& results,
                      const KeptDrives& drives, const std::string& folder, const Config& config) {
  const auto weaknesses = findWeaknesses(
      results, [&](std::size_t index) { return *cases.request(index).manoeuvre; },
      config.planners.until_hit);
  const fs::path pictures = fs::path(folder) / "weaknesses";
  fs::remove_all(pictures);
  fs::create_directories(pictures);
  WeaknessList list(weaknesses, results.size());
  std::string scenarios;
  std::string witnesses;
  std::set<std::size_t> written;
  for (const Weakness& weakness : weaknesses) {
    const std::size_t hardest = weakness.results.front();
    const Shown shown = show(weakness, cases, drives);
    list.add(weakness, shown);
    if (written.insert(hardest).second) scenarios += scenarioLine(shown.scenario) + "\n";
    witnesses += witnessLine(weakness, shown) + "\n";
    const std::string picture = (pictures / std::to_string(list.count())).string();
    drawView(picture, viewOfCollision(shown.one, shown.row, config), config.drawing);
    drawView(picture + "_escape", viewOfEvasiveManoeuvre(shown.one, shown.row), config.drawing);
  }
  writeText(folder + "/weaknesses.md", list.table());
  writeText(folder + "/weaknesses.jsonl", scenarios);
  writeText(folder + "/witnesses.jsonl", witnesses);
  std::cout << list.printed(folder);
}

}  // namespace forge
