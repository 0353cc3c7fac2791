// A JSON text as a flat list of values, read strictly: refuses duplicate keys, deep nesting and numbers beyond the
// range of double. The flat list lets a hostile file use little memory and no stack.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/error.h"

namespace tactus::base {

// Describes a JSON syntax error in words for the user.

/// `line 3, column 14` for the byte `at` of `text`. Both count from 1; columns count characters.
std::string linePlace(std::string_view text, std::size_t at);

/// The error if a parser stopped in `text` after `position` bytes. A position beyond the text means its end.
Error syntaxError(std::string_view text, std::size_t position);

// Places in a JSON text (RFC 6901), as errors name them.

/// The pointer of the member `key` of the object at `place`. Escapes `/` and `~` in the key.
std::string childPointer(const std::string& place, std::string_view key);

/// The pointer of element `index` of the array at `place`.
std::string childPointer(const std::string& place, std::size_t index);

enum class JsonKind : std::uint8_t { kNull, kTrue, kFalse, kNumber, kString, kArray, kObject };

class JsonValue;

class JsonDocument {
 public:
  static constexpr std::size_t kDeepest = 64;  ///< nested containers

  /// Parses `text` (UTF-8, less than 4 GiB; a byte order mark is skipped). The outermost value must be an object.
  /// Syntax errors have line and column; other errors have the JSON pointer (RFC 6901) of the value.
  static Result<JsonDocument> parse(std::string_view text);

  /// The outermost object. Values refer to the document; do not move it while they are in use.
  JsonValue root() const;

 private:
  friend class JsonValue;
  friend class JsonBuilder;

  struct Node {
    std::uint32_t next = 0;  ///< index after the last node of this value
    std::uint32_t key_begin = 0;
    std::uint32_t key_size = 0;
    std::uint32_t text_begin = 0;
    std::uint32_t text_size = 0;
    JsonKind kind = JsonKind::kNull;
  };

  std::string_view poolText(std::uint32_t begin, std::uint32_t size) const {
    return std::string_view(pool_).substr(begin, size);
  }

  std::deque<Node> nodes_;  ///< each container is followed by its children
  std::string pool_;        ///< keys, strings and digits of numbers
};

/// One value of a document. Arrays and objects are ranges: `for (const JsonValue child : value)`.
class JsonValue {
 public:
  class Iterator {
   public:
    Iterator(const JsonDocument* document, std::uint32_t index) : document_(document), index_(index) {}
    JsonValue operator*() const { return {document_, index_}; }
    Iterator& operator++() {
      index_ = document_->nodes_[index_].next;
      return *this;
    }
    bool operator!=(const Iterator& other) const { return index_ != other.index_; }

   private:
    const JsonDocument* document_;
    std::uint32_t index_;
  };

  JsonKind kind() const { return node().kind; }
  /// The key of the value in its object; empty in an array.
  std::string_view key() const { return document_->poolText(node().key_begin, node().key_size); }
  /// The characters of a string, or the digits of a number as in the file. Empty for other kinds.
  std::string_view text() const { return document_->poolText(node().text_begin, node().text_size); }
  /// The value of a number.
  double number() const;
  /// The value of `key` in an object, or nothing.
  std::optional<JsonValue> find(std::string_view key) const;

  Iterator begin() const { return {document_, index_ + 1}; }
  Iterator end() const { return {document_, node().next}; }

  /// The pointer (RFC 6901) of this value, e.g. `/inputs/0/terms/2`; empty for the outermost.
  std::string pointer() const;
  /// The value in words for an error: `the string 'x'`, `the number 3`, `an array`.
  std::string description() const;
  /// The value as JSON text on one line; numbers keep their digits.
  std::string json() const;

 private:
  friend class JsonDocument;

  JsonValue(const JsonDocument* document, std::uint32_t index) : document_(document), index_(index) {}
  const JsonDocument::Node& node() const { return document_->nodes_[index_]; }

  const JsonDocument* document_;
  std::uint32_t index_;
};

}  // namespace tactus::base
