#include "app/workbench/plot/landmarks.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <string_view>

#include "core/base/check.h"

namespace tactus::workbench {

std::string_view landmarksText();

namespace {

// lupdate finds the texts through tactus_data_words.
QString translated(const QJsonObject& entry, const char* key) {
  return QCoreApplication::translate("Landmarks", entry.value(QLatin1String(key)).toString().toUtf8());
}

}  // namespace

std::vector<Landmark> landmarksFor(const fuzzy::Variable& variable) {
  if (variable.id != "depth" || variable.unit != "mm") return {};
  const std::string_view text = landmarksText();
  const QJsonDocument document =
      QJsonDocument::fromJson(QByteArray::fromRawData(text.data(), static_cast<qsizetype>(text.size())));
  const QJsonArray entries = document.object().value(QLatin1String("landmarks")).toArray();
  TACTUS_CHECK(!entries.isEmpty());
  std::vector<Landmark> landmarks;
  for (const QJsonValue& value : entries) {
    const QJsonObject entry = value.toObject();
    Landmark landmark{translated(entry, "name"), entry.value(QLatin1String("from_mm")).toDouble(),
                      entry.value(QLatin1String("to_mm")).toDouble(), translated(entry, "what"),
                      entry.value(QLatin1String("source")).toString()};
    if (landmark.from_mm >= variable.min && landmark.to_mm <= variable.max) landmarks.push_back(std::move(landmark));
  }
  return landmarks;
}

}  // namespace tactus::workbench
