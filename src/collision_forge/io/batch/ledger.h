#pragma once

#include <cstddef>
#include <exception>
#include <map>
#include <optional>
#include <string>

namespace forge {

/// What came of one item: bytes, or the exception that was thrown.
struct ItemResult {
  std::size_t index = 0;
  std::string bytes;
  std::exception_ptr error;
};

/// Which items of [first, count) are dealt, and which results wait for their turn. Not thread-safe.
class Ledger {
 public:
  /// At most `ahead` (> 0) items are dealt and not yet handed on by next().
  Ledger(std::size_t first, std::size_t count, std::size_t ahead);

  /// The next item to work on; empty when all are dealt, when too many are under way, and after an
  /// item that failed: what comes after it is not needed.
  std::optional<std::size_t> deal();

  /// Takes a result, in any order.
  void put(ItemResult result);

  /// The result whose turn it is by index; empty while it is not there.
  std::optional<ItemResult> next();

  /// True when every item was handed on.
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
