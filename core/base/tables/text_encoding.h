// Text as spreadsheets of different countries save it, as UTF-8.
#pragma once

#include <string>

#include "core/base/error.h"

namespace tactus::base {

/// Text in UTF-8 without a byte order mark, and how it was read.
struct DecodedText {
  std::string text;
  std::string encoding;  ///< `UTF-16`, `Windows-1252` or `GB 18030`; empty for UTF-8
};

/// Reads `bytes` as UTF-8; as UTF-16 where a byte order mark or the zeros of its ASCII letters say so; as GB 18030
/// where the bytes above 0x7F come in pairs most of which are common Chinese characters (GB 2312, level 1, or its
/// punctuation); as Windows-1252 where some of them stand alone and all of them are characters there. Other bytes are
/// refused. Guessing can be wrong for a few letters, so callers say what `encoding` is.
Result<DecodedText> decodeText(std::string bytes);

}  // namespace tactus::base
