#include "app/workbench/participant/own_model.h"

#include <algorithm>
#include <chrono>
#include <numeric>

#include "app/session/study_source.h"
#include "app/session/session_notes.h"
#include "app/session/study_view.h"
#include "app/version.h"
#include "core/base/clock.h"
#include "core/fuzzy/compiled_model.h"
#include "core/model_io/model_file.h"
#include "elicitation/model/model_builder.h"

namespace tactus::workbench {
namespace {

using base::Result;

constexpr auto kDepthInput = "depth";
constexpr auto kNeckInput = "neck_flexion";
constexpr int kCurvePoints = 200;  // one a few pixels

template <class Row>
void keepOnly(std::vector<Row>& rows, const std::string& code) {
  std::erase_if(rows, [&](const Row& row) { return row.participant != code; });
}

/// What one participant told the study.
study::Study dataOf(study::Study all, const std::string& code) {
  std::erase_if(all.participants, [&](const study::Participant& one) { return one.code != code; });
  keepOnly(all.speeds, code);
  keepOnly(all.judgements, code);
  keepOnly(all.answers, code);
  keepOnly(all.rules, code);
  return all;
}

// The values at which the model is felt: of the term in the middle, of neck flexion of the first (upright), in the
// middle of what belongs to it wholly.
double feltAt(const fuzzy::Variable& input) {
  if (input.terms.empty()) return std::midpoint(input.min, input.max);
  const std::vector<double>& points = input.terms[input.id == kNeckInput ? 0 : input.terms.size() / 2].points;
  const double middle = points.size() == 4   ? std::midpoint(points[1], points[2])
                        : points.size() == 3 ? points[1]
                                             : points[0];
  return std::clamp(middle, input.min, input.max);
}

// From the middle of the overlap with the region before to that with the next.
std::vector<OwnRegion> regionsOf(const fuzzy::Variable& depth) {
  std::vector<OwnRegion> out;
  for (const fuzzy::Term& term : depth.terms) {
    if (term.points.size() != 4) continue;
    const double from_mm = (term.points[0] + term.points[1]) / 2;
    const double to_mm = (term.points[2] + term.points[3]) / 2;
    out.push_back({term.id, std::max(from_mm, depth.min), std::min(to_mm, depth.max)});
  }
  return out;
}

std::vector<QPointF> curveOf(const fuzzy::CompiledModel& compiled, std::vector<double> inputs, std::size_t depth,
                             const fuzzy::Variable& variable) {
  std::vector<QPointF> out;
  double largest_n = 0;
  for (int i = 0; i <= kCurvePoints; ++i) {
    inputs[depth] = variable.min + (variable.max - variable.min) * i / kCurvePoints;
    const fuzzy::Evaluation force = compiled.evaluate(inputs);
    if (!force.fired) continue;
    out.emplace_back(inputs[depth], force.force_n);
    largest_n = std::max(largest_n, force.force_n);
  }
  for (QPointF& point : out) point.setY(largest_n > 0 ? point.y() / largest_n : 0);
  return out;
}

}  // namespace

Result<OwnModel> ownModel(const store::StudyFile& file, const std::string& code) {
  auto view = session::studyForElicitation(file);
  if (!view) return tl::unexpected(view.error());
  elicitation::BuildSettings settings;
  settings.name = code;
  const auto now = std::chrono::system_clock::now();
  settings.created_utc = base::formatUtc(now);
  settings.generator = kGenerator;
  const auto built = elicitation::buildModel(dataOf(std::move(view->study), code), session::knownForms(), settings);
  if (!built) return tl::unexpected(built.error());
  const fuzzy::ForceModel& model = built->model;
  const auto compiled = fuzzy::compile(model);
  if (!compiled) return tl::unexpected(compiled.error());

  OwnModel out;
  std::vector<double> inputs;
  std::optional<std::size_t> depth;
  for (const fuzzy::Variable& input : model.inputs) {
    if (input.id == kDepthInput) depth = inputs.size();
    inputs.push_back(feltAt(input));
    if (input.id != kDepthInput && input.id != haptics::MovedInputs().speed) out.conditions[input.id] = inputs.back();
  }
  if (!depth) return base::fail(base::ErrorCode::kReference, "her model", "no input 'depth'", "a model along the tube");
  auto scene = haptics::ServoScene::make(model, *compiled, out.conditions);
  if (!scene) return tl::unexpected(scene.error());
  out.scene = std::move(*scene);
  out.version.utc_ms = std::chrono::duration_cast<std::chrono::milliseconds>(now.time_since_epoch()).count();
  out.version.author = code;
  out.version.label = session::kOwnModelLabel;
  out.version.text = model_io::formatModel(model);
  out.regions = regionsOf(model.inputs[*depth]);
  out.curve = curveOf(*compiled, inputs, *depth, model.inputs[*depth]);
  return out;
}

}  // namespace tactus::workbench
