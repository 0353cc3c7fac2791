// Tables on Windows, where libtactus reads those of a bundle alone: they are UTF-8.
#include <utility>

#include "core/base/tables/text_encoding.h"
#include "core/base/text.h"

namespace tactus::base {

Result<DecodedText> decodeText(std::string bytes) {
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.erase(0, 3);
  if (isUtf8(bytes)) return DecodedText{std::move(bytes), {}};
  return fail(ErrorCode::kSyntax, {}, "bytes that are not UTF-8 text", "a CSV table in UTF-8");
}

}  // namespace tactus::base
