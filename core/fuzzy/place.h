// Places in a model file. The text of a place is made only for an error message. Nothing outside core/fuzzy includes
// this.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/base/json/json_pointer.h"

namespace tactus::fuzzy {

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

}  // namespace tactus::fuzzy
