#include "collision_forge/ros/bags/bag_file.h"

#include <filesystem>
#include <mutex>

#include "collision_forge/ros/bags/bag_check.h"

namespace forge {
namespace {

/// Guards construction and destruction of bags, which load and unload an encryption plugin: the
/// plugin loader is not thread-safe.
std::mutex& pluginMutex() {
  static std::mutex mutex;
  return mutex;
}

std::unique_ptr<rosbag::Bag> makeBag() {
  const std::lock_guard<std::mutex> lock(pluginMutex());
  return std::make_unique<rosbag::Bag>();
}

void dropBag(std::unique_ptr<rosbag::Bag>& bag) {
  const std::lock_guard<std::mutex> lock(pluginMutex());
  bag.reset();
}

}  // namespace

OpenedBag::OpenedBag(const std::string& path) : bag_(makeBag()) {
  try {
    if (!std::filesystem::exists(path)) throw BagError(path + ": there is no such file");
    checkBag(path);
    bag_->open(path, rosbag::bagmode::Read);
  } catch (...) {
    dropBag(bag_);
    throw;
  }
}

OpenedBag::~OpenedBag() { dropBag(bag_); }

NewBag::NewBag(const std::string& path) : path_(path), aside_(path), bag_(makeBag()) {
  try {
    bag_->open(aside_.partPath(), rosbag::bagmode::Write);
  } catch (const rosbag::BagException& error) {
    abandon();
    throw BagError(path_ + ": cannot be written: " + error.what());
  }
  bag_->setCompression(rosbag::compression::LZ4);
}

NewBag::~NewBag() {
  try {
    close();
  } catch (const rosbag::BagException&) {
    // Only an uncommitted bag is still open here, and its file is deleted.
  }
}

void NewBag::commit() {
  try {
    close();
  } catch (const rosbag::BagException& error) {
    throw BagError(path_ + ": cannot be completed: " + error.what());
  }
  aside_.commit();
}

void NewBag::close() {
  if (!bag_) return;
  try {
    bag_->close();
  } catch (const rosbag::BagException&) {
    abandon();
    throw;
  }
  dropBag(bag_);
}

// A bag that could not be closed tries again when it is destroyed, and would throw from there.
void NewBag::abandon() { static_cast<void>(bag_.release()); }

}  // namespace forge
