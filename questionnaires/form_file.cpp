#include "questionnaires/form_file.h"

#include <utility>

#include "core/base/check.h"
#include "core/base/json/json_members.h"

namespace tactus::questionnaires {
namespace {

using base::JsonMembers;
using base::required;

constexpr base::NumberRange kScaleNumbers{1, 1'000'000};
constexpr base::NumberRange kPoints{2, 101};

void readItems(JsonMembers& json, std::vector<ScaleItem>& items, std::optional<base::Error>& error) {
  for (const base::JsonValue value : json.elements(required("items"))) {
    JsonMembers members(value, error);
    ScaleItem item;
    members.integer(required("number"), item.number, kScaleNumbers);
    members.text(required("text"), item.text);
    members.refuseOthers();
    for (const auto& earlier : items) {
      if (earlier.number == item.number) {
        members.refuse("number", std::to_string(item.number) + " again", "each number once");
      }
      if (earlier.text == item.text) {
        members.refuse("text", "the statement of item " + std::to_string(earlier.number),
                       "another statement for each item");
      }
    }
    items.push_back(std::move(item));
  }
  if (items.empty()) json.refuse("items", "no items", "at least one item");
}

}  // namespace

base::Result<ScaleForm> parseScaleForm(std::string_view text, const std::string& file) {
  return base::readJson(text, file, [](JsonMembers& json, std::optional<base::Error>& error) {
    ScaleForm form;
    json.format("tactus-scale-form");
    json.text(required("id"), form.id);
    json.text(required("title"), form.title);
    json.text(required("source"), form.source);
    json.text(required("low"), form.low);
    json.text(required("high"), form.high);
    json.integer(required("version"), form.version, kScaleNumbers);
    json.integer(required("points"), form.points, kPoints);
    readItems(json, form.items, error);
    json.refuseOthers();
    return form;
  });
}

ScaleForm usabilityForm() {
  auto read = parseScaleForm(usabilityFormJson(), "usability_v1.json");
  TACTUS_CHECK(read.has_value());
  return std::move(*read);
}

}  // namespace tactus::questionnaires
