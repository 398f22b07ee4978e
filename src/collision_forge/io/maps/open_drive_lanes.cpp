#include "collision_forge/io/maps/open_drive_lanes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "collision_forge/io/maps/open_drive_areas.h"

namespace forge {
namespace {

constexpr double kShortestLane = 0.1;             // m; shorter lanes are bridged
constexpr double kNarrowestLane = 0.5;            // m; a lane that is nowhere wider is left out
constexpr double kIntersectionTurn = M_PI / 6.0;  // rad; ramps and forks turn less

/// A lane of one section, in one driving direction.
struct LanePiece {
  std::size_t road = 0;
  std::size_t section = 0;
  bool is_forward = true;  ///< in the direction of the reference line
  Lane lane;
  std::vector<std::size_t> next;
  std::vector<std::size_t> previous;
};

/// The pieces of a lane of one section, by direction.
struct LanePieces {
  std::optional<std::size_t> forward;
  std::optional<std::size_t> backward;

  /// Returns the piece whose traffic leaves the lane at an end in terms of the reference line.
  std::optional<std::size_t> leavingAt(bool end) const { return end ? forward : backward; }
  std::optional<std::size_t> enteringAt(bool end) const { return end ? backward : forward; }
};

void addOnce(std::vector<std::size_t>& places, std::size_t place) {
  if (std::find(places.begin(), places.end(), place) == places.end()) places.push_back(place);
}

double lengthOf(const std::vector<Pose2>& line) {
  double length = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    length += (line[i].position() - line[i - 1].position()).norm();
  }
  return length;
}

double turnOf(const ReferenceLine& line) {
  return std::abs(angleBetween(line.at(0.0).pose.yaw, line.at(line.length()).pose.yaw));
}

/// Builds the map of one network.
class LaneBuilder {
 public:
  LaneBuilder(const OpenDriveNetwork& network, double resolution, const InputLimits& limits,
              WarningCounter& warnings)
      : network_(network), resolution_(resolution), limits_(limits), warnings_(warnings) {}

  LaneMap build() {
    findIntersections();
    for (std::size_t i = 0; i < network_.roads.size(); ++i) addRoad(i);
    closeJunctions();
    for (std::size_t i = 0; i < network_.roads.size(); ++i) linkRoad(i);
    for (const OpenDriveConnection& connection : network_.connections) linkJunction(connection);
    bridgeShortPieces();
    joinPieces();
    chooseSide();
    return std::move(map_);
  }

 private:
  void findIntersections() {
    for (std::size_t i = 0; i < network_.roads.size(); ++i) {
      const OpenDriveRoad& road = network_.roads[i];
      if (!roads_.emplace(road.id, i).second)
        warnings_.add("roads with the id of another", road.id);
      if (road.junction.empty()) continue;
      is_intersection_[road.junction] |= turnOf(road.line) > kIntersectionTurn;
    }
  }

  void addRoad(std::size_t road) {
    const OpenDriveRoad& from = network_.roads[road];
    for (std::size_t i = 0; i < from.sections.size(); ++i) {
      const OpenDriveSection& section = from.sections[i];
      const SectionStrips strips = laneStrips(from, section, resolution_);
      if (!isUsable(strips)) {
        warnings_.add("roads with a lane section beyond the input limits", from.id);
        continue;
      }
      const std::size_t areas = map_.drivable_area.size();
      addAreas(section, strips, map_);
      if (!from.junction.empty()) {
        std::vector<Polygon>& inside = junction_areas_[from.junction];
        inside.insert(inside.end(), map_.drivable_area.begin() + static_cast<std::ptrdiff_t>(areas),
                      map_.drivable_area.end());
      }
      for (std::size_t k = 0; k < section.left.size(); ++k) {
        addLane(road, i, section.left[k], strips.left[k]);
      }
      for (std::size_t k = 0; k < section.right.size(); ++k) {
        addLane(road, i, section.right[k], strips.right[k]);
      }
    }
  }

  void closeJunctions() {
    for (const auto& [junction, areas] : junction_areas_) {
      for (Polygon& gap : gapsBetween(areas)) map_.drivable_area.push_back(std::move(gap));
    }
  }

  /// Returns false if a border is beyond the limits; counts the points.
  bool isUsable(const SectionStrips& strips) {
    for (const std::vector<LaneStrip>* const side : {&strips.left, &strips.right}) {
      for (const LaneStrip& strip : *side) {
        points_ += strip.centre.size();
        if (points_ > static_cast<std::size_t>(limits_.max_map_points)) {
          throw InputError(network_.path +
                           ": the lanes have more points than max_map_points in input_limits.yaml");
        }
        const auto is_within = [&](const Vector2& point) { return isWithin(point, limits_); };
        if (!std::all_of(strip.left.begin(), strip.left.end(), is_within) ||
            !std::all_of(strip.right.begin(), strip.right.end(), is_within)) {
          return false;
        }
      }
    }
    return true;
  }

  void addLane(std::size_t road, std::size_t section, const OpenDriveLane& from,
               const LaneStrip& strip) {
    const std::optional<LaneUse> use = laneUse(from.type);
    if (!use) warnings_.add("lanes of a type that is not in OpenDRIVE 1.4 to 1.8", from.type);
    if (use != LaneUse::kLane || strip.widest < kNarrowestLane) return;
    const bool is_along = (from.id < 0) == (network_.roads[road].side == DrivingSide::kRight);
    const bool is_forward = is_along != (from.direction == LaneDirection::kReversed);
    LanePieces& pieces = pieces_of_[{road, section, from.id}];
    for (const bool forward : {true, false}) {
      if (forward != is_forward && from.direction != LaneDirection::kBoth) continue;
      (forward ? pieces.forward : pieces.backward) = pieces_.size();
      pieces_.push_back(pieceOf(road, section, from, strip, forward));
      if (forward != is_forward) pieces_.back().lane.id += ".back";
    }
  }

  LanePiece pieceOf(std::size_t road, std::size_t section, const OpenDriveLane& from,
                    const LaneStrip& strip, bool is_forward) const {
    const OpenDriveRoad& owner = network_.roads[road];
    const auto count = static_cast<std::ptrdiff_t>(strip.left.size());
    LanePiece piece;
    piece.road = road;
    piece.section = section;
    piece.is_forward = is_forward;
    piece.lane.id = owner.id + "." + std::to_string(section) + "." + std::to_string(from.id);
    piece.lane.is_connector = !owner.junction.empty();
    piece.lane.is_intersection = piece.lane.is_connector && is_intersection_.at(owner.junction);
    piece.lane.speed_limit = from.speed_limit;
    piece.lane.centerline = strip.centre;
    piece.lane.polygon = strip.left;
    piece.lane.polygon.insert(piece.lane.polygon.end(), strip.right.rbegin(), strip.right.rend());
    if (!is_forward) {
      std::reverse(piece.lane.centerline.begin(), piece.lane.centerline.end());
      for (Pose2& pose : piece.lane.centerline) pose.yaw = wrapAngle(pose.yaw + M_PI);
      // Rotates the ring, so that it begins with the border that is left in driving direction.
      std::rotate(piece.lane.polygon.begin(), piece.lane.polygon.begin() + count,
                  piece.lane.polygon.end());
    }
    return piece;
  }

  // Links. The lanes of two ends that touch lead to each other as their directions allow.

  const LanePieces* piecesOf(std::size_t road, std::size_t section, int lane) const {
    const auto found = pieces_of_.find({road, section, lane});
    return found == pieces_of_.end() ? nullptr : &found->second;
  }

  void link(std::optional<std::size_t> from, std::optional<std::size_t> to) {
    if (!from || !to) return;
    addOnce(pieces_[*from].next, *to);
    addOnce(pieces_[*to].previous, *from);
  }

  void touch(const LanePieces* one, bool one_end, const LanePieces* other, bool other_end) {
    if (one == nullptr || other == nullptr) return;
    link(one->leavingAt(one_end), other->enteringAt(other_end));
    link(other->leavingAt(other_end), one->enteringAt(one_end));
  }

  /// Calls `visit` with each lane of a section.
  template <typename Visit>
  static void eachLane(const OpenDriveSection& section, const Visit& visit) {
    for (const OpenDriveLane& lane : section.left) visit(lane);
    for (const OpenDriveLane& lane : section.right) visit(lane);
  }

  void linkRoad(std::size_t road) {
    const OpenDriveRoad& from = network_.roads[road];
    const std::size_t last = from.sections.size() - 1;
    for (std::size_t i = 0; i <= last; ++i) {
      eachLane(from.sections[i], [&](const OpenDriveLane& lane) {
        linkLane(road, i, lane, true, i == last ? from.after : OpenDriveLink{});
        linkLane(road, i, lane, false, i == 0 ? from.before : OpenDriveLink{});
      });
    }
  }

  /// Links one end of a lane: to the adjacent section, or beyond the end of the road.
  void linkLane(std::size_t road, std::size_t section, const OpenDriveLane& lane, bool at_end,
                const OpenDriveLink& beyond) {
    const std::vector<OpenDriveSection>& sections = network_.roads[road].sections;
    const LanePieces* const here = piecesOf(road, section, lane.id);
    if (here == nullptr) return;
    const bool is_inside = at_end ? section + 1 < sections.size() : section > 0;
    const std::size_t adjacent = at_end ? section + 1 : section - 1;
    if (is_inside && sections[std::min(section, adjacent)].continues) {
      touch(here, at_end, piecesOf(road, adjacent, lane.id), !at_end);
      return;
    }
    for (const int id : at_end ? lane.successors : lane.predecessors) {
      if (is_inside) {
        touch(here, at_end, piecesOf(road, adjacent, id), !at_end);
      } else if (beyond.to == OpenDriveLink::To::kRoad) {
        touch(here, at_end, piecesAt(beyond.id, beyond.at_end, id), beyond.at_end);
      }
    }
  }

  /// Returns the pieces of a lane at one end of a road; null if there is none.
  const LanePieces* piecesAt(const std::string& road, bool at_end, int lane) const {
    const auto found = roads_.find(road);
    if (found == roads_.end()) return nullptr;
    const std::size_t last = network_.roads[found->second].sections.size() - 1;
    return piecesOf(found->second, at_end ? last : 0, lane);
  }

  void linkJunction(const OpenDriveConnection& connection) {
    const auto incoming = roads_.find(connection.incoming);
    const auto connecting = roads_.find(connection.connecting);
    if (incoming == roads_.end() || connecting == roads_.end()) {
      warnings_.add("junctions with a connection of missing roads", connection.junction);
      return;
    }
    const std::optional<bool> end = incomingEnd(connection, network_.roads[incoming->second],
                                                network_.roads[connecting->second]);
    if (!end) {
      warnings_.add("junctions with a connection whose incoming road does not lead to it",
                    connection.junction);
      return;
    }
    for (const auto& [from, to] : connection.lanes) {
      touch(piecesAt(connection.incoming, *end, from), *end,
            piecesAt(connection.connecting, connection.at_end, to), connection.at_end);
    }
  }

  /// Returns at which end the incoming road leads to the junction; true for its end.
  static std::optional<bool> incomingEnd(const OpenDriveConnection& connection,
                                         const OpenDriveRoad& incoming,
                                         const OpenDriveRoad& connecting) {
    const OpenDriveLink& back = connection.at_end ? connecting.after : connecting.before;
    if (back.to == OpenDriveLink::To::kRoad && back.id == incoming.id) return back.at_end;
    const auto leads = [&](const OpenDriveLink& link) {
      return link.to == OpenDriveLink::To::kJunction && link.id == connection.junction;
    };
    if (leads(incoming.after) == leads(incoming.before)) return std::nullopt;
    return leads(incoming.after);
  }

  /// Links the lanes before and after a piece that is too short for a lane, and empties it.
  void bridgeShortPieces() {
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      LanePiece& piece = pieces_[i];
      if (lengthOf(piece.lane.centerline) >= kShortestLane) continue;
      piece.lane.centerline.clear();
      const auto forget = [&](std::vector<std::size_t>& places) {
        places.erase(std::remove(places.begin(), places.end(), i), places.end());
      };
      forget(piece.next);
      forget(piece.previous);
      for (const std::size_t before : piece.previous) forget(pieces_[before].next);
      for (const std::size_t after : piece.next) forget(pieces_[after].previous);
      for (const std::size_t before : piece.previous) {
        for (const std::size_t after : piece.next) link(before, after);
      }
    }
  }

  /// Returns true if `after` continues `before` unchanged in the next section of the road.
  bool isContinued(const LanePiece& before, const LanePiece& after) const {
    return before.next.size() == 1 && after.previous.size() == 1 && before.road == after.road &&
           (before.is_forward ? before.section < after.section : before.section > after.section) &&
           before.is_forward == after.is_forward &&
           before.lane.speed_limit == after.lane.speed_limit;
  }

  /// Returns the piece that continues a piece unchanged; null if there is none.
  const LanePiece* continuation(const LanePiece& piece) const {
    if (piece.next.size() != 1) return nullptr;
    const LanePiece& next = pieces_[piece.next.front()];
    return isContinued(piece, next) ? &next : nullptr;
  }

  bool isContinuation(const LanePiece& piece) const {
    return piece.previous.size() == 1 && isContinued(pieces_[piece.previous.front()], piece);
  }

  /// Makes lanes of the pieces: chains of at most kLongestSection that continue unchanged.
  void joinPieces() {
    std::vector<std::size_t> lane_of(pieces_.size());
    std::vector<const LanePiece*> last_of;  // of each lane
    for (const LanePiece& first : pieces_) {
      if (first.lane.centerline.empty() || isContinuation(first)) continue;
      double length = 0.0;
      for (const LanePiece* piece = &first; piece != nullptr; piece = continuation(*piece)) {
        const double added = lengthOf(piece->lane.centerline);
        if (piece == &first || length + added > kLongestSection) {
          map_.lanes.push_back(piece->lane);
          last_of.push_back(nullptr);
          length = 0.0;
        } else {
          append(piece->lane, map_.lanes.back());
        }
        length += added;
        last_of.back() = piece;
        lane_of[static_cast<std::size_t>(piece - pieces_.data())] = map_.lanes.size() - 1;
      }
    }
    for (std::size_t i = 0; i < last_of.size(); ++i) {
      for (const std::size_t next : last_of[i]->next) {
        map_.lanes[i].outgoing.push_back(map_.lanes[lane_of[next]].id);
        map_.lanes[lane_of[next]].incoming.push_back(map_.lanes[i].id);
      }
    }
  }

  /// Extends a lane by the next one. A polygon is the left border and then the right one backwards,
  /// with as many points as the centreline.
  static void append(const Lane& next, Lane& lane) {
    constexpr double kSamePoint = 1e-3;  // m
    const Vector2 end = lane.centerline.back().position();
    const auto skipped = (next.centerline.front().position() - end).norm() < kSamePoint ? 1 : 0;
    const auto count = static_cast<std::ptrdiff_t>(lane.centerline.size());
    lane.polygon.insert(lane.polygon.begin() + count, next.polygon.begin() + skipped,
                        next.polygon.end() - skipped);
    lane.centerline.insert(lane.centerline.end(), next.centerline.begin() + skipped,
                           next.centerline.end());
  }

  void chooseSide() {
    const auto left =
        std::count_if(network_.roads.begin(), network_.roads.end(),
                      [](const OpenDriveRoad& road) { return road.side == DrivingSide::kLeft; });
    const auto right = static_cast<std::ptrdiff_t>(network_.roads.size()) - left;
    map_.driving_side = left > right ? DrivingSide::kLeft : DrivingSide::kRight;
    for (const OpenDriveRoad& road : network_.roads) {
      if (road.side != map_.driving_side) warnings_.add("roads of the other driving side", road.id);
    }
  }

  const OpenDriveNetwork& network_;
  const double resolution_;
  const InputLimits& limits_;
  WarningCounter& warnings_;
  LaneMap map_;
  std::size_t points_ = 0;
  std::unordered_map<std::string, std::size_t> roads_;
  std::unordered_map<std::string, bool> is_intersection_;  // by id of the junction
  std::map<std::string, std::vector<Polygon>> junction_areas_;
  std::vector<LanePiece> pieces_;
  std::map<std::tuple<std::size_t, std::size_t, int>, LanePieces> pieces_of_;
};

}  // namespace

LaneMap laneMapOf(const OpenDriveNetwork& network, double resolution, const InputLimits& limits,
                  WarningCounter& warnings) {
  return LaneBuilder(network, resolution, limits, warnings).build();
}

}  // namespace forge
