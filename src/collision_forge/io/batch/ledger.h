#pragma once

#include <cstddef>
#include <exception>
#include <map>
#include <optional>
#include <string>

namespace forge {

/// The result of one item: bytes, or the exception that was thrown.
struct ItemResult {
  std::size_t index = 0;
  std::string bytes;
  std::exception_ptr error;
};

/// Tracks which items of [first, count) are assigned and which results wait for their turn. Not
/// thread-safe.
class Ledger {
 public:
  /// At most `ahead` (> 0) items are assigned and not yet returned by next().
  Ledger(std::size_t first, std::size_t count, std::size_t ahead);

  /// Assigns the next item. Returns nullopt if all are assigned, if `ahead` items are pending, and
  /// after an item that failed: later ones are not needed.
  std::optional<std::size_t> deal();

  /// Stores a result, in any order.
  void put(ItemResult result);

  /// Returns the next result in order of index; nullopt if it is not there yet.
  std::optional<ItemResult> next();

  /// Returns true if next() has returned every item.
  bool isFinished() const { return next_turn_ >= count_; }

 private:
  std::size_t next_turn_;
  std::size_t next_dealt_;
  std::size_t count_;
  std::size_t deal_end_;
  std::size_t ahead_;
  std::map<std::size_t, ItemResult> waiting_;
};

}  // namespace forge
