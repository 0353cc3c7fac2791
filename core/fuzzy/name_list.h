// The ids of a list, found by name. Nothing outside core/fuzzy includes this.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string_view>
#include <vector>

namespace tactus::fuzzy {

/// Ids in the order in which they were added. The strings must outlive it.
class NameList {
 public:
  void reserve(std::size_t count) { entries_.reserve(count); }
  void add(std::string_view id) { entries_.push_back({Ends(id), id}); }

  std::optional<std::size_t> find(std::string_view id) const noexcept {
    const Ends ends(id);
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      if (entries_[i].ends == ends && (id.size() <= Ends::kWhole || entries_[i].id == id)) return i;
    }
    return std::nullopt;
  }

 private:
  /// Length, first and last eight bytes (four of a short one): the whole id, where it is no longer than kWhole.
  struct Ends {
    static constexpr std::size_t kWord = sizeof(std::uint64_t);
    static constexpr std::size_t kWhole = 2 * kWord;
    std::size_t size;
    std::uint64_t head = 0;
    std::uint64_t tail = 0;

    explicit Ends(std::string_view id) noexcept : size(id.size()) {
      if (size >= kWord) {
        std::memcpy(&head, id.data(), kWord);
        std::memcpy(&tail, id.data() + size - kWord, kWord);
        return;
      }
      constexpr std::size_t kHalf = kWord / 2;
      if (size >= kHalf) {
        std::memcpy(&head, id.data(), kHalf);
        std::memcpy(&tail, id.data() + size - kHalf, kHalf);
        return;
      }
      for (const char c : id) head = head << 8U | static_cast<unsigned char>(c);
    }
    bool operator==(const Ends&) const = default;
  };
  struct Entry {
    Ends ends;
    std::string_view id;
  };

  std::vector<Entry> entries_;
};

}  // namespace tactus::fuzzy
