// A list of ids with a search by name. Nothing outside core/fuzzy includes this.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string_view>
#include <vector>

namespace tactus::fuzzy {

/// Whether the first and last sizeof(Word) bytes of `a` and `b` agree. Both have the same length, at least
/// sizeof(Word).
template <class Word>
bool haveSameEnds(std::string_view a, std::string_view b) noexcept {
  const auto same_at = [&](std::size_t place) {
    Word of_a, of_b;
    std::memcpy(&of_a, a.data() + place, sizeof(Word));
    std::memcpy(&of_b, b.data() + place, sizeof(Word));
    return of_a == of_b;
  };
  return same_at(0) && same_at(a.size() - sizeof(Word));
}

/// Whether two ids are equal. Most ids are so short that comparing one word at each end is enough; the words may
/// overlap.
inline bool isSameId(std::string_view a, std::string_view b) noexcept {
  constexpr std::size_t kWord = sizeof(std::uint64_t);
  if (a.size() != b.size()) return false;
  if (a.size() >= kWord && a.size() <= 2 * kWord) return haveSameEnds<std::uint64_t>(a, b);
  if (a.size() >= kWord / 2 && a.size() < kWord) return haveSameEnds<std::uint32_t>(a, b);
  return a == b;
}

/// Ids in the order of insertion. The caller keeps the strings alive.
class NameList {
 public:
  void clear() noexcept { ids_.clear(); }
  void reserve(std::size_t count) { ids_.reserve(count); }

  /// Adds `id`. Returns false if the list already contains it.
  bool add(std::string_view id) {
    if (find(id) != kNone) return false;
    ids_.push_back(id);
    return true;
  }

  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

  /// The index of `id`, or kNone.
  std::size_t find(std::string_view id) const noexcept {
    for (std::size_t i = 0; i < ids_.size(); ++i) {
      if (isSameId(ids_[i], id)) return i;
    }
    return kNone;
  }

  bool operator==(const NameList&) const = default;

 private:
  std::vector<std::string_view> ids_;
};

}  // namespace tactus::fuzzy
