#include "app/workbench/plot/landmarks.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <string_view>

#include "core/base/check.h"

namespace tactus::workbench {

std::string_view landmarksText();

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
    Landmark landmark{entry.value(QLatin1String("name")).toString(), entry.value(QLatin1String("from_mm")).toDouble(),
                      entry.value(QLatin1String("to_mm")).toDouble(), entry.value(QLatin1String("what")).toString(),
                      entry.value(QLatin1String("source")).toString()};
    if (landmark.from_mm >= variable.min && landmark.to_mm <= variable.max) landmarks.push_back(std::move(landmark));
  }
  return landmarks;
}

}  // namespace tactus::workbench
