#pragma once

#include <string>
#include <vector>

#include "collision_forge/io/export/crash_record.h"

namespace forge {

/// What is known of a crash that was exported, for what a writer makes of all of them together.
struct ExportedCrash {
  std::string name;
  std::string scene;
  std::string location;
  std::size_t states = 0;  ///< of the ego
};

/// Writes crashes in a format of other tools. write() is called on many threads.
class CrashWriter {
 public:
  virtual ~CrashWriter() = default;

  /// Writes the files of a crash, each aside and renamed, and returns their paths as seen from the
  /// folder. The same record gives the same bytes.
  virtual std::vector<std::string> write(const CrashRecord& record) const = 0;

  /// What the format wants of all crashes together; called once, when all are written.
  virtual void finish(const std::vector<ExportedCrash>& crashes) const { (void)crashes; }
};

/// What writers are made for.
struct ExportPlan {
  std::string folder;     ///< exists
  bool ego_free = false;  ///< the ego has a start alone: the tool drives it
  ExportOptions options;
  DriveLimitOptions limits;
};

}  // namespace forge
