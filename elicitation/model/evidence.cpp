#include "elicitation/model/evidence.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/tables/csv.h"
#include "core/base/text.h"
#include "elicitation/force/noticeable_force.h"

namespace tactus::elicitation {

using base::ErrorCode;
using base::Result;

namespace {

/// The one column called `name` or `name_unit`.
Result<std::size_t> columnOf(const base::CsvTable& table, const std::string& name, const std::string& unit) {
  const auto plain = table.find(name);
  const auto named = table.find(name + "_" + unit);
  if (plain.has_value() != named.has_value()) return plain ? *plain : *named;
  return base::inFile({ErrorCode::kSchema,
                       {},
                       "header",
                       base::joined(table.columns(), ", "),
                       "one column " + name + " or " + name + "_" + unit + ", in " +
                           (unit == "n" ? std::string("newtons") : std::string("millimeters"))},
                      table.file());
}

}  // namespace

Result<std::vector<ReferencePoint>> readReferenceCurve(const std::string& text, const std::string& file,
                                                       const procedure::Procedure& procedure) {
  TACTUS_TRY(const auto table, base::CsvTable::parse(text, file));
  TACTUS_TRY(const auto depth, columnOf(table, "depth", "mm"));
  TACTUS_TRY(const auto force, columnOf(table, "force", "n"));
  if (table.find("series")) {
    return base::inFile({ErrorCode::kSchema, {}, "header", "a column series", "a file with one curve"}, file);
  }
  const fuzzy::Variable& universe = procedure.wayInput();
  std::vector<ReferencePoint> out;
  for (std::size_t row = 0; row < table.rowCount(); ++row) {
    TACTUS_TRY(const double depth_mm, table.number(row, depth));
    if (depth_mm < universe.min || depth_mm > universe.max) {
      return table.refuse(
          row, depth, ErrorCode::kValue,
          "a depth from " + base::formatNumber(universe.min) + " to " + base::formatNumber(universe.max) + " mm");
    }
    if (base::trimmed(table.cell(row, force)).empty()) continue;
    TACTUS_TRY(const double force_n, table.number(row, force));
    if (force_n < 0) return table.refuse(row, force, ErrorCode::kValue, "a force of 0 N or more");
    if (!out.empty() && depth_mm <= out.back().depth_mm) {
      return table.refuse(row, depth, ErrorCode::kValue,
                          "more than the depth before, " + base::formatNumber(out.back().depth_mm) + " mm");
    }
    out.push_back({depth_mm, force_n});
  }
  if (out.size() < 2 || out.size() > kMostReferencePoints) {
    return base::inFile({ErrorCode::kLimit,
                         {},
                         {},
                         std::to_string(out.size()) + " points",
                         "2 to " + std::to_string(kMostReferencePoints)},
                        file);
  }
  return out;
}

std::vector<double> referenceInputs(const procedure::Procedure& procedure,
                                    const std::map<std::string, double>& conditions, double depth_mm) {
  std::vector<double> out;
  for (std::size_t i = 0; i < procedure.inputs.size(); ++i) {
    const auto given = conditions.find(procedure.inputs[i].id);
    out.push_back(i == procedure.way()        ? depth_mm
                  : given != conditions.end() ? given->second
                                              : procedure.input_notes[i].usual);
  }
  return out;
}

Result<ReferenceError> referenceError(const procedure::Procedure& procedure, const fuzzy::ForceModel& model,
                                      const SealedCurve& curve) {
  TACTUS_TRY(const auto compiled, fuzzy::compile(model));
  ReferenceError out;
  for (const auto& point : curve.points) {
    const auto force = compiled.evaluate(referenceInputs(procedure, curve.conditions, point.depth_mm));
    if (!force.fired) {
      ++out.without;
      continue;
    }
    ++out.points;
    const double error_n = force.force_n - point.force_n;
    const double error_jnd = error_n / justNoticeableDifference(point.force_n);
    out.mean_n += error_n;
    out.rms_n += error_n * error_n;
    out.rms_jnd += error_jnd * error_jnd;
    out.largest_jnd = std::max(out.largest_jnd, std::abs(error_jnd));
    if (std::abs(error_n) > std::abs(out.largest_n)) {
      out.largest_n = error_n;
      out.largest_at_mm = point.depth_mm;
    }
  }
  if (out.points == 0) return out;
  const auto points = static_cast<double>(out.points);
  out.mean_n /= points;
  out.rms_n = std::sqrt(out.rms_n / points);
  out.rms_jnd = std::sqrt(out.rms_jnd / points);
  return out;
}

namespace {

constexpr std::size_t kMostDivided = 18;  // 48,620 divisions

/// Whether a category names an expert or a student; nothing for another one.
std::optional<bool> isExpert(const std::string& category) {
  const std::string word = base::lowered(category);
  if (word == "expert") return true;
  if (word == "student" || word == "novice" || word == "beginner") return false;
  return std::nullopt;
}

/// `samples` of one stroke, in the order of time.
void addStroke(const procedure::Procedure& about, const fuzzy::CompiledModel& compiled,
               const std::vector<const study::SpeedSample*>& samples, StrokeForces& sum) {
  double peak_n = 0;
  double work_n_mm = 0;
  double reversals = 0;
  double turn_mm = samples.front()->depth_mm;  // the furthest place in the current direction
  bool forward = true;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const auto& one = *samples[i];
    if (forward) {
      if (one.depth_mm > turn_mm) turn_mm = one.depth_mm;
      if (one.depth_mm < turn_mm - kReversalMm) {
        forward = false;
        turn_mm = one.depth_mm;
        ++reversals;
      }
    } else {
      if (one.depth_mm < turn_mm) turn_mm = one.depth_mm;
      if (one.depth_mm > turn_mm + kReversalMm) {
        forward = true;
        turn_mm = one.depth_mm;
      }
    }
    if (i == 0) continue;
    const double step_mm = one.depth_mm - samples[i - 1]->depth_mm;
    if (step_mm <= 0) continue;
    std::map<std::string, double> moved;
    if (const auto* const rate = about.rateInput()) moved.emplace(rate->id, std::max(0.0, one.speed_mm_s));
    const auto point = referenceInputs(about, moved, one.depth_mm);
    const auto force = compiled.evaluate(point);
    if (!force.fired) continue;
    peak_n = std::max(peak_n, force.force_n);
    work_n_mm += force.force_n * step_mm;
  }
  ++sum.strokes;
  sum.peak_n += peak_n;
  sum.work_n_mm += work_n_mm;
  sum.reversals += reversals;
}

/// The chance that a value of a member is above one of another.
double aboveOf(const std::vector<double>& values, const std::vector<bool>& members) {
  double above = 0;
  double pairs = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!members[i]) continue;
    for (std::size_t k = 0; k < values.size(); ++k) {
      if (members[k]) continue;
      ++pairs;
      above += values[i] > values[k] ? 1 : values[i] == values[k] ? 0.5 : 0;
    }
  }
  return above / pairs;
}

GroupDifference differenceOf(const ConstructEvidence& found, double StrokeForces::*measure) {
  GroupDifference out;
  std::vector<double> values;
  std::vector<bool> experts;
  for (const auto& one : found.participants) {
    values.push_back(one.*measure);
    experts.push_back(one.expert);
    (one.expert ? out.expert_mean : out.student_mean) += one.*measure;
  }
  out.expert_mean /= static_cast<double>(found.experts);
  out.student_mean /= static_cast<double>(found.students);
  out.above = aboveOf(values, experts);
  if (values.size() > kMostDivided) return out;
  const double distance = std::abs(out.above - 0.5);
  double divisions = 0;
  double as_far = 0;
  std::sort(experts.begin(), experts.end());
  do {
    ++divisions;
    // The sums are halves of whole numbers over the same count of pairs; 1e-12 is far below their distance.
    if (std::abs(aboveOf(values, experts) - 0.5) >= distance - 1e-12) ++as_far;
  } while (std::next_permutation(experts.begin(), experts.end()));
  out.chance = as_far / divisions;
  return out;
}

}  // namespace

Result<ConstructEvidence> constructEvidence(const study::Study& study, const fuzzy::ForceModel& model) {
  TACTUS_TRY(const auto compiled, fuzzy::compile(model));
  ConstructEvidence out;
  for (const auto& person : study.participants) {
    const auto expert = isExpert(person.category);
    if (!expert) continue;
    std::map<std::pair<std::string, int>, std::vector<const study::SpeedSample*>> strokes;
    for (const auto& sample : study.speeds) {
      if (sample.participant == person.code) strokes[{sample.level, sample.stroke}].push_back(&sample);
    }
    if (strokes.empty()) continue;
    StrokeForces sum{.participant = person.code, .expert = *expert};
    for (const auto& [name, samples] : strokes) addStroke(procedure::of(study), compiled, samples, sum);
    const auto count = static_cast<double>(sum.strokes);
    sum.peak_n /= count;
    sum.work_n_mm /= count;
    sum.reversals /= count;
    out.participants.push_back(sum);
    ++(*expert ? out.experts : out.students);
    out.simulated = out.simulated || person.simulated;
  }
  if (out.experts < 2 || out.students < 2) return out;
  out.peak = differenceOf(out, &StrokeForces::peak_n);
  out.work = differenceOf(out, &StrokeForces::work_n_mm);
  out.reversals = differenceOf(out, &StrokeForces::reversals);
  return out;
}

}  // namespace tactus::elicitation
