#include "core/exchange/import/import_model.h"

#include <utility>

#include "core/base/files/file.h"
#include "core/base/text.h"
#include "core/exchange/import/convert.h"
#include "core/exchange/import/format_guess.h"
#include "core/exchange/import/readers.h"

namespace tactus::exchange {
namespace {

std::string_view fileName(std::string_view path) { return path.substr(path.find_last_of("/\\") + 1); }

}  // namespace

base::Result<ReadFile> ReadFile::read(std::string bytes, const std::string& file, std::optional<ImportFormat> format) {
  if (const auto ok = refuseOthers(bytes, file); !ok) return tl::unexpected(ok.error());
  const auto source = SourceText::decoded(std::move(bytes), file);
  if (!source) return tl::unexpected(source.error());
  if (!format) {
    const auto guessed = guessFormat(**source);
    if (!guessed) return tl::unexpected(guessed.error());
    format = *guessed;
  }
  auto foreign = *format == ImportFormat::kFll   ? readFll(*source)
                 : *format == ImportFormat::kFcl ? readFcl(*source)
                                                 : readFis(*source);
  if (!foreign) return tl::unexpected(foreign.error());
  return ReadFile(std::move(*foreign));
}

base::Result<ReadFile> ReadFile::open(const std::string& path, std::optional<ImportFormat> format) {
  auto bytes = base::readFile(path, kMostImportBytes);
  if (!bytes) return tl::unexpected(bytes.error());
  return read(std::move(*bytes), path, format);
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
