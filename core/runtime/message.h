// The sentence that a call hands out, and the wall that no exception passes.
#pragma once

#include <cstddef>
#include <exception>
#include <string_view>

#include "tactus/tactus.h"

namespace tactus::runtime {

/// The caller's room for one sentence.
class Message {
 public:
  /// `text`: `size` bytes, or null.
  Message(char* text, std::size_t size) noexcept;

  /// Puts `sentence` there, cut between two characters.
  void say(std::string_view sentence) noexcept;

  /// Says `sentence` and returns `status`.
  tactus_status fail(tactus_status status, std::string_view sentence) noexcept {
    say(sentence);
    return status;
  }

 private:
  char* text_;
  std::size_t size_;
};

/// Runs `work`, which returns a status. Whatever the C++ runtime throws becomes TACTUS_NO_MEMORY: nothing else in this
/// library throws.
template <typename Work>
tactus_status guarded(Message& message, Work&& work) noexcept {
  try {
    return work();
  } catch (const std::exception&) {
    return message.fail(TACTUS_NO_MEMORY, "there is not enough memory");
  }
}

}  // namespace tactus::runtime
