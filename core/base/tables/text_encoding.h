// Converts text from spreadsheets of different countries to UTF-8.
#pragma once

#include <string>

#include "core/base/error.h"

namespace tactus::base {

/// Text in UTF-8 without a byte order mark, and its original encoding.
struct DecodedText {
  std::string text;
  std::string encoding;  ///< `UTF-16`, `Windows-1252` or `GB 18030`; empty for UTF-8
};

/// Decodes `bytes` as UTF-8 if possible. Otherwise as:
/// - UTF-16, if a byte order mark or the zero bytes of ASCII letters indicate it;
/// - GB 18030, if the bytes above 0x7F form pairs that are mostly common Chinese characters (GB 2312, level 1, or its
///   punctuation);
/// - Windows-1252, if some of these bytes stand alone and all are characters there.
/// Returns an error for other bytes. A guess can be wrong for a few letters, so callers report `encoding`.
Result<DecodedText> decodeText(std::string bytes);

}  // namespace tactus::base
