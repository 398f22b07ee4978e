#include "ros/bag_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <mutex>

namespace forge {
namespace {

namespace fs = std::filesystem;

/// A bag loads and unloads its encryption plugin when it is made and destroyed, and the plugin
/// loader must not do that from two threads at a time.
std::mutex& pluginMutex() {
  static std::mutex mutex;
  return mutex;
}

std::unique_ptr<rosbag::Bag> makeBag() {
  const std::lock_guard<std::mutex> lock(pluginMutex());
  return std::make_unique<rosbag::Bag>();
}

}  // namespace

NewBag::NewBag(const std::string& path) : path_(path), part_(path + ".part"), bag_(makeBag()) {
  if (fs::exists(path_) && !fs::is_regular_file(path_)) {
    throw BagError(path_ + ": is there and no file");
  }
  try {
    bag_->open(part_, rosbag::bagmode::Write);
  } catch (const rosbag::BagException& error) {
    abandon();
    std::remove(part_.c_str());
    throw BagError(path_ + ": cannot be written: " + error.what());
  }
  bag_->setCompression(rosbag::compression::LZ4);
}

NewBag::~NewBag() {
  try {
    close();
  } catch (const rosbag::BagException&) {
    // Only an uncommitted bag gets here open, and its file goes away.
  }
  if (!part_.empty()) std::remove(part_.c_str());
}

void NewBag::commit() {
  try {
    close();
  } catch (const rosbag::BagException& error) {
    throw BagError(path_ + ": cannot be completed: " + error.what());
  }
  if (std::rename(part_.c_str(), path_.c_str()) != 0) {
    throw BagError(path_ + ": cannot be written: " + std::strerror(errno));
  }
  part_.clear();
}

void NewBag::close() {
  if (!bag_) return;
  try {
    bag_->close();
  } catch (const rosbag::BagException&) {
    abandon();
    throw;
  }
  const std::lock_guard<std::mutex> lock(pluginMutex());
  bag_.reset();
}

// A bag that could not be closed tries again when it is destroyed, and would throw from there.
void NewBag::abandon() { static_cast<void>(bag_.release()); }

}  // namespace forge
