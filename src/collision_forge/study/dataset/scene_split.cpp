#include "collision_forge/study/dataset/scene_split.h"

#include <algorithm>
#include <set>

#include "collision_forge/study/dataset/seeds.h"

namespace forge {
namespace {

std::size_t countOf(double share, std::size_t scenes) {
  constexpr double kRounding = 1e-9;
  if (share < kRounding) return 0;
  const auto count = static_cast<std::size_t>(share * static_cast<double>(scenes) + kRounding);
  return scenes >= splitNames().size() ? std::max<std::size_t>(count, 1) : count;
}

}  // namespace

const std::vector<std::string>& splitNames() {
  static const std::vector<std::string> names = {"train", "val", "test"};
  return names;
}

std::map<std::string, std::string> splitByScene(const std::vector<std::string>& scenes,
                                                const SplitOptions& options) {
  const std::set<std::string> names(scenes.begin(), scenes.end());
  std::vector<std::string> order(names.begin(), names.end());
  std::stable_sort(order.begin(), order.end(), [](const std::string& a, const std::string& b) {
    return seedOf(a, 0) < seedOf(b, 0);
  });
  const std::size_t val = countOf(options.val_share, order.size());
  const std::size_t test = countOf(1.0 - options.train_share - options.val_share, order.size());
  std::map<std::string, std::string> splits;
  for (std::size_t i = 0; i < order.size(); ++i) {
    splits[order[i]] = i < val ? "val" : i < val + test ? "test" : "train";
  }
  return splits;
}

}  // namespace forge
