// The ids of a list, found by name. Nothing outside core/fuzzy includes this.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace tactus::fuzzy {

/// Ids in the order in which they were added. The strings must outlive it.
class NameList {
 public:
  void reserve(std::size_t count) { entries_.reserve(count); }
  void add(std::string_view id) { entries_.push_back({tagOf(id), id}); }

  std::optional<std::size_t> find(std::string_view id) const noexcept {
    const std::uint64_t tag = tagOf(id);
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      if (entries_[i].tag == tag && entries_[i].id == id) return i;
    }
    return std::nullopt;
  }

 private:
  struct Entry {
    std::uint64_t tag;
    std::string_view id;
  };

  /// A few characters and the length: mostly enough to tell the ids of a list apart.
  static std::uint64_t tagOf(std::string_view id) noexcept {
    const auto at = [&id](std::size_t i) { return std::uint64_t{static_cast<unsigned char>(id[i])}; };
    const std::size_t size = id.size();
    return size == 0 ? 0 : size << 24U | at(0) << 16U | at(size / 2) << 8U | at(size - 1);
  }

  std::vector<Entry> entries_;
};

}  // namespace tactus::fuzzy
