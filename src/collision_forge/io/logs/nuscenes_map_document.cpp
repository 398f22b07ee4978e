#include "collision_forge/io/logs/nuscenes_map_document.h"

#include <rapidjson/error/en.h>
#include <rapidjson/filereadstream.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string_view>
#include <system_error>
#include <utility>

#include "collision_forge/io/json/json_numbers.h"
#include "collision_forge/io/logs/nuscenes_json.h"

namespace forge {
namespace {

using rapidjson::Value;

constexpr std::size_t kBufferBytes = 1 << 18;
constexpr std::pair<int, int> kOldestVersion = {1, 3};

std::string textOf(const Value& value) { return {value.GetString(), value.GetStringLength()}; }

/// Returns the token of the row with this index, or words for a row without one.
std::string tokenOf(const Value& row, std::size_t index) {
  if (row.IsObject()) {
    const auto token = row.FindMember("token");
    if (token != row.MemberEnd() && token->value.IsString()) return textOf(token->value);
  }
  return "of row " + std::to_string(index);
}

/// Returns true for "1.3" or later, compared by the first two numbers: "1.10" is later than "1.3".
bool isSupported(std::string_view version) {
  std::pair<int, int> numbers;
  const char* const end = version.data() + version.size();
  const auto [dot, major_error] = std::from_chars(version.data(), end, numbers.first);
  if (major_error != std::errc() || dot == end || *dot != '.') return false;
  const auto minor_error = std::from_chars(dot + 1, end, numbers.second).ec;
  return minor_error == std::errc() && numbers >= kOldestVersion;
}

}  // namespace

NuScenesMapDocument::NuScenesMapDocument(const std::string& path) : path_(path) {
  parse();
  checkVersion();
}

void NuScenesMapDocument::parse() {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path_.c_str(), "rb"),
                                                             &std::fclose);
  if (!file) throw NuScenesError(path_ + ": cannot be opened: " + std::strerror(errno));
  std::vector<char> buffer(kBufferBytes);
  rapidjson::FileReadStream stream(file.get(), buffer.data(), buffer.size());
  const rapidjson::ParseResult result =
      parseExactly<rapidjson::kParseNanAndInfFlag>(stream, document_);
  if (result.IsError()) {
    throw NuScenesError(path_ + ": invalid JSON at byte " + std::to_string(result.Offset()) + ": " +
                        rapidjson::GetParseError_En(result.Code()));
  }
  if (!document_.IsObject()) throw NuScenesError(path_ + ": is not an object of layers");
}

void NuScenesMapDocument::checkVersion() const {
  constexpr const char* kNeeded = "; map expansion '1.3' or later is needed";
  const auto version = document_.FindMember("version");
  if (version == document_.MemberEnd()) {
    throw NuScenesError(path_ + ": field version is missing" + kNeeded);
  }
  if (!version->value.IsString()) {
    throw NuScenesError(path_ + ": field version is not a string" + kNeeded);
  }
  if (!isSupported(textOf(version->value))) {
    throw NuScenesError(path_ + ": field version is '" + textOf(version->value) + "'" + kNeeded);
  }
}

void NuScenesMapDocument::fail(const MapRow& row, const char* name,
                               const std::string& problem) const {
  throw NuScenesError(path_ + ": " + row.layer + ": token " + row.token + ": field " + name + " " +
                      problem);
}

const Value& NuScenesMapDocument::layer(const char* name) const {
  const auto found = document_.FindMember(name);
  if (found == document_.MemberEnd()) {
    throw NuScenesError(path_ + ": layer " + name + " is missing");
  }
  return found->value;
}

std::vector<MapRow> NuScenesMapDocument::rows(const char* layer_name) const {
  const Value& array = layer(layer_name);
  if (!array.IsArray()) throw NuScenesError(path_ + ": layer " + layer_name + " is not an array");
  std::vector<MapRow> rows;
  rows.reserve(array.Size());
  for (const Value& value : array.GetArray()) {
    rows.push_back({value, layer_name, tokenOf(value, rows.size())});
  }
  return rows;
}

std::vector<MapRow> NuScenesMapDocument::entries(const char* layer_name) const {
  const Value& object = layer(layer_name);
  if (!object.IsObject())
    throw NuScenesError(path_ + ": layer " + layer_name + " is not an object");
  std::vector<MapRow> entries;
  entries.reserve(object.MemberCount());
  for (const auto& entry : object.GetObject()) {
    entries.push_back({entry.value, layer_name, textOf(entry.name)});
  }
  return entries;
}

std::vector<MapRow> NuScenesMapDocument::elements(const MapRow& array, const char* name) const {
  if (!array.value.IsArray()) fail(array, name, "is not an array");
  std::vector<MapRow> elements;
  for (const Value& value : array.value.GetArray()) {
    elements.push_back({value, array.layer, array.token});
  }
  return elements;
}

const Value& NuScenesMapDocument::field(const MapRow& row, const char* name) const {
  if (!row.value.IsObject()) fail(row, name, "is missing: the row is not an object");
  const auto found = row.value.FindMember(name);
  if (found == row.value.MemberEnd()) fail(row, name, "is missing");
  return found->value;
}

bool NuScenesMapDocument::flag(const MapRow& row, const char* name) const {
  const Value& value = field(row, name);
  if (!value.IsBool()) fail(row, name, "is neither true nor false");
  return value.GetBool();
}

double NuScenesMapDocument::number(const MapRow& row, const char* name) const {
  const Value& value = field(row, name);
  if (!value.IsNumber()) fail(row, name, "is not a number");
  return value.GetDouble();
}

std::string NuScenesMapDocument::text(const MapRow& row, const char* name) const {
  const Value& value = field(row, name);
  if (!value.IsString()) fail(row, name, "is not a string");
  return textOf(value);
}

std::vector<double> NuScenesMapDocument::numbers(const MapRow& row, const char* name,
                                                 std::size_t count) const {
  const Value& array = field(row, name);
  const auto is_number = [](const Value& value) { return value.IsNumber(); };
  if (!array.IsArray() || array.Size() != count ||
      !std::all_of(array.Begin(), array.End(), is_number)) {
    fail(row, name, "is not an array of " + std::to_string(count) + " numbers");
  }
  std::vector<double> numbers;
  for (const Value& value : array.GetArray()) numbers.push_back(value.GetDouble());
  return numbers;
}

std::vector<std::string> NuScenesMapDocument::texts(const MapRow& row, const char* name) const {
  const Value& array = field(row, name);
  const auto is_text = [](const Value& value) { return value.IsString(); };
  if (!array.IsArray() || !std::all_of(array.Begin(), array.End(), is_text)) {
    fail(row, name, "is not an array of strings");
  }
  std::vector<std::string> texts;
  for (const Value& value : array.GetArray()) texts.push_back(textOf(value));
  return texts;
}

}  // namespace forge
