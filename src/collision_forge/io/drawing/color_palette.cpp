#include "collision_forge/io/drawing/color_palette.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace forge {

namespace {

constexpr int kBits = 6;
constexpr std::size_t kBins = std::size_t{1} << (3 * kBits);

std::size_t binOf(std::uint32_t color) {
  const auto channel = [color](int shift) { return (color >> (shift + 8 - kBits)) & 0x3FU; };
  return (channel(16) << (2 * kBits)) | (channel(8) << kBits) | channel(0);
}

/// The mean colour of one bin, and its frequency.
struct WeightedColor {
  std::size_t bin = 0;
  double weight = 0.0;
  std::array<double, 3> channels = {0, 0, 0};
};

/// Colours that share one entry of the palette.
struct Group {
  std::vector<WeightedColor> members;
  std::array<double, 3> mean = {0, 0, 0};
  double error = 0.0;       ///< weighted sum of squares along the widest channel
  std::size_t channel = 0;  ///< the widest channel
};

Group makeGroup(std::vector<WeightedColor> members) {
  Group group;
  double weight = 0.0;
  for (const WeightedColor& color : members) weight += color.weight;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    double sum = 0.0;
    for (const WeightedColor& color : members) sum += color.weight * color.channels[channel];
    const double mean = sum / weight;
    double error = 0.0;
    for (const WeightedColor& color : members) {
      error += color.weight * std::pow(color.channels[channel] - mean, 2);
    }
    group.mean[channel] = mean;
    if (error > group.error) {
      group.error = error;
      group.channel = channel;
    }
  }
  group.members = std::move(members);
  return group;
}

/// Splits `group` at its mean and returns the upper part.
Group split(Group& group) {
  const std::size_t channel = group.channel;
  const double mean = group.mean[channel];
  const auto middle = std::stable_partition(
      group.members.begin(), group.members.end(),
      [channel, mean](const WeightedColor& color) { return color.channels[channel] <= mean; });
  std::vector<WeightedColor> upper(middle, group.members.end());
  group.members.erase(middle, group.members.end());
  group = makeGroup(std::move(group.members));
  return makeGroup(std::move(upper));
}

std::uint32_t packed(const std::array<double, 3>& channels) {
  std::uint32_t color = 0;
  for (const double channel : channels) {
    color = (color << 8U) | static_cast<std::uint32_t>(std::lround(channel));
  }
  return color;
}

}  // namespace

ColorHistogram::ColorHistogram() : bins_(kBins) {}

void ColorHistogram::add(const Image& image) {
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const std::uint32_t color = image.pixel(x, y);
      Bin& bin = bins_[binOf(color)];
      ++bin.count;
      bin.red += (color >> 16U) & 0xFFU;
      bin.green += (color >> 8U) & 0xFFU;
      bin.blue += color & 0xFFU;
    }
  }
}

ColorPalette::ColorPalette(const ColorHistogram& histogram, int max_colors)
    : index_of_bin_(kBins, 0) {
  std::vector<WeightedColor> all;
  for (std::size_t i = 0; i < kBins; ++i) {
    const ColorHistogram::Bin& bin = histogram.bins_[i];
    if (bin.count == 0) continue;
    const auto count = static_cast<double>(bin.count);
    all.push_back({i,
                   count,
                   {static_cast<double>(bin.red) / count, static_cast<double>(bin.green) / count,
                    static_cast<double>(bin.blue) / count}});
  }
  if (all.empty()) return;
  std::vector<Group> groups = {makeGroup(std::move(all))};
  while (groups.size() < static_cast<std::size_t>(max_colors)) {
    const auto worst =
        std::max_element(groups.begin(), groups.end(),
                         [](const Group& a, const Group& b) { return a.error < b.error; });
    if (worst->members.size() < 2 || worst->error <= 0) break;
    Group upper = split(*worst);
    groups.push_back(std::move(upper));
  }
  for (const Group& group : groups) {
    for (const WeightedColor& color : group.members) {
      index_of_bin_[color.bin] = static_cast<std::uint8_t>(colors_.size());
    }
    colors_.push_back(packed(group.mean));
  }
}

std::uint8_t ColorPalette::indexOf(std::uint32_t color) const {
  return index_of_bin_[binOf(color)];
}

}  // namespace forge
