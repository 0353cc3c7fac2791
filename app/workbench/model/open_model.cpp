#include "app/workbench/model/open_model.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSettings>
#include <algorithm>
#include <utility>

#include "app/workbench/model/edit_controller.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/model_io/model_file.h"
#include "core/procedure/procedure.h"

namespace tactus::workbench {
namespace {

constexpr auto kKey = "author";

}  // namespace

AuthorName::AuthorName(QSettings& settings, EditController& edits, QObject* parent)
    : QObject(parent), settings_(settings), edits_(edits) {
  edits_.setAuthor(name());
}

QString AuthorName::name() const { return settings_.value(QLatin1String(kKey)).toString(); }

void AuthorName::setName(const QString& name) {
  settings_.setValue(QLatin1String(kKey), name.trimmed());
  edits_.setAuthor(name);
}

QString freshModelPath(const QString& stem) {
  QString fresh = stem + QStringLiteral(".tactus.json");
  for (int copy = 2; QFileInfo::exists(fresh); ++copy)
    fresh = stem + QLatin1Char('-') + QString::number(copy) + QStringLiteral(".tactus.json");
  return fresh;
}

base::Result<OpenModel> templateModel(const procedure::Procedure& procedure, const QString& name,
                                      const QString& folder) {
  fuzzy::ForceModel model;
  model.name = name.toStdString();
  model.inputs = procedure.inputs;
  model.output = procedure.output;
  fuzzy::Expert expert;
  expert.id = expert.label = "E1";
  model.experts.push_back(std::move(expert));
  TACTUS_TRY(auto ready, editing::ready(std::move(model)));
  OpenModel open(std::move(ready));
  open.path = freshModelPath(QDir(folder).absoluteFilePath(QString::fromStdString(procedure.id)));
  return open;
}

bool isImportPath(const QString& path) { return exchange::isImportPath(path.toStdString()); }

base::Result<exchange::ReadFile> readImport(const QString& path) {
  TACTUS_TRY(auto bytes, base::readFile(path.toStdString(), exchange::kMostImportBytes));
  return exchange::ReadFile::read(std::move(bytes), QFileInfo(path).fileName().toStdString());
}

base::Result<OpenModel> importedModel(const exchange::ReadFile& file, const QString& path, const std::string& output) {
  TACTUS_TRY(auto model, file.model(output));
  auto ready = editing::ready(std::move(model));
  if (!ready) return base::inFile(ready.error(), path.toStdString());
  const QFileInfo file_info(path);
  OpenModel open(std::move(*ready));
  open.path = freshModelPath(file_info.absolutePath() + QLatin1Char('/') + file_info.completeBaseName());
  for (const std::string& warning : file.warnings()) open.warnings << QString::fromStdString(warning);
  open.simulated = saysSimulated(open.model);
  return open;
}

namespace {

bool mentions(const QString& text) { return text.contains(QLatin1String("simulated"), Qt::CaseInsensitive); }

bool saysYes(const QJsonValue& value) {
  switch (value.type()) {
    case QJsonValue::Bool: return value.toBool();
    case QJsonValue::Double: return value.toDouble() != 0;
    case QJsonValue::String: return !value.toString().isEmpty();
    case QJsonValue::Array: return !value.toArray().isEmpty();
    case QJsonValue::Object: return !value.toObject().isEmpty();
    default: return false;
  }
}

// Qt's parser refuses JSON that nests deeper than 1024 levels, so this recursion is bounded.
bool mentions(const QJsonValue& value) {
  if (value.isString()) return mentions(value.toString());
  if (value.isArray()) {
    const QJsonArray array = value.toArray();
    return std::any_of(array.begin(), array.end(), [](const QJsonValue& item) { return mentions(item); });
  }
  const QJsonObject object = value.toObject();
  for (auto it = object.begin(); it != object.end(); ++it) {
    if ((mentions(it.key()) && saysYes(it.value())) || mentions(QJsonValue(it.value()))) return true;
  }
  return false;
}

bool mentions(const std::vector<fuzzy::NamedJson>& members) {
  return std::any_of(members.begin(), members.end(), [](const fuzzy::NamedJson& member) {
    // A bare value is not a JSON document for Qt, so each is wrapped in an object under its key.
    const QByteArray value = QByteArray::fromStdString(member.json);
    const QJsonValue parsed = QJsonDocument::fromJson("{\"v\":" + value + '}').object().value(QLatin1String("v"));
    return (mentions(QString::fromStdString(member.key)) && saysYes(parsed)) || mentions(parsed);
  });
}

template <typename Named>
std::optional<std::size_t> placeOf(const std::vector<Named>& all, const std::string& id) {
  const auto found = std::find_if(all.begin(), all.end(), [&id](const Named& one) { return one.id == id; });
  return found == all.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - all.begin()));
}

}  // namespace

std::optional<std::size_t> inputNamed(const fuzzy::ForceModel& model, const std::string& id) {
  return placeOf(model.inputs, id);
}

std::optional<std::size_t> expertNamed(const fuzzy::ForceModel& model, const std::string& id) {
  return placeOf(model.experts, id);
}

base::Result<OpenModel> readOpenModel(const QString& path) {
  TACTUS_TRY(auto read, model_io::readModel(path.toStdString()));
  auto ready = editing::ready(std::move(read.model));
  if (!ready) return base::inFile(ready.error(), path.toStdString());

  OpenModel open(std::move(*ready));
  open.path = path;
  for (const std::string& warning : read.warnings) open.warnings << QString::fromStdString(warning);
  open.simulated = saysSimulated(open.model);
  return open;
}

bool saysSimulated(const fuzzy::ForceModel& model) {
  const bool by_expert = std::any_of(model.experts.begin(), model.experts.end(), [](const fuzzy::Expert& expert) {
    return mentions(QString::fromStdString(expert.label));
  });
  if (by_expert || mentions(QString::fromStdString(model.name))) return true;
  if (!model.provenance) return false;
  const fuzzy::Provenance& from = *model.provenance;
  return mentions(QString::fromStdString(from.study)) || mentions(QString::fromStdString(from.notes)) ||
         mentions(from.settings) || mentions(from.sources);
}

}  // namespace tactus::workbench
