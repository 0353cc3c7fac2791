#include "app/link/line_buffer.h"

#include <algorithm>

namespace tactus::link {

void LineBuffer::add(std::string_view bytes) {
  // What was read is dropped here, not with each line: many short lines cost one move.
  bytes_.erase(0, begin_);
  scanned_ -= begin_;
  begin_ = 0;
  bytes_ += bytes;
}

std::size_t LineBuffer::findEnd() {
  const std::size_t end = bytes_.find('\n', scanned_);
  scanned_ = end == std::string::npos ? bytes_.size() : end;
  return end;
}

bool LineBuffer::hasLine() {
  const std::size_t end = findEnd();
  return end != std::string::npos && end - begin_ <= kLongestLine;
}

bool LineBuffer::isTooLong() { return std::min(findEnd(), bytes_.size()) - begin_ > kLongestLine; }

std::optional<std::string_view> LineBuffer::next() {
  if (!hasLine()) return std::nullopt;
  const auto line = std::string_view(bytes_).substr(begin_, scanned_ - begin_);
  begin_ = scanned_ = scanned_ + 1;
  return line;
}

}  // namespace tactus::link
