#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace forge {

/// Assigns numbers 0, 1, 2... to tokens in the order in which they are added. Not thread-safe while
/// tokens are added. A token of 32 lower-case hexadecimal digits (the usual kind) takes 16 bytes
/// plus its hash slot; any other string works too.
class TokenIndex {
 public:
  /// Adds a token if it is new. Returns its number, and true if it was new.
  std::pair<std::uint32_t, bool> add(std::string_view token);
  /// Returns the token's number; nullopt if it was not added.
  std::optional<std::uint32_t> find(std::string_view token) const;
  /// Returns the token with a number that add() returned; no other number is allowed.
  std::string text(std::uint32_t number) const;
  /// Returns the number of tokens.
  std::size_t size() const { return keys_.size(); }

 private:
  /// The two halves of a hexadecimal token.
  struct Key {
    std::uint64_t high = 0;
    std::uint64_t low = 0;
  };

  /// Returns nullopt for a token of another kind.
  static std::optional<Key> keyOf(std::string_view token);
  /// Returns the slot of the key, or the free slot for it.
  std::size_t slotOf(const Key& key) const;
  /// Doubles the slots.
  void grow();

  std::vector<Key> keys_;             ///< by number
  std::vector<std::uint32_t> slots_;  ///< open addressing: number + 1, or 0 if free
  std::unordered_map<std::string, std::uint32_t> other_numbers_;  ///< tokens of another kind
  std::unordered_map<std::uint32_t, std::string> other_texts_;    ///< the same, by number
};

}  // namespace forge
