#include "collision_forge/io/lidar/point_cloud.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <initializer_list>
#include <limits>

namespace forge {
namespace {

constexpr std::uint32_t kSizes[] = {0, 1, 1, 2, 2, 4, 4, 4, 8};  // bytes, by datatype
constexpr std::uint8_t kFloat32 = 7;
constexpr double kFirstAbsolute = 1e6;  // s; no sweep is that long

template <typename Number>
double load(const std::uint8_t* bytes, bool is_swapped) {
  std::uint8_t ordered[sizeof(Number)];
  std::memcpy(ordered, bytes, sizeof(Number));
  if (is_swapped) std::reverse(std::begin(ordered), std::end(ordered));
  Number value;
  std::memcpy(&value, ordered, sizeof(Number));
  return static_cast<double>(value);
}

template <typename Number>
void store(std::uint8_t* bytes, double value, bool is_swapped) {
  if constexpr (std::numeric_limits<Number>::is_integer) {
    value = std::clamp(std::round(value), double{std::numeric_limits<Number>::min()},
                       double{std::numeric_limits<Number>::max()});
  }
  const auto number = static_cast<Number>(value);
  std::memcpy(bytes, &number, sizeof(Number));
  if (is_swapped) std::reverse(bytes, bytes + sizeof(Number));
}

bool isBigEndianMachine() {
  const std::uint16_t one = 1;
  std::uint8_t first = 0;
  std::memcpy(&first, &one, 1);
  return first == 0;
}

const CloudField* findField(const PointCloud& cloud, std::initializer_list<const char*> names) {
  for (const char* name : names) {
    for (const CloudField& field : cloud.fields) {
      if (field.name == name) return &field;
    }
  }
  return nullptr;
}

void checkField(const PointCloud& cloud, const CloudField& field) {
  if (field.datatype < 1 || field.datatype > 8) {
    throw CloudError("field " + field.name + ": datatype " + std::to_string(field.datatype) +
                     " is unknown");
  }
  if (std::uint64_t{field.offset} + kSizes[field.datatype] > cloud.point_step) {
    throw CloudError("field " + field.name + ": offset " + std::to_string(field.offset) +
                     " is beyond the point_step of " + std::to_string(cloud.point_step) + " bytes");
  }
}

FieldAccess coordinate(const PointCloud& cloud, const char* name) {
  const CloudField* field = findField(cloud, {name});
  if (!field) throw CloudError(std::string("field ") + name + " is missing");
  checkField(cloud, *field);
  if (field->datatype < kFloat32) {
    throw CloudError(std::string("field ") + name + ": datatype " +
                     std::to_string(field->datatype) + " is no float");
  }
  return {*field, cloud.is_bigendian};
}

std::optional<FieldAccess> known(const PointCloud& cloud,
                                 std::initializer_list<const char*> names) {
  const CloudField* field = findField(cloud, names);
  if (!field) return std::nullopt;
  checkField(cloud, *field);
  return FieldAccess(*field, cloud.is_bigendian);
}

}  // namespace

FieldAccess::FieldAccess(const CloudField& field, bool is_bigendian)
    : offset_(field.offset),
      datatype_(field.datatype),
      is_swapped_(is_bigendian != isBigEndianMachine()) {}

double FieldAccess::get(const std::uint8_t* point) const {
  const std::uint8_t* bytes = point + offset_;
  switch (datatype_) {
    case 1:
      return load<std::int8_t>(bytes, is_swapped_);
    case 2:
      return load<std::uint8_t>(bytes, is_swapped_);
    case 3:
      return load<std::int16_t>(bytes, is_swapped_);
    case 4:
      return load<std::uint16_t>(bytes, is_swapped_);
    case 5:
      return load<std::int32_t>(bytes, is_swapped_);
    case 6:
      return load<std::uint32_t>(bytes, is_swapped_);
    case kFloat32:
      return load<float>(bytes, is_swapped_);
    default:
      return load<double>(bytes, is_swapped_);
  }
}

void FieldAccess::set(std::uint8_t* point, double value) const {
  std::uint8_t* bytes = point + offset_;
  switch (datatype_) {
    case 1:
      return store<std::int8_t>(bytes, value, is_swapped_);
    case 2:
      return store<std::uint8_t>(bytes, value, is_swapped_);
    case 3:
      return store<std::int16_t>(bytes, value, is_swapped_);
    case 4:
      return store<std::uint16_t>(bytes, value, is_swapped_);
    case 5:
      return store<std::int32_t>(bytes, value, is_swapped_);
    case 6:
      return store<std::uint32_t>(bytes, value, is_swapped_);
    case kFloat32:
      return store<float>(bytes, value, is_swapped_);
    default:
      return store<double>(bytes, value, is_swapped_);
  }
}

CloudLayout::CloudLayout(const PointCloud& cloud)
    : x(coordinate(cloud, "x")),
      y(coordinate(cloud, "y")),
      z(coordinate(cloud, "z")),
      intensity(known(cloud, {"intensity", "i", "reflectivity"})),
      ring(known(cloud, {"ring", "channel", "laser_id"})),
      time(known(cloud, {"time", "t", "timestamp", "time_stamp", "offset_time"})) {
  const std::uint64_t row = std::uint64_t{cloud.width} * cloud.point_step;
  if (cloud.height > 1 && cloud.row_step < row) {
    throw CloudError("row_step " + std::to_string(cloud.row_step) + " is less than the " +
                     std::to_string(row) + " bytes of a row");
  }
  const std::uint64_t bytes =
      cloud.height == 0 ? 0 : std::uint64_t{cloud.row_step} * (cloud.height - 1) + row;
  if (cloud.data.size() < bytes) {
    throw CloudError("data have " + std::to_string(cloud.data.size()) + " bytes, height " +
                     std::to_string(cloud.height) + " and width " + std::to_string(cloud.width) +
                     " need " + std::to_string(bytes));
  }
}

void CloudLayout::setPosition(std::uint8_t* point, const Eigen::Vector3d& position) const {
  x.set(point, position.x());
  y.set(point, position.y());
  z.set(point, position.z());
}

double CloudLayout::timeOf(const std::uint8_t* point, double stamp) const {
  const double value = time->get(point);
  if (!time->isFloat()) return value * 1e-9;
  return std::abs(value) < kFirstAbsolute ? value : value - stamp;
}

}  // namespace forge
