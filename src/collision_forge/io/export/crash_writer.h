#pragma once

#include <string>
#include <vector>

#include "collision_forge/attack/search/catalogue.h"
#include "collision_forge/io/export/crash_record.h"

namespace forge {

/// Summary of an exported crash, for files that a writer makes of all crashes together.
struct ExportedCrash {
  std::string name;        ///< CrashRecord::name
  std::string scene;       ///< name of the recording
  std::string location;    ///< LaneMap::location
  std::size_t states = 0;  ///< number of the ego's states
};

/// Extension point: writes crashes in the format of another tool (registered in
/// export_formats.cpp).
class CrashWriter {
 public:
  virtual ~CrashWriter() = default;

  /// Writes the files of one crash, each with an AsideFile, and returns their paths relative to
  /// ExportPlan::folder. Called by `forge export` once per crash, concurrently from several
  /// threads: must be thread-safe, must write only files of this crash, and must give the same
  /// bytes for the same record. May throw any std::exception, which ends the export.
  virtual std::vector<std::string> write(const CrashRecord& record) const = 0;

  /// Writes files over all crashes, if the format has any. `crashes`: all exported crashes, earlier
  /// runs included, in the order of the scenario file. Called by `forge export` once, after the
  /// last write(), from one thread. May throw any std::exception, which ends the export.
  virtual void finish(const std::vector<ExportedCrash>& crashes) const { (void)crashes; }
};

/// Configuration of a writer.
struct ExportPlan {
  std::string folder;  ///< output folder; must exist
  /// True: export only the ego's start, the tool drives the ego; false: the ego follows its record.
  bool ego_free = false;
  ExportOptions options;     ///< heights of boxes, lane width and radius for a writer's use
  DriveLimitOptions limits;  ///< vehicle limits by class, for formats that have them
  std::vector<CatalogueEntry> catalogue = {};  ///< names of scenarios, for tags
  /// True: OpenSCENARIO 1.0 as CARLA's ScenarioRunner reads it; false: ASAM's 1.2.
  bool for_carla = false;
};

}  // namespace forge
