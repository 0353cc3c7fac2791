// The reader of answer files of the web page, fuzzed.
#pragma once

#include <string_view>

namespace tactus::fuzz {

/// Any bytes give answers or one sentence; answers have a check code, and are checked against a form.
void fuzzAnswers(std::string_view bytes);

}  // namespace tactus::fuzz
