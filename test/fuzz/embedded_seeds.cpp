#include "fuzz/embedded_seeds.h"

#include <rapidjson/document.h>
#include <rapidjson/stringbuffer.h>
#include <rapidjson/writer.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <memory>
#include <set>
#include <stdexcept>

#include "collision_forge/io/logs/log_source.h"
#include "collision_forge/io/logs/nuscenes_map.h"
#include "collision_forge/ros/bags/bag_writer.h"
#include "fuzz/reading.h"

namespace forge {
namespace {

using rapidjson::Document;
using rapidjson::Value;
using Tokens = std::set<std::string>;

const std::string kEmbedded = COLLISION_FORGE_SOURCE_DIR "/data/embedded";
const std::string kScene = "scene-0001";
constexpr std::size_t kFrames = 2;
constexpr std::size_t kKeptAgents = 3;  // per frame
constexpr double kRadius = 5.0;         // m around the ego within which the map is kept

Document parsed(const std::string& path) {
  Document document;
  document.Parse(bytesOf(path).c_str());
  if (document.HasParseError()) throw std::runtime_error(path + ": is no JSON");
  return document;
}

std::string written(const Document& document) {
  rapidjson::StringBuffer text;
  rapidjson::Writer<rapidjson::StringBuffer> writer(text);
  document.Accept(writer);
  return text.GetString();
}

std::string textOf(const Value& row, const char* field) {
  return row.HasMember(field) ? row[field].GetString() : "";
}

/// Deletes the rows of a layer or table that are not wanted.
void keepRows(Value& rows, const std::function<bool(const Value& row)>& is_wanted) {
  for (auto row = rows.Begin(); row != rows.End();) {
    row = is_wanted(*row) ? row + 1 : rows.Erase(row);
  }
}

void keepRows(Value& rows, const char* field, const Tokens& tokens) {
  keepRows(rows, [&](const Value& row) { return tokens.count(textOf(row, field)) > 0; });
}

void keepFirst(Value& rows, rapidjson::SizeType count) {
  if (rows.Size() > count) rows.Erase(rows.Begin() + count, rows.End());
}

void keepMembers(Value& object, const Tokens& names) {
  for (auto member = object.MemberBegin(); member != object.MemberEnd();) {
    member = names.count(member->name.GetString()) > 0 ? member + 1 : object.EraseMember(member);
  }
}

Tokens tokensIn(const Value& rows, const char* field) {
  Tokens tokens;
  for (const Value& row : rows.GetArray()) tokens.insert(textOf(row, field));
  return tokens;
}

void addTexts(const Value& texts, Tokens& tokens) {
  for (const Value& text : texts.GetArray()) tokens.insert(text.GetString());
}

/// Returns the tokens of the nodes of all polygons and lines.
Tokens nodesOf(const Document& map) {
  Tokens nodes;
  for (const Value& polygon : map["polygon"].GetArray()) {
    addTexts(polygon["exterior_node_tokens"], nodes);
    for (const Value& hole : polygon["holes"].GetArray()) addTexts(hole["node_tokens"], nodes);
  }
  for (const Value& line : map["line"].GetArray()) addTexts(line["node_tokens"], nodes);
  return nodes;
}

LoggedScene firstFrames() {
  const LogSource source{kEmbedded, ""};
  LoggedScene logged =
      source.format->open(source, {{kScene}, configuration(), {}, {}})->recording(kScene);
  NuScenesRecording& recording = logged.recording;
  recording.frames.resize(kFrames);
  for (NuScenesFrame& frame : recording.frames) {
    frame.annotations.resize(std::min(frame.annotations.size(), kKeptAgents));
  }
  recording.ego_poses.resize(kFrames);
  return logged;
}

LaneMap mapAround(const LoggedScene& logged) {
  return cropped(logged.lanes->map(), {logged.recording.ego_poses[0].translation.head<2>()},
                 kRadius);
}

}  // namespace

std::map<std::string, std::string> embeddedTables() {
  std::map<std::string, Document> tables;
  for (const auto& entry : std::filesystem::directory_iterator(kEmbedded + "/v1.0-embedded")) {
    tables[entry.path().stem().string()] = parsed(entry.path().string());
  }
  keepRows(tables["scene"], "name", {kScene});
  keepRows(tables["log"], "token", tokensIn(tables["scene"], "log_token"));
  keepRows(tables["sample"], "scene_token", tokensIn(tables["scene"], "token"));
  keepFirst(tables["sample"], kFrames);
  const Tokens samples = tokensIn(tables["sample"], "token");
  keepRows(tables["sample_annotation"], "sample_token", samples);
  keepFirst(tables["sample_annotation"], kFrames * kKeptAgents);
  keepRows(tables["instance"], "token", tokensIn(tables["sample_annotation"], "instance_token"));
  keepRows(tables["sample_data"], "sample_token", samples);
  keepRows(tables["ego_pose"], "token", tokensIn(tables["sample_data"], "ego_pose_token"));
  std::map<std::string, std::string> texts;
  for (const auto& [name, table] : tables) texts[name] = written(table);
  return texts;
}

std::string embeddedMap() {
  Document map = parsed(kEmbedded + "/maps/expansion/embedded-left.json");
  keepFirst(map["lane_connector"], 1);
  const std::string connector = textOf(map["lane_connector"][0], "token");
  Tokens lanes = {connector};
  for (const char* links : {"incoming", "outgoing"}) {
    addTexts(map["connectivity"][connector.c_str()][links], lanes);
  }
  keepRows(map["lane"], "token", lanes);
  keepMembers(map["connectivity"], lanes);
  keepMembers(map["arcline_path_3"], lanes);
  Tokens polygons;
  for (auto& layer : map.GetObject()) {
    const std::string name = layer.name.GetString();
    if (!layer.value.IsArray() || name == "polygon" || name == "node") continue;
    if (name != "lane") keepFirst(layer.value, 1);
    for (Value& row : layer.value.GetArray()) {
      if (!row.IsObject()) continue;
      polygons.insert(textOf(row, "polygon_token"));
      if (name != "drivable_area") continue;
      keepFirst(row["polygon_tokens"], 1);
      addTexts(row["polygon_tokens"], polygons);
    }
  }
  keepRows(map["polygon"], "token", polygons);
  keepRows(map["node"], "token", nodesOf(map));
  return written(map);
}

std::string embeddedBag() {
  const LoggedScene logged = firstFrames();
  const InputFolder folder;
  const std::string path = folder.path() + "/" + kScene + ".bag";
  writeBag(path, logged.recording, mapAround(logged));
  return bytesOf(path);
}

}  // namespace forge
