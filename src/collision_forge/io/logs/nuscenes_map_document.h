#pragma once

#include <rapidjson/document.h>

#include <string>
#include <vector>

namespace forge {

/// A value of a map file and its position, for messages.
struct MapRow {
  const rapidjson::Value& value;
  const char* layer;
  std::string token;
};

/// A parsed map expansion file with typed access. Every accessor throws NuScenesError, naming file,
/// layer, token and field, if the value is missing or has another type.
class NuScenesMapDocument {
 public:
  /// Throws NuScenesError for a file that is missing, not JSON, or of a version before 1.3.
  explicit NuScenesMapDocument(const std::string& path);

  /// Returns the rows of a layer that is an array of objects, each with a "token".
  std::vector<MapRow> rows(const char* layer) const;
  /// Returns the entries of a layer that is a dictionary keyed by token.
  std::vector<MapRow> entries(const char* layer) const;
  /// Returns the elements of an array, for instance the arcs of an arcline; `name` is for messages.
  std::vector<MapRow> elements(const MapRow& array, const char* name) const;

  // Return the field `name` of a row with the given type.
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
