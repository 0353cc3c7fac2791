// The ids of a list, found by name. Nothing outside core/fuzzy includes this.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string_view>
#include <vector>

namespace tactus::fuzzy {

/// Whether `a` and `b`, which are as long as each other and at least as long as a Word, have the same ends.
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

/// Whether two ids are the same. Most are so short that a word at each end, which may overlap, tells.
inline bool isSameId(std::string_view a, std::string_view b) noexcept {
  constexpr std::size_t kWord = sizeof(std::uint64_t);
  if (a.size() != b.size()) return false;
  if (a.size() >= kWord && a.size() <= 2 * kWord) return haveSameEnds<std::uint64_t>(a, b);
  if (a.size() >= kWord / 2 && a.size() < kWord) return haveSameEnds<std::uint32_t>(a, b);
  return a == b;
}

/// Ids in the order in which they were added. The strings must outlive it.
class NameList {
 public:
  void clear() noexcept { ids_.clear(); }
  void reserve(std::size_t count) { ids_.reserve(count); }

  /// False where the list has this id already.
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
