#include "collision_forge/study/evaluation/result_row.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "collision_forge/base/geometry/enum_words.h"
#include "collision_forge/base/scene/formatted.h"
#include "collision_forge/planner_test/statistics/csv_text.h"

namespace forge {
namespace {

constexpr EnumWord<Protocol> kProtocolWords[] = {
    {Protocol::kPublished, "published"},
    {Protocol::kStrict, "strict"},
};

constexpr double kDegree = M_PI / 180.0;  // rad
constexpr std::size_t kFixedColumns = 12;
constexpr double kLargest = 1e9;  // upper limit of valid figures

std::string decimals(const char* format, const std::optional<double>& value) {
  return value ? formatted(format, *value) : "";
}

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> parts(1);
  for (const char character : line) {
    if (character == ',') {
      parts.emplace_back();
    } else {
      parts.back() += character;
    }
  }
  return parts;
}

template <typename Number>
bool parse(const std::string& text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size();
}

bool parse(const std::string& text, std::optional<double>& number) {
  if (text.empty()) return true;
  return parse(text, number.emplace()) && std::abs(*number) <= kLargest;
}

bool parse(const std::string& text, std::optional<bool>& answer) {
  if (text.empty()) return true;
  answer = text == "1";
  return text == "0" || text == "1";
}

const char* const kRequestHeader = "road_allows,believable,attacker,class";
constexpr std::size_t kRequestColumns = 4;

std::vector<std::string> requestColumns(const RequestFacts& facts) {
  std::vector<std::string> columns;
  for (const std::optional<bool>& answer : {facts.road_allows, facts.believable}) {
    columns.push_back(!answer ? "" : *answer ? "1" : "0");
  }
  columns.push_back(csvText(facts.attacker));
  columns.push_back(facts.attacker_class ? toString(*facts.attacker_class) : "");
  return columns;
}

bool parse(const std::vector<std::string>& columns, RequestFacts& facts) {
  if (columns.size() != kRequestColumns) return false;
  facts.attacker = columns[2];
  facts.attacker_class = agentClassFromString(columns[3]);
  return facts.attacker_class.has_value() != columns[3].empty() &&
         parse(columns[0], facts.road_allows) && parse(columns[1], facts.believable);
}

}  // namespace

const char* toString(Protocol protocol) { return wordOf(kProtocolWords, protocol); }

const std::vector<Measure>& measuresOf(Protocol protocol) {
  static const std::vector<Measure> published = {{"collision", "Collision rate", std::nullopt},
                                                 {"similar", "Similarity, of the collisions", 0}};
  static const std::vector<Measure> strict = {
      {"angle_bands", "All conditions, angle bands", std::nullopt},
      {"full_definitions", "All conditions, full definitions", std::nullopt},
      {"contact", "Contact after t0", std::nullopt},
      {"type_angle_bands", "Type, angle bands", std::nullopt},
      {"type_full", "Type, full definitions", std::nullopt},
      {"on_time", "On time", std::nullopt},
      {"limits_kept", "Limits kept", std::nullopt},
      {"nobody_before", "No earlier contact", std::nullopt}};
  return protocol == Protocol::kPublished ? published : strict;
}

std::string csvHeader(Protocol protocol, RowsOf rows_of) {
  std::string text = "name,scene,type,tta,method,seed,status";
  for (const Measure& measure : measuresOf(protocol)) text += "," + measure.name;
  text += ",contact_after,relative_heading,confidence,off_road_share";
  if (rows_of == RowsOf::kRequests) text += std::string(",") + kRequestHeader;
  return text + ",note";
}

std::string toCsv(const ResultRow& row) {
  for (const std::string& name : {row.name, row.scene}) {
    if (csvText(name) != name) {
      throw std::runtime_error("\"" + name +
                               "\" cannot be written to a CSV file: it has commas or line ends");
    }
  }
  std::ostringstream text;
  text << row.name << ',' << row.scene << ',' << toString(row.type) << ',' << row.tta << ','
       << row.method << ',' << row.seed << ',' << csvText(row.status);
  for (const bool met : row.meets) text << ',' << met;
  std::optional<double> degrees = row.relative_heading;
  if (degrees) *degrees /= kDegree;
  text << ',' << decimals("%.3f", row.contact_after) << ',' << decimals("%.2f", degrees);
  for (const auto& share : {row.confidence, row.off_road_share}) {
    text << ',' << decimals("%.4f", share);
  }
  if (row.request) {
    for (const std::string& column : requestColumns(*row.request)) text << ',' << column;
  }
  text << ',' << csvText(row.note);
  return text.str();
}

std::optional<ResultRow> rowFromCsv(const std::string& line, Protocol protocol) {
  const std::vector<std::string> parts = split(line);
  const std::size_t measures = measuresOf(protocol).size();
  const std::size_t columns = kFixedColumns + measures;
  if (parts.size() < columns) return std::nullopt;
  ResultRow row;
  row.name = parts[0];
  row.scene = parts[1];
  row.method = parts[4];
  row.status = parts[6];
  row.note = parts.back();
  const auto type = collisionTypeFromString(parts[2]);
  if (!type || !parse(parts[3], row.tta) || !parse(parts[5], row.seed)) return std::nullopt;
  row.type = *type;
  for (std::size_t i = 0; i < measures; ++i) {
    const std::string& met = parts[7 + i];
    if (met != "0" && met != "1") return std::nullopt;
    row.meets.push_back(met == "1");
  }
  const std::string* part = &parts[7 + measures];
  for (auto* number :
       {&row.contact_after, &row.relative_heading, &row.confidence, &row.off_road_share}) {
    if (!parse(*part++, *number)) return std::nullopt;
  }
  if (row.relative_heading && std::abs(*row.relative_heading) > 180.0) return std::nullopt;
  if (row.relative_heading) *row.relative_heading *= kDegree;
  if (parts.size() == columns) return row;
  const auto rest = parts.begin() + static_cast<std::ptrdiff_t>(columns - 1);
  if (!parse({rest, parts.end() - 1}, row.request.emplace())) return std::nullopt;
  return row;
}

std::vector<ResultRow> readResultRows(const std::string& where, const std::string& lines,
                                      Protocol protocol, const std::string& name) {
  std::vector<ResultRow> rows;
  std::istringstream stream(lines);
  for (std::string line; std::getline(stream, line);) {
    auto row = rowFromCsv(line, protocol);
    if (!row || row->name != name) {
      throw std::runtime_error(where + ": \"" + line + "\" is not a row of \"" + name +
                               "\"; choose another --out");
    }
    rows.push_back(std::move(*row));
  }
  return rows;
}

}  // namespace forge
