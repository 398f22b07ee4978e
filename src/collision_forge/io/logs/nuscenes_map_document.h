#pragma once

#include <rapidjson/document.h>

#include <string>
#include <vector>

namespace forge {

/// Where a value of a map file stands, for messages.
struct MapRow {
  const rapidjson::Value& value;
  const char* layer;
  std::string token;
};

/// A map expansion file in memory, and typed access to it. Every accessor throws NuScenesError,
/// naming file, layer, token and field, when the value is missing or of another type.
class NuScenesMapDocument {
 public:
  /// Throws NuScenesError for a file that is missing, no JSON, or of a version before 1.3.
  explicit NuScenesMapDocument(const std::string& path);

  /// The rows of a layer that is an array of objects with a "token" each.
  std::vector<MapRow> rows(const char* layer) const;
  /// The entries of a layer that is a dictionary by token.
  std::vector<MapRow> entries(const char* layer) const;
  /// The elements of an array, for instance the arcs of an arcline.
  std::vector<MapRow> elements(const MapRow& array, const char* name) const;

  const rapidjson::Value& field(const MapRow& row, const char* name) const;
  bool flag(const MapRow& row, const char* name) const;
  double number(const MapRow& row, const char* name) const;
  std::string text(const MapRow& row, const char* name) const;
  std::vector<double> numbers(const MapRow& row, const char* name, std::size_t count) const;
  std::vector<std::string> texts(const MapRow& row, const char* name) const;

 private:
  [[noreturn]] void fail(const MapRow& row, const char* name, const std::string& problem) const;
  const rapidjson::Value& layer(const char* name) const;
  void parse();
  void checkVersion() const;

  std::string path_;
  rapidjson::Document document_;
};

}  // namespace forge
