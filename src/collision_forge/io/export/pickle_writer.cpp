#include "collision_forge/io/export/pickle_writer.h"

#include <cmath>
#include <stdexcept>

namespace forge {

void PickleWriter::number(const char* key, double value) { write(key, "f8", {}, {value}); }

void PickleWriter::array(const char* key, const std::vector<double>& values, std::size_t columns) {
  if (columns == 0) return write(key, "f8", {values.size()}, values);
  write(key, "f8", {values.size() / columns, columns}, values);
}

void PickleWriter::flags(const char* key, const std::vector<bool>& values) {
  write(key, "b1", {values.size()}, {values.begin(), values.end()});
}

void PickleWriter::write(const char* key, const char* type, const std::vector<std::size_t>& shape,
                         const std::vector<double>& items) {
  for (const double item : items) {
    if (std::isfinite(item)) continue;
    throw std::invalid_argument("field " + std::string(key == nullptr ? "of a list" : key) + " = " +
                                std::to_string(item) + " is not finite");
  }
  beginObject(key);
  beginArray("ndarray");
  for (const std::size_t size : shape) count(nullptr, size);
  endArray();
  text("dtype", type);
  count("at", items_.size() / sizeof(double));
  endObject();
  items_.append(reinterpret_cast<const char*>(items.data()), items.size() * sizeof(double));
}

}  // namespace forge
