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

namespace forge {
namespace {

namespace fs = std::filesystem;

/// Returns the output file of each bag, in the same order.
std::vector<fs::path> filesOf(const std::vector<std::string>& bags, const fs::path& out) {
  std::map<fs::path, std::string> bag_of;
  std::vector<fs::path> files;
  for (const std::string& bag : bags) {
    files.push_back(out / (fs::path(bag).stem().string() + ".mcap"));
    const auto [other, is_new] = bag_of.emplace(files.back(), bag);
    if (is_new) continue;
    throw std::invalid_argument("--bag " + other->second + " and " + bag +
                                " have the same output file " + files.back().string() +
                                "; export them to different folders");
  }
  return files;
}

/// Returns "" on success, else the error message.
std::string exportOne(const std::string& bag, const std::string& file, const Config& config) {
  ProgressLine progress(fs::path(bag).filename().string());
  try {
    const std::vector<std::string> warnings =
        exportToMcap(bag, file, config, [&](double share) { progress.show(share); });
    printWarnings(file, warnings);
    return "";
  } catch (const std::exception& error) {
    return error.what();
  }
}

}  // namespace

int exportMcap(const std::vector<std::string>& bags, const std::string& out, const Config& config) {
  const std::vector<fs::path> files = filesOf(bags, out);
  const OutputLock lock = OutputLock::ofFolder(out);
  std::size_t written = 0;
  std::size_t before = 0;
  for (std::size_t i = 0; i < bags.size(); ++i) {
    if (fs::exists(files[i])) {
      ++before;
      continue;
    }
    const std::string failure = exportOne(bags[i], files[i].string(), config);
    if (failure.empty()) {
      ++written;
    } else {
      printLine("not exported: " + failure);
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
