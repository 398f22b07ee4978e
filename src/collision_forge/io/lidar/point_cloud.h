#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace forge {

/// Thrown for a cloud that cannot be read. The message names field and value.
struct CloudError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// One field of each point, as in sensor_msgs/PointField.
struct CloudField {
  std::string name;
  std::uint32_t offset = 0;  ///< bytes from the start of a point
  std::uint8_t datatype =
      0;  ///< 1 to 8: int8, uint8, int16, uint16, int32, uint32, float32, float64
  std::uint32_t count = 1;
};

/// A cloud as in sensor_msgs/PointCloud2, without its header. Coordinates are in the sensor's
/// frame, m.
struct PointCloud {
  std::uint32_t height = 1;
  std::uint32_t width = 0;
  std::vector<CloudField> fields;
  bool is_bigendian = false;
  std::uint32_t point_step = 0;  ///< bytes of a point
  std::uint32_t row_step = 0;    ///< bytes of a row
  std::vector<std::uint8_t> data;
  bool is_dense = true;  ///< no point has NaN coordinates

  std::size_t pointCount() const { return std::size_t{height} * width; }
  /// Bytes of a point; `index` counts row by row.
  std::uint8_t* pointAt(std::size_t index) {
    return data.data() + index / width * row_step + index % width * point_step;
  }
  const std::uint8_t* pointAt(std::size_t index) const {
    return data.data() + index / width * row_step + index % width * point_step;
  }
};

/// Reads and writes one field of a point as a number, in the cloud's byte order.
class FieldAccess {
 public:
  FieldAccess(const CloudField& field, bool is_bigendian);
  double get(const std::uint8_t* point) const;
  /// Rounds and clamps to the range of an integer field.
  void set(std::uint8_t* point, double value) const;
  /// Returns true for float32 and float64.
  bool isFloat() const { return datatype_ >= 7; }

 private:
  std::uint32_t offset_;
  std::uint8_t datatype_;
  bool is_swapped_;
};

/// The known fields of a cloud. Fields are found by name, never by position.
struct CloudLayout {
  /// Throws CloudError if x, y or z is missing or no float, if a known field reaches over the
  /// point, or if the data are shorter than the sizes say.
  explicit CloudLayout(const PointCloud& cloud);

  FieldAccess x, y, z;
  std::optional<FieldAccess> intensity;  ///< `intensity`, `i` or `reflectivity`
  std::optional<FieldAccess> ring;       ///< `ring`, `channel` or `laser_id`
  std::optional<FieldAccess> time;       ///< `time`, `t`, `timestamp`, `time_stamp`, `offset_time`

  Eigen::Vector3d position(const std::uint8_t* point) const {
    return {x.get(point), y.get(point), z.get(point)};
  }
  void setPosition(std::uint8_t* point, const Eigen::Vector3d& position) const;
  /// Returns the time of a point, s after the cloud's `stamp` (s). Integers are nanoseconds after
  /// the stamp; floats are seconds, after the stamp or (from 1e6 on) of the clock of the stamp.
  /// Requires `time`.
  double timeOf(const std::uint8_t* point, double stamp) const;
};

}  // namespace forge
