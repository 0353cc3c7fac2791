// Models of other fuzzy programs: FLL (fuzzylite), FCL (IEC 61131-7 and fuzzylite), FIS (MATLAB, Octave).
// What is read and what is refused: docs/exchange.md.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/exchange/import/foreign_model.h"
#include "core/fuzzy/force_model.h"

namespace tactus::exchange {

/// `fll`, `fcl`, `fis`: the words of the command line, and the usual extensions.
std::string_view name(ImportFormat format) noexcept;

/// Whether `path` has the usual extension of one of the formats, in any case.
bool isImportPath(std::string_view path);

/// A file that was read completely.
class ReadFile {
 public:
  /// Reads `bytes` of the file `file`. `format`: nothing to tell it from the content, and, where that says nothing,
  /// from the extension. An error has line and column.
  static base::Result<ReadFile> read(std::string bytes, const std::string& file,
                                     std::optional<ImportFormat> format = std::nullopt);
  /// The same for a file on the disk.
  static base::Result<ReadFile> open(const std::string& path, std::optional<ImportFormat> format = std::nullopt);

  ImportFormat format() const { return foreign_.format; }
  /// The names of the outputs. Where there are several, one must be chosen.
  std::vector<std::string> outputs() const;

  /// The force model of `output` (empty: of the only one): one expert, a valid model, without checks, time and
  /// generator. Its notes tell the origin and repeat the warnings. Refused with one sentence: what Tactus cannot carry.
  base::Result<fuzzy::ForceModel> model(const std::string& output = {}) const;

  /// One sentence each, with file, line and column; complete after `model`. At most 101.
  std::vector<std::string> warnings() const { return foreign_.source->warnings(); }

 private:
  explicit ReadFile(ForeignModel foreign) : foreign_(std::move(foreign)) {}

  ForeignModel foreign_;
};

}  // namespace tactus::exchange
