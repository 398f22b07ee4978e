#include "ros/bag_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace forge {

NewBag::NewBag(const std::string& path) : path_(path), part_(path + ".part") {
  try {
    bag_.open(part_, rosbag::bagmode::Write);
  } catch (const rosbag::BagException& error) {
    throw BagError(path_ + ": cannot be written: " + error.what());
  }
  bag_.setCompression(rosbag::compression::LZ4);
}

NewBag::~NewBag() {
  if (part_.empty()) return;
  try {
    bag_.close();
  } catch (const rosbag::BagException&) {
    // The file goes away anyway.
  }
  std::remove(part_.c_str());
}

void NewBag::commit() {
  try {
    bag_.close();
  } catch (const rosbag::BagException& error) {
    throw BagError(path_ + ": cannot be completed: " + error.what());
  }
  if (std::rename(part_.c_str(), path_.c_str()) != 0) {
    throw BagError(path_ + ": cannot be written: " + std::strerror(errno));
  }
  part_.clear();
}

}  // namespace forge
