#include "collision_forge/planner_test/report/report_files.h"

#include <cctype>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "collision_forge/io/json/input_line.h"
#include "collision_forge/io/json/json_line.h"

namespace forge {
namespace {

namespace fs = std::filesystem;

std::ifstream openToRead(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file || fs::is_directory(path)) throw std::runtime_error(path + ": cannot be read");
  return file;
}

/// Returns the kind of a file by its first line.
ReportFileKind kindOf(const std::string& where, const std::string& line) {
  if (!line.empty() && line.front() == '{') {
    const JsonLine parsed(where, line);
    const std::string format = parsed.root().text("format");
    if (format == "collision_forge/scenario") return ReportFileKind::kScenarios;
    if (format == "collision_forge/planner_test") return ReportFileKind::kPlannerTests;
    throw std::runtime_error(where + ": format = \"" + format +
                             "\" is neither the format of scenario files nor of results.jsonl");
  }
  throw std::runtime_error(where + ": is neither a scenario nor a planner-test result");
}

}  // namespace

ReportFile openReportFile(const std::string& path, const InputLimits& limits) {
  std::ifstream file = openToRead(path);
  if (fs::path(path).extension() == ".png") return {path, ReportFileKind::kMaps};
  const std::string where = path + ": line 1";
  std::string line;
  readInputLine(file, line, where, limits);
  return {path, kindOf(where, line)};
}

void readReportLines(const ReportFile& file, const InputLimits& limits,
                     const OnReportLine& on_line) {
  std::ifstream stream = openToRead(file.path);
  const auto size = static_cast<double>(fs::file_size(file.path));
  double read = 0.0;
  std::size_t number = 1;
  const auto where = [&] { return file.path + ": line " + std::to_string(number); };
  for (std::string text; readInputLine(stream, text, where(), limits); ++number) {
    read += static_cast<double>(text.size()) + 1.0;
    on_line(where(), number, text, read / size);
  }
}

std::string linkTo(const std::string& path, const std::string& folder) {
  constexpr const char* kDigits = "0123456789ABCDEF";
  std::string link;
  for (const char character : fs::proximate(fs::absolute(path), fs::absolute(folder)).string()) {
    const auto byte = static_cast<unsigned char>(character);
    if (byte < 128 && (std::isalnum(byte) != 0 || character == '/' || character == '.' ||
                       character == '-' || character == '_')) {
      link += character;
    } else {
      link += {'%', kDigits[byte / 16], kDigits[byte % 16]};
    }
  }
  return link;
}

}  // namespace forge
