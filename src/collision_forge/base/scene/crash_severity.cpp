#include "collision_forge/base/scene/crash_severity.h"

#include <cmath>

#include "collision_forge/base/scene/formatted.h"

namespace forge {

int clockHour(double force_from) {
  constexpr double kHour = M_PI / 6.0;
  const int hour = static_cast<int>(std::lround(-force_from / kHour)) % 12;
  return hour <= 0 ? hour + 12 : hour;
}

std::string severityClass(const CrashEffect& effect) {
  const std::string least = "S" + std::to_string(effect.least_class);
  if (effect.least_class == effect.most_class) return least;
  return least + " to S" + std::to_string(effect.most_class);
}

std::string deltaVText(const CrashEffect& effect) {
  return formatted("%.1f m/s from %d o'clock", effect.delta_v, clockHour(effect.force_from));
}

std::string injuryText(const CrashEffect& effect) {
  if (effect.curve.empty()) return "";
  return formatted("MAIS 3+ %.1f %% (%s), %s", 100.0 * effect.mais3, effect.curve.c_str(),
                   severityClass(effect).c_str());
}

}  // namespace forge
