#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace forge {

/// Numbers tokens 0, 1, 2... in the order they are added. Tokens of 32 lower-case hexadecimal
/// digits, the usual ones, take 16 bytes and a few more for the search; any other string works.
class TokenIndex {
 public:
  /// The token's number, and whether it is new.
  std::pair<std::uint32_t, bool> add(std::string_view token);
  std::optional<std::uint32_t> find(std::string_view token) const;
  /// The token of a number that was given out.
  std::string text(std::uint32_t number) const;
  std::size_t size() const { return keys_.size(); }

 private:
  struct Key {
    std::uint64_t high = 0;
    std::uint64_t low = 0;
  };

  static std::optional<Key> keyOf(std::string_view token);
  std::size_t slotOf(const Key& key) const;
  void grow();

  std::vector<Key> keys_;             ///< by number
  std::vector<std::uint32_t> slots_;  ///< open addressing: number + 1, or 0 when free
  std::unordered_map<std::string, std::uint32_t> other_numbers_;
  std::unordered_map<std::uint32_t, std::string> other_texts_;
};

}  // namespace forge
