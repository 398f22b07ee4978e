#include "collision_forge/io/weights/speed_profiles_file.h"

#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>
#include <system_error>

#include "collision_forge/base/files/aside_file.h"

namespace forge {
namespace {

const char* const kColumns =
    "scene,frame,speed,turn_rate,bend_braking,bend_turn,bend_curvature,headway,closing";
constexpr double kRounding = 1e3;
constexpr double kLargest = 150.0;  // in any unit; what is recorded is some tens at most

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> cells;
  std::size_t from = 0;
  for (std::size_t comma = line.find(','); comma != std::string::npos;
       from = comma + 1, comma = line.find(',', from)) {
    cells.push_back(line.substr(from, comma - from));
  }
  cells.push_back(line.substr(from));
  return cells;
}

/// One line of the file while it is read.
class RowReader {
 public:
  RowReader(std::string place, const std::string& line)
      : place_(std::move(place)), cells_(split(line)) {
    if (cells_.size() != split(kColumns).size()) {
      throw SpeedProfilesFileError(place_ + ": \"" + line + "\" has " +
                                   std::to_string(cells_.size()) + " values, not those of " +
                                   kColumns);
    }
  }

  SpeedProfileRow read() {
    SpeedProfileRow row;
    row.scene = cells_[next_++];
    if (row.scene.empty()) throw SpeedProfilesFileError(place_ + ": scene is empty");
    row.frame = number<int>();
    for (double* const value :
         {&row.speed, &row.ahead.turn_rate, &row.ahead.bend_braking, &row.ahead.bend_turn,
          &row.ahead.bend_curvature, &row.ahead.headway, &row.ahead.closing}) {
      *value = measured();
    }
    return row;
  }

 private:
  template <typename Number>
  Number number() {
    const std::string& cell = cells_[next_];
    Number value{};
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (error != std::errc() || end != cell.data() + cell.size() ||
        !std::isfinite(static_cast<double>(value))) {
      throw SpeedProfilesFileError(place_ + ": " + split(kColumns)[next_] + " = \"" + cell +
                                   "\" is not a number");
    }
    ++next_;
    return value;
  }

  double measured() {
    const auto value = number<double>();
    if (std::abs(value) > kLargest) {
      throw SpeedProfilesFileError(place_ + ": " + split(kColumns)[next_ - 1] + " = \"" +
                                   cells_[next_ - 1] + "\" is beyond " +
                                   std::to_string(static_cast<int>(kLargest)));
    }
    return value;
  }

  std::string place_;
  std::vector<std::string> cells_;
  std::size_t next_ = 0;
};

double rounded(double value) { return std::round(value * kRounding) / kRounding + 0.0; }

}  // namespace

SpeedSituations readSpeedSituations(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  if (!std::getline(file, line)) throw SpeedProfilesFileError(path + ": cannot be read");
  if (line != kColumns) {
    throw SpeedProfilesFileError(path + ": line 1 = \"" + line + "\" is not " + kColumns);
  }
  std::vector<SpeedProfileRow> rows;
  for (std::size_t number = 2; std::getline(file, line); ++number) {
    rows.push_back(RowReader(path + ": line " + std::to_string(number), line).read());
  }
  if (file.bad()) throw SpeedProfilesFileError(path + ": cannot be read");
  try {
    return SpeedSituations(std::move(rows));
  } catch (const std::invalid_argument& error) {
    throw SpeedProfilesFileError(path + ": " + error.what());
  }
}

SpeedProfiles readSpeedProfiles(const std::string& path, const SpeedProfileOptions& options) {
  return SpeedProfiles(readSpeedSituations(path), options);
}

void writeSpeedProfiles(const std::vector<SpeedProfileRow>& rows, const std::string& path) {
  AsideFile aside(path);
  std::ostream& file = aside.stream();
  file << kColumns << '\n';
  for (const SpeedProfileRow& row : rows) {
    file << row.scene << ',' << row.frame;
    for (const double value :
         {row.speed, row.ahead.turn_rate, row.ahead.bend_braking, row.ahead.bend_turn,
          row.ahead.bend_curvature, row.ahead.headway, row.ahead.closing}) {
      file << ',' << rounded(value);
    }
    file << '\n';
  }
  aside.commit();
}

}  // namespace forge
