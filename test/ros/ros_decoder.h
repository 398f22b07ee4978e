#pragma once

#include <cstdint>
#include <cstring>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace forge {

/// Reads ROS 1 bytes by nothing but the text of the message's definition, as a foreign program
/// does. Values are found by their paths: "entities[0].cubes[1].size.x".
class RosDecoder {
 public:
  RosDecoder(const std::string& definition, std::string bytes) : bytes_(std::move(bytes)) {
    readDefinition(definition);
    read("", "", "");
    if (place_ != bytes_.size()) throw std::runtime_error("bytes are left over");
  }

  double number(const std::string& path) const { return numbers_.at(path); }
  const std::string& text(const std::string& path) const { return texts_.at(path); }
  std::size_t size(const std::string& path) const { return sizes_.at(path); }

 private:
  using Fields = std::vector<std::pair<std::string, std::string>>;  ///< type and name

  /// The type before the first rule is named "".
  void readDefinition(const std::string& definition) {
    std::istringstream lines(definition);
    std::string type;
    for (std::string line; std::getline(lines, line);) {
      if (line.rfind("MSG: ", 0) == 0) type = line.substr(5);
      std::istringstream words(line.substr(0, line.find('#')));
      std::string kind;
      std::string name;
      const bool is_field = words >> kind >> name && kind != "MSG:";
      if (is_field && line.find('=') == std::string::npos) types_[type].emplace_back(kind, name);
    }
  }

  template <typename Number>
  Number take() {
    Number number{};
    const std::string bytes = taken(sizeof number);
    std::memcpy(&number, bytes.data(), sizeof number);
    return number;
  }

  std::string taken(std::size_t count) {
    if (count > bytes_.size() - place_) throw std::runtime_error("the bytes end too early");
    place_ += count;
    return bytes_.substr(place_ - count, count);
  }

  /// True for a simple type.
  bool readSimple(const std::string& type, const std::string& path) {
    if (type == "float64") {
      numbers_[path] = take<double>();
    } else if (type == "uint8" || type == "bool") {
      numbers_[path] = take<std::uint8_t>();
    } else if (type == "uint32") {
      numbers_[path] = take<std::uint32_t>();
    } else if (type == "string") {
      texts_[path] = taken(take<std::uint32_t>());
    } else if (type == "time" || type == "duration") {
      const auto seconds = take<std::uint32_t>();
      numbers_[path] = seconds + 1e-9 * take<std::uint32_t>();
    } else {
      return false;
    }
    return true;
  }

  /// A type without its package is of that of the type around it.
  void read(const std::string& type, const std::string& package, const std::string& path) {
    if (readSimple(type, path)) return;
    const bool is_whole = type.empty() || type.find('/') != std::string::npos;
    const std::string name = is_whole ? type : package + "/" + type;
    for (const auto& [kind, field] : types_.at(name)) {
      const std::string place = path.empty() ? field : path + "." + field;
      const std::string own_package = name.substr(0, name.find('/'));
      const std::size_t list = kind.find("[]");
      if (list == std::string::npos) {
        read(kind, own_package, place);
        continue;
      }
      sizes_[place] = take<std::uint32_t>();
      for (std::size_t i = 0; i < sizes_[place]; ++i) {
        read(kind.substr(0, list), own_package, place + "[" + std::to_string(i) + "]");
      }
    }
  }

  std::string bytes_;
  std::size_t place_ = 0;
  std::map<std::string, Fields> types_;
  std::map<std::string, double> numbers_;
  std::map<std::string, std::string> texts_;
  std::map<std::string, std::size_t> sizes_;
};

}  // namespace forge
