#include "collision_forge/io/logs/nuscenes_tokens.h"

namespace forge {
namespace {

constexpr std::size_t kDigits = 32;
constexpr std::size_t kFirstSlots = 1024;

std::optional<std::uint64_t> hexadecimal(std::string_view digits) {
  std::uint64_t value = 0;
  for (const char digit : digits) {
    const bool is_number = digit >= '0' && digit <= '9';
    if (!is_number && (digit < 'a' || digit > 'f')) return std::nullopt;
    value = value << 4 | static_cast<std::uint64_t>(is_number ? digit - '0' : digit - 'a' + 10);
  }
  return value;
}

}  // namespace

std::optional<TokenIndex::Key> TokenIndex::keyOf(std::string_view token) {
  if (token.size() != kDigits) return std::nullopt;
  const auto high = hexadecimal(token.substr(0, kDigits / 2));
  const auto low = hexadecimal(token.substr(kDigits / 2));
  if (!high || !low) return std::nullopt;
  return Key{*high, *low};
}

/// Returns the slot of the key, or the free slot for it.
std::size_t TokenIndex::slotOf(const Key& key) const {
  const std::size_t mask = slots_.size() - 1;
  const std::uint64_t mixed = (key.high ^ key.low * 0x9e3779b97f4a7c15ULL) * 0xbf58476d1ce4e5b9ULL;
  std::size_t slot = (mixed >> 32) & mask;
  while (slots_[slot] != 0) {
    const Key& other = keys_[slots_[slot] - 1];
    if (other.high == key.high && other.low == key.low) break;
    slot = (slot + 1) & mask;
  }
  return slot;
}

void TokenIndex::grow() {
  slots_.assign(slots_.empty() ? kFirstSlots : 2 * slots_.size(), 0);
  for (std::uint32_t number = 0; number < keys_.size(); ++number) {
    if (other_texts_.count(number) == 0) slots_[slotOf(keys_[number])] = number + 1;
  }
}

std::pair<std::uint32_t, bool> TokenIndex::add(std::string_view token) {
  const auto next = static_cast<std::uint32_t>(keys_.size());
  const std::optional<Key> key = keyOf(token);
  if (!key) {
    const auto [entry, is_new] = other_numbers_.try_emplace(std::string(token), next);
    if (is_new) {
      other_texts_.emplace(next, token);
      keys_.emplace_back();
    }
    return {entry->second, is_new};
  }
  if (2 * (keys_.size() + 1) > slots_.size()) grow();
  const std::size_t slot = slotOf(*key);
  if (slots_[slot] != 0) return {slots_[slot] - 1, false};
  keys_.push_back(*key);
  slots_[slot] = next + 1;
  return {next, true};
}

std::optional<std::uint32_t> TokenIndex::find(std::string_view token) const {
  const std::optional<Key> key = keyOf(token);
  if (!key) {
    const auto entry = other_numbers_.find(std::string(token));
    if (entry == other_numbers_.end()) return std::nullopt;
    return entry->second;
  }
  if (slots_.empty()) return std::nullopt;
  const std::uint32_t found = slots_[slotOf(*key)];
  if (found == 0) return std::nullopt;
  return found - 1;
}

std::string TokenIndex::text(std::uint32_t number) const {
  const auto other = other_texts_.find(number);
  if (other != other_texts_.end()) return other->second;
  std::string digits(kDigits, '0');
  for (std::size_t i = 0; i < kDigits; ++i) {
    const std::uint64_t half = i < kDigits / 2 ? keys_[number].high : keys_[number].low;
    digits[i] = "0123456789abcdef"[half >> (60 - 4 * (i % (kDigits / 2))) & 15];
  }
  return digits;
}

}  // namespace forge
