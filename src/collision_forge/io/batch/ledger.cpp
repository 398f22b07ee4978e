#include "collision_forge/io/batch/ledger.h"

#include <algorithm>
#include <utility>

namespace forge {

Ledger::Ledger(std::size_t first, std::size_t count, std::size_t ahead)
    : next_turn_(first), next_dealt_(first), count_(count), deal_end_(count), ahead_(ahead) {}

std::optional<std::size_t> Ledger::deal() {
  if (next_dealt_ >= deal_end_ || next_dealt_ - next_turn_ >= ahead_) return std::nullopt;
  return next_dealt_++;
}

void Ledger::put(ItemResult result) {
  if (result.error) deal_end_ = std::min(deal_end_, result.index);
  const std::size_t index = result.index;
  waiting_.emplace(index, std::move(result));
}

std::optional<ItemResult> Ledger::next() {
  const auto found = waiting_.find(next_turn_);
  if (found == waiting_.end()) return std::nullopt;
  ItemResult result = std::move(found->second);
  waiting_.erase(found);
  ++next_turn_;
  return result;
}

}  // namespace forge
