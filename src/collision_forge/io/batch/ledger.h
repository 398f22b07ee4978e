#pragma once

#include <cstddef>
#include <exception>
#include <map>
#include <optional>
#include <string>

namespace forge {

/// The result of one item: bytes, or the exception that was thrown.
struct ItemResult {
  std::size_t index = 0;     ///< of the item
  std::string bytes;         ///< empty after an exception
  std::exception_ptr error;  ///< null: no exception
};

/// Tracks which items of [first, count) are assigned and which results wait for their turn. Use:
/// deal() gives an item to a worker, put() stores its result, next() returns results in order. Not
/// thread-safe.
class Ledger {
 public:
  /// Items are the indices from `first` to `count` - 1. At most `ahead` (> 0) items are assigned
  /// and not yet returned by next().
  Ledger(std::size_t first, std::size_t count, std::size_t ahead);

  /// Assigns the next item and returns its index. Returns nullopt if all are assigned, if `ahead`
  /// items are pending, and after an item that failed: later ones are not needed.
  std::optional<std::size_t> deal();

  /// Stores the result of an assigned item, in any order.
  void put(ItemResult result);

  /// Returns the next result in order of index, each once; nullopt if it is not there yet.
  std::optional<ItemResult> next();

  /// Returns true if next() has returned every item; at once if `first` >= `count`.
  bool isFinished() const { return next_turn_ >= count_; }

 private:
  std::size_t next_turn_;   ///< index of the next result that next() returns
  std::size_t next_dealt_;  ///< index of the next item that deal() assigns
  std::size_t count_;
  std::size_t deal_end_;  ///< end of the items to assign: `count_`, or the first item that failed
  std::size_t ahead_;
  std::map<std::size_t, ItemResult> waiting_;  ///< results by index
};

}  // namespace forge
