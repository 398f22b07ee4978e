#pragma once

#include <fstream>
#include <sstream>
#include <string>

#include "collision_forge/base/files/fingerprint.h"
#include "collision_forge/base/files/resumable_file.h"

namespace forge {

/// Creates the files of an interrupted run: PATH.part and the checksums of its complete items.
inline void leavePart(const std::string& path, const std::string& text,
                      const ItemLayout& layout = {}) {
  std::ofstream(path + ".part", std::ios::binary) << text;
  std::ofstream sums(path + ".part.sums");
  std::istringstream lines(text);
  std::string line;
  if (!layout.header.empty()) std::getline(lines, line);
  std::string sum;
  std::string item;
  for (std::size_t count = 0; std::getline(lines, line) && !lines.eof();) {
    item += (count == 0 ? "" : "\n") + line;
    if (++count < layout.lines_per_item) continue;
    sum = fingerprint(item, sum);
    sums << sum << '\n';
    item.clear();
    count = 0;
  }
}

}  // namespace forge
