// Checks used for several parts of a force model. Nothing outside core/fuzzy includes this.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/json/json_document.h"
#include "core/fuzzy/force_model.h"

namespace tactus::fuzzy {

// Places in a model file. The text of a place is made only for an error message. Nothing outside core/fuzzy includes
// this.

/// A member or an element of a parent place. The parent must outlive it.
class Place {
 public:
  Place() = default;

  Place operator[](std::string_view key) const { return {this, key, 0}; }
  Place operator[](std::size_t index) const { return {this, {}, index}; }

  /// The place as a JSON pointer (RFC 6901).
  std::string text() const {
    if (parent_ == nullptr) return {};
    const std::string parent = parent_->text();
    return key_.data() != nullptr ? base::childPointer(parent, key_) : base::childPointer(parent, index_);
  }

 private:
  Place(const Place* parent, std::string_view key, std::size_t index) : parent_(parent), key_(key), index_(index) {}

  const Place* parent_ = nullptr;
  std::string_view key_;
  std::size_t index_ = 0;
};

// A list of ids with a search by name. Nothing outside core/fuzzy includes this.

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

// Values beyond kLargest would overflow the moments of the output set; universes below kNarrowest would underflow.
inline constexpr double kLargest = 1e150;
inline constexpr double kNarrowest = 1e-150;

/// The error of a check, or null if the check passes. Smaller than a Result: one word instead of twenty.
using Problem = std::unique_ptr<base::Error>;

Problem problem(base::ErrorCode code, const Place& place, std::string found, std::string wanted);

/// Whether `value` lies in [min, max]. False for NaN.
inline bool isWithin(double value, double min, double max) noexcept { return value >= min && value <= max; }

/// Checks that the number is finite and in [min, max].
Problem checkNumber(double value, double min, double max, const Place& place);

/// Checks that `count` is between 1 and `most`. `what`: the name of the counted things in the message.
Problem checkCount(std::size_t count, std::size_t most, std::string_view what, const Place& place);

/// Checks that `id` is a valid id and not yet in `seen`, and adds it to `seen`.
Problem checkUnique(NameList& seen, const std::string& id, const Place& place);

/// Checks a list of terms and puts their ids into `names`. `output`: the output variable if the terms belong to it,
/// else null. Output terms must overlap its universe.
Problem checkTerms(const std::vector<Term>& terms, const Variable* output, const Place& place, NameList& names);

}  // namespace tactus::fuzzy
