#pragma once

#include <sstream>
#include <string>
#include <vector>

namespace forge {

/// A motion decoded from the page's records: s after t0, m.
struct DecodedMotion {
  std::vector<double> t;
  std::vector<double> x;
  std::vector<double> y;
};

/// Decodes the list of a key by summing the differences.
inline std::vector<double> decodedList(const std::string& record, const std::string& key,
                                       double unit) {
  std::istringstream text(record.substr(record.find('"' + key + "\":[") + key.size() + 4));
  std::vector<double> values;
  double sum = 0.0;
  for (double step = 0.0; text >> step; text.ignore(1)) {
    sum += step * unit;
    values.push_back(sum);
  }
  return values;
}

/// Decodes a motion's object (writeStates(), writeTrajectory()).
inline DecodedMotion decodedMotion(const std::string& record) {
  return {decodedList(record, "t", 1e-3), decodedList(record, "x", 1e-2),
          decodedList(record, "y", 1e-2)};
}

}  // namespace forge
