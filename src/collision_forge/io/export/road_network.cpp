#include "collision_forge/io/export/road_network.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <unordered_map>

namespace forge {
namespace {

constexpr double kMinPiece = 1e-6;   // m; shorter pieces are rounding
constexpr double kMinLength = 0.05;  // m, of a reference line
constexpr double kMinWidth = 2.0;    // m
constexpr double kMaxWidth = 8.0;    // m

double lengthOf(const std::vector<RoadPiece>& course) {
  return std::accumulate(course.begin(), course.end(), 0.0,
                         [](double sum, const RoadPiece& piece) { return sum + piece.length; });
}

Pose2 endOf(const RoadPiece& piece) { return alongArc(piece.start, piece.curvature, piece.length); }

void addArcs(const ArcPath& path, std::vector<RoadPiece>& course) {
  double begin = 0.0;
  for (std::size_t i = 0; i < path.shape.size(); ++i) {
    const double length = path.segment_length[i];
    if (length > kMinPiece) course.push_back({poseAt(path, begin), length, curvatureOf(path, i)});
    begin += length;
  }
}

/// Adds the arc that leaves a pose along its heading and ends at a point.
void addArcThrough(const Pose2& from, const Vector2& to, std::vector<RoadPiece>& course) {
  const Vector2 chord = to - from.position();
  const double distance = chord.norm();
  if (distance <= kMinPiece) return;
  const double half_turn = angleBetween(from.yaw, std::atan2(chord.y(), chord.x()));
  if (std::abs(half_turn) < 1e-9) {
    course.push_back({from, distance, 0.0});
  } else {
    course.push_back(
        {from, distance * half_turn / std::sin(half_turn), 2.0 * std::sin(half_turn) / distance});
  }
}

/// Splits a reference line at an arc length below its length.
std::pair<std::vector<RoadPiece>, std::vector<RoadPiece>> splitAt(
    const std::vector<RoadPiece>& course, double at) {
  std::vector<RoadPiece> head, rest;
  for (const RoadPiece& piece : course) {
    const double here = std::clamp(at, 0.0, piece.length);
    at -= piece.length;
    const RoadPiece first{piece.start, here, piece.curvature};
    if (here > kMinPiece) head.push_back(first);
    if (piece.length - here > kMinPiece) {
      rest.push_back(
          {here > kMinPiece ? endOf(first) : piece.start, piece.length - here, piece.curvature});
    }
  }
  return {head, rest};
}

/// Builds one network. Lanes are identified by their index among the lanes that become roads.
class NetworkBuilder {
 public:
  NetworkBuilder(const LaneMap& map, const LaneArcs& arcs, double lane_width) {
    addRoads(map, arcs, lane_width);
    addLinks(map);
    findConnectors();
  }

  RoadNetwork build() {
    joinDirectly();
    addForkPieces();
    addConnectors();
    groupJunctions();
    return std::move(network_);
  }

 private:
  using Places = std::vector<std::size_t>;

  void addRoads(const LaneMap& map, const LaneArcs& arcs, double lane_width) {
    for (const Lane& lane : map.lanes) {
      Road road;
      road.course = courseOf(lane, arcs);
      if (road.course.empty()) continue;
      road.id = static_cast<int>(network_.roads.size()) + 1;
      road.lane = lane.id;
      road.width = widthOf(lane, road.length(), lane_width);
      road.speed_limit = lane.speed_limit;
      places_[lane.id] = network_.roads.size();
      is_connector_.push_back(lane.is_connector);
      network_.roads.push_back(std::move(road));
    }
    next_.resize(network_.roads.size());
    previous_.resize(network_.roads.size());
  }

  bool meets(std::size_t from, std::size_t to) const {
    const Vector2 end = endOf(network_.roads[from].course.back()).position();
    const Vector2 start = network_.roads[to].course.front().start.position();
    return (end - start).norm() <= kMaxJointGap;
  }

  void addLinks(const LaneMap& map) {
    for (const Lane& lane : map.lanes) {
      const auto from = places_.find(lane.id);
      if (from == places_.end()) continue;
      for (const std::string& id :
           std::set<std::string>(lane.outgoing.begin(), lane.outgoing.end())) {
        const auto to = places_.find(id);
        if (to == places_.end() || to == from || !meets(from->second, to->second)) continue;
        next_[from->second].push_back(to->second);
        previous_[to->second].push_back(from->second);
      }
    }
  }

  bool isDirect(std::size_t from, std::size_t to) const {
    return next_[from].size() == 1 && previous_[to].size() == 1;
  }

  /// Finds connecting roads: connectors between two lanes where either forks or merges. A
  /// connector next to a connector becomes a plain road, as a connecting road must not follow
  /// another.
  void findConnectors() {
    is_connecting_.resize(network_.roads.size(), false);
    for (std::size_t i = 0; i < network_.roads.size(); ++i) {
      if (!is_connector_[i] || next_[i].size() != 1 || previous_[i].size() != 1) continue;
      const std::size_t before = previous_[i][0], after = next_[i][0];
      if (is_connector_[before] || is_connector_[after] || before == after) continue;
      is_connecting_[i] = !isDirect(before, i) || !isDirect(i, after);
    }
  }

  bool isPlain(std::size_t from, std::size_t to) const {
    return !is_connecting_[from] && !is_connecting_[to];
  }

  void joinDirectly() {
    for (std::size_t from = 0; from < next_.size(); ++from) {
      for (const std::size_t to : next_[from]) {
        if (!isPlain(from, to) || !isDirect(from, to)) continue;
        network_.roads[from].after = {RoadJoint::To::kRoad, network_.roads[to].id};
        network_.roads[to].before = {RoadJoint::To::kRoad, network_.roads[from].id};
      }
    }
  }

  /// At forks without a connector, the start of the following lane becomes the connecting roads
  /// that lead into it.
  void addForkPieces() {
    heads_.resize(next_.size());
    for (std::size_t to = 0; to < next_.size(); ++to) {
      Places from;
      for (const std::size_t place : previous_[to]) {
        if (isPlain(place, to) && !isDirect(place, to)) from.push_back(place);
      }
      if (from.empty()) continue;
      Road& road = network_.roads[to];
      const double piece = std::min(kForkPiece, road.length() / 3.0);
      std::tie(heads_[to], road.course) = splitAt(road.course, piece);
      for (const std::size_t place : from) addConnecting(place, to, heads_[to]);
    }
  }

  void addConnecting(std::size_t from, std::size_t to, const std::vector<RoadPiece>& course) {
    Road road;
    road.id = static_cast<int>(network_.roads.size()) + 1;
    road.lane = network_.roads[to].lane;
    road.course = course;
    road.width = network_.roads[to].width;
    road.speed_limit = network_.roads[to].speed_limit;
    network_.roads.push_back(road);
    connections_.push_back({from, to, network_.roads.size() - 1});
  }

  void addConnectors() {
    for (std::size_t place = 0; place < is_connecting_.size(); ++place) {
      if (!is_connecting_[place]) continue;
      const std::size_t before = previous_[place][0], after = next_[place][0];
      std::vector<RoadPiece>& course = network_.roads[place].course;
      course.insert(course.end(), heads_[after].begin(), heads_[after].end());
      connections_.push_back({before, after, place});
    }
  }

  /// Union-find: lane ends are nodes 2 i, lane starts 2 i + 1; each connection joins two.
  void groupJunctions() {
    std::vector<std::size_t> parent(2 * next_.size());
    std::iota(parent.begin(), parent.end(), 0);
    const auto find = [&](std::size_t node) {
      while (parent[node] != node) node = parent[node] = parent[parent[node]];
      return node;
    };
    for (const Connection& one : connections_) parent[find(2 * one.from)] = find(2 * one.to + 1);
    std::unordered_map<std::size_t, std::size_t> junction_of;
    for (const Connection& one : connections_) {
      const auto [entry, is_new] = junction_of.emplace(find(2 * one.from), junction_of.size());
      if (is_new)
        network_.junctions.push_back({firstJunction() + static_cast<int>(entry->second), {}});
      join(one, network_.junctions[entry->second]);
    }
  }

  int firstJunction() const { return static_cast<int>(network_.roads.size()) + 1; }

  struct Connection {
    std::size_t from;
    std::size_t to;
    std::size_t road;
  };

  void join(const Connection& one, Junction& junction) {
    Road& from = network_.roads[one.from];
    Road& to = network_.roads[one.to];
    Road& road = network_.roads[one.road];
    from.after = to.before = {RoadJoint::To::kJunction, junction.id};
    road.junction = junction.id;
    road.before = {RoadJoint::To::kRoad, from.id};
    road.after = {RoadJoint::To::kRoad, to.id};
    junction.connections.push_back({from.id, road.id});
  }

  RoadNetwork network_;
  std::unordered_map<std::string, std::size_t> places_;
  std::vector<bool> is_connector_;  // this and the lists below: one per lane that becomes a road
  std::vector<bool> is_connecting_;
  std::vector<Places> next_;
  std::vector<Places> previous_;
  std::vector<std::vector<RoadPiece>> heads_;  // start pieces moved to connecting roads
  std::vector<Connection> connections_;
};

}  // namespace

double Road::length() const { return lengthOf(course); }

std::vector<RoadPiece> courseOf(const Lane& lane, const LaneArcs& arcs) {
  std::vector<RoadPiece> course;
  const auto found = arcs.find(lane.id);
  if (found != arcs.end()) {
    for (const ArcPath& path : found->second) addArcs(path, course);
  } else {
    for (std::size_t i = 1; i < lane.centerline.size(); ++i) {
      addArcThrough(lane.centerline[i - 1], lane.centerline[i].position(), course);
    }
  }
  if (lengthOf(course) < kMinLength) course.clear();
  return course;
}

double widthOf(const Lane& lane, double length, double otherwise) {
  if (lane.polygon.size() < 3 || !(length > 0.0)) return otherwise;
  double twice_area = 0.0;
  for (std::size_t i = 0; i < lane.polygon.size(); ++i) {
    const Vector2 a = lane.polygon[i] - lane.polygon[0];
    const Vector2 b = lane.polygon[(i + 1) % lane.polygon.size()] - lane.polygon[0];
    twice_area += a.x() * b.y() - b.x() * a.y();
  }
  return std::clamp(std::abs(twice_area) / 2.0 / length, kMinWidth, kMaxWidth);
}

RoadNetwork roadNetwork(const LaneMap& lanes, const LaneArcs& arcs, double lane_width) {
  return NetworkBuilder(lanes, arcs, lane_width).build();
}

}  // namespace forge
