// A model as a file. Not in libtactus for Windows, which only reads.
#include <string>

#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/fuzzy/validate.h"
#include "core/model_io/model_file.h"

namespace tactus::model_io {

base::Result<std::string> modelText(const fuzzy::ForceModel& model, const std::string& path) {
  if (auto ok = fuzzy::validate(model); !ok) return base::inFile(ok.error(), path);
  std::string text = formatModel(model);
  // What is written must read: this finds text that is not UTF-8, doubled keys, wrong checks, a file beyond the limit.
  TACTUS_TRY(const auto read, parseModel(text, path));
  // JSON text has U+FFFD instead of bytes that are no text, and would read as another name.
  if (text.find("\\ufffd") != std::string::npos && formatModel(read.model) != text) {
    return tl::unexpected(base::Error{
        base::ErrorCode::kSyntax, path, {}, "a name with bytes that are not UTF-8 text", "names that are UTF-8 text"});
  }
  return text;
}

base::Result<void> writeModel(const fuzzy::ForceModel& model, const std::string& path) {
  TACTUS_TRY(const auto text, modelText(model, path));
  return base::writeFileAtomically(path, text);
}

}  // namespace tactus::model_io
