#pragma once

#include <rosbag/bag.h>

#include <memory>
#include <string>

#include "collision_forge/base/files/aside_file.h"
#include "collision_forge/ros/bags/bag_error.h"

namespace forge {

/// Returns the name in a bag for a relative topic of topic_names.h: with a leading slash.
inline std::string bagTopic(const char* name) { return std::string("/") + name; }

/// A bag opened for reading. Threads may read different bags at the same time.
class OpenedBag {
 public:
  /// Opens the bag at `path`. Throws BagError for a missing file and a damaged bag (checkBag()),
  /// and rosbag::BagException like rosbag::Bag::open(), BagUnindexedException for a bag without an
  /// index.
  explicit OpenedBag(const std::string& path);
  ~OpenedBag();
  OpenedBag(const OpenedBag&) = delete;
  OpenedBag& operator=(const OpenedBag&) = delete;

  /// Returns the open bag; valid as long as this object.
  const rosbag::Bag& bag() const { return *bag_; }

 private:
  std::unique_ptr<rosbag::Bag> bag_;
};

/// Writes an LZ4 bag to a temporary file beside `path`; commit() renames it (AsideFile), the
/// destructor deletes a file that was not committed. Threads may write different bags at the same
/// time.
class NewBag {
 public:
  /// `path`: file name with extension, in an existing folder; an existing file is replaced by
  /// commit(). Throws BagError if the bag cannot be created, and std::runtime_error if `path`
  /// exists and is no file.
  explicit NewBag(const std::string& path);
  ~NewBag();
  NewBag(const NewBag&) = delete;
  NewBag& operator=(const NewBag&) = delete;

  /// Writes a message with `time`, which must not be 0, as its record time; times may come in any
  /// order. `topic`: with leading slash, see bagTopic().
  /// `message`: a ROS message, or a rosbag::MessageInstance to copy. `header`: header of the
  /// connection; null: default. Throws BagError.
  template <typename Message>
  void write(const std::string& topic, const ros::Time& time, const Message& message,
             const boost::shared_ptr<ros::M_string>& header = {}) {
    try {
      bag_->write(topic, time, message, header);
    } catch (const rosbag::BagException& error) {
      throw BagError(path_ + ": cannot be written: " + error.what());
    }
  }

  /// Writes like a recorded latched publisher, so that rosbag play latches the message again.
  template <typename Message>
  void writeLatched(const std::string& topic, const ros::Time& time, const Message& message) {
    write(topic, time, message, latchedHeader<Message>());
  }

  /// Closes and renames the bag; nothing may be written afterwards. Throws BagError, and
  /// std::runtime_error if renaming fails.
  void commit();

 private:
  /// Returns the header of a connection of a latched publisher of this message type.
  template <typename Message>
  static boost::shared_ptr<ros::M_string> latchedHeader() {
    auto header = boost::make_shared<ros::M_string>();
    (*header)["type"] = ros::message_traits::datatype<Message>();
    (*header)["md5sum"] = ros::message_traits::md5sum<Message>();
    (*header)["message_definition"] = ros::message_traits::definition<Message>();
    (*header)["latching"] = "1";
    return header;
  }

  void close();    // does nothing for a closed bag
  void abandon();  // leaks a bag that cannot be closed: its destructor would throw

  std::string path_;
  AsideFile aside_;
  std::unique_ptr<rosbag::Bag> bag_;  // null after close()
};

}  // namespace forge
