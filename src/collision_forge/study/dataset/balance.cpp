#include "collision_forge/study/dataset/balance.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>
#include <string>

#include "collision_forge/base/scene/number_words.h"
#include "collision_forge/study/dataset/seeds.h"

namespace forge {
namespace {

using Counts = std::vector<std::size_t>;

constexpr double kRounding = 1e-9;

std::size_t sum(const Counts& counts) {
  return std::accumulate(counts.begin(), counts.end(), std::size_t{0});
}

Counts cutTo(Counts counts, std::size_t cap) {
  for (std::size_t& count : counts) count = std::min(count, cap);
  return counts;
}

/// Returns the number of non-empty groups.
std::size_t countFull(const Counts& counts) {
  return counts.size() -
         static_cast<std::size_t>(std::count(counts.begin(), counts.end(), std::size_t{0}));
}

/// Indices of the clips of one type by length, in random order.
using ByLength = std::map<int, std::vector<std::size_t>>;

Counts sizesOf(const ByLength& kinds) {
  Counts sizes;
  for (const auto& [length, clips] : kinds) sizes.push_back(clips.size());
  return sizes;
}

std::map<CollisionType, ByLength> drawnOrder(const std::vector<ClipKind>& clips,
                                             std::uint64_t seed) {
  std::map<CollisionType, ByLength> kinds;
  for (std::size_t i = 0; i < clips.size(); ++i) kinds[clips[i].type][clips[i].length].push_back(i);
  const auto rank = [seed](std::size_t clip) { return seedOf(std::to_string(clip), seed); };
  for (auto& [type, lengths] : kinds) {
    for (auto& [length, group] : lengths) {
      std::sort(group.begin(), group.end(),
                [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
    }
  }
  return kinds;
}

}  // namespace

std::vector<std::size_t> levelledCounts(const std::vector<std::size_t>& available,
                                        std::size_t most) {
  if (sum(available) <= most) return available;
  std::size_t cap = 0;
  std::size_t above = *std::max_element(available.begin(), available.end());
  while (above - cap > 1) {
    const std::size_t middle = cap + (above - cap) / 2;
    (sum(cutTo(available, middle)) <= most ? cap : above) = middle;
  }
  Counts counts = cutTo(available, cap);
  std::size_t left = most - sum(counts);
  for (std::size_t i = 0; i < counts.size() && left > 0; ++i) {
    if (available[i] <= cap) continue;
    ++counts[i];
    --left;
  }
  return counts;
}

std::vector<std::size_t> withMinShare(const std::vector<std::size_t>& available, double min_share) {
  const std::size_t groups = countFull(available);
  if (min_share * static_cast<double>(groups) > 1.0 + kRounding) {
    throw std::invalid_argument("min_share = " + numberText(min_share) + " is not possible for " +
                                std::to_string(groups) + " groups: the sum exceeds 1");
  }
  if (min_share <= 0.0 || groups == 0) return available;
  std::size_t least = sum(available);
  for (const std::size_t count : available) least = count > 0 ? std::min(least, count) : least;
  const double most = std::floor(static_cast<double>(least) / min_share + kRounding);
  return levelledCounts(available, static_cast<std::size_t>(most));
}

std::vector<std::size_t> withMaxRatio(const std::vector<std::size_t>& available, double max_ratio) {
  if (max_ratio < 1.0) {
    throw std::invalid_argument("max_ratio = " + numberText(max_ratio) + " is below 1");
  }
  const std::size_t groups = countFull(available);
  if (groups == 0) return available;
  // The mean is concave in the cap, so the ratio holds exactly for all caps up to some limit:
  // bisection finds it.
  std::size_t cap = 0;
  std::size_t above = *std::max_element(available.begin(), available.end()) + 1;
  while (above - cap > 1) {
    const std::size_t middle = cap + (above - cap) / 2;
    const double mean =
        static_cast<double>(sum(cutTo(available, middle))) / static_cast<double>(groups);
    (static_cast<double>(middle) <= max_ratio * mean + kRounding ? cap : above) = middle;
  }
  return cutTo(available, cap);
}

std::vector<std::size_t> chooseBalanced(const std::vector<ClipKind>& clips,
                                        const BalanceOptions& options, std::uint64_t seed) {
  auto kinds = drawnOrder(clips, seed);
  Counts types;
  for (const auto& [type, lengths] : kinds) {
    types.push_back(sum(withMaxRatio(sizesOf(lengths), options.max_tta_ratio)));
  }
  types = withMinShare(types, options.min_type_share);
  std::vector<std::size_t> chosen;
  auto most = types.begin();
  for (const auto& [type, lengths] : kinds) {
    const Counts counts =
        levelledCounts(withMaxRatio(sizesOf(lengths), options.max_tta_ratio), *most++);
    auto count = counts.begin();
    for (const auto& [length, group] : lengths) {
      chosen.insert(chosen.end(), group.begin(),
                    group.begin() + static_cast<std::ptrdiff_t>(*count++));
    }
  }
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

}  // namespace forge
