#include "collision_forge/planner_test/sweeps/sweep_map.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "collision_forge/base/scene/formatted.h"
#include "collision_forge/planner_test/statistics/csv_text.h"
#include "collision_forge/planner_test/sweeps/sweep_parameters.h"

namespace forge {
namespace {

std::size_t placeOf(const SweepLayout& layout, const std::string& name) {
  const auto& all = layout.parameters;
  return static_cast<std::size_t>(std::find(all.begin(), all.end(), name) - all.begin());
}

/// There must be a cell.
MapAxis axisOf(const SweepLayout& layout, const std::vector<SweepCell>& cells,
               const std::string& name) {
  if (name.empty()) return {"", true, {0.0}, {""}, 0.0, 0.0};
  const SweepParameter& parameter = sweepParameter(name);
  std::set<double> values;
  for (const SweepCell& cell : cells) values.insert(cell.values[placeOf(layout, name)]);
  MapAxis axis{parameter.heading, !parameter.words.empty(), {values.begin(), values.end()}, {}};
  for (const double value : values) axis.labels.push_back(parameter.text(value));
  axis.min = *values.begin();
  axis.max = *values.rbegin();
  return axis;
}

/// Returns the place of each cell on an axis.
std::vector<double> placesOn(const MapAxis& axis, const SweepLayout& layout,
                             const std::vector<SweepCell>& cells, const std::string& name) {
  std::vector<double> places;
  for (const SweepCell& cell : cells) {
    const double value = name.empty() ? 0.0 : cell.values[placeOf(layout, name)];
    const auto found = std::lower_bound(axis.values.begin(), axis.values.end(), value);
    places.push_back(layout.is_grid ? static_cast<double>(found - axis.values.begin()) : value);
  }
  return places;
}

/// The outcome of every cell for one planner or driver; nullopt for a rejected cell.
using Outcomes = std::vector<std::optional<SweepOutcome>>;

void add(MapTile& tile, const std::optional<SweepOutcome>& outcome, int& hits, int& feasible) {
  ++tile.count;
  if (outcome) {
    const bool is_same = feasible == 0 || tile.verdict == outcome->verdict;
    tile.verdict = is_same ? outcome->verdict : SweepVerdict::kMixed;
    ++feasible;
    if (outcome->verdict == SweepVerdict::kHit) ++hits;
  }
  if (tile.count > 1 && feasible > 0) {
    tile.text = std::to_string(hits) + "/" + std::to_string(feasible);
  } else if (hits > 0 && !outcome->is_driver) {
    tile.text = formatted("%.1f", outcome->impact_speed);
  }
}

std::vector<MapTile> tilesOf(const Outcomes& outcomes, const std::vector<double>& x,
                             const std::vector<double>& y) {
  struct Known {
    MapTile tile;
    int hits = 0;
    int feasible = 0;
  };
  std::map<std::pair<double, double>, Known> known;
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    Known& here = known[{x[i], y[i]}];
    if (here.tile.count == 0) {
      here.tile.x = x[i];
      here.tile.y = y[i];
      here.tile.cell = i;
    }
    add(here.tile, outcomes[i], here.hits, here.feasible);
  }
  std::vector<MapTile> tiles;
  for (const auto& [place, here] : known) tiles.push_back(here.tile);
  return tiles;
}

std::vector<MapBoundary> boundariesOf(const SweepLayout& layout,
                                      const std::vector<SweepCell>& cells,
                                      const Outcomes& outcomes) {
  std::vector<MapBoundary> boundaries;
  if (!layout.is_grid || !sweepParameter(layout.x).words.empty()) return boundaries;
  const std::size_t place = placeOf(layout, layout.x);
  std::map<std::vector<double>, std::map<double, const SweepOutcome*>> rows;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    std::vector<double> others = cells[i].values;
    others[place] = 0.0;
    rows[others][cells[i].values[place]] = outcomes[i] ? &*outcomes[i] : nullptr;
  }
  for (const auto& [others, row] : rows) {
    for (auto next = std::next(row.begin()); next != row.end(); ++next) {
      const auto cell = std::prev(next);
      if (!cell->second || !next->second || cell->second->verdict == next->second->verdict)
        continue;
      boundaries.push_back({others, cell->second->verdict, next->second->verdict});
      boundaries.back().values[place] = 0.5 * (cell->first + next->first);
    }
  }
  return boundaries;
}

}  // namespace

SweepMap sweepMap(const SweepLayout& layout, const std::vector<SweepCell>& cells) {
  SweepMap map{
      layout.is_grid, axisOf(layout, cells, layout.x), axisOf(layout, cells, layout.y), {}};
  std::vector<std::pair<std::pair<bool, std::string>, Outcomes>> found;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    for (const SweepOutcome& outcome : outcomesOf(cells[i])) {
      const std::pair name{outcome.is_driver, outcome.name};
      auto known = std::find_if(found.begin(), found.end(),
                                [&](const auto& entry) { return entry.first == name; });
      if (known == found.end()) known = found.insert(found.end(), {name, Outcomes(cells.size())});
      known->second[i] = outcome;
    }
  }
  if (found.empty()) found.push_back({{false, ""}, Outcomes(cells.size())});
  const std::vector<double> x = placesOn(map.x, layout, cells, layout.x);
  const std::vector<double> y = placesOn(map.y, layout, cells, layout.y);
  for (const auto& [name, outcomes] : found) {
    map.panels.push_back(
        {name.second, name.first, tilesOf(outcomes, x, y), boundariesOf(layout, cells, outcomes)});
  }
  return map;
}

std::string boundaryCsv(const SweepLayout& layout, const SweepMap& map) {
  std::string text = "name";
  for (const std::string& name : layout.parameters) text += "," + name;
  text += ",verdict_below,verdict_above\n";
  for (const MapPanel& panel : map.panels) {
    for (const MapBoundary& boundary : panel.boundaries) {
      text += csvText(panel.name);
      for (std::size_t i = 0; i < layout.parameters.size(); ++i) {
        text += "," + sweepParameter(layout.parameters[i]).text(boundary.values[i]);
      }
      text += std::string(",") + toString(boundary.below) + "," + toString(boundary.above) + "\n";
    }
  }
  return text;
}

}  // namespace forge
