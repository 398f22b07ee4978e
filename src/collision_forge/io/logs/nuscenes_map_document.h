#pragma once

#include <rapidjson/document.h>

#include <string>
#include <vector>

namespace forge {

/// A value of a map file and its position, for messages. Valid while the NuScenesMapDocument
/// exists.
struct MapRow {
  const rapidjson::Value& value;  ///< the row, or an element of an array in it
  const char* layer;              ///< name of the layer, not owned
  std::string token;              ///< token of the row; "of row N" (from 0) for a row without one
};

/// A parsed map expansion file with typed access. Every accessor throws NuScenesError, naming file,
/// layer, token and field, if the value is missing or has another type.
class NuScenesMapDocument {
 public:
  /// Throws NuScenesError for a file that is missing, not JSON, or of a version before 1.3.
  explicit NuScenesMapDocument(const std::string& path);

  /// Returns true if the file has the layer.
  bool has(const char* layer) const { return document_.HasMember(layer); }
  /// Returns the rows of a layer that is an array, in the file's order.
  std::vector<MapRow> rows(const char* layer) const;
  /// Returns the entries of a layer that is a dictionary keyed by token; MapRow::token is the key.
  std::vector<MapRow> entries(const char* layer) const;
  /// Returns the elements of an array, for instance the arcs of an arcline, with the layer and
  /// token of `array`. `name` is the field's name for messages.
  std::vector<MapRow> elements(const MapRow& array, const char* name) const;

  // Return the field `name` of a row with the type of the function; field() of any type. `count`:
  // number of elements; an array of another length throws, too.
  const rapidjson::Value& field(const MapRow& row, const char* name) const;
  bool flag(const MapRow& row, const char* name) const;
  double number(const MapRow& row, const char* name) const;
  std::string text(const MapRow& row, const char* name) const;
  std::vector<double> numbers(const MapRow& row, const char* name, std::size_t count) const;
  std::vector<std::string> texts(const MapRow& row, const char* name) const;

 private:
  /// Throws NuScenesError: file, layer, token and field, then `problem`.
  [[noreturn]] void fail(const MapRow& row, const char* name, const std::string& problem) const;
  /// Returns a layer; throws if it is missing.
  const rapidjson::Value& layer(const char* name) const;
  /// Reads the file into `document_`.
  void parse();
  /// Throws NuScenesError for a version before 1.3.
  void checkVersion() const;

  std::string path_;
  rapidjson::Document document_;
};

}  // namespace forge
