#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "collision_forge/io/export/crash_record.h"
#include "collision_forge/io/logs/log_source.h"
#include "collision_forge/planner_test/settings/config.h"

namespace forge {

/// The attacks that forge export writes, by index. record() is thread-safe.
class AttackSource {
 public:
  virtual ~AttackSource() = default;

  virtual std::size_t count() const = 0;
  /// From 1: of a scenario file its line, of bags the number.
  virtual std::size_t numberOf(std::size_t index) const = 0;
  /// Where it stands, for messages.
  virtual std::string where(std::size_t index) const = 0;
  /// What the attacks are of, for people.
  virtual std::string described() const = 0;
  /// What the records depend on beside the configuration of results.
  virtual std::map<std::string, std::string> fingerprints() const = 0;
  /// `history`: s before now. Throws what is wrong with an attack.
  virtual CrashRecord record(std::size_t index, double history) = 0;
};

/// The lines of a scenario file that are attacks, over their scenes. Throws JsonLineError for a
/// line that is no scenario, std::runtime_error for a file without attacks, and as SceneSource.
std::unique_ptr<AttackSource> openScenarioAttacks(const std::string& path, const LogSource& logs,
                                                  int jobs, const Config& config);

/// Bags of forge inject.
std::unique_ptr<AttackSource> openBagAttacks(const std::vector<std::string>& paths,
                                             const Config& config);

}  // namespace forge
