#include "app/workbench/model/imported_model.h"

#include <QFileInfo>
#include <utility>

#include "app/workbench/model/fresh_path.h"
#include "core/base/files/file.h"

namespace tactus::workbench {

bool isImportPath(const QString& path) { return exchange::isImportPath(path.toStdString()); }

base::Result<exchange::ReadFile> readImport(const QString& path) {
  auto bytes = base::readFile(path.toStdString(), exchange::kMostImportBytes);
  if (!bytes) return tl::unexpected(bytes.error());
  return exchange::ReadFile::read(std::move(*bytes), QFileInfo(path).fileName().toStdString());
}

base::Result<OpenModel> importedModel(const exchange::ReadFile& file, const QString& path, const std::string& output) {
  auto model = file.model(output);
  if (!model) return tl::unexpected(model.error());
  auto ready = editing::ready(std::move(*model));
  if (!ready) return base::inFile(ready.error(), path.toStdString());
  const QFileInfo file_info(path);
  OpenModel open(std::move(*ready));
  open.path = freshModelPath(file_info.absolutePath() + QLatin1Char('/') + file_info.completeBaseName());
  for (const std::string& warning : file.warnings()) open.warnings << QString::fromStdString(warning);
  open.simulated = saysSimulated(open.model);
  return open;
}

}  // namespace tactus::workbench
