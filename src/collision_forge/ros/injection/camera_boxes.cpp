#include "collision_forge/ros/injection/camera_boxes.h"

#include <rosbag/view.h>

#include <algorithm>
#include <utility>

#include "collision_forge/ros/injection/agent_body.h"
#include "collision_forge/ros/markers/marker_colors.h"
#include "collision_forge/ros/messages/topic_names.h"

namespace forge {
namespace {

constexpr double kNearest = 0.1;    // m in front of the camera
constexpr float kLineWidth = 3.0F;  // pixels

using Projection = Eigen::Matrix<double, 3, 4>;

Projection projectionOf(const sensor_msgs::CameraInfo& info) {
  Projection projection = Projection::Zero();
  const bool has_projection =
      std::any_of(info.P.begin(), info.P.end(), [](double value) { return value != 0.0; });
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < (has_projection ? 4 : 3); ++column) {
      projection(row, column) =
          has_projection ? info.P[4 * row + column] : info.K[3 * row + column];
    }
  }
  return projection;
}

/// Cuts a line from `begin` to `end` off where `inside` (a signed distance, linear along the line)
/// is negative. Returns false if nothing is left.
template <typename Point, typename Inside>
bool cutOff(Point& begin, Point& end, const Inside& inside) {
  const double first = inside(begin);
  const double last = inside(end);
  if (!(first >= 0.0) && !(last >= 0.0)) return false;
  if (first >= 0.0 && last >= 0.0) return true;
  const Point border = begin + first / (first - last) * (end - begin);
  (first < 0.0 ? begin : end) = border;
  return true;
}

}  // namespace

std::vector<PictureLine> boxEdges(const collision_forge::Agent& agent,
                                  const Eigen::Isometry3d& camera,
                                  const sensor_msgs::CameraInfo& info) {
  const Eigen::Isometry3d to_camera = camera.inverse() * bottomOf(agent);
  const Eigen::Vector3d size = sizeOf(agent);
  const auto corner = [&](unsigned index) -> Eigen::Vector3d {
    return to_camera * Eigen::Vector3d(size.x() * ((index & 1U) ? 0.5 : -0.5),
                                       size.y() * ((index & 2U) ? 0.5 : -0.5),
                                       (index & 4U) ? size.z() : 0.0);
  };
  const Projection projection = projectionOf(info);
  const auto pixelOf = [&](const Eigen::Vector3d& point) -> Eigen::Vector2d {
    return (projection * point.homogeneous()).hnormalized();
  };
  std::vector<PictureLine> lines;
  for (unsigned from = 0; from < 8; ++from) {
    for (const unsigned axis : {1U, 2U, 4U}) {
      if (from & axis) continue;  // each edge once, from its lower corner
      Eigen::Vector3d begin = corner(from);
      Eigen::Vector3d end = corner(from | axis);
      if (!cutOff(begin, end, [](const auto& point) { return point.z() - kNearest; })) continue;
      PictureLine line{pixelOf(begin), pixelOf(end)};
      const auto isLeft = [&](const auto& inside) { return cutOff(line.begin, line.end, inside); };
      if (isLeft([](const auto& pixel) { return pixel.x(); }) &&
          isLeft([&](const auto& pixel) { return info.width - pixel.x(); }) &&
          isLeft([](const auto& pixel) { return pixel.y(); }) &&
          isLeft([&](const auto& pixel) { return info.height - pixel.y(); })) {
        lines.push_back(line);
      }
    }
  }
  return lines;
}

CameraBoxes::CameraBoxes(const rosbag::Bag& source, std::string attacker)
    : attacker_(std::move(attacker)), frames_(names::kMapFrame, names::kBaseFrame, kLongestBag) {
  for (const rosbag::ConnectionInfo* connection : rosbag::View(source).getConnections()) {
    if (connection->datatype == ros::message_traits::datatype<sensor_msgs::CameraInfo>()) {
      counts_[connection->topic];
    }
  }
  if (!counts_.empty()) addTransforms(source, frames_);
}

std::string CameraBoxes::boxTopic(const std::string& info_topic) {
  const std::size_t begin = info_topic.rfind('/') + 1;
  const std::string name = info_topic.substr(begin);
  return info_topic.substr(0, begin) + (name == "camera_info" ? "" : name + "_") + "attack_box";
}

std::vector<visualization_msgs::ImageMarker> CameraBoxes::mark(
    const std::string& topic, const sensor_msgs::CameraInfo& info,
    const std::vector<collision_forge::Agent>& agents) {
  Counts& counts = counts_.at(topic);
  ++counts.pictures;
  const auto camera = frames_.poseOf(frameName(info.header.frame_id), info.header.stamp);
  if (!camera) {
    ++counts.unplaced;
    return {};
  }
  std::vector<visualization_msgs::ImageMarker> markers;
  const auto add = [&](const std::string& agent) -> visualization_msgs::ImageMarker& {
    visualization_msgs::ImageMarker& marker = markers.emplace_back();
    marker.header = info.header;
    marker.ns = agent == attacker_ ? "attacker" : "support";
    marker.id = marker_ids_.try_emplace(agent, static_cast<int>(marker_ids_.size())).first->second;
    marker.type = visualization_msgs::ImageMarker::LINE_LIST;
    marker.scale = kLineWidth;
    return marker;
  };
  std::set<std::string> shown;
  for (const collision_forge::Agent& agent : agents) {
    const std::vector<PictureLine> lines = boxEdges(agent, *camera, info);
    if (lines.empty()) continue;
    shown.insert(agent.id);
    visualization_msgs::ImageMarker& marker = add(agent.id);
    marker.action = visualization_msgs::ImageMarker::ADD;
    marker.outline_color =
        colors::toMessage(agent.id == attacker_ ? colors::kAttacker : colors::kPatternAttacker);
    for (const PictureLine& line : lines) {
      for (const Eigen::Vector2d& pixel : {line.begin, line.end}) {
        geometry_msgs::Point& point = marker.points.emplace_back();
        point.x = pixel.x();
        point.y = pixel.y();
      }
    }
  }
  for (const std::string& agent : counts.shown) {
    if (shown.count(agent) == 0) add(agent).action = visualization_msgs::ImageMarker::REMOVE;
  }
  counts.marked += shown.count(attacker_);
  counts.shown = std::move(shown);
  return markers;
}

std::vector<std::string> CameraBoxes::summary() const {
  std::vector<std::string> lines;
  for (const auto& [topic, counts] : counts_) {
    std::string line = boxTopic(topic) + ": the attacker's box on " +
                       std::to_string(counts.marked) + " of " + std::to_string(counts.pictures) +
                       " pictures, which are not repainted";
    if (counts.unplaced > 0) {
      line += "; " + std::to_string(counts.unplaced) + " have no transform from " +
              names::kMapFrame + " at their stamp";
    }
    lines.push_back(line);
  }
  return lines;
}

}  // namespace forge
