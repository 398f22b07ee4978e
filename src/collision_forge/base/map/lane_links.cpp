#include "collision_forge/base/map/lane_links.h"

#include <algorithm>
#include <string>
#include <unordered_map>
#include <utility>

namespace forge {

void linkMutually(std::vector<Lane>& lanes) {
  std::unordered_map<std::string, std::size_t> places;
  for (const Lane& lane : lanes) places.emplace(lane.id, places.size());
  std::vector<std::vector<std::string>> incoming(lanes.size());
  std::vector<std::vector<std::string>> outgoing(lanes.size());
  const auto add = [&](const std::string& from, const std::string& to) {
    const auto before = places.find(from);
    const auto after = places.find(to);
    if (before == places.end() || after == places.end()) return;
    std::vector<std::string>& out = outgoing[before->second];
    if (std::find(out.begin(), out.end(), to) != out.end()) return;
    out.push_back(to);
    incoming[after->second].push_back(from);
  };
  for (const Lane& lane : lanes) {
    for (const std::string& next : lane.outgoing) add(lane.id, next);
  }
  for (const Lane& lane : lanes) {
    for (const std::string& before : lane.incoming) add(before, lane.id);
  }
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    lanes[i].incoming = std::move(incoming[i]);
    lanes[i].outgoing = std::move(outgoing[i]);
  }
}

}  // namespace forge
