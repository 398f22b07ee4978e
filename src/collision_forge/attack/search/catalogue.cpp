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

/// Sets a field that is a word; returns false for an unknown field or word.
bool setWord(const std::string& field, const std::string& word, CollisionRequest& request) {
  const auto set = [&](const auto& value, auto& target) {
    if (value) target = *value;
    return value.has_value();
  };
  if (field == "type") return set(collisionTypeFromString(word), request.type);
  if (field == "turning") return set(turningFromString(word), request.turning);
  if (field == "manoeuvre") return set(manoeuvreFromString(word), request.manoeuvre);
  if (field == "ego_side") return set(sideFromString(word), request.ego_side);
  if (field == "from_side") return set(sideFromString(word), request.from_side);
  if (field == "hidden_by") return set(hiderFromString(word), request.hidden_by);
  if (field == "attacker_class") return set(agentClassFromString(word), request.attacker_class);
  return false;
}

std::string unknownWord(const std::string& word) {
  return "\"" + word + "\" is not a value of a field of this name";
}

/// Returns the range control of a name, or null.
const RangeControl* rangeControl(const std::string& name) {
  const auto found =
      std::find_if(std::begin(kRangeControls), std::end(kRangeControls),
                   [&](const RangeControl& control) { return name == control.name; });
  return found != std::end(kRangeControls) ? found : nullptr;
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
      if (!setWord(key, word, request)) fields.refuse(key, unknownWord(word));
    }
    fields.finish();
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
        std::istringstream list(words);
        for (std::string word; list >> word;) {
          all.push_back(cell);
          all.back().name += " " + field + "=" + word;
          if (!setWord(field, word, all.back().request)) grid.refuse(field, unknownWord(word));
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
  const auto shortName = [](const CatalogueEntry& entry) {
    return entry.name.substr(entry.name.find('/') + 1);
  };
  std::vector<CatalogueEntry> found;
  for (const std::string& name : names) {
    const std::size_t before = found.size();
    std::copy_if(entries.begin(), entries.end(), std::back_inserter(found),
                 [&](const CatalogueEntry& entry) {
                   return name == entry.name || name == shortName(entry);
                 });
    if (found.size() > before) continue;
    std::vector<std::string> known;
    std::transform(entries.begin(), entries.end(), std::back_inserter(known), shortName);
    throw std::invalid_argument("no scenario \"" + name + "\" in the catalogue" +
                                nearestNameHint(name, known));
  }
  return found;
}

}  // namespace forge
