#include "core/exchange/import/import_model.h"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/text.h"
#include "core/exchange/import/convert.h"
#include "core/exchange/import/foreign_model.h"

namespace tactus::exchange {

// Which format a file has, told from its content first.

/// An error for the bytes of formats that are known and not read: FML, JSON, MAT and compressed files.
base::Result<void> refuseOthers(std::string_view bytes, const std::string& file);

/// The format of the text, or an error where neither the content nor the extension tells.
base::Result<ImportFormat> guessFormat(const SourceText& source);

namespace {

using base::ErrorCode;

constexpr ImportFormat kFormats[] = {ImportFormat::kFll, ImportFormat::kFcl, ImportFormat::kFis};

bool hasExtension(std::string_view path, ImportFormat format) {
  return base::lowered(path).ends_with("." + std::string(name(format)));
}

/// The first line that is neither empty nor a comment of a line.
std::string_view firstLine(std::string_view text) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.size(), text.find('\n'));
    const std::string_view line = base::trimmed(text.substr(0, end));
    if (!line.empty() && line.front() != '#' && line.front() != '%' && !line.starts_with("//")) return line;
    text.remove_prefix(std::min(text.size(), end + 1));
  }
  return {};
}

std::optional<ImportFormat> fromContent(std::string_view text) {
  const std::string line = base::lowered(firstLine(text).substr(0, 80));
  if (line.starts_with("(*") || line.starts_with("/*")) return ImportFormat::kFcl;
  for (const char* const word : {"function_block", "var_input", "var_output", "fuzzify"}) {
    if (line.starts_with(word)) return ImportFormat::kFcl;
  }
  for (const char* const section : {"[system]", "[input", "[output", "[rules]"}) {
    if (line.starts_with(section)) return ImportFormat::kFis;
  }
  const std::string_view key = base::trimmed(std::string_view(line).substr(0, line.find(':')));
  for (const char* const word : {"engine", "inputvariable", "outputvariable", "ruleblock"}) {
    if (key == word) return ImportFormat::kFll;
  }
  return std::nullopt;
}

}  // namespace

std::string_view name(ImportFormat format) noexcept {
  constexpr std::string_view kNames[] = {"fll", "fcl", "fis"};
  return kNames[static_cast<int>(format)];
}

bool isImportPath(std::string_view path) {
  return std::any_of(std::begin(kFormats), std::end(kFormats),
                     [path](auto format) { return hasExtension(path, format); });
}

base::Result<void> refuseOthers(std::string_view bytes, const std::string& file) {
  const auto refuse = [&file](std::string found) -> base::Result<void> {
    return base::inFile({ErrorCode::kSyntax, {}, {}, std::move(found), "FLL, FCL or FIS"}, file);
  };
  if (bytes.starts_with("MATLAB 5.0 MAT-file")) return refuse("a MAT-file of MATLAB, which is no text");
  if (bytes.starts_with("\x89HDF")) return refuse("a MAT-file of MATLAB 7.3, which is no text");
  if (bytes.starts_with("PK\x03\x04")) return refuse("a compressed file");
  std::string_view start = bytes.substr(bytes.starts_with("\xEF\xBB\xBF") ? 3 : 0, 4096);
  start = start.substr(std::min(start.size(), start.find_first_not_of(" \t\r\n")));
  if (start.starts_with("{")) return refuse("JSON, perhaps a model of Tactus, which needs no import");
  if (start.starts_with("<")) {
    const bool fml = base::lowered(start).find("fuzzysystem") != std::string::npos;
    return refuse(fml ? "FML (IEEE 1855), which Tactus writes and does not read" : "XML");
  }
  return {};
}

base::Result<ImportFormat> guessFormat(const SourceText& source) {
  if (const auto format = fromContent(source.text())) return *format;
  for (const ImportFormat format : kFormats) {
    if (hasExtension(source.file(), format)) return format;
  }
  const std::string_view line = firstLine(source.text());
  return source.failWhole(ErrorCode::kSyntax, line.empty() ? "no text" : base::quoted(line),
                          "the beginning of FLL ('Engine:'), FCL ('FUNCTION_BLOCK') or FIS ('[System]')");
}

namespace {

std::string_view fileName(std::string_view path) { return path.substr(path.find_last_of("/\\") + 1); }

}  // namespace

base::Result<ReadFile> ReadFile::read(std::string bytes, const std::string& file, std::optional<ImportFormat> format) {
  if (const auto ok = refuseOthers(bytes, file); !ok) return tl::unexpected(ok.error());
  TACTUS_TRY(const auto source, SourceText::decoded(std::move(bytes), file));
  if (!format) {
    TACTUS_TRY(const auto guessed, guessFormat(*source));
    format = guessed;
  }
  TACTUS_TRY(auto foreign, *format == ImportFormat::kFll   ? readFll(source)
                           : *format == ImportFormat::kFcl ? readFcl(source)
                                                           : readFis(source));
  return ReadFile(std::move(foreign));
}

base::Result<ReadFile> ReadFile::open(const std::string& path, std::optional<ImportFormat> format) {
  TACTUS_TRY(auto bytes, base::readFile(path, kMostImportBytes));
  return read(std::move(bytes), path, format);
}

std::vector<std::string> ReadFile::outputs() const {
  std::vector<std::string> out;
  for (const ForeignVariable& output : foreign_.outputs) out.emplace_back(output.name.text);
  return out;
}

base::Result<fuzzy::ForceModel> ReadFile::model(const std::string& output) const {
  auto model = converted(foreign_, output);
  if (!model) return model;
  if (foreign_.name.empty()) {
    const std::string_view file = fileName(foreign_.source->file());
    model->name = base::oneLine(file.substr(0, file.rfind('.')));
  }
  std::string notes = "Imported from " + base::oneLine(fileName(foreign_.source->file())) + " (" +
                      std::string(name(foreign_.format)) + "), which states no units.";
  for (const std::string& warning : warnings()) notes += "\n" + warning;
  model->provenance = fuzzy::Provenance{};
  model->provenance->notes = std::move(notes);
  return model;
}

}  // namespace tactus::exchange
