#pragma once

#include <ros/time.h>

#include <cstdint>
#include <vector>

namespace forge {

/// Converts between the two clocks of a bag: header stamps, and the times at which the messages
/// were recorded. The clocks differ by latency, and by much more in a bag that was recorded while
/// another bag was replayed.
class RecordClock {
 public:
  /// Adds a message: its header stamp and the time at which it was recorded. Ignored unless both
  /// times are later than the times of the message added last.
  void add(const ros::Time& stamp, const ros::Time& recorded);

  /// Returns the record time for a stamp. The offset between the clocks is interpolated linearly
  /// between the two neighbouring messages, and constant before the first and after the last one.
  /// Without messages the clocks are equal.
  ros::Time recordedAt(const ros::Time& stamp) const;

  /// Returns the stamp for a record time: the inverse of recordedAt().
  ros::Time stampAt(const ros::Time& recorded) const;

 private:
  struct Message {
    std::int64_t stamp;     // ns
    std::int64_t recorded;  // ns
  };
  /// Returns `time` of the clock `from` on the clock `to`.
  ros::Time converted(const ros::Time& time, std::int64_t Message::*from,
                      std::int64_t Message::*to) const;

  std::vector<Message> messages_;  // both times ascend
};

}  // namespace forge
