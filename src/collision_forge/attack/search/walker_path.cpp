#include "collision_forge/attack/search/walker_path.h"

#include <cmath>
#include <vector>

namespace forge {
namespace {

constexpr double kLeastAhead = 0.5;  // m straight towards the meeting place
constexpr double kLeastAlong = 0.3;  // m along the kerb; less is cut

}  // namespace

std::optional<Polyline> walkerPath(const Pose2& start, const Pose2& meeting) {
  const Vector2 ahead = meeting.heading();
  const Vector2 way = meeting.position() - start.position();
  const double distance = way.dot(ahead);
  if (distance < kLeastAhead) return std::nullopt;
  const Vector2 corner = meeting.position() - distance * ahead;
  std::vector<Vector2> points = {start.position()};
  if ((corner - start.position()).norm() > kLeastAlong) points.push_back(corner);
  points.push_back(meeting.position());
  points.push_back(meeting.position() + kBeyondMeeting * ahead);
  return Polyline(points);
}

}  // namespace forge
