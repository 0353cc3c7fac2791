#include "app/workbench/plot/landmarks.h"

#include <QCoreApplication>
#include <string_view>

#include "core/base/check.h"
#include "core/base/json/json_members.h"

namespace tactus::workbench {

std::string_view landmarksText();

namespace {

// lupdate finds the texts through tactus_data_words.
QString translated(const std::string& text) { return QCoreApplication::translate("Landmarks", text.c_str()); }

std::vector<Landmark> readLandmarks(base::JsonMembers& json, std::optional<base::Error>& error) {
  std::vector<Landmark> landmarks;
  for (const base::JsonValue value : json.elements(base::required("landmarks"))) {
    base::JsonMembers entry(value, error);
    std::string name, what, source;
    Landmark& landmark = landmarks.emplace_back();
    entry.text(base::required("name"), name);
    entry.number(base::required("from_mm"), landmark.from_mm);
    entry.number(base::required("to_mm"), landmark.to_mm);
    entry.text(base::required("what"), what);
    entry.text(base::required("source"), source);
    entry.refuseOthers();
    landmark.name = translated(name);
    landmark.what = translated(what);
    landmark.source = QString::fromStdString(source);
  }
  json.refuseOthers();
  return landmarks;
}

}  // namespace

std::vector<Landmark> landmarksFor(const fuzzy::Variable& variable) {
  if (variable.id != "depth" || variable.unit != "mm") return {};
  auto landmarks = base::readJson(landmarksText(), "landmarks.json", readLandmarks);
  TACTUS_CHECK(landmarks.has_value());
  std::erase_if(*landmarks, [&](const Landmark& landmark) {
    return landmark.from_mm < variable.min || landmark.to_mm > variable.max;
  });
  return std::move(*landmarks);
}

}  // namespace tactus::workbench
