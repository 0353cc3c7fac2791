#include "core/runtime/message.h"

#include <algorithm>

namespace tactus::runtime {

Message::Message(char* text, std::size_t size) noexcept : text_(size > 0 ? text : nullptr), size_(size) {
  if (text_ != nullptr) *text_ = '\0';
}

void Message::say(std::string_view sentence) noexcept {
  if (text_ == nullptr) return;
  std::size_t length = std::min(sentence.size(), size_ - 1);
  if (length < sentence.size()) {
    // Bytes 10xxxxxx continue a character.
    while (length > 0 && (static_cast<unsigned char>(sentence[length]) & 0xC0U) == 0x80U) --length;
  }
  std::copy_n(sentence.begin(), length, text_);
  text_[length] = '\0';
}

}  // namespace tactus::runtime
