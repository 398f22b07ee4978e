#include "collision_forge/io/export/lane_bundles.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace forge {
namespace {

constexpr double kBesideSpacing = 2.0;     // m between the places at which lanes are compared
constexpr double kBesideHeading = 0.2;     // rad
constexpr double kLeastBesideShare = 0.7;  // of the longer lane
constexpr double kLeastDistance = 1.5;     // m between centrelines
constexpr double kDistanceSlack = 1.0;     // m between the distance and the mean width
constexpr double kWidestMedian = 1.5;      // m between lanes of opposite directions in one road
constexpr double kLongestTail = 10.0;      // m of a lane beyond the end of its road
constexpr double kLongestTailShare = 0.3;  // of the lane
constexpr double kMostCut = 0.02;          // m of a lane that leads nowhere
constexpr double kMostKinkShift = 0.08;    // m that a kink of the course shifts the farthest lane
constexpr double kMostBend = 0.8;          // offset over radius of the course

/// Position of one lane as seen from another.
struct Beside {
  double distance = 0.0;  ///< m, mean; positive if it lies to the left
  bool along = true;      ///< driven in the same direction
};

double unwrappedTurn(const RoadPiece& before, const RoadPiece& after) {
  const double end = before.start.yaw + before.curvature * before.length;
  return std::abs(angleBetween(end, after.start.yaw));
}

/// Compares lanes and forms bundles.
class Bundler {
 public:
  Bundler(const std::vector<BundleLane>& lanes, DrivingSide side)
      : lanes_(lanes), is_right_(side == DrivingSide::kRight), is_done_(lanes.size(), false) {
    for (const BundleLane& lane : lanes) {
      Eigen::AlignedBox2d box;
      for (double at = 0.0; at < lane.course.length(); at += kBesideSpacing) {
        box.extend(lane.course.poseAt(at).position());
      }
      boxes_.push_back(box.extend(lane.course.poseAt(lane.course.length()).position()));
    }
  }

  LaneBundles build() {
    findNeighbours();
    for (std::size_t lane = 0; lane < lanes_.size(); ++lane) {
      if (is_done_[lane]) continue;
      addGroup(chainOf(lane));
    }
    std::sort(result_.bundles.begin(), result_.bundles.end(), [](const auto& a, const auto& b) {
      const auto first = [](const LaneBundle& bundle) {
        return std::min_element(bundle.members.begin(), bundle.members.end(),
                                [](const auto& m, const auto& n) { return m.lane < n.lane; })
            ->lane;
      };
      return first(a) < first(b);
    });
    return std::move(result_);
  }

 private:
  using Chain = std::vector<std::size_t>;  // lanes of one direction, left to right as driven

  std::optional<Beside> besideAt(std::size_t from, std::size_t to) const {
    const RoadCourse& course = lanes_[from].course;
    const RoadCourse& other = lanes_[to].course;
    const Pose2 middle = course.poseAt(0.5 * course.length());
    double guess = other.roughProjection(middle.position());
    const bool along = middle.heading().dot(other.poseAt(guess).heading()) > 0.0;
    const auto count = static_cast<int>(std::ceil(course.length() / kBesideSpacing));
    double sum = 0.0;
    int inside = 0;
    for (int i = 0; i <= count; ++i) {
      const Pose2 here = course.poseAt(course.length() * i / count);
      const double start = i == 0 ? other.roughProjection(here.position()) : guess;
      const double at = other.crossing(here, start);
      if (!std::isfinite(at)) return std::nullopt;
      guess = at;
      if (at < 0.0 || at > other.length()) continue;
      const Pose2 beside = other.poseAt(at);
      const double turn = angleBetween(here.yaw, beside.yaw + (along ? 0.0 : M_PI));
      const double lateral = relativeTo(here, beside).y;
      if (std::abs(turn) > kBesideHeading || (inside > 0 && (lateral > 0.0) != (sum > 0.0)) ||
          !isApart(std::abs(lateral), from, to, along)) {
        return std::nullopt;
      }
      sum += lateral;
      ++inside;
    }
    const double covered = course.length() * inside / (count + 1);
    if (covered < kLeastBesideShare * std::max(course.length(), other.length())) {
      return std::nullopt;
    }
    return Beside{sum / inside, along};
  }

  bool isApart(double distance, std::size_t one, std::size_t other, bool along) const {
    const double touching = 0.5 * (lanes_[one].width + lanes_[other].width);
    return distance >= std::max(kLeastDistance, touching - kDistanceSlack) &&
           distance <= touching + (along ? kDistanceSlack : kWidestMedian);
  }

  /// Finds the lane to the left and to the right of each lane, and the oncoming one beside it.
  void findNeighbours() {
    constexpr double kReach = 6.0;  // m; farther lanes do not touch
    lefts_.resize(lanes_.size());
    rights_.resize(lanes_.size());
    oncoming_.resize(lanes_.size());
    for (std::size_t one = 0; one < lanes_.size(); ++one) {
      for (std::size_t other = 0; other < lanes_.size(); ++other) {
        if (one == other || !lanes_[one].may_share || !lanes_[other].may_share) continue;
        if (boxes_[one].exteriorDistance(boxes_[other]) > kReach) continue;
        const std::optional<Beside> beside = besideAt(one, other);
        if (!beside) continue;
        const bool is_left = beside->distance > 0.0;
        if (beside->along) {
          (is_left ? lefts_ : rights_)[one].push_back(other);
        } else if (is_left == is_right_) {
          oncoming_[one].push_back(other);
        }
      }
    }
  }

  /// Returns the only candidate on a side, if each is the only one of the other.
  static std::optional<std::size_t> mutual(std::size_t lane, const std::vector<Chain>& there,
                                           const std::vector<Chain>& back) {
    if (there[lane].size() != 1) return std::nullopt;
    const std::size_t other = there[lane].front();
    if (back[other].size() != 1 || back[other].front() != lane) return std::nullopt;
    return other;
  }

  /// Returns the lanes of one direction beside a lane.
  Chain chainOf(std::size_t lane) const {
    std::set<std::size_t> seen = {lane};
    std::size_t first = lane;
    for (auto left = mutual(first, lefts_, rights_); left && seen.insert(*left).second;
         left = mutual(first, lefts_, rights_)) {
      first = *left;
    }
    Chain chain = {first};
    seen = {first};
    for (auto right = mutual(first, rights_, lefts_); right && seen.insert(*right).second;
         right = mutual(chain.back(), rights_, lefts_)) {
      chain.push_back(*right);
    }
    return chain;
  }

  /// The lane of a chain beside which oncoming traffic drives.
  std::size_t innermost(const Chain& chain) const {
    return is_right_ ? chain.front() : chain.back();
  }

  std::vector<BundleMember> membersOf(const Chain& chain, const Chain& oncoming) const {
    std::vector<BundleMember> members;
    for (const std::size_t lane : chain) members.push_back({lane, true});
    std::vector<BundleMember> others;
    for (auto lane = oncoming.rbegin(); lane != oncoming.rend(); ++lane) {
      others.push_back({*lane, false});
    }
    members.insert(is_right_ ? members.begin() : members.end(), others.begin(), others.end());
    return members;
  }

  /// Adds a chain as one bundle, with the oncoming lanes beside it if that works, or else its
  /// halves.
  void addGroup(const Chain& chain) {
    const auto opposite = mutual(innermost(chain), oncoming_, oncoming_);
    if (opposite && !is_done_[*opposite]) {
      const Chain oncoming = chainOf(*opposite);
      if (innermost(oncoming) == *opposite && add(membersOf(chain, oncoming))) return;
    }
    if (add(membersOf(chain, {}))) {
      const std::size_t lane = chain.front();
      if (chain.size() == 1 && (!lefts_[lane].empty() || !rights_[lane].empty())) {
        ++result_.unbundled;
      }
      return;
    }
    const auto middle = chain.begin() + static_cast<std::ptrdiff_t>((chain.size() + 1) / 2);
    addGroup({chain.begin(), middle});
    addGroup({middle, chain.end()});
  }

  /// Adds a bundle with the first reference that works. Returns false if none does.
  bool add(const std::vector<BundleMember>& members) {
    std::vector<std::size_t> references;
    for (const BundleMember& member : members) {
      if (member.along) references.push_back(member.lane);
    }
    std::stable_sort(references.begin(), references.end(), [&](std::size_t a, std::size_t b) {
      return largestKink(lanes_[a].course) < largestKink(lanes_[b].course);
    });
    for (const std::size_t reference : references) {
      LaneBundle bundle{lanes_[reference].course, members};
      if (!layOut(bundle)) continue;
      for (const BundleMember& member : members) is_done_[member.lane] = true;
      result_.bundles.push_back(std::move(bundle));
      return true;
    }
    return false;
  }

  static double largestKink(const RoadCourse& course) {
    double largest = 0.0;
    for (std::size_t i = 1; i < course.pieces().size(); ++i) {
      largest = std::max(largest, unwrappedTurn(course.pieces()[i - 1], course.pieces()[i]));
    }
    return largest;
  }

  /// Finds where the members and the road begin and end. Returns false if they do not fit.
  bool layOut(LaneBundle& bundle) const {
    if (bundle.members.size() == 1) {
      bundle.members.front().to = bundle.end = bundle.course.length();
      return true;
    }
    for (BundleMember& member : bundle.members) {
      const RoadCourse& course = lanes_[member.lane].course;
      const auto foot = [&](double at) {
        const Vector2 point = course.poseAt(at).position();
        return bundle.course.projection(point, bundle.course.roughProjection(point));
      };
      member.from = foot(member.along ? 0.0 : course.length());
      member.to = foot(member.along ? course.length() : 0.0);
      if (!(member.from < member.to)) return false;
    }
    return findEnds(bundle) && isSmooth(bundle);
  }

  bool findEnds(LaneBundle& bundle) const {
    double first = std::numeric_limits<double>::infinity(), last = -first;
    double entered = last, left = first;
    for (const BundleMember& member : bundle.members) {
      first = std::min(first, member.from);
      last = std::max(last, member.to);
      if (hasLink(member, false)) entered = std::max(entered, member.from);
      if (hasLink(member, true)) left = std::min(left, member.to);
    }
    bundle.begin = std::isfinite(entered) ? entered : first;
    bundle.end = std::isfinite(left) ? left : last;
    return std::all_of(
        bundle.members.begin(), bundle.members.end(), [&](const BundleMember& member) {
          const double head = bundle.begin - member.from, tail = member.to - bundle.end;
          const double most =
              std::min(kLongestTail, kLongestTailShare * lanes_[member.lane].course.length());
          return head <= (hasLink(member, false) ? most : kMostCut) &&
                 tail <= (hasLink(member, true) ? most : kMostCut);
        });
  }

  /// Returns true if a member has a link at the start or the end of the road.
  bool hasLink(const BundleMember& member, bool at_end) const {
    const BundleLane& lane = lanes_[member.lane];
    return member.along == at_end ? lane.is_left : lane.is_entered;
  }

  /// Returns true if every lane has a distinct place beside every place of the course.
  bool isSmooth(const LaneBundle& bundle) const {
    double left = 0.0, right = 0.0;  // m, farthest offsets
    for (const BundleMember& member : bundle.members) {
      const RoadCourse& course = lanes_[member.lane].course;
      double at = bundle.begin, last = std::numeric_limits<double>::quiet_NaN();
      for (; at <= bundle.end; at += kBesideSpacing) {
        const double beside = besideOf(bundle, member, course, at);
        if (!std::isfinite(beside) || (beside - last) * (member.along ? 1.0 : -1.0) <= 0.0) {
          return false;
        }
        last = beside;
        const double lateral = relativeTo(bundle.course.poseAt(at), course.poseAt(beside)).y;
        left = std::max(left, lateral);
        right = std::max(right, -lateral);
      }
    }
    if (largestKink(bundle.course) * std::max(left, right) > kMostKinkShift) return false;
    return std::all_of(
        bundle.course.pieces().begin(), bundle.course.pieces().end(), [&](const RoadPiece& piece) {
          return piece.curvature * left <= kMostBend && -piece.curvature * right <= kMostBend;
        });
  }

  const std::vector<BundleLane>& lanes_;
  const bool is_right_;
  std::vector<bool> is_done_;
  std::vector<Eigen::AlignedBox2d> boxes_;
  std::vector<Chain> lefts_;
  std::vector<Chain> rights_;
  std::vector<Chain> oncoming_;
  LaneBundles result_;
};

}  // namespace

LaneBundles bundlesOf(const std::vector<BundleLane>& lanes, DrivingSide side) {
  return Bundler(lanes, side).build();
}

double besideOf(const LaneBundle& bundle, const BundleMember& member, const RoadCourse& lane,
                double arc_length) {
  if (bundle.members.size() == 1) return arc_length;
  const double share = (arc_length - member.from) / (member.to - member.from);
  const double guess = lane.length() * (member.along ? share : 1.0 - share);
  return lane.crossing(bundle.course.poseAt(arc_length), guess);
}

}  // namespace forge
