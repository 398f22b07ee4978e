#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "collision_forge/io/export/crash_record.h"
#include "collision_forge/io/logs/log_source.h"
#include "collision_forge/planner_test/settings/config.h"

namespace forge {

/// The attacks that forge export converts, addressed by an index from 0 to count() - 1. CrashExport
/// calls record() and where() from worker threads; both are thread-safe.
class AttackSource {
 public:
  virtual ~AttackSource() = default;

  /// Returns the number of attacks.
  virtual std::size_t count() const = 0;
  /// Returns the number that names the attack in the index file, from 1: the line in the scenario
  /// file, or the position in the list of bags.
  virtual std::size_t numberOf(std::size_t index) const = 0;
  /// Returns the place of the attack for messages: "FILE: line NUMBER", or the path of the bag.
  virtual std::string where(std::size_t index) const = 0;
  /// Returns a summary of the whole source, as "12 scenarios" (all lines of the file, also without
  /// an attack) or "1 bag".
  virtual std::string described() const = 0;
  /// Returns the fingerprint of each input (logs and scenario file, or each bag), keyed by a name
  /// for messages. A resumed run is rejected if one has changed. Throws std::runtime_error for an
  /// unreadable bag.
  virtual std::map<std::string, std::string> fingerprints() const = 0;
  /// Returns the record of one attack (crashRecord()), which starts `history` s before t0, or where
  /// the ego's track begins if that is later; its number is numberOf(). Reads the scene or the bag
  /// anew if it is not cached. Throws std::runtime_error (BagError, InputError, ...) if the attack
  /// or its scene cannot be read or is invalid.
  virtual CrashRecord record(std::size_t index, double history) = 0;
};

/// Reads the solved requests (status OK) of the scenario file `path`, in the file's order; their
/// scenes are loaded from `logs` on demand. `jobs`: number of threads that call record(); jobs + 1
/// scenes are cached. Throws JsonLineError for a malformed line, std::runtime_error for a file that
/// cannot be read or has no attacks, and the exceptions of SceneSource. `config` must outlive the
/// result.
std::unique_ptr<AttackSource> openScenarioAttacks(const std::string& path, const LogSource& logs,
                                                  int jobs, const Config& config);

/// Returns the attacks of bags that forge inject wrote, one per bag, in the order of `paths`.
/// record() opens the bag, so this call throws nothing for a missing one. `config` must outlive the
/// result.
std::unique_ptr<AttackSource> openBagAttacks(const std::vector<std::string>& paths,
                                             const Config& config);

}  // namespace forge
