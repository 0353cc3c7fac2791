#include "core/exchange/import/source_text.h"

#include "core/base/json/json_document.h"
#include "core/base/tables/text_encoding.h"
#include "core/base/text.h"

namespace tactus::exchange {
namespace {

using base::ErrorCode;

/// `text` with `\n` for `\r\n` and for `\r`.
std::string withPlainLineEnds(std::string text) {
  if (text.find('\r') == std::string::npos) return text;
  std::string out;
  out.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n') continue;
    out += text[i] == '\r' ? '\n' : text[i];
  }
  return out;
}

}  // namespace

base::Result<std::shared_ptr<SourceText>> SourceText::decoded(std::string bytes, std::string file) {
  const auto refuse = [&file](ErrorCode code, std::string found, std::string wanted) {
    return base::inFile(base::Error{code, {}, {}, std::move(found), std::move(wanted)}, file);
  };
  if (bytes.size() > kMostImportBytes) {
    return refuse(ErrorCode::kLimit, std::to_string(bytes.size()) + " bytes",
                  "at most " + std::to_string(kMostImportBytes));
  }
  auto decoded = base::decodeText(std::move(bytes));
  if (!decoded) return refuse(ErrorCode::kSyntax, "bytes that are no text", "FLL, FCL or FIS in UTF-8");
  std::shared_ptr<SourceText> out(new SourceText(withPlainLineEnds(std::move(decoded->text)), std::move(file)));
  const std::size_t zero = out->text_.find('\0');
  if (zero != std::string::npos) return out->fail(ErrorCode::kSyntax, zero, "a zero byte", "text");
  if (!decoded->encoding.empty())
    out->warnWhole("the text is not UTF-8 and is read as " + decoded->encoding + "; names may have wrong letters");
  return out;
}

base::Error SourceText::error(ErrorCode code, std::size_t at, std::string found, std::string wanted) const {
  return {code, file_, base::linePlace(text_, at), std::move(found), std::move(wanted)};
}

tl::unexpected<base::Error> SourceText::fail(ErrorCode code, std::size_t at, std::string found,
                                             std::string wanted) const {
  return tl::unexpected(error(code, at, std::move(found), std::move(wanted)));
}

tl::unexpected<base::Error> SourceText::failWhole(ErrorCode code, std::string found, std::string wanted) const {
  return tl::unexpected(base::Error{code, file_, {}, std::move(found), std::move(wanted)});
}

void SourceText::warn(std::size_t at, const std::string& sentence) {
  // The place takes a walk through the text, so it is looked for only where it is told.
  if (warnings_.size() < kMostWarnings) {
    warnWhole(base::linePlace(text_, at) + ": " + sentence);
  } else {
    ++more_warnings_;
  }
}

void SourceText::warnWhole(const std::string& sentence) {
  if (warnings_.size() < kMostWarnings) {
    warnings_.push_back(base::oneLine(file_) + ": " + sentence);
  } else {
    ++more_warnings_;
  }
}

std::vector<std::string> SourceText::warnings() const {
  std::vector<std::string> out = warnings_;
  if (more_warnings_ > 0) {
    out.push_back(base::oneLine(file_) + ": " + std::to_string(more_warnings_) + " more warnings are not listed");
  }
  return out;
}

std::optional<double> numberIn(std::string_view text) noexcept {
  if (text.size() > 1 && text.front() == '+' && text[1] != '-') text.remove_prefix(1);
  return base::parseNumber(text);
}

}  // namespace tactus::exchange
