#include "collision_forge/io/export/bundle_profile.h"

#include <algorithm>
#include <cmath>

namespace forge {
namespace {

constexpr double kSpacing = 0.5;       // m between the samples of a profile
constexpr double kLeastWidth = 1.5;    // m of a lane whose borders are shared
constexpr double kMostWidening = 1.3;  // of such a lane over its own width

/// Sets the borders at one place: shared ones where the lanes' own widths roughly allow it.
class BorderFitter {
 public:
  BorderFitter(const LaneBundle& bundle, const std::vector<BundleLane>& lanes) {
    for (const BundleMember& member : bundle.members) {
      widths_.push_back(lanes[member.lane].width);
      along_.push_back(member.along);
    }
  }

  /// Returns the left and right border of each lane for the middles, m to the left. `is_shared`:
  /// neighbours of one direction share their borders.
  std::vector<double> borders(const std::vector<double>& middles, bool is_shared) const {
    std::vector<double> widths = limited(middles);
    if (is_shared) {
      for (std::size_t begin = 0; begin < middles.size();) {
        const std::size_t end = endOfRun(begin);
        share(middles, begin, end, widths);
        begin = end;
      }
    }
    std::vector<double> result;
    for (std::size_t i = 0; i < middles.size(); ++i) {
      result.push_back(middles[i] + 0.5 * widths[i]);
      result.push_back(middles[i] - 0.5 * widths[i]);
    }
    return result;
  }

  /// Returns true if shared borders leave every lane a usual width.
  bool canShare(const std::vector<double>& middles) const {
    std::vector<double> widths = limited(middles);
    for (std::size_t begin = 0; begin < middles.size(); begin = endOfRun(begin)) {
      share(middles, begin, endOfRun(begin), widths);
    }
    for (std::size_t i = 0; i < widths.size(); ++i) {
      if (widths[i] < kLeastWidth || widths[i] > kMostWidening * widths_[i]) return false;
      if (i > 0 && along_[i] != along_[i - 1] &&
          0.5 * (widths[i - 1] + widths[i]) > middles[i - 1] - middles[i]) {
        return false;
      }
    }
    return true;
  }

 private:
  std::size_t endOfRun(std::size_t begin) const {
    std::size_t end = begin + 1;
    while (end < along_.size() && along_[end] == along_[begin]) ++end;
    return end;
  }

  /// Returns the lanes' own widths, narrowed so that neighbours do not overlap.
  std::vector<double> limited(const std::vector<double>& middles) const {
    std::vector<double> widths = widths_;
    for (std::size_t i = 1; i < middles.size(); ++i) {
      const double distance = middles[i - 1] - middles[i];
      widths[i - 1] = std::min(widths[i - 1], distance);
      widths[i] = std::min(widths[i], distance);
    }
    return widths;
  }

  /// Sets the widths of lanes begin..end-1 so that they share their borders and come closest to
  /// their own widths. One width sets all: w_i = base_i + (-1)^i x.
  void share(const std::vector<double>& middles, std::size_t begin, std::size_t end,
             std::vector<double>& widths) const {
    if (end - begin < 2) return;
    std::vector<double> base = {0.0};
    for (std::size_t i = begin + 1; i < end; ++i) {
      base.push_back(2.0 * (middles[i - 1] - middles[i]) - base.back());
    }
    double free = 0.0;
    for (std::size_t i = 0; i < base.size(); ++i) {
      free += (i % 2 == 0 ? 1.0 : -1.0) * (widths_[begin + i] - base[i]);
    }
    free /= static_cast<double>(base.size());
    for (std::size_t i = 0; i < base.size(); ++i) {
      widths[begin + i] = base[i] + (i % 2 == 0 ? free : -free);
    }
  }

  std::vector<double> widths_;
  std::vector<bool> along_;
};

/// Returns true if the values at `from` and `to` interpolate all in between to kProfileTolerance.
bool isLinear(const BundleProfile& fine, std::size_t from, std::size_t to) {
  for (std::size_t i = from + 1; i < to; ++i) {
    const double share = (fine.arc_lengths[i] - fine.arc_lengths[from]) /
                         (fine.arc_lengths[to] - fine.arc_lengths[from]);
    for (std::size_t k = 0; k < fine.borders[i].size(); ++k) {
      const double value =
          fine.borders[from][k] + share * (fine.borders[to][k] - fine.borders[from][k]);
      if (std::abs(value - fine.borders[i][k]) > kProfileTolerance) return false;
    }
  }
  return true;
}

BundleProfile thinned(const BundleProfile& fine) {
  BundleProfile thin;
  const auto keep = [&](std::size_t i) {
    thin.arc_lengths.push_back(fine.arc_lengths[i]);
    thin.borders.push_back(fine.borders[i]);
  };
  const std::size_t last = fine.arc_lengths.size() - 1;
  for (std::size_t from = 0; from < last;) {
    keep(from);
    std::size_t reach = 1;  // doubled, then halved, to the farthest linear stretch
    while (from + 2 * reach <= last && isLinear(fine, from, from + 2 * reach)) reach *= 2;
    for (std::size_t step = reach; step > 0; step /= 2) {
      if (from + reach + step <= last && isLinear(fine, from, from + reach + step)) reach += step;
    }
    from = std::min(from + reach, last);
  }
  keep(last);
  return thin;
}
}  // namespace

BundleProfile profileOf(const LaneBundle& bundle, const std::vector<BundleLane>& lanes) {
  BundleProfile fine;
  std::vector<std::vector<double>> middles;
  const BorderFitter fitter(bundle, lanes);
  const bool is_single = bundle.members.size() == 1;
  const auto count =
      is_single ? 1 : static_cast<int>(std::ceil((bundle.end - bundle.begin) / kSpacing));
  bool is_shared = true;
  for (int i = 0; i <= count; ++i) {
    const double at = bundle.begin + (bundle.end - bundle.begin) * i / count;
    const Pose2 here = bundle.course.poseAt(at);
    std::vector<double> row;
    for (const BundleMember& member : bundle.members) {
      const RoadCourse& course = lanes[member.lane].course;
      const double beside = besideOf(bundle, member, course, at);
      row.push_back(is_single ? 0.0 : relativeTo(here, course.poseAt(beside)).y);
    }
    is_shared = is_shared && fitter.canShare(row);
    fine.arc_lengths.push_back(at);
    middles.push_back(std::move(row));
  }
  for (const std::vector<double>& row : middles) {
    fine.borders.push_back(fitter.borders(row, is_shared));
  }
  return thinned(fine);
}
}  // namespace forge
