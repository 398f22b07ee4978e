#include "collision_forge/app/export_mcap.h"

#include <filesystem>
#include <iostream>
#include <map>
#include <stdexcept>

#include "collision_forge/app/command_line.h"
#include "collision_forge/app/options.h"
#include "collision_forge/base/files/aside_file.h"
#include "collision_forge/base/files/output_lock.h"
#include "collision_forge/base/scene/number_words.h"
#include "collision_forge/io/batch/progress_line.h"
#include "collision_forge/planner_test/settings/config.h"
#include "collision_forge/ros/bags/foxglove_layout.h"
#include "collision_forge/ros/bags/mcap_export.h"
#include "collision_forge/ros/bags/mcap_writer.h"
#include "collision_forge/ros/bags/ros2_folder.h"

namespace forge {
namespace {

namespace fs = std::filesystem;

/// Returns the MCAP file of each bag, in the same order.
std::vector<fs::path> filesOf(const std::vector<std::string>& bags, const fs::path& out,
                              BagExport format) {
  std::map<fs::path, std::string> bag_of;
  std::vector<fs::path> files;
  for (const std::string& bag : bags) {
    const fs::path name = fs::path(bag).stem();
    const fs::path folder = format == BagExport::kRosbag2 ? out / name : out;
    files.push_back(folder / (name.string() + ".mcap"));
    const auto [other, is_new] = bag_of.emplace(files.back(), bag);
    if (is_new) continue;
    throw std::invalid_argument("--bag " + other->second + " and " + bag +
                                " have the same output file " + files.back().string() +
                                "; export them to different folders");
  }
  return files;
}

/// Returns the file that is written last.
fs::path lastFileOf(const fs::path& mcap, BagExport format) {
  return format == BagExport::kRosbag2 ? mcap.parent_path() / kRosbag2Metadata : mcap;
}

/// Returns the error message if an existing file has the other profile, else "". The content of a
/// file that is not MCAP is left to its reader.
std::string profileProblem(const fs::path& existing, BagExport format) {
  const std::string profile = mcapProfileOf(existing.string());
  const std::string wanted = format == BagExport::kMcap ? "ros1" : "ros2";
  if (profile.empty() || profile == wanted) return "";
  return existing.string() + " exists with profile " + profile + ", not " + wanted +
         ": delete it, or choose another --out";
}

/// Returns "" on success, else the error message.
std::string exportOne(const std::string& bag, const fs::path& file, const std::string& out,
                      BagExport format, const Config& config) {
  ProgressLine progress(fs::path(bag).filename().string());
  const McapProfile profile = format == BagExport::kMcap ? McapProfile::kRos1 : McapProfile::kRos2;
  try {
    fs::create_directories(file.parent_path());
    const McapExport made = exportToMcap(bag, file.string(), config, profile,
                                         [&](double share) { progress.show(share); });
    if (profile == McapProfile::kRos2) writeRos2Package(out, made.topics);
    if (format == BagExport::kRosbag2) {
      writeRosbag2Metadata(file.parent_path().string(), file.filename().string(), made);
    }
    printWarnings(file.string(), made.warnings);
    return "";
  } catch (const std::exception& error) {
    std::error_code ignored;
    fs::remove(file, ignored);
    if (format == BagExport::kRosbag2) fs::remove(file.parent_path(), ignored);
    return error.what();
  }
}

}  // namespace

int exportBags(const std::vector<std::string>& bags, const std::string& out, BagExport format,
               const Config& config) {
  const std::vector<fs::path> files = filesOf(bags, out, format);
  const OutputLock lock = OutputLock::ofFolder(out);
  std::size_t written = 0;
  std::size_t before = 0;
  for (std::size_t i = 0; i < bags.size(); ++i) {
    const bool exists = fs::exists(lastFileOf(files[i], format));
    const std::string failure = exists ? profileProblem(files[i], format)
                                       : exportOne(bags[i], files[i], out, format, config);
    if (!failure.empty()) {
      printLine("not exported: " + failure);
    } else if (exists) {
      ++before;
    } else {
      ++written;
    }
  }
  const fs::path layout = fs::path(out) / "layout.json";
  if (written + before > 0 && !fs::exists(layout)) writeText(layout.string(), foxgloveLayout());
  std::cout << written << " of " << counted(bags.size(), "bag") << " exported to " << out;
  if (before > 0) std::cout << ", " << before << " exported before";
  std::cout << "\n";
  return written + before == bags.size() ? kExitOk : kExitError;
}

}  // namespace forge
