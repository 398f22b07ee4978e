#include "collision_forge/study/scorecard_report.h"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <optional>
#include <sstream>
#include <utility>

#include "collision_forge/statistics/statistics.h"

namespace forge {
namespace {

const char* const kRecorded = "recorded";
constexpr double kWhole = 1.0 - 1e-3;  // shares are written with four decimals

/// An attack or a window of a recorded vehicle, as a trial of anything.
struct Drive {
  Trial trial;  // without its value
  RoadUse road;
  std::optional<double> least_gap;
  DrivePeaks limits;
  std::optional<DrivePeaks> driven;  // of all points until the contact; of attacks alone
  std::optional<DrivePeaks> fitted;  // of the window
  std::optional<MotionWindow> window;
};

/// What is compared; the recorded ones, last, are of no type and no TTA.
struct Drivers {
  std::string name;
  std::vector<Drive> drives;
  bool isRecorded() const { return name == kRecorded; }
};

Drive driveOf(const ResultRow& row, const StudyOptions& options) {
  const AttackFigures& attack = *row.request->attack;
  Drive drive{{row.scene, row.type, row.tta, 0.0},
              attack.road,
              attack.least_gap,
              {},
              attack.peaks,
              {},
              attack.window};
  drive.limits = peakLimits(attack.agent_class, attack.size, options.attack.verification.drivable);
  if (attack.window) {
    drive.fitted = peaksOf(*attack.window, options.evaluation.scorecard.motion);
  }
  return drive;
}

Drive driveOf(const RecordedMotion& motion, const StudyOptions& options) {
  const MotionWindow& window = motion.window;
  return {{window.scene, {}, 0.0, 0.0},
          motion.road,
          motion.least_gap,
          peakLimits(window.agent_class, window.size, options.attack.verification.drivable),
          {},
          peaksOf(window, options.evaluation.scorecard.motion),
          window};
}

std::vector<Drivers> driversOf(const std::vector<ResultRow>& rows,
                               const std::vector<std::string>& methods,
                               const std::vector<RecordedMotion>& recorded,
                               const StudyOptions& options) {
  std::vector<Drivers> all;
  for (const std::string& method : methods) {
    all.push_back({method, {}});
    for (const ResultRow& row : rows) {
      if (row.method != method || !row.request || !row.request->attack) continue;
      all.back().drives.push_back(driveOf(row, options));
    }
  }
  all.push_back({kRecorded, {}});
  for (const RecordedMotion& motion : recorded) {
    all.back().drives.push_back(driveOf(motion, options));
  }
  return all;
}

/// A share that every drive has.
struct Share {
  const char* name;
  const char* title;
  bool is_charted;
  double (*of)(const RoadUse& road);
};

const Share kShares[] = {
    {"wholly_on_lane", "On a lane throughout", true,
     [](const RoadUse& road) { return road.on_lane >= kWhole ? 1.0 : 0.0; }},
    {"on_lane", "On a lane, mean share of the time", true,
     [](const RoadUse& road) { return road.on_lane; }},
    {"wrong_way", "Against its lane at some time", true,
     [](const RoadUse& road) { return road.wrong_way > 0.0 ? 1.0 : 0.0; }},
    {"on_island", "On an island at some time", true,
     [](const RoadUse& road) { return road.on_island > 0.0 ? 1.0 : 0.0; }},
    {"on_walkway", "On a walkway at some time", true,
     [](const RoadUse& road) { return road.on_walkway > 0.0 ? 1.0 : 0.0; }},
    {"off_road", "Off the drivable area, mean share of the box", true,
     [](const RoadUse& road) { return road.off_road; }},
    {"wrong_way_share", "Against its lane, mean share of the time", false,
     [](const RoadUse& road) { return road.wrong_way; }},
    {"on_island_share", "On an island, mean share of the time", false,
     [](const RoadUse& road) { return road.on_island; }},
    {"on_walkway_share", "On a walkway, mean share of the time", false,
     [](const RoadUse& road) { return road.on_walkway; }},
};

/// The cells of one who is of no type and no TTA, but for the last one, have no trials.
void keepLast(std::vector<Rate>& rates) {
  for (std::size_t i = 0; i + 1 < rates.size(); ++i) rates[i] = {};
}

RateTable shareTable(const Share& share, const std::vector<Drivers>& all,
                     const StatisticsOptions& options) {
  MethodTrials trials;
  for (const Drivers& drivers : all) {
    trials.push_back({drivers.name, {}});
    for (const Drive& drive : drivers.drives) {
      Trial trial = drive.trial;
      trial.value = share.of(drive.road);
      trials.back().second.push_back(std::move(trial));
    }
  }
  RateTable table = tabulateTrials({share.name, share.title, std::nullopt, false}, trials, options);
  keepLast(table.rates.back());
  return table;
}

/// A value that some drives have.
struct Quantity {
  std::string name;
  std::string title;  // with the unit that values times `scale` are in
  double scale = 1.0;
  std::vector<double> shares;  // of the quantiles
  std::function<std::optional<double>(const Drive&)> of;
};

std::string shareName(double share) {
  char text[32];
  std::snprintf(text, sizeof(text), "%g", 100.0 * share);
  return text;
}

/// Quantiles of a quantity, a row a driver and a column a group.
class QuantileTable {
 public:
  QuantileTable(Quantity quantity, const std::vector<Drivers>& all, int least)
      : quantity_(std::move(quantity)), least_(static_cast<std::size_t>(least)) {
    for (const Drivers& drivers : all) {
      std::vector<Trial> trials;
      for (const Drive& drive : drivers.drives) {
        const auto value = quantity_.of(drive);
        if (!value) continue;
        trials.push_back(drive.trial);
        trials.back().value = *value;
      }
      if (trials.empty()) continue;
      rows_.push_back({drivers.name, groupTrials(trials)});
      if (drivers.isRecorded()) {
        for (std::size_t i = 0; i + 1 < rows_.back().second.size(); ++i) {
          rows_.back().second[i].trials.clear();
        }
      }
    }
  }

  std::string markdown() const {
    if (rows_.empty()) return "";
    std::ostringstream out;
    out << "\n" << quantity_.title << ": quantiles ";
    for (const double share : quantity_.shares) {
      out << (share == quantity_.shares.front() ? "" : " / ") << shareName(share) << " %";
    }
    out << "\n\n| method |";
    for (const TrialGroup& group : rows_.front().second) out << ' ' << group.title << " |";
    out << "\n|---|";
    for (std::size_t i = 0; i < rows_.front().second.size(); ++i) out << "---|";
    for (const auto& [name, groups] : rows_) {
      out << "\n| " << name << " |";
      for (const TrialGroup& group : groups) out << ' ' << cell(group) << " |";
    }
    out << "\n";
    return out.str();
  }

  std::string csv() const {
    std::string text;
    for (const auto& [name, groups] : rows_) {
      for (const TrialGroup& group : groups) {
        if (group.trials.size() < least_) continue;
        const std::vector<double> values = sorted(group);
        for (const double share : quantity_.shares) {
          char value[32];
          std::snprintf(value, sizeof(value), "%.4f", quantile(values, share));
          text += quantity_.name + "_quantile_" + shareName(share) + ',' + name + ',' +
                  group.title + ',' + std::to_string(values.size()) + ',' + value + ",,\n";
        }
      }
    }
    return text;
  }

 private:
  static std::vector<double> sorted(const TrialGroup& group) {
    std::vector<double> values;
    for (const Trial& trial : group.trials) values.push_back(trial.value);
    std::sort(values.begin(), values.end());
    return values;
  }

  std::string cell(const TrialGroup& group) const {
    if (group.trials.size() < least_) return "-";
    const std::vector<double> values = sorted(group);
    std::string text;
    for (const double share : quantity_.shares) {
      char value[32];
      std::snprintf(value, sizeof(value), "%.1f", quantity_.scale * quantile(values, share));
      text += (text.empty() ? "" : " / ") + std::string(value);
    }
    return text;
  }

  Quantity quantity_;
  std::size_t least_;
  std::vector<std::pair<std::string, std::vector<TrialGroup>>> rows_;
};

using Peaks = std::optional<DrivePeaks> Drive::*;

/// A peak as a share of its limit.
Quantity peakQuantity(const std::string& name, const std::string& title, Peaks peaks,
                      double DrivePeaks::*peak) {
  return {name,
          title + ", % of the class's limit",
          100.0,
          {0.5, 0.9, 0.99, 1.0},
          [=](const Drive& drive) -> std::optional<double> {
            if (!(drive.*peaks)) return std::nullopt;
            return (*(drive.*peaks)).*peak / (drive.limits.*peak);
          }};
}

std::vector<Quantity> quantities() {
  std::vector<Quantity> found = {
      {"least_gap",
       "Least gap to anybody but the ego until the contact, m (recorded: to anybody)",
       1.0,
       {0.05, 0.5},
       [](const Drive& drive) { return drive.least_gap; }}};
  const std::pair<const char*, double DrivePeaks::*> peaks[] = {
      {"steering_rate", &DrivePeaks::steering_rate},
      {"jerk", &DrivePeaks::jerk},
      {"lateral_acceleration", &DrivePeaks::lateral_acceleration}};
  for (const auto& [name, peak] : peaks) {
    std::string title = name;
    std::replace(title.begin(), title.end(), '_', ' ');
    found.push_back(peakQuantity(std::string("peak_") + name,
                                 "Greatest " + title + " until the contact", &Drive::driven, peak));
    found.push_back(peakQuantity(std::string("fitted_") + name,
                                 "Greatest " + title + " of the fit over 3 s", &Drive::fitted,
                                 peak));
  }
  return found;
}

std::vector<MotionWindow> windowsOf(const Drivers& drivers,
                                    std::optional<CollisionType> type = {}) {
  std::vector<MotionWindow> windows;
  for (const Drive& drive : drivers.drives) {
    if (drive.window && (!type || drive.trial.type == *type)) windows.push_back(*drive.window);
  }
  return windows;
}

std::string number(const char* format, double value) {
  char text[48];
  std::snprintf(text, sizeof(text), format, value);
  return text;
}

std::string csvLine(const std::string& name, const std::string& method, const std::string& group,
                    std::size_t count, double value) {
  return name + ',' + method + ',' + group + ',' + std::to_string(count) + ',' +
         number("%.4f", value) + ",,\n";
}

std::string floorText(const char* format, const RecordedFloor& floor) {
  return number(format, floor.mean) + " (" + number(format, floor.max) + ")";
}

/// A row a group of attacks.
class ClassifierTable {
 public:
  void add(const std::string& method, const std::string& group, const ClassifierRow& row) {
    text_ += "| " + method + ", " + group + " | " + std::to_string(row.test.first) + " | " +
             std::to_string(row.unmatched) + " | " + number("%.3f", row.test.larger()) + " | " +
             number("%.3f", row.test.logistic) + " | " + number("%.3f", row.test.forest) + " | " +
             number("%.3f", row.noisy.larger()) + " | " + floorText("%.3f", row.larger_floor) +
             " |\n";
    const std::pair<const char*, double> values[] = {
        {"area", row.test.larger()},           {"area_logistic", row.test.logistic},
        {"area_forest", row.test.forest},      {"area_noisy", row.noisy.larger()},
        {"area_floor", row.larger_floor.mean}, {"area_floor_max", row.larger_floor.max}};
    for (const auto& [name, value] : values) {
      csv_ += csvLine(name, method, group, row.test.first, value);
    }
  }

  std::string markdown() const {
    if (text_.empty()) return "";
    return "\nArea under the curve of a classifier, attacks against recorded vehicles (0.5: "
           "alike); "
           "larger of the two, with the recordings' noise, and the floor between recorded "
           "vehicles, "
           "mean (largest)\n\n| method | attacks | unmatched | larger | logistic | forest | noisy "
           "| "
           "floor |\n|---|---|---|---|---|---|---|---|\n" +
           text_;
  }
  const std::string& csv() const { return csv_; }

 private:
  std::string text_;
  std::string csv_;
};

/// The distances of one method's attacks.
class DistanceTable {
 public:
  explicit DistanceTable(std::string method) : method_(std::move(method)) {}

  void add(const DistanceRow& row) {
    const std::string group =
        std::string(toString(row.group)) +
        (row.band == SpeedBand::kAll ? "" : std::string(" at ") + toString(row.band));
    const std::string quantity = toString(row.quantity);
    text_ += "| " + group + " | " + quantity + " | " + std::to_string(row.attacks) + " | " +
             number("%.3f", row.distance.jensen_shannon) + " | " +
             number("%.3f", row.noisy.jensen_shannon) + " | " +
             floorText("%.3f", row.floor.jensen_shannon) + " | " +
             number("%.3f", row.distance.wasserstein) + " | " +
             number("%.3f", row.noisy.wasserstein) + " | " +
             floorText("%.3f", row.floor.wasserstein) + " " + unitOf(row.quantity) + " |\n";
    const std::pair<const char*, double> values[] = {
        {"jensen_shannon", row.distance.jensen_shannon},
        {"jensen_shannon_noisy", row.noisy.jensen_shannon},
        {"jensen_shannon_floor", row.floor.jensen_shannon.mean},
        {"jensen_shannon_floor_max", row.floor.jensen_shannon.max},
        {"wasserstein", row.distance.wasserstein},
        {"wasserstein_noisy", row.noisy.wasserstein},
        {"wasserstein_floor", row.floor.wasserstein.mean},
        {"wasserstein_floor_max", row.floor.wasserstein.max}};
    for (const auto& [name, value] : values) {
      csv_ += csvLine(quantity + " " + name, method_, group, row.attacks, value);
    }
  }

  std::string markdown() const {
    if (text_.empty()) return "";
    return "\nDistances from recorded vehicles, " + method_ +
           ": as they are, with the recordings' noise, and the floor between recorded vehicles, "
           "mean (largest)\n\n| vehicles | quantity | attacks | Jensen-Shannon | noisy | floor | "
           "Wasserstein | noisy | floor |\n|---|---|---|---|---|---|---|---|---|\n" +
           text_;
  }
  const std::string& csv() const { return csv_; }

 private:
  std::string method_;
  std::string text_;
  std::string csv_;
};

/// Classifiers of all methods by class and by type, then the distances of each.
void addScorecards(const std::vector<Drivers>& all, const ScorecardOptions& options,
                   ScorecardReport& report) {
  const std::vector<MotionWindow> recorded = windowsOf(all.back());
  ClassifierTable classifiers;
  std::string counts, distances;
  for (const Drivers& drivers : all) {
    if (drivers.isRecorded()) break;
    const Scorecard card = scorecardOf(windowsOf(drivers), recorded, options);
    counts += "\n" + drivers.name + ": " + std::to_string(drivers.drives.size()) + " attacks, " +
              std::to_string(card.attacks) + " windows of 3 s that count, " +
              std::to_string(card.left_out) + " with too few generated samples; " +
              std::to_string(card.recorded) + " recorded windows\n";
    for (const ClassifierRow& row : card.classifiers) {
      classifiers.add(drivers.name, toString(row.group), row);
    }
    for (const CollisionType type : kCollisionTypes) {
      const Scorecard of_type = scorecardOf(windowsOf(drivers, type), recorded, options);
      if (of_type.classifiers.empty()) continue;
      classifiers.add(drivers.name, toString(type), of_type.classifiers.front());
    }
    DistanceTable table(drivers.name);
    for (const DistanceRow& row : card.distances) table.add(row);
    distances += table.markdown();
    report.csv += table.csv();
  }
  report.markdown += counts + classifiers.markdown() + distances;
  report.csv += classifiers.csv();
}

}  // namespace

ScorecardReport reportScorecard(const std::vector<ResultRow>& rows,
                                const std::vector<std::string>& methods,
                                const std::vector<RecordedMotion>& recorded,
                                const StudyOptions& options) {
  const std::vector<Drivers> all = driversOf(rows, methods, recorded, options);
  ScorecardReport report{{}, rateCsvHeader() + "\n", {}};
  for (const Share& share : kShares) {
    RateTable table = shareTable(share, all, options.evaluation.statistics);
    report.markdown += "\n" + toMarkdown(table);
    report.csv += toCsv(table);
    if (share.is_charted) report.shares.push_back(std::move(table));
  }
  const ScorecardOptions& scorecard = options.evaluation.scorecard;
  for (Quantity& quantity : quantities()) {
    const QuantileTable table(std::move(quantity), all, scorecard.min_windows);
    report.markdown += table.markdown();
    report.csv += table.csv();
  }
  addScorecards(all, scorecard, report);
  return report;
}

}  // namespace forge
