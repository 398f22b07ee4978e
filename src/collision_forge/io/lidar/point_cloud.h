#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace forge {

/// Thrown for a cloud that cannot be read. The message names field or size and value.
struct CloudError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// One field of each point, as in sensor_msgs/PointField.
struct CloudField {
  std::string name;
  std::uint32_t offset = 0;  ///< bytes from the start of a point
  /// 1 to 8: int8, uint8, int16, uint16, int32, uint32, float32, float64.
  std::uint8_t datatype = 0;
  std::uint32_t count = 1;  ///< elements of the field; only the first is read or written
};

/// A cloud as in sensor_msgs/PointCloud2, without its header. Coordinates are in the sensor's
/// frame, m.
struct PointCloud {
  std::uint32_t height = 1;  ///< rows; 1: unorganised
  std::uint32_t width = 0;   ///< points per row
  std::vector<CloudField> fields;
  bool is_bigendian = false;       ///< byte order of the fields in `data`
  std::uint32_t point_step = 0;    ///< bytes of a point
  std::uint32_t row_step = 0;      ///< bytes of a row, at least width * point_step
  std::vector<std::uint8_t> data;  ///< rows one after the other
  bool is_dense = true;            ///< true: no point has NaN coordinates

  std::size_t pointCount() const { return std::size_t{height} * width; }
  /// Returns the first byte of a point; `index` counts row by row and must be below pointCount().
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
  /// `field.datatype` must be 1 to 8; `is_bigendian`: the cloud's byte order.
  FieldAccess(const CloudField& field, bool is_bigendian);
  /// Returns the field's value; `point` is the first byte of a point.
  double get(const std::uint8_t* point) const;
  /// Writes the field of `point`. For an integer field, rounds and clamps the value to the field's
  /// range; `value` must then not be NaN.
  void set(std::uint8_t* point, double value) const;
  /// Returns true for float32 and float64.
  bool isFloat() const { return datatype_ >= 7; }

 private:
  std::uint32_t offset_;  ///< bytes from the start of a point
  std::uint8_t datatype_;
  bool is_swapped_;  ///< the cloud's byte order differs from the machine's
};

/// The known fields of a cloud. Fields are found by name, never by position; if several names are
/// possible, the first one in the order given below that the cloud has.
struct CloudLayout {
  /// Finds the fields of a cloud; does not keep a reference to it. Throws CloudError if x, y or z
  /// is missing or no float, if a known field has an unknown datatype or reaches over the point, or
  /// if `row_step` or `data` is shorter than the sizes require.
  explicit CloudLayout(const PointCloud& cloud);

  FieldAccess x, y, z;
  std::optional<FieldAccess> intensity;  ///< `intensity`, `i` or `reflectivity`; empty: none
  std::optional<FieldAccess> ring;       ///< `ring`, `channel` or `laser_id`; empty: none
  /// `time`, `t`, `timestamp`, `time_stamp` or `offset_time`; empty: none.
  std::optional<FieldAccess> time;

  /// Returns x, y, z of a point, m in the sensor's frame; NaN or zeros for a ray without return.
  Eigen::Vector3d position(const std::uint8_t* point) const {
    return {x.get(point), y.get(point), z.get(point)};
  }
  /// Writes x, y, z of a point, m in the sensor's frame.
  void setPosition(std::uint8_t* point, const Eigen::Vector3d& position) const;
  /// Returns the time of a point, s after `stamp` (s, the stamp in the cloud's header). Integer
  /// fields hold nanoseconds after the stamp; float fields hold seconds, after the stamp or (from
  /// 1e6 on) on the clock of the stamp. Requires that `time` is set.
  double timeOf(const std::uint8_t* point, double stamp) const;
};

}  // namespace forge
