#include "collision_forge/io/collide/collide_clip.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string_view>
#include <utility>

#include "collision_forge/base/files/aside_file.h"
#include "collision_forge/base/scene/scene.h"
#include "collision_forge/io/json/input_line.h"

namespace forge {
namespace {

constexpr double kDegree = M_PI / 180.0;  // rad
constexpr double kMicroseconds = 1e6;     // 1/s
constexpr int kMinCollisionFrame = kCollideNowFrame + 1;
constexpr int kMaxPlacement = 5;

constexpr std::array<std::pair<CollisionType, const char*>, 5> kTypeNames = {{
    {CollisionType::kLaneChange, "LC"},
    {CollisionType::kOppositeDirection, "HO"},
    {CollisionType::kRearEnd, "RE"},
    {CollisionType::kJunctionCrossing, "JC"},
    {CollisionType::kLtap, "LTAP"},
}};

enum Column { kTrackId, kTimestamp, kSpeed, kX, kY, kYaw, kColumns };
constexpr std::array<const char*, kColumns> kColumnNames = {"TRACK_ID", "TIMESTAMP", "V",
                                                            "X",        "Y",         "YAW"};

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0;;) {
    const std::size_t end = text.find(separator, begin);
    parts.push_back(text.substr(begin, end - begin));
    if (end == std::string_view::npos) return parts;
    begin = end + 1;
  }
}

template <typename Number>
std::optional<Number> toNumber(std::string_view text) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

// ---- the file's name ----

/// Returns (FRAME - 8) / 12: the time to the collision as the paper gives it to its network.
double normalizedTta(int collision_frame) { return (collision_frame - kMinCollisionFrame) / 12.0; }

class NameParser {
 public:
  explicit NameParser(const std::string& path)
      : path_(path), stem_(std::filesystem::path(path).stem().string()) {}

  CollideName parse() const {
    if (std::filesystem::path(path_).extension() != ".csv") fail("ending", path_, "is not .csv");
    const auto parts = split(stem_, '_');
    if (parts.size() != 10) fail("name", stem_, "has not ten parts between '_'");
    expect(parts[0], "data");
    expect(parts[1], "hcis");
    expect(parts[3], "trainval");
    CollideName name;
    name.batch = text("batch", parts[2]);
    name.city = text("city", parts[4]);
    name.type = type(parts[5]);
    name.scene = text("scene", parts[6]);
    parseCounts(parts[7], name);
    const double degrees = number<double>("angle", parts[8]);
    if (!(degrees >= 0.0 && degrees <= 180.0)) fail("angle", parts[8], "is not within 0 to 180");
    name.angle = degrees * kDegree;
    name.attacker_id = text("attacker", parts[9]);
    return name;
  }

 private:
  [[noreturn]] void fail(const char* field, std::string_view value,
                         const std::string& problem) const {
    throw CollideError(path_ + ": file name: " + field + " = \"" + std::string(value) + "\" " +
                       problem);
  }

  void expect(std::string_view part, const char* wanted) const {
    if (part != wanted) fail("part", part, std::string("is not \"") + wanted + "\"");
  }

  std::string text(const char* field, std::string_view value) const {
    if (value.empty()) fail(field, value, "is empty");
    return std::string(value);
  }

  template <typename Number>
  Number number(const char* field, std::string_view value) const {
    const auto found = toNumber<Number>(value);
    if (!found) fail(field, value, "is not a number");
    return *found;
  }

  CollisionType type(std::string_view value) const {
    for (const auto& [type, name] : kTypeNames) {
      if (value == name) return type;
    }
    fail("type", value, "is not one of LC, HO, RE, JC, LTAP");
  }

  void parseCounts(std::string_view value, CollideName& name) const {
    const auto counts = split(value, '-');
    if (counts.size() != 4) fail("placement-variant-n-frame", value, "has not four parts");
    name.placement = number<int>("placement", counts[0]);
    if (name.placement < 0 || name.placement > kMaxPlacement) {
      fail("placement", counts[0], "is not within 0 to 5");
    }
    name.variant = number<int>("variant", counts[1]);
    name.collision_frame = number<int>("frame", counts[3]);
    if (name.collision_frame < kMinCollisionFrame) fail("frame", counts[3], "is below 8");
    constexpr double kRounding = 1e-6;
    const double normalized = number<double>("n", counts[2]);
    if (!(std::abs(normalized - normalizedTta(name.collision_frame)) <= kRounding)) {
      fail("n", counts[2], "is not (frame - 8) / 12");
    }
  }

  const std::string& path_;
  std::string stem_;
};

/// Returns the shortest text that reads back as the same number, in Python's notation.
std::string shortest(double value) {
  constexpr double kLeastFixed = 1e-4;
  const bool fixed = value == 0.0 || std::abs(value) >= kLeastFixed;
  std::array<char, 512> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                 fixed ? std::chars_format::fixed : std::chars_format::scientific)
                       .ptr;
  std::string text(buffer.data(), end);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

// ---- the rows ----

/// Reads the lines of one file into a clip.
class RowReader {
 public:
  RowReader(const std::string& path, const InputLimits& limits, CollideClip& clip)
      : path_(path), limits_(limits), clip_(clip) {}

  /// Returns the position of the next line, for messages.
  std::string nextWhere() const { return whereOf(line_ + 1); }

  void readHeader(std::string_view line) {
    ++line_;
    const auto names = split(line, ',');
    columns_ = names.size();
    for (std::size_t column = 0; column < kColumns; ++column) {
      const auto found = std::find(names.begin(), names.end(), kColumnNames[column]);
      if (found == names.end()) {
        throw CollideError(path_ + ": line 1: column " + kColumnNames[column] + " is missing");
      }
      places_[column] = static_cast<std::size_t>(found - names.begin());
    }
  }

  void readRow(std::string_view line) {
    ++line_;
    values_ = split(line, ',');
    if (values_.size() != columns_) {
      throw CollideError(where() + std::to_string(values_.size()) + " values, but the header has " +
                         std::to_string(columns_));
    }
    const double speed = within(kSpeed, limits_.max_speed);
    const Pose2 pose{within(kX, limits_.max_coordinate), within(kY, limits_.max_coordinate),
                     real(kYaw) * kDegree};
    const auto timestamp = toNumber<std::int64_t>(value(kTimestamp));
    if (!timestamp) fail(kTimestamp, "is not a whole number of microseconds");
    CollideTrack& track = trackOf(std::string(value(kTrackId)));
    const std::size_t frame = track.frames.size();
    if (frame > static_cast<std::size_t>(clip_.collision_frame)) {
      fail(kTrackId, "has more rows than the " + std::to_string(clip_.collision_frame + 1) +
                         " of the file name's frame");
    }
    const bool is_missing = speed == 0.0 && pose.x == 0.0 && pose.y == 0.0 && pose.yaw == 0.0;
    if (is_missing && (track.id == kEgoId || track.id == clip_.attacker_id)) {
      fail(kTrackId, "is missing in frame " + std::to_string(frame));
    }
    if (!is_missing || *timestamp != 0) checkTimestamp(*timestamp, frame);
    track.frames.push_back(is_missing ? std::nullopt : std::optional<CollideState>({pose, speed}));
  }

  /// Checks the clip after the last row.
  void finish() {
    const auto frames = static_cast<std::size_t>(clip_.collision_frame) + 1;
    for (const CollideTrack& track : clip_.tracks) {
      if (track.frames.size() == frames) continue;
      throw CollideError(path_ + ": TRACK_ID = \"" + track.id + "\" has " +
                         std::to_string(track.frames.size()) + " rows, not the " +
                         std::to_string(frames) + " of the file name's frame");
    }
    for (const std::string& id : {std::string(kEgoId), clip_.attacker_id}) {
      if (numbers_.count(id) == 0) {
        throw CollideError(path_ + ": TRACK_ID = \"" + id + "\" is missing");
      }
    }
    for (std::size_t frame = 0; frame < frames; ++frame) {
      clip_.times.push_back(static_cast<double>(*timestamps_[frame]) / kMicroseconds);
    }
  }

 private:
  std::string where() const { return whereOf(line_) + ": "; }

  std::string whereOf(std::size_t line) const { return path_ + ": line " + std::to_string(line); }

  std::string_view value(Column column) const { return values_[places_[column]]; }

  [[noreturn]] void fail(Column column, const std::string& problem) const {
    throw CollideError(where() + kColumnNames[column] + " = \"" + std::string(value(column)) +
                       "\" " + problem);
  }

  double real(Column column) const {
    const auto number = toNumber<double>(value(column));
    if (!number) fail(column, "is not a number");
    if (!std::isfinite(*number)) fail(column, "is not finite");
    return *number;
  }

  /// Returns a number in [-largest, largest].
  double within(Column column, double largest) const {
    const double number = real(column);
    if (std::abs(number) > largest) {
      std::ostringstream problem;
      problem << "is outside " << -largest << " to " << largest;
      fail(column, problem.str());
    }
    return number;
  }

  CollideTrack& trackOf(const std::string& id) {
    if (id.empty()) fail(kTrackId, "is empty");
    const auto [entry, is_new] = numbers_.emplace(id, clip_.tracks.size());
    if (is_new) clip_.tracks.push_back({id, {}});
    return clip_.tracks[entry->second];
  }

  /// Checks that all tracks have the same timestamp in a frame.
  void checkTimestamp(std::int64_t timestamp, std::size_t frame) {
    if (timestamps_.size() <= frame) timestamps_.resize(frame + 1);
    if (timestamps_[frame] && *timestamps_[frame] != timestamp) {
      fail(kTimestamp,
           "differs from the timestamp of frame " + std::to_string(frame) + " of earlier tracks");
    }
    if (frame > 0 && timestamps_[frame - 1] && timestamp <= *timestamps_[frame - 1]) {
      fail(kTimestamp, "is not after the timestamp of the previous frame");
    }
    timestamps_[frame] = timestamp;
  }

  const std::string& path_;
  const InputLimits& limits_;
  CollideClip& clip_;
  std::size_t line_ = 0;
  std::size_t columns_ = 0;
  std::array<std::size_t, kColumns> places_{};
  std::vector<std::string_view> values_;
  std::map<std::string, std::size_t> numbers_;
  std::vector<std::optional<std::int64_t>> timestamps_;
};

/// Returns degrees that read back as the same radians, with as few digits as possible.
std::string degreesText(double radians) {
  const double degrees = radians / kDegree;
  constexpr int kMaxDigits = 17;
  for (int digits = 1; digits <= kMaxDigits; ++digits) {
    std::array<char, 64> buffer;
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), degrees,
                                   std::chars_format::scientific, digits - 1)
                         .ptr;
    const double rounded =
        *toNumber<double>({buffer.data(), static_cast<std::size_t>(end - buffer.data())});
    if (rounded * kDegree == radians) return shortest(rounded);
  }
  // The division may be off by one bit.
  for (const double near :
       {std::nextafter(degrees, -INFINITY), std::nextafter(degrees, INFINITY)}) {
    if (near * kDegree == radians) return shortest(near);
  }
  return shortest(degrees);
}

void writeRow(std::ostream& out, const CollideTrack& track, double time,
              const std::optional<CollideState>& state) {
  out << track.id << ',' << std::llround(time * kMicroseconds) << ',';
  if (!state) {
    out << "0.0,0.0,0.0,0.0\n";
    return;
  }
  out << shortest(state->speed) << ',' << shortest(state->pose.x) << ',' << shortest(state->pose.y)
      << ',' << degreesText(state->pose.yaw) << '\n';
}

}  // namespace

const CollideTrack& CollideClip::track(const std::string& id) const {
  const auto found = std::find_if(tracks.begin(), tracks.end(),
                                  [&](const CollideTrack& track) { return track.id == id; });
  if (found == tracks.end()) throw std::out_of_range(name + " has no track \"" + id + "\"");
  return *found;
}

const CollideTrack& CollideClip::ego() const { return track(kEgoId); }

CollideName parseCollideName(const std::string& path) { return NameParser(path).parse(); }

std::string composeCollideName(const CollideName& name) {
  for (const std::string& text : {name.batch, name.city, name.scene, name.attacker_id}) {
    if (text.empty() || text.find_first_of("_/") != std::string::npos) {
      throw std::invalid_argument("\"" + text + "\" cannot be part of a clip's name");
    }
  }
  const auto* type = std::find_if(kTypeNames.begin(), kTypeNames.end(),
                                  [&](const auto& entry) { return entry.first == name.type; });
  constexpr double kAngleSteps = 100.0;  // per degree
  const double degrees = std::round(name.angle / kDegree * kAngleSteps) / kAngleSteps;
  std::ostringstream text;
  text << "data_hcis_" << name.batch << "_trainval_" << name.city << '_' << type->second << '_'
       << name.scene << '_' << name.placement << '-' << name.variant << '-'
       << shortest(normalizedTta(name.collision_frame)) << '-' << name.collision_frame << '_'
       << shortest(degrees) << '_' << name.attacker_id << ".csv";
  return text.str();
}

CollideClip readCollideClip(const std::string& path, const InputLimits& limits) {
  CollideClip clip;
  static_cast<CollideName&>(clip) = parseCollideName(path);
  clip.name = std::filesystem::path(path).stem().string();
  std::ifstream file(path, std::ios::binary);
  if (!file) throw CollideError(path + ": cannot be read");
  RowReader reader(path, limits, clip);
  std::string line;
  const auto next = [&] {
    if (!readInputLine(file, line, reader.nextWhere(), limits)) return false;
    if (!line.empty() && line.back() == '\r') line.pop_back();
    return true;
  };
  if (!next()) throw CollideError(path + ": is empty");
  reader.readHeader(line);
  while (next()) reader.readRow(line);
  reader.finish();
  return clip;
}

void writeCollideClip(const std::string& path, const CollideClip& clip) {
  AsideFile file(path);
  std::ostream& out = file.stream();
  for (std::size_t column = 0; column < kColumns; ++column) {
    out << (column > 0 ? "," : "") << kColumnNames[column];
  }
  out << '\n';
  for (const CollideTrack& track : clip.tracks) {
    for (std::size_t frame = 0; frame < track.frames.size(); ++frame) {
      writeRow(out, track, clip.times[frame], track.frames[frame]);
    }
  }
  file.commit();
}

}  // namespace forge
