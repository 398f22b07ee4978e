#include <filesystem>
#include <fstream>
#include <iostream>

#include "fuzz/targets.h"

/// usage: fuzz_seeds FOLDER: writes the seeds of every target into FOLDER/TARGET.
int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: fuzz_seeds FOLDER\n";
    return 2;
  }
  for (const auto& [target, makeSeeds] : forge::seedMakers()) {
    const std::filesystem::path folder = std::filesystem::path(argv[1]) / target;
    std::filesystem::create_directories(folder);
    int number = 0;
    for (const std::string& seed : makeSeeds()) {
      std::ofstream(folder / ("seed_" + std::to_string(++number)), std::ios::binary) << seed;
    }
  }
  return 0;
}
