#include "app/cli/commands.h"
#include "app/cli/model_arguments.h"
#include "app/cli/output_file.h"
#include "app/replay/stroke_file.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/json/json_writer.h"
#include "core/base/text.h"
#include "core/contracts/telling_stroke.h"

namespace tactus::cli {
namespace {

using base::formatFixed;
using contracts::TellingStroke;

/// A stroke of less than one just-noticeable difference is not felt, in the mean over its time.
bool isFelt(const TellingStroke& found) { return found.feel.rms_jnd >= 1; }

std::string conditionsText(const fuzzy::ForceModel& model, const contracts::StrokeInputs& inputs,
                           const contracts::Stroke& stroke) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    if (i == inputs.depth || i == inputs.speed) continue;
    parts.push_back(model.inputs[i].id + "=" + base::roundedNumber(stroke.inputs[i]));
  }
  return base::oneLine(base::joined(parts, ","));
}

std::string asText(const fuzzy::ForceModel& model, const contracts::StrokeInputs& inputs, const TellingStroke& found) {
  const auto& feel = found.feel;
  std::string text = isFelt(found) ? "felt: " : "none felt: the best stroke found differs by ";
  text += formatFixed(feel.rms_jnd, 2) + " JND in the mean square over its time\n";
  if (feel.rms_jnd > 0) {
    text += "  insertion from " + formatFixed(found.stroke.from_mm, 1) + " to " + formatFixed(found.stroke.to_mm, 1) +
            " mm, " + formatFixed(found.stroke.peak_mm_s, 0) + " mm/s at its fastest, " +
            conditionsText(model, inputs, found.stroke) + '\n';
    text += "  largest difference " + signedNewtons(feel.largest_n) + ", " + formatFixed(feel.largest_jnd, 2) +
            " JND, at " + formatFixed(feel.at_mm, 1) + " mm\n";
  }
  if (feel.silent > 0) text += "  " + std::to_string(feel.silent) + " of 121 places without a force, left out\n";
  if (!found.bound_jnd) return text + "  no bound: the input space is divided too finely, or was not bounded\n";
  return text + "  nowhere more than " + base::roundedNumber(*found.bound_jnd) + " JND, proved\n";
}

std::string asJson(const TellOptions& options, const fuzzy::ForceModel& model, const contracts::StrokeInputs& inputs,
                   const TellingStroke& found) {
  base::JsonWriter json;
  json.beginObject().key("first").value(options.first).key("second").value(options.second);
  json.key("felt").value(isFelt(found)).key("rms_jnd").value(found.feel.rms_jnd);
  json.key("largest_jnd").value(found.feel.largest_jnd).key("largest_n").value(found.feel.largest_n);
  json.key("at_mm").value(found.feel.at_mm).key("peak_n").value(found.feel.peak_n);
  json.key("places_without_force").value(found.feel.silent);
  json.key("bound_jnd").value(found.bound_jnd).key("parts").value(found.parts);
  json.key("stroke").beginObject().key("from_mm").value(found.stroke.from_mm).key("to_mm").value(found.stroke.to_mm);
  json.key("peak_mm_s").value(found.stroke.peak_mm_s).key("at").beginObject();
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    if (i != inputs.depth && i != inputs.speed) json.key(model.inputs[i].id).value(found.stroke.inputs[i]);
  }
  return json.endObject().endObject().endObject().text();
}

}  // namespace

base::Result<Output> tellApart(const TellOptions& options) {
  if (const auto ok = requireOutput(options.strokes, {options.first, options.second}); !ok)
    return tl::unexpected(ok.error());
  TACTUS_TRY(auto first, openedModel(options.first));
  TACTUS_TRY(auto second, openedModel(options.second));
  std::vector<std::string> warnings = first.warnings;
  warnings.insert(warnings.end(), second.warnings.begin(), second.warnings.end());
  const auto keep_one = [](OpenedModel& opened, const std::string& file, const std::string& id) -> base::Result<void> {
    TACTUS_TRY(const auto expert, expertOption(opened.model, file, id));
    if (!expert) return {};
    fuzzy::Expert one = opened.model.experts[*expert];
    one.weight = 1;
    opened.model.experts = {std::move(one)};
    TACTUS_TRY(auto compiled, fuzzy::compile(opened.model));
    opened.compiled = std::move(compiled);
    return {};
  };
  if (const auto ok = keep_one(first, options.first, options.first_expert); !ok) return tl::unexpected(ok.error());
  if (const auto ok = keep_one(second, options.second, options.second_expert); !ok) return tl::unexpected(ok.error());
  const auto inputs = contracts::strokeInputs(first.model);
  if (!inputs) return base::inFile(inputs.error(), options.first);
  const auto found = contracts::tell(first.model, first.compiled, second.model, second.compiled);
  if (!found) return base::inFile(found.error(), options.second);
  if (!options.strokes.empty()) {
    const std::string text =
        replay::formatStrokes(first.model, {{"tells " + options.first + " from " + options.second, found->stroke}});
    if (const auto ok = base::writeFileAtomically(options.strokes, text); !ok) return tl::unexpected(ok.error());
  }
  return Output{options.json ? asJson(options, first.model, *inputs, *found) : asText(first.model, *inputs, *found),
                std::move(warnings)};
}

}  // namespace tactus::cli
