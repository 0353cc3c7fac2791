#include "app/workbench/model/imported_model.h"

#include <QFileInfo>
#include <utility>

#include "core/base/files/file.h"

namespace tactus::workbench {
namespace {

/// `pump.tactus.json` beside `pump.fll`; `pump-2.tactus.json` where that exists, and so on.
QString freshPathBeside(const QString& path) {
  const QFileInfo file(path);
  const QString stem = file.absolutePath() + QLatin1Char('/') + file.completeBaseName();
  QString fresh = stem + QStringLiteral(".tactus.json");
  for (int copy = 2; QFileInfo::exists(fresh); ++copy)
    fresh = stem + QLatin1Char('-') + QString::number(copy) + QStringLiteral(".tactus.json");
  return fresh;
}

}  // namespace

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
  OpenModel open(std::move(*ready));
  open.path = freshPathBeside(path);
  for (const std::string& warning : file.warnings()) open.warnings << QString::fromStdString(warning);
  open.simulated = saysSimulated(open.model);
  return open;
}

}  // namespace tactus::workbench
