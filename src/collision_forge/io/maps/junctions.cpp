#include "collision_forge/io/maps/junctions.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <unordered_map>

namespace forge {
namespace {

constexpr double kCell = 5.0;        // m, side of a cell of the grid
constexpr double kLeastSine = 0.26;  // of the angle of a crossing, 15 degrees

double cross(const Vector2& a, const Vector2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// A piece of a lane's centreline.
struct LanePiece {
  std::size_t lane = 0;
  Vector2 start;
  Vector2 span;
};

/// Returns true if the pieces cross. A point belongs to the piece that starts there; pieces that
/// only start at the same point do not cross.
bool areCrossing(const LanePiece& a, const LanePiece& b) {
  const double sine = cross(a.span, b.span);
  if (std::abs(sine) < kLeastSine * a.span.norm() * b.span.norm() || sine == 0.0) return false;
  const Vector2 apart = b.start - a.start;
  const double along_a = cross(apart, b.span) / sine;
  const double along_b = cross(apart, a.span) / sine;
  return along_a >= 0.0 && along_a < 1.0 && along_b >= 0.0 && along_b < 1.0 &&
         along_a + along_b > 0.0;
}

class CrossingSearch {
 public:
  explicit CrossingSearch(const std::vector<Lane>& lanes) : is_crossing_(lanes.size(), false) {
    for (std::size_t lane = 0; lane < lanes.size(); ++lane) {
      const std::vector<Pose2>& line = lanes[lane].centerline;
      for (std::size_t i = 1; i < line.size(); ++i) {
        const Vector2 start = line[i - 1].position();
        add({lane, start, line[i].position() - start});
      }
    }
  }

  /// Returns one flag per lane.
  const std::vector<bool>& found() const { return is_crossing_; }

 private:
  /// Compares a piece with the pieces in its cells, and adds it to these cells.
  void add(const LanePiece& piece) {
    const Vector2 end = piece.start + piece.span;
    const Vector2 low = (piece.start.cwiseMin(end) / kCell).array().floor();
    const Vector2 high = (piece.start.cwiseMax(end) / kCell).array().floor();
    for (double x = low.x(); x <= high.x(); ++x) {
      for (double y = low.y(); y <= high.y(); ++y) {
        std::vector<LanePiece>& near = cells_[keyOf(x, y)];
        for (const LanePiece& other : near) {
          if (other.lane == piece.lane || !areCrossing(other, piece)) continue;
          is_crossing_[other.lane] = is_crossing_[piece.lane] = true;
        }
        near.push_back(piece);
      }
    }
  }

  static std::int64_t keyOf(double x, double y) {
    constexpr std::int64_t kRow = std::int64_t{1} << 32;
    return static_cast<std::int64_t>(x) * kRow + static_cast<std::int64_t>(y);
  }

  std::vector<bool> is_crossing_;
  std::unordered_map<std::int64_t, std::vector<LanePiece>> cells_;
};

}  // namespace

void markJunctions(std::vector<Lane>& lanes) {
  const CrossingSearch search(lanes);
  std::unordered_map<std::string, Lane*> lane_of_id;
  for (Lane& lane : lanes) lane_of_id[lane.id] = &lane;
  const auto mark = [](Lane& lane) { lane.is_connector = lane.is_intersection = true; };
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    if (!search.found()[i]) continue;
    mark(lanes[i]);
    for (const std::string& before : lanes[i].incoming) {
      for (const std::string& beside : lane_of_id.at(before)->outgoing) {
        mark(*lane_of_id.at(beside));
      }
    }
    for (const std::string& after : lanes[i].outgoing) {
      for (const std::string& beside : lane_of_id.at(after)->incoming) {
        mark(*lane_of_id.at(beside));
      }
    }
  }
}

}  // namespace forge
