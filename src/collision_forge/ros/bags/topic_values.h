#pragma once

#include <ros/serialization.h>
#include <rosbag/message_instance.h>
#include <rosbag/structures.h>

#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "collision_forge/ros/bags/bag_error.h"
#include "collision_forge/ros/bags/bag_frames.h"
#include "collision_forge/ros/bags/message_fields.h"
#include "collision_forge/ros/bags/topic_mapping.h"

namespace forge {

/// The values of the requested fields in the newest message of a topic. Usage: want() all fields,
/// add() all connections of the topic, then take() each message and read its values. A missing
/// value (an array that is too short) is NaN, "" or 0. Not thread-safe.
class TopicValues {
 public:
  /// Requests the fields for nanoseconds() and frame(). `topic` must outlive the object.
  explicit TopicValues(const TopicFields& topic) : topic_(topic) {
    want(topic.stamp, FieldKind::kTime);
    if (!topic.frame_id_path.empty()) want(topic.frame_id_path, FieldKind::kText);
  }

  // Request fields; call before add(). A constant needs no field. Paths as in FieldPath.
  void want(const std::string& path, FieldKind kind) {
    if (columns_.try_emplace(path, paths_.size()).second) paths_.push_back({path, kind});
  }
  void want(const NumberSource& source) {
    if (const auto* path = std::get_if<std::string>(&source)) want(*path, FieldKind::kNumber);
  }
  template <std::size_t count>
  void want(const std::array<NumberSource, count>& sources) {
    for (const NumberSource& source : sources) want(source);
  }
  void want(const PoseFields& pose) {
    want(pose.position);
    std::visit([this](const auto& orientation) { want(orientation); }, pose.orientation);
  }

  /// Adds a connection of the topic. Throws BagError, without path and topic, if its type
  /// contradicts the mapping, and as the constructor of MessageFields.
  void add(const rosbag::ConnectionInfo& connection) {
    if (connection.datatype != topic_.type) {
      throw BagError("is of type " + connection.datatype + ", not " + topic_.type);
    }
    readers_[connection.header] =
        std::make_unique<MessageFields>(connection.datatype, connection.msg_def, paths_);
  }

  /// Reads the requested fields of a message, which replaces the one before. Its connection must
  /// have been added. Throws BagError as MessageFields::read().
  void take(const rosbag::MessageInstance& instance) {
    bytes_.resize(instance.size());
    ros::serialization::OStream stream(bytes_.data(), static_cast<std::uint32_t>(bytes_.size()));
    instance.write(stream);
    values_ = readers_.at(instance.getConnectionHeader())->read(bytes_.data(), bytes_.size());
  }

  // The functions below read the message of the last take(), which must have been called. Their
  // paths must have been requested; `row` counts from 0, and a row beyond the last has no values.

  /// Returns the number of rows of a field (FieldRows).
  std::size_t rows(const std::string& path) const { return values_[columns_.at(path)].size(); }

  /// Returns all values in a row, none if it has none; valid until the next take().
  const std::vector<FieldValue>& all(const std::string& path, std::size_t row) const {
    static const std::vector<FieldValue> none;
    const FieldRows& rows = values_[columns_.at(path)];
    return row < rows.size() ? rows[row] : none;
  }
  // Return the first value in a row ("" or NaN if it has none), or the constant.
  std::string text(const std::string& path, std::size_t row) const {
    const auto& values = all(path, row);
    return values.empty() ? "" : std::get<std::string>(values.front());
  }
  double number(const NumberSource& source, std::size_t row) const {
    if (const auto* constant = std::get_if<double>(&source)) return *constant;
    const auto& values = all(std::get<std::string>(source), row);
    return values.empty() ? std::nan("") : std::get<double>(values.front());
  }
  Eigen::Vector3d vector(const std::array<NumberSource, 3>& sources, std::size_t row) const {
    return {number(sources[0], row), number(sources[1], row), number(sources[2], row)};
  }
  /// Returns the rotation of a pose, as a unit quaternion; not finite if a field has no finite
  /// value or the quaternion is zero.
  Eigen::Quaterniond rotation(const PoseFields& pose, std::size_t row) const {
    if (const auto* yaw = std::get_if<NumberSource>(&pose.orientation)) {
      return Eigen::Quaterniond(Eigen::AngleAxisd(number(*yaw, row), Eigen::Vector3d::UnitZ()));
    }
    const auto& parts = std::get<0>(pose.orientation);
    Eigen::Vector4d coefficients;  // x, y, z, w
    for (int i = 0; i < 4; ++i) coefficients[i] = number(parts[static_cast<std::size_t>(i)], row);
    return Eigen::Quaterniond(Eigen::Vector4d(coefficients / coefficients.norm()));
  }
  /// Returns the stamp of the message, ns since the epoch; 0 if it is not set.
  std::int64_t nanoseconds() const {
    const auto& values = all(topic_.stamp, 0);
    return values.empty() ? 0 : std::get<std::int64_t>(values.front());
  }
  /// Returns the frame of the poses, as frameName(); `map_frame` for a message that names none.
  /// Throws BagError, without path and topic, if it is not the frame that the mapping requires.
  std::string frame(const std::string& map_frame) const {
    if (topic_.frame_id_path.empty()) return map_frame;
    const std::string found = text(topic_.frame_id_path, 0);
    if (!topic_.frame_id.empty() && frameName(found) != frameName(topic_.frame_id)) {
      throw BagError(topic_.frame_id_path + " is '" + found + "', not '" + topic_.frame_id + "'");
    }
    return found.empty() ? map_frame : frameName(found);
  }

 private:
  const TopicFields& topic_;
  std::vector<FieldPath> paths_;
  std::map<std::string, std::size_t> columns_;  ///< indices in `paths_` and `values_`, by path
  /// By the header of their connection, which all its messages share.
  std::map<boost::shared_ptr<ros::M_string>, std::unique_ptr<MessageFields>> readers_;
  std::vector<std::uint8_t> bytes_;  ///< buffer of take()
  std::vector<FieldRows> values_;    ///< of the newest message, in the order of `paths_`
};

}  // namespace forge
