#include "app/replay/stroke_file.h"

#include <map>
#include <optional>
#include <utility>

#include "core/base/json/json_members.h"
#include "core/base/json/json_writer.h"
#include "core/base/text.h"

namespace tactus::replay {
namespace {

constexpr std::string_view kFormat = "tactus-strokes";
constexpr base::NumberRange kSpeed{1e-3, 1e6};

bool isMoved(const contracts::StrokeInputs& inputs, std::size_t i) { return i == inputs.depth || i == inputs.speed; }

}  // namespace

std::string formatStrokes(const fuzzy::ForceModel& model, const std::vector<NamedStroke>& strokes) {
  const auto inputs = contracts::strokeInputs(model);
  base::JsonWriter json;
  json.beginObject().key("format").value(kFormat).key("version").value(1).key("strokes").beginArray();
  for (const NamedStroke& one : strokes) {
    json.beginObject(base::JsonWriter::Layout::kInline).key("name").value(one.name);
    json.key("from_mm").value(one.stroke.from_mm).key("to_mm").value(one.stroke.to_mm);
    json.key("peak_mm_s").value(one.stroke.peak_mm_s).key("at").beginObject();
    for (std::size_t i = 0; i < model.inputs.size() && inputs; ++i) {
      if (!isMoved(*inputs, i)) json.key(model.inputs[i].id).value(one.stroke.inputs[i]);
    }
    json.endObject().endObject();
  }
  return json.endArray().endObject().text();
}

base::Result<std::vector<NamedStroke>> parseStrokes(const fuzzy::ForceModel& model, std::string_view text,
                                                    const std::string& file) {
  TACTUS_TRY(const auto inputs, contracts::strokeInputs(model));
  return base::readJson(text, file, [&](base::JsonMembers& members, std::optional<base::Error>& error) {
    std::vector<NamedStroke> out;
    members.format(kFormat);
    members.version(base::required("version"));
    for (const base::JsonValue value : members.elements(base::required("strokes"))) {
      base::JsonMembers one(value, error);
      NamedStroke named;
      std::map<std::string, double> at;
      one.textOrEmpty("name", named.name);
      one.number(base::required("from_mm"), named.stroke.from_mm);
      one.number(base::required("to_mm"), named.stroke.to_mm);
      one.number(base::required("peak_mm_s"), named.stroke.peak_mm_s, kSpeed);
      one.numbers(base::required("at"), at, base::kAnyNumber);
      if (!error && !(named.stroke.to_mm > named.stroke.from_mm))
        one.refuse("to_mm", "a depth behind from_mm, which is " + base::formatNumber(named.stroke.from_mm));
      for (std::size_t i = 0; i < model.inputs.size() && !error; ++i) {
        named.stroke.inputs.push_back(0);
        if (isMoved(inputs, i)) continue;
        const auto found = at.find(model.inputs[i].id);
        if (found == at.end()) {
          one.refuse("at", "a value for " + base::quoted(model.inputs[i].id));
          continue;
        }
        named.stroke.inputs.back() = found->second;
        at.erase(found);
      }
      if (!error && !at.empty())
        one.refuse("at", base::quoted(at.begin()->first), "the inputs of the model but depth and speed",
                   base::ErrorCode::kReference);
      out.push_back(std::move(named));
    }
    return out;
  });
}

}  // namespace tactus::replay
