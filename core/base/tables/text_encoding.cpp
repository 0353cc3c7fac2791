#include "core/base/tables/text_encoding.h"

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <iconv.h>
#include <optional>
#include <string_view>
#include <utility>

#include "core/base/text.h"

namespace tactus::base {
namespace {

unsigned at(std::string_view bytes, std::size_t i) { return static_cast<unsigned char>(bytes[i]); }

/// `bytes` of the encoding that iconv calls `name`, as UTF-8; nothing where they are not of it, or where the C library
/// does not know it.
std::optional<std::string> converted(std::string_view bytes, const char* name) {
  const iconv_t converter = ::iconv_open("UTF-8", name);
  if (converter == reinterpret_cast<iconv_t>(-1)) return std::nullopt;
  std::string out;
  std::string buffer(std::size_t{1} << 16U, '\0');
  // iconv takes its input by a pointer to non-const and never writes there.
  auto* in = const_cast<char*>(bytes.data());
  std::size_t in_left = bytes.size();
  bool good = true;
  while (good && in_left > 0) {
    char* to = buffer.data();
    std::size_t to_left = buffer.size();
    const bool done = ::iconv(converter, &in, &in_left, &to, &to_left) != static_cast<std::size_t>(-1);
    out.append(buffer.data(), buffer.size() - to_left);
    good = done || errno == E2BIG;
  }
  ::iconv_close(converter);
  if (!good) return std::nullopt;
  return out;
}

/// UTF-16 without a byte order mark: every other byte of the beginning is 0, as it is for ASCII.
const char* utf16Without(std::string_view bytes) {
  constexpr std::size_t kLooked = 64;
  const std::size_t size = std::min(bytes.size(), kLooked) & ~std::size_t{1};
  if (size < 4) return nullptr;
  std::size_t even = 0;
  std::size_t odd = 0;
  for (std::size_t i = 0; i < size; i += 2) {
    if (bytes[i] == '\0') ++even;
    if (bytes[i + 1] == '\0') ++odd;
  }
  if (even == 0 && 2 * odd == size) return "UTF-16LE";
  return odd == 0 && 2 * even == size ? "UTF-16BE" : nullptr;
}

/// How the bytes above 0x7F stand together.
struct HighBytes {
  std::size_t alone = 0;    // runs of an odd number
  std::size_t pairs = 0;    // in runs of an even number
  std::size_t chinese = 0;  // pairs that are common Chinese characters or punctuation
  bool western = true;      // all are characters of Windows-1252
};

HighBytes highBytes(std::string_view bytes) {
  HighBytes out;
  for (std::size_t i = 0; i < bytes.size();) {
    std::size_t end = i;
    while (end < bytes.size() && at(bytes, end) >= 0x80) {
      const unsigned byte = at(bytes, end++);
      if (byte == 0x81 || byte == 0x8D || byte == 0x8F || byte == 0x90 || byte == 0x9D) out.western = false;
    }
    const std::size_t size = end - i;
    if (size % 2 == 1) ++out.alone;
    for (; size % 2 == 0 && i < end; i += 2) {
      ++out.pairs;
      const unsigned lead = at(bytes, i);
      const bool common = (lead >= 0xB0 && lead <= 0xD7) || (lead >= 0xA1 && lead <= 0xA3);
      if (common && at(bytes, i + 1) >= 0xA1) ++out.chinese;
    }
    i = end + 1;
  }
  return out;
}

}  // namespace

Result<DecodedText> decodeText(std::string bytes) {
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.erase(0, 3);
  const char* utf16 = bytes.starts_with("\xFF\xFE") ? "UTF-16LE" : bytes.starts_with("\xFE\xFF") ? "UTF-16BE" : nullptr;
  const std::size_t mark = utf16 != nullptr ? 2 : 0;
  if (utf16 == nullptr) utf16 = utf16Without(bytes);
  if (utf16 != nullptr) {
    auto text = converted(std::string_view(bytes).substr(mark), utf16);
    if (text && isUtf8(*text)) return DecodedText{std::move(*text), "UTF-16"};
    return fail(ErrorCode::kSyntax, {}, "text that begins as UTF-16 and is none", "a table saved as CSV in UTF-8");
  }
  if (isUtf8(bytes)) return DecodedText{std::move(bytes), {}};

  const HighBytes high = highBytes(bytes);
  if (high.chinese > 3 * high.alone && 10 * high.chinese >= 7 * high.pairs) {
    if (auto text = converted(bytes, "GB18030")) return DecodedText{std::move(*text), "GB 18030"};
  }
  if (high.western) {
    if (auto text = converted(bytes, "WINDOWS-1252")) return DecodedText{std::move(*text), "Windows-1252"};
  }
  return fail(ErrorCode::kSyntax, {}, "bytes that are not UTF-8 text, nor plainly Windows-1252 or GB 18030",
              "a CSV table in UTF-8: save it again as \"CSV UTF-8\"");
}

}  // namespace tactus::base
