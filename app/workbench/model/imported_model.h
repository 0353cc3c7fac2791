// Models of other fuzzy programs (FLL, FCL, FIS) as open models.
#pragma once

#include <QString>
#include <string>

#include "app/workbench/model/open_model.h"
#include "core/base/error.h"
#include "core/exchange/import/import_model.h"

namespace tactus::workbench {

/// Whether `path` has the extension of such a file.
bool isImportPath(const QString& path);

/// Reads the file `path`. Messages name the file without its folder.
base::Result<exchange::ReadFile> readImport(const QString& path);

/// The model of the output `output` (empty: of the only one), with the sentences of the importer as its warnings. Its
/// path is one beside `path` that does not exist yet.
base::Result<OpenModel> importedModel(const exchange::ReadFile& file, const QString& path, const std::string& output);

}  // namespace tactus::workbench
