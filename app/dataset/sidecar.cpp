#include "app/dataset/sidecar.h"

namespace tactus::dataset {

Sidecar& Sidecar::member(std::string_view name, std::string_view value) {
  json_.key(name).value(value);
  return *this;
}

Sidecar& Sidecar::member(std::string_view name, double value) {
  json_.key(name).value(value);
  return *this;
}

Sidecar& Sidecar::member(std::string_view name, bool value) {
  json_.key(name).value(value);
  return *this;
}

Sidecar& Sidecar::object(std::string_view name, std::string_view description) {
  json_.key(name).beginObject().key("Description").value(description).endObject();
  return *this;
}

Sidecar& Sidecar::column(std::string_view name, std::string_view description, const Levels& levels) {
  json_.key(name).beginObject().key("Description").value(description);
  if (!levels.empty()) {
    json_.key("Levels").beginObject();
    for (const auto& [value, meaning] : levels) json_.key(value).value(meaning);
    json_.endObject();
  }
  json_.endObject();
  return *this;
}

Sidecar& Sidecar::column(std::string_view name, std::string_view description, std::string_view unit) {
  json_.key(name).beginObject().key("Description").value(description).key("Units").value(unit).endObject();
  return *this;
}

}  // namespace tactus::dataset
