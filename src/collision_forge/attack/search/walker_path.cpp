#include "collision_forge/attack/search/walker_path.h"

#include <cmath>
#include <vector>

namespace forge {
namespace {

constexpr double kLeastAhead = 0.5;  // m straight towards the meeting place
constexpr double kLeastAlong = 0.3;  // m along the kerb; less is cut

}  // namespace

Gait gaitOf(AgentClass agent_class) {
  switch (agent_class) {
    case AgentClass::kChild:  // Euro NCAP's child has 1.4 m/s within 1 m; the rest is own choice
      return {{1.1, 1.4, 2.2}, 1.0, 2.2};
    case AgentClass::kRunner:  // Euro NCAP's runner has 2.2 m/s within 1.5 m; the rest is own
                               // choice
      return {{2.2, 2.8, 3.5}, 1.65, 3.3};
    default:  // recorded walkers have 1.24 m/s; Euro NCAP's has 1.0 m/s2
      return {{1.3, 1.7, 2.4}, 1.0, 2.6};
  }
}

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
