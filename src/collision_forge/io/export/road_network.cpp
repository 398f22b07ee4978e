#include "collision_forge/io/export/road_network.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>

#include "collision_forge/io/export/bundle_profile.h"
#include "collision_forge/io/export/lane_bundles.h"
#include "collision_forge/io/export/linked_lanes.h"

namespace forge {
namespace {

constexpr double kMostTail = 0.02;   // m of a lane beyond the end of a road that is linked directly
constexpr double kLostPiece = 0.03;  // m of a lane that leads nowhere, for a fork beside it
constexpr double kLeastGap = 0.01;   // m; narrower gaps between lanes are left out

/// One of the two ends of a bundle's road.
struct RoadEnd {
  std::size_t bundle = 0;
  bool at_end = false;

  bool operator==(const RoadEnd& other) const {
    return bundle == other.bundle && at_end == other.at_end;
  }
};

/// Builds one network. Lanes are identified by their index among the lanes that have a course.
class NetworkBuilder {
 public:
  NetworkBuilder(const LaneMap& map, const LaneArcs& arcs, double lane_width)
      : is_right_(map.driving_side == DrivingSide::kRight),
        linked_(linkedLanes(map, arcs, lane_width)) {
    bundle(map.driving_side);
    findDirectEnds();
    findConnecting();
  }

  RoadNetwork build() {
    cutForks();
    for (std::size_t i = 0; i < bundles_.size(); ++i) addRoad(i);
    joinDirectly();
    addConnections();
    groupJunctions();
    return std::move(network_);
  }

 private:
  void bundle(DrivingSide side) {
    LaneBundles found = bundlesOf(lanes_, side);
    bundles_ = std::move(found.bundles);
    network_.unbundled = found.unbundled;
    bundle_of_.resize(lanes_.size());
    members_.resize(lanes_.size());
    for (std::size_t i = 0; i < bundles_.size(); ++i) {
      for (const BundleMember& member : bundles_[i].members) {
        bundle_of_[member.lane] = i;
        members_[member.lane] = &member;
      }
    }
  }

  /// Returns the end of the road at which a lane begins, or ends (`is_exit`), as driven.
  RoadEnd endOf(std::size_t lane, bool is_exit) const {
    return {bundle_of_[lane], members_[lane]->along == is_exit};
  }

  /// Returns the arc length (m) on a lane at which it enters or leaves its road.
  double roadEndOn(std::size_t lane, bool is_exit) const {
    const LaneBundle& bundle = bundles_[bundle_of_[lane]];
    return besideOf(bundle, *members_[lane], lanes_[lane].course,
                    members_[lane]->along == is_exit ? bundle.end : bundle.begin);
  }

  bool isDirect(std::size_t from, std::size_t to) const {
    const double tail = lanes_[from].course.length() - roadEndOn(from, true);
    return next_[from].size() == 1 && previous_[to].size() == 1 && std::abs(tail) <= kMostTail &&
           std::abs(roadEndOn(to, false)) <= kMostTail;
  }

  /// Calls `visit` with both lanes of each link at an end of a road.
  template <typename Visit>
  void eachLink(const RoadEnd& end, const Visit& visit) const {
    for (const BundleMember& member : bundles_[end.bundle].members) {
      if (member.along == end.at_end) {
        for (const std::size_t to : next_[member.lane]) visit(member.lane, to);
      } else {
        for (const std::size_t from : previous_[member.lane]) visit(from, member.lane);
      }
    }
  }

  /// Returns the only end to which all lanes of an end are linked, one to one.
  std::optional<RoadEnd> onlyPartner(const RoadEnd& end) const {
    std::optional<RoadEnd> partner;
    bool is_only = true;
    eachLink(end, [&](std::size_t from, std::size_t to) {
      const RoadEnd exit = endOf(from, true), entry = endOf(to, false);
      const RoadEnd other = exit == end ? entry : exit;
      is_only = is_only && !(partner && !(*partner == other)) && isDirect(from, to);
      partner = other;
    });
    const bool is_found = is_only && partner && partner->bundle != end.bundle;
    return is_found ? partner : std::nullopt;
  }

  void findDirectEnds() {
    partners_.resize(2 * bundles_.size());
    for (std::size_t i = 0; i < partners_.size(); ++i) {
      partners_[i] = onlyPartner({i / 2, i % 2 == 1});
    }
  }

  static std::size_t indexOf(const RoadEnd& end) { return 2 * end.bundle + (end.at_end ? 1 : 0); }

  bool isDirectEnd(const RoadEnd& end) const {
    const auto& partner = partners_[indexOf(end)];
    return partner && partners_[indexOf(*partner)] == end;
  }

  /// Finds connecting roads: connectors between two lanes where either forks or merges. A connector
  /// next to a connector becomes a plain road, as a connecting road must not follow another.
  void findConnecting() {
    is_connecting_.resize(lanes_.size(), false);
    for (std::size_t i = 0; i < lanes_.size(); ++i) {
      if (!sources_[i]->is_connector || next_[i].size() != 1 || previous_[i].size() != 1) continue;
      const std::size_t before = previous_[i][0], after = next_[i][0];
      if (sources_[before]->is_connector || sources_[after]->is_connector || before == after) {
        continue;
      }
      is_connecting_[i] = !isDirectEnd(endOf(i, false)) || !isDirectEnd(endOf(i, true));
    }
  }

  /// Returns true if a link without a connecting connector needs a connecting road.
  bool isFork(std::size_t from, std::size_t to) const {
    return !is_connecting_[from] && !is_connecting_[to] && !isDirectEnd(endOf(to, false));
  }

  /// At forks without a connector, shortens the road that follows, so that the connecting roads
  /// have a length.
  void cutForks() {
    for (std::size_t i = 0; i < bundles_.size(); ++i) {
      LaneBundle& bundle = bundles_[i];
      for (const bool at_end : {false, true}) {
        double cut = std::min(kForkPiece, (bundle.end - bundle.begin) / 3.0);
        bool is_fork = false;
        for (const BundleMember& member : bundle.members) {
          if (member.along == at_end ? next_[member.lane].empty()
                                     : !lanes_[member.lane].is_entered) {
            cut = std::min(cut, kLostPiece);
          }
          if (member.along == at_end) continue;
          for (const std::size_t from : previous_[member.lane]) {
            is_fork = is_fork || isFork(from, member.lane);
          }
        }
        if (is_fork) (at_end ? bundle.end : bundle.begin) += at_end ? -cut : cut;
      }
    }
  }

  void addRoad(std::size_t index) {
    const LaneBundle& bundle = bundles_[index];
    if (is_connecting_[bundle.members.front().lane]) return;
    const BundleProfile profile = profileOf(bundle, lanes_);
    Road road;
    road.id = static_cast<int>(network_.roads.size()) + 1;
    road.course = bundle.course.between(bundle.begin, bundle.end);
    for (const double at : profile.arc_lengths) road.knots.push_back(at - bundle.begin);
    addLanesOf(bundle, profile, road);
    road_of_[index] = network_.roads.size();
    network_.roads.push_back(std::move(road));
  }

  /// Adds the lanes and the gaps between them on both sides of the centre, which is the inner
  /// border of the first lane along the course.
  void addLanesOf(const LaneBundle& bundle, const BundleProfile& profile, Road& road) {
    const auto count = static_cast<std::ptrdiff_t>(bundle.members.size());
    std::ptrdiff_t first_right = 0;  // the centre is to the left of this member
    while (first_right < count &&
           bundle.members[static_cast<std::size_t>(first_right)].along != is_right_) {
      ++first_right;
    }
    const std::size_t centre =
        static_cast<std::size_t>(is_right_ ? 2 * first_right : 2 * first_right - 1);
    for (const auto& borders : profile.borders) road.offset.push_back(borders[centre]);
    std::size_t inner = centre;
    for (std::ptrdiff_t i = first_right; i < count; ++i) {
      addLane(bundle, profile, static_cast<std::size_t>(i), inner, -1, road);
    }
    inner = centre;
    for (std::ptrdiff_t i = first_right - 1; i >= 0; --i) {
      addLane(bundle, profile, static_cast<std::size_t>(i), inner, 1, road);
    }
  }

  /// Adds a member outside of the border `inner`, and the gap in between; moves `inner` outwards.
  void addLane(const LaneBundle& bundle, const BundleProfile& profile, std::size_t member,
               std::size_t& inner, int side, Road& road) {
    const std::size_t near = 2 * member + (side < 0 ? 0 : 1), far = 2 * member + (side < 0 ? 1 : 0);
    std::vector<RoadLane>& lanes = side < 0 ? road.right : road.left;
    const auto widthBetween = [&](std::size_t one, std::size_t other) {
      std::vector<double> width;
      for (const auto& borders : profile.borders) {
        width.push_back(std::max(0.0, (borders[other] - borders[one]) * side));
      }
      return width;
    };
    const auto nextId = [&] { return side * (static_cast<int>(lanes.size()) + 1); };
    std::vector<double> gap = widthBetween(inner, near);
    if (*std::max_element(gap.begin(), gap.end()) > kLeastGap) {
      RoadLane lane;
      lane.id = nextId();
      lane.width = std::move(gap);
      lanes.push_back(std::move(lane));
    }
    const BundleMember& from = bundle.members[member];
    const Lane& source = *sources_[from.lane];
    RoadLane lane;
    lane.id = nextId();
    lane.lane = source.id;
    lane.from = std::max(0.0, from.from - bundle.begin);
    lane.to = std::min(bundle.end, from.to) - bundle.begin;
    lane.width = widthBetween(near, far);
    lane.speed_limit = source.speed_limit;
    lane.is_for_bikes = linked_.isForBikes(from.lane);
    ids_[from.lane] = lane.id;
    lanes.push_back(std::move(lane));
    inner = far;
  }

  Road& roadOf(std::size_t lane) { return network_.roads[road_of_.at(bundle_of_[lane])]; }

  static RoadLane& laneWith(Road& road, int id) {
    return id < 0 ? road.right[static_cast<std::size_t>(-id - 1)]
                  : road.left[static_cast<std::size_t>(id - 1)];
  }

  /// Joins an end of a road to a road or junction.
  static void join(Road& road, bool at_end, const RoadJoint& joint) {
    (at_end ? road.after : road.before) = joint;
  }

  void joinDirectly() {
    for (std::size_t from = 0; from < next_.size(); ++from) {
      for (const std::size_t to : next_[from]) {
        const RoadEnd exit = endOf(from, true), entry = endOf(to, false);
        if (is_connecting_[from] || is_connecting_[to] || !isDirectEnd(exit)) continue;
        linkLanes(roadOf(from), exit.at_end, ids_[from], roadOf(to), entry.at_end, ids_[to]);
        linkLanes(roadOf(to), entry.at_end, ids_[to], roadOf(from), exit.at_end, ids_[from]);
      }
    }
  }

  static void linkLanes(Road& road, bool at_end, int id, const Road& other, bool other_at_end,
                        int other_id) {
    join(road, at_end, {RoadJoint::To::kRoad, other.id, other_at_end});
    RoadLane& lane = laneWith(road, id);
    (at_end ? lane.after : lane.before) = other_id;
  }

  void addConnections() {
    for (std::size_t from = 0; from < next_.size(); ++from) {
      for (const std::size_t to : next_[from]) {
        if (is_connecting_[to]) {
          addConnecting(from, next_[to][0], to);
        } else if (isFork(from, to)) {
          addConnecting(from, to, std::nullopt);
        }
      }
    }
  }

  /// Adds the connecting road between two lanes: the part of the first beyond its road, the
  /// connector, and the part of the second before its road.
  void addConnecting(std::size_t from, std::size_t to, std::optional<std::size_t> connector) {
    const RoadCourse& first = lanes_[from].course;
    Road road;
    road.course = first.between(std::min(roadEndOn(from, true), first.length()), first.length());
    if (connector) road.course.append(lanes_[*connector].course);
    road.course.append(lanes_[to].course.between(0.0, std::max(0.0, roadEndOn(to, false))));
    if (road.course.empty()) return;
    const std::size_t source = connector.value_or(to);
    road.id = static_cast<int>(network_.roads.size()) + 1;
    road.knots = {0.0};
    road.offset = {(is_right_ ? 0.5 : -0.5) * lanes_[source].width};
    RoadLane lane;
    lane.id = is_right_ ? -1 : 1;
    lane.lane = sources_[source]->id;
    lane.to = road.course.length();
    lane.width = {lanes_[source].width};
    lane.speed_limit = sources_[source]->speed_limit;
    lane.before = ids_[from];
    lane.after = ids_[to];
    (is_right_ ? road.right : road.left).push_back(std::move(lane));
    connections_.push_back({from, to, network_.roads.size()});
    network_.roads.push_back(std::move(road));
  }

  /// Union-find over the ends of the roads; each connection joins two.
  void groupJunctions() {
    std::vector<std::size_t> parent(2 * bundles_.size());
    std::iota(parent.begin(), parent.end(), 0);
    const auto find = [&](std::size_t node) {
      while (parent[node] != node) node = parent[node] = parent[parent[node]];
      return node;
    };
    for (const Connection& one : connections_) {
      parent[find(indexOf(endOf(one.from, true)))] = find(indexOf(endOf(one.to, false)));
    }
    std::unordered_map<std::size_t, std::size_t> junction_of;
    for (const Connection& one : connections_) {
      const auto [entry, is_new] =
          junction_of.emplace(find(indexOf(endOf(one.from, true))), junction_of.size());
      if (is_new) {
        network_.junctions.push_back({firstJunction() + static_cast<int>(entry->second), {}});
      }
      connect(one, network_.junctions[entry->second]);
    }
  }

  int firstJunction() const { return static_cast<int>(network_.roads.size()) + 1; }

  struct Connection {
    std::size_t from;  ///< lane
    std::size_t to;    ///< lane
    std::size_t road;  ///< index of the connecting road
  };

  void connect(const Connection& one, Junction& junction) {
    Road& road = network_.roads[one.road];
    Road& from = roadOf(one.from);
    Road& to = roadOf(one.to);
    const RoadEnd exit = endOf(one.from, true), entry = endOf(one.to, false);
    join(from, exit.at_end, {RoadJoint::To::kJunction, junction.id});
    join(to, entry.at_end, {RoadJoint::To::kJunction, junction.id});
    road.junction = junction.id;
    road.before = {RoadJoint::To::kRoad, from.id, exit.at_end};
    road.after = {RoadJoint::To::kRoad, to.id, entry.at_end};
    junction.connections.push_back({from.id, road.id, ids_[one.from], is_right_ ? -1 : 1});
  }

  const bool is_right_;
  RoadNetwork network_;
  const LinkedLanes linked_;
  const std::vector<BundleLane>& lanes_ = linked_.lanes;
  const std::vector<const Lane*>& sources_ = linked_.sources;  // this and the lists below: per lane
  const std::vector<std::vector<std::size_t>>& next_ = linked_.next;
  const std::vector<std::vector<std::size_t>>& previous_ = linked_.previous;
  std::vector<std::size_t> bundle_of_;
  std::vector<const BundleMember*> members_;
  std::vector<bool> is_connecting_;
  std::unordered_map<std::size_t, int> ids_;  // of the lane in its road
  std::vector<LaneBundle> bundles_;
  std::vector<std::optional<RoadEnd>> partners_;          // by indexOf()
  std::unordered_map<std::size_t, std::size_t> road_of_;  // by bundle
  std::vector<Connection> connections_;
};

}  // namespace

std::string Road::name() const {
  std::string name;
  for (const auto* lanes : {&left, &right}) {
    for (const RoadLane& lane : *lanes) {
      if (!lane.lane.empty()) name += (name.empty() ? "" : " ") + lane.lane;
    }
  }
  return name;
}

double Road::valueAt(const std::vector<double>& per_knot, double arc_length) const {
  const auto after = std::upper_bound(knots.begin(), knots.end(), arc_length);
  const std::size_t next = static_cast<std::size_t>(after - knots.begin());
  if (next == 0 || next == knots.size()) return per_knot[next == 0 ? 0 : next - 1];
  const double share = (arc_length - knots[next - 1]) / (knots[next] - knots[next - 1]);
  return per_knot[next - 1] + share * (per_knot[next] - per_knot[next - 1]);
}

double Road::borderAt(int id, double arc_length) const {
  double border = valueAt(offset, arc_length);
  const std::vector<RoadLane>& lanes = id < 0 ? right : left;
  for (int i = 0; i < std::abs(id); ++i) {
    const double width = valueAt(lanes[static_cast<std::size_t>(i)].width, arc_length);
    border += id < 0 ? -width : width;
  }
  return border;
}

RoadNetwork roadNetwork(const LaneMap& lanes, const LaneArcs& arcs, double lane_width) {
  return NetworkBuilder(lanes, arcs, lane_width).build();
}

}  // namespace forge
