#include "collision_forge/attack/search/catalogue.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "collision_forge/attack/search/request_check.h"
#include "collision_forge/base/config/config_file.h"
#include "collision_forge/base/config/nearest_names.h"
#include "collision_forge/base/scene/contact_conditions.h"
#include "collision_forge/base/scene/number_words.h"
#include "collision_forge/base/scene/request_words.h"

namespace forge {
namespace {

constexpr const char* kFolder = "catalogue";
constexpr double kMostTolerance = 100.0;  // in the unit of the field

using Tolerances = std::map<std::string, double>;

std::string unknownWord(const std::string& word) {
  return "\"" + word + "\" is not a value of a field of this name";
}

std::string shortName(const CatalogueEntry& entry) {
  return entry.name.substr(entry.name.find('/') + 1);
}

std::vector<std::string> wordsIn(const std::string& text) {
  std::istringstream words(text);
  return {std::istream_iterator<std::string>(words), {}};
}

/// Keeps the cells with a value of the grid ("deceleration=4"). Throws std::invalid_argument if
/// there is none.
void keepCells(const std::string& value, CatalogueEntry& entry) {
  std::vector<CatalogueCell> kept;
  std::vector<std::string> known;
  for (const CatalogueCell& cell : entry.cells) {
    std::vector<std::string> values = wordsIn(cell.name);
    values.erase(values.begin());
    if (std::count(values.begin(), values.end(), value) > 0) kept.push_back(cell);
    known.insert(known.end(), values.begin(), values.end());
  }
  if (kept.empty()) {
    throw std::invalid_argument("scenario " + entry.name + " has no cell \"" + value + "\"" +
                                nearestNameHint(value, known));
  }
  entry.cells = std::move(kept);
}

/// Reads one catalogue file.
class Reader {
 public:
  Reader(const ConfigFolder& folder, std::string catalogue)
      : catalogue_(std::move(catalogue)),
        file_(openConfigFile(folder, std::string(kFolder) + "/" + catalogue_ + ".yaml")) {}

  std::vector<CatalogueEntry> read() {
    Section whole = file_.section(catalogue_);
    readTolerances(whole);
    Section scenarios = whole.section("scenarios");
    std::vector<CatalogueEntry> entries;
    const std::set<std::string> names = scenarios.unread();
    for (const std::string& name : names) {
      Section entry = scenarios.section(name);
      entries.push_back(readEntry(name, entry));
      entry.finish();
    }
    scenarios.finish();
    whole.finish();
    file_.finish();
    return entries;
  }

 private:
  void readTolerances(Section& whole) {
    Section section = whole.section("tolerance");
    const std::set<std::string> names = section.unread();
    for (const std::string& name : names) {
      if (!rangeControl(name)) section.refuse(name, "is not a range of a request");
      tolerances_[name] = section.within(name, 0.0, kMostTolerance);
    }
    section.finish();
  }

  CatalogueEntry readEntry(const std::string& name, Section& section) {
    CatalogueEntry entry;
    entry.name = catalogue_ + "/" + name;
    entry.text = section.text("text");
    if (section.has("differs")) entry.differs = section.text("differs");
    if (section.has("missing")) {
      entry.missing = section.text("missing");
      return entry;
    }
    CollisionRequest request;
    Section fields = section.section("request");
    const std::set<std::string> keys = fields.unread();
    for (const std::string& key : keys) {
      const std::string word = fields.text(key);
      if (!setRequestWord(key, word, request)) fields.refuse(key, unknownWord(word));
    }
    fields.finish();
    entry.request = request;
    entry.cells = {{entry.name, request}};
    if (section.has("grid")) {
      Section grid = section.section("grid");
      const std::set<std::string> varied = grid.unread();
      for (const std::string& field : varied) vary(field, grid, entry.cells);
      grid.finish();
    }
    for (const CatalogueCell& cell : entry.cells) {
      const Status status = checkControls(cell.request);
      if (status.code != StatusCode::kOk) section.refuse("request", status.message);
    }
    return entry;
  }

  /// Replaces each cell by one per value of the field.
  void vary(const std::string& field, Section& grid, std::vector<CatalogueCell>& cells) const {
    std::vector<CatalogueCell> all;
    const RangeControl* control = rangeControl(field);
    if (control) {
      const auto tolerance = tolerances_.find(field);
      if (tolerance == tolerances_.end()) grid.refuse(field, "has no tolerance");
      const std::vector<double> values = grid.numbers(field, control->least, control->most);
      for (const CatalogueCell& cell : cells) {
        for (const double value : values) {
          all.push_back(cell);
          all.back().name += " " + field + "=" + numberText(value);
          all.back().request.*control->asked =
              Range{std::max(control->least, value - tolerance->second),
                    std::min(control->most, value + tolerance->second)};
        }
      }
    } else {
      const std::string words = grid.text(field);
      for (const CatalogueCell& cell : cells) {
        for (const std::string& word : wordsIn(words)) {
          all.push_back(cell);
          all.back().name += " " + field + "=" + word;
          if (!setRequestWord(field, word, all.back().request))
            grid.refuse(field, unknownWord(word));
        }
      }
    }
    cells = std::move(all);
  }

  std::string catalogue_;
  Section file_;
  Tolerances tolerances_;
};

}  // namespace

bool isInstance(const CollisionRequest& cell, const CollisionRequest& request, const Attack& attack,
                const std::optional<ContactConditions>& conditions) {
  const auto fits = [](const auto& wanted, const auto& is) { return !wanted || *wanted == is; };
  const CollisionReport& report = attack.report;
  if (cell.type != request.type || cell.turning != request.turning ||
      !fits(cell.attacker_class, attack.trajectory.agent_class) ||
      !fits(cell.manoeuvre, report.manoeuvre) || !fits(cell.ego_side, report.ego_side)) {
    return false;
  }
  const bool has_queue = std::any_of(
      attack.supports.begin(), attack.supports.end(),
      [](const SupportVehicle& support) { return support.role == SupportRole::kQueue; });
  // An attack of a request with a queue has one, which may be recorded: then without a support.
  if (cell.queue && !has_queue && !request.queue) return false;
  if (!asksForConditions(cell)) return true;
  if (!conditions || !fits(cell.from_side, conditions->from_side)) return false;
  if (cell.hidden_by && conditions->hidden_by != cell.hidden_by) return false;
  return std::all_of(std::begin(kRangeControls), std::end(kRangeControls),
                     [&](const RangeControl& control) {
                       const std::optional<Range>& range = cell.*control.asked;
                       const double measured = (*conditions).*control.measured;
                       return !range || (measured >= range->min && measured <= range->max);
                     });
}

std::vector<std::string> catalogueNames(const ConfigFolder& folder) {
  std::vector<std::string> names;
  for (const std::string& file : folder.files(kFolder)) {
    const std::size_t begin = file.find_last_of('/') + 1;
    names.push_back(file.substr(begin, file.rfind(".yaml") - begin));
  }
  return names;
}

std::vector<CatalogueEntry> readCatalogue(const ConfigFolder& folder,
                                          const std::string& catalogue) {
  std::vector<CatalogueEntry> entries;
  std::string known = "all";
  for (const std::string& name : catalogueNames(folder)) {
    known += ", " + name;
    if (catalogue != "all" && catalogue != name) continue;
    std::vector<CatalogueEntry> read = Reader(folder, name).read();
    std::move(read.begin(), read.end(), std::back_inserter(entries));
  }
  if (entries.empty()) {
    throw std::invalid_argument("no catalogue \"" + catalogue + "\"; known catalogues: " + known);
  }
  return entries;
}

std::vector<CatalogueEntry> namedEntries(const std::vector<CatalogueEntry>& entries,
                                         const std::vector<std::string>& names) {
  if (names.empty()) return entries;
  std::vector<CatalogueEntry> found;
  for (const std::string& name : names) {
    const std::vector<std::string> words = wordsIn(name);
    const std::string wanted = words.empty() ? "" : lowered(words.front());
    const std::size_t before = found.size();
    std::copy_if(entries.begin(), entries.end(), std::back_inserter(found),
                 [&](const CatalogueEntry& entry) {
                   return wanted == lowered(entry.name) || wanted == lowered(shortName(entry));
                 });
    if (found.size() == before) {
      std::vector<std::string> known;
      std::transform(entries.begin(), entries.end(), std::back_inserter(known), shortName);
      throw std::invalid_argument("no scenario \"" + name + "\" in the catalogue" +
                                  nearestNameHint(wanted, known));
    }
    for (std::size_t i = before; i < found.size(); ++i) {
      for (std::size_t k = 1; k < words.size(); ++k) keepCells(words[k], found[i]);
    }
  }
  return found;
}

std::vector<CatalogueCell> namedCells(const std::vector<CatalogueEntry>& entries,
                                      const std::string& name) {
  std::vector<CatalogueCell> cells;
  std::string missing;
  for (const CatalogueEntry& entry : namedEntries(entries, {name})) {
    cells.insert(cells.end(), entry.cells.begin(), entry.cells.end());
    if (!entry.missing.empty()) missing = entry.name + " cannot be requested: " + entry.missing;
  }
  if (cells.empty()) throw std::invalid_argument(missing);
  return cells;
}

}  // namespace forge
