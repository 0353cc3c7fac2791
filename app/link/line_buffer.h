// Lines out of a stream of bytes, with a limit on their length.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace tactus::link {

class LineBuffer {
 public:
  /// Bytes of a line of a client, without its line end.
  static constexpr std::size_t kLongestLine = std::size_t{1} << 20U;

  void add(std::string_view bytes);
  /// The next whole line without its line end, or nothing. Valid until the next call of any function.
  std::optional<std::string_view> next();
  /// Whether `next` would give a line.
  bool hasLine();
  /// Whether the line that is next is longer than the limit. It can then never be read.
  bool isTooLong();
  /// Bytes that are kept.
  std::size_t size() const { return bytes_.size() - begin_; }

 private:
  std::size_t findEnd();

  std::string bytes_;
  std::size_t begin_ = 0;    ///< of the next line
  std::size_t scanned_ = 0;  ///< no line end in [begin_, scanned_)
};

}  // namespace tactus::link
