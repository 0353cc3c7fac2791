#include <algorithm>

#include "core/base/json/json_members.h"
#include "core/base/json/json_writer.h"
#include "core/procedure/procedure.h"

namespace tactus::procedure {
namespace {

constexpr std::string_view kSetting = "procedure";
constexpr std::string_view kFalls = "falls";
constexpr std::string_view kRises = "rises";

}  // namespace

fuzzy::NamedJson modelSetting(const Procedure& procedure) {
  base::JsonWriter json;
  json.beginObject(base::JsonWriter::Layout::kInline).key("id").value(procedure.id);
  json.key("pack_version").value(static_cast<std::size_t>(procedure.version)).key("sha256").value(procedure.sha256);
  json.key("directions").beginObject();
  for (std::size_t i = 0; i < procedure.inputs.size(); ++i) {
    const Direction direction = procedure.input_notes[i].direction;
    if (direction != Direction::kNone)
      json.key(procedure.inputs[i].id).value(direction == Direction::kFalls ? kFalls : kRises);
  }
  std::string text = json.endObject().endObject().text();
  text.pop_back();  // the newline of a whole file
  return {std::string(kSetting), std::move(text)};
}

ModelProcedure procedureOf(const fuzzy::ForceModel& model) {
  const auto of = [](const Procedure& known) {
    ModelProcedure out{known.id, {}, {}};
    for (std::size_t i = 0; i < known.inputs.size(); ++i)
      out.directions.emplace(known.inputs[i].id, known.input_notes[i].direction);
    return out;
  };
  if (!model.provenance) return of(*defaultProcedure());
  const auto& settings = model.provenance->settings;
  const auto said = std::find_if(settings.begin(), settings.end(), [](const auto& one) { return one.key == kSetting; });
  if (said == settings.end()) return of(*defaultProcedure());
  auto read = base::readJson(said->json, kSetting, [](base::JsonMembers& json, std::optional<base::Error>&) {
    ModelProcedure out;
    json.text("id", out.id);
    json.text("sha256", out.sha256);
    std::vector<base::JsonMembers::NamedText> directions;
    json.texts("directions", directions);
    for (const auto& [input, direction] : directions) {
      out.directions.emplace(input, direction == kFalls   ? Direction::kFalls
                                    : direction == kRises ? Direction::kRises
                                                          : Direction::kNone);
    }
    return out;
  });
  return read ? *std::move(read) : ModelProcedure{};
}

}  // namespace tactus::procedure
