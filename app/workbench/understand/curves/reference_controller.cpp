#include "app/workbench/understand/curves/reference_controller.h"

#include <QFileInfo>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/plot_table.h"
#include "app/workbench/model/scene_controller.h"
#include "core/base/check.h"
#include "core/base/error.h"
#include "core/base/tables/csv.h"
#include "core/base/text.h"
#include "core/procedure/procedure.h"

namespace tactus::workbench {
namespace {

constexpr double kGap = std::numeric_limits<double>::quiet_NaN();

struct Columns {
  std::size_t x = 0;
  std::size_t force = 0;
  std::optional<std::size_t> series;
  const fuzzy::Variable* input = nullptr;
};

std::optional<std::size_t> columnOf(const base::CsvTable& table, const fuzzy::Variable& variable) {
  const auto found = table.find(columnName(variable));
  return found ? found : table.find(variable.id);
}

base::Result<Columns> columnsOf(const base::CsvTable& table, const fuzzy::ForceModel& model) {
  Columns out;
  std::vector<std::string> found;
  std::vector<std::string> wanted;
  for (const fuzzy::Variable& input : model.inputs) {
    wanted.push_back(columnName(input));
    const auto column = columnOf(table, input);
    if (!column) continue;
    found.push_back(table.columns()[*column]);
    out.x = *column;
    out.input = &input;
  }
  const auto refuse = [&table](const std::string& what, const std::string& want) {
    return base::inFile({base::ErrorCode::kSchema, {}, "header", what, want}, table.file());
  };
  if (found.empty()) {
    return refuse("columns " + base::joined(table.columns(), ", "), "one of " + base::joined(wanted, ", "));
  }
  if (found.size() > 1) {
    return refuse("columns " + base::joined(found, ", "), "one input alone, which is the x axis of the curve");
  }
  const auto force = columnOf(table, model.output);
  if (!force) return refuse("columns " + base::joined(table.columns(), ", "), "a column " + columnName(model.output));
  out.force = *force;
  out.series = table.find("series");
  return out;
}

base::Result<void> addRow(ReferenceCurve& curve, const base::CsvTable& table, const Columns& columns, std::size_t row) {
  TACTUS_TRY(const auto x, table.number(row, columns.x));
  double force = kGap;
  if (!base::trimmed(table.cell(row, columns.force)).empty()) {
    TACTUS_TRY(const auto number, table.number(row, columns.force));
    force = number;
  }
  if (!curve.x.empty() && x <= curve.x.back()) {
    return table.refuse(row, columns.x, base::ErrorCode::kValue,
                        "more than " + base::formatNumber(curve.x.back()) + ", the place before it in this curve");
  }
  curve.x.push_back(x);
  curve.force_n.push_back(force);
  return {};
}

// The force of the reference at `x`, straight between the points at `i` and `i + 1`.
double forceAt(const ReferenceCurve& reference, std::size_t i, double x) {
  if (x == reference.x[i]) return reference.force_n[i];
  if (x == reference.x[i + 1]) return reference.force_n[i + 1];
  const double share = (x - reference.x[i]) / (reference.x[i + 1] - reference.x[i]);
  return reference.force_n[i] + share * (reference.force_n[i + 1] - reference.force_n[i]);
}

}  // namespace

base::Result<std::vector<ReferenceCurve>> readReferences(const QString& path, const fuzzy::ForceModel& model) {
  TACTUS_TRY(const auto table, base::CsvTable::read(path.toStdString()));
  TACTUS_TRY(const auto columns, columnsOf(table, model));
  const auto too_many = [&](std::size_t found, std::size_t most, const char* what) {
    return base::inFile(
        {base::ErrorCode::kLimit, {}, {}, std::to_string(found) + what, "at most " + std::to_string(most) + what},
        table.file());
  };
  if (table.rowCount() > kMostReferencePoints) return too_many(table.rowCount(), kMostReferencePoints, " points");

  std::vector<ReferenceCurve> curves;
  for (std::size_t row = 0; row < table.rowCount(); ++row) {
    QString name = QFileInfo(path).completeBaseName();
    if (columns.series) {
      const std::string_view series = base::trimmed(table.cell(row, *columns.series));
      if (!series.empty()) name = QString::fromUtf8(series.data(), static_cast<qsizetype>(series.size()));
    }
    auto curve = std::find_if(curves.begin(), curves.end(), [&](const auto& known) { return known.name == name; });
    if (curve == curves.end()) {
      if (curves.size() == kMostReferences) return too_many(curves.size() + 1, kMostReferences, " curves");
      curve = curves.insert(curves.end(), ReferenceCurve{path, name, columns.input->id, {}, {}, 0});
    }
    if (auto added = addRow(*curve, table, columns, row); !added) return tl::unexpected(added.error());
  }
  for (const ReferenceCurve& curve : curves) {
    const auto points = std::count_if(curve.force_n.begin(), curve.force_n.end(), [](double f) { return f == f; });
    if (points >= 2) continue;
    return base::inFile({base::ErrorCode::kData,
                         {},
                         base::quoted(curve.name.toStdString()),
                         std::to_string(points) + " points with a force",
                         "two or more"},
                        table.file());
  }
  if (curves.empty()) return base::inFile({base::ErrorCode::kData, {}, {}, "no rows", "points"}, table.file());
  return curves;
}

std::optional<ReferenceDifference> compare(const ReferenceCurve& reference, const SampledForce& force) {
  TACTUS_CHECK(force.x.size() == force.force_n.size());
  ReferenceDifference out;
  double length = 0;
  double squares = 0;
  std::size_t piece = 0;  // of the reference, at the left place
  const auto look = [&](double off, double at) {
    if (std::abs(off) <= out.largest_n) return;
    out.largest_n = std::abs(off);
    out.largest_at = at;
  };
  for (std::size_t i = 0; i + 1 < force.x.size(); ++i) {
    const double left = force.x[i];
    const double right = force.x[i + 1];
    if (left < reference.x.front() || right > reference.x.back()) continue;
    while (reference.x[piece + 1] <= left) ++piece;
    const double off_left = force.force_n[i] - forceAt(reference, piece, left);
    const double off_right = force.force_n[i + 1] - forceAt(reference, piece, right);
    // Not a number: a gap in one of the two.
    if (!std::isfinite(off_left) || !std::isfinite(off_right)) continue;
    if (length == 0) {
      out.from = left;
      out.largest_at = left;
    }
    out.to = right;
    length += right - left;
    squares += (right - left) * (off_left * off_left + off_left * off_right + off_right * off_right) / 3;
    look(off_left, left);
    look(off_right, right);
  }
  if (length == 0) return std::nullopt;
  out.rms_n = std::sqrt(squares / length);
  return out;
}

ReferenceController::ReferenceController(const SceneController& scene, QObject* parent)
    : QObject(parent), scene_(scene) {
  connect(&scene_, &SceneController::modelChanged, this, &ReferenceController::adoptModel);
  connect(&scene_, &SceneController::xInputChanged, this, [this] {
    drop();
    emit changed();
  });
  connect(&scene_, &SceneController::curvesChanged, this, &ReferenceController::drop);
}

std::vector<ReferenceCurve> ReferenceController::shown() const {
  std::vector<ReferenceCurve> out;
  if (!scene_.model()) return out;
  std::copy_if(references_.begin(), references_.end(), std::back_inserter(out),
               [this](const ReferenceCurve& curve) { return curve.input == scene_.xVariable().id; });
  return out;
}

void ReferenceController::open(const QString& path) {
  TACTUS_CHECK(scene_.model() != nullptr);
  auto curves = readReferences(path, scene_.model()->model);
  if (!curves) {
    emit refused(text(curves.error().message()));
    return;
  }
  add(std::move(*curves), path);
}

void ReferenceController::addPublished(const procedure::Procedure& procedure) {
  std::vector<ReferenceCurve> curves;
  for (const procedure::PublishedForce& force : procedure.published) {
    const QString label = text(procedure::textIn(force.label, "en"));
    const bool range = force.low_n < force.high_n;
    const auto line = [&](const QString& name, double force_n) {
      curves.push_back({{}, name, procedure.wayInput().id, {force.from_mm, force.to_mm}, {force_n, force_n}, 0});
    };
    line(range ? tr("%1, lowest").arg(label) : label, force.low_n);
    if (range) line(tr("%1, highest").arg(label), force.high_n);
  }
  add(std::move(curves), tr("The published forces"));
}

void ReferenceController::add(std::vector<ReferenceCurve> curves, const QString& from) {
  std::vector<ReferenceCurve> next = references_;
  for (ReferenceCurve& curve : curves) {
    const auto known = std::find_if(next.begin(), next.end(), [&](const auto& old) { return old.name == curve.name; });
    if (known != next.end()) {
      curve.color = known->color;
      *known = std::move(curve);
      continue;
    }
    // The first color that is free.
    while (std::any_of(next.begin(), next.end(), [&](const auto& old) { return old.color == curve.color; })) {
      ++curve.color;
    }
    next.push_back(std::move(curve));
  }
  if (next.size() > kMostReferences) {
    emit refused(
        tr("%1: found %n reference curve(s) together with those that are shown, wanted at most %2; remove some first.",
           nullptr, static_cast<int>(next.size()))
            .arg(from)
            .arg(kMostReferences));
    return;
  }
  references_ = std::move(next);
  drop();
  emit changed();
}

void ReferenceController::remove(const QString& name) {
  if (std::erase_if(references_, [&](const ReferenceCurve& curve) { return curve.name == name; }) == 0) return;
  drop();
  emit changed();
}

void ReferenceController::setExpert(std::optional<std::size_t> expert) {
  TACTUS_CHECK(!expert || *expert < scene_.model()->model.experts.size());
  if (expert == expert_) return;
  expert_ = expert;
  expert_id_ = expert ? scene_.model()->model.experts[*expert].id : std::string();
  drop();
  emit changed();
}

void ReferenceController::adoptModel() {
  const std::vector<fuzzy::Variable>& inputs = scene_.model()->model.inputs;
  std::erase_if(references_, [&inputs](const ReferenceCurve& curve) {
    return std::none_of(inputs.begin(), inputs.end(), [&](const auto& input) { return input.id == curve.input; });
  });
  expert_ = expertNamed(scene_.model()->model, expert_id_);
  drop();
  emit changed();
}

void ReferenceController::drop() { differences_.reset(); }

const std::vector<std::optional<ReferenceDifference>>& ReferenceController::differences() const {
  if (!differences_) {
    differences_.emplace();
    for (const ReferenceCurve& reference : shown()) differences_->push_back(differenceOf(reference));
  }
  return *differences_;
}

std::optional<ReferenceDifference> ReferenceController::differenceOf(const ReferenceCurve& reference) const {
  const figures::ForceCurves& curves = scene_.curves();
  const std::vector<fuzzy::Evaluation>& known = expert_ ? curves.experts[*expert_] : curves.mean;
  const fuzzy::CompiledModel& compiled = scene_.model()->compiled;
  std::vector<double> point = scene_.readingPoint();
  std::vector<double> places;
  std::vector<double> forces;
  const auto add = [&](double x, const fuzzy::Evaluation& here) {
    places.push_back(x);
    forces.push_back(here.fired ? here.force_n : std::numeric_limits<double>::quiet_NaN());
  };
  // The places of both: the model's own are there, at the others it is asked.
  std::size_t next = 0;
  std::uint64_t asked = 0;
  for (const double x : reference.x) {
    for (; next < curves.x.size() && curves.x[next] < x; ++next) add(curves.x[next], known[next]);
    if (x < scene_.xVariable().min || x > scene_.xVariable().max) continue;
    if (next < curves.x.size() && curves.x[next] == x) continue;
    point[scene_.xInput()] = x;
    add(x, expert_ ? compiled.evaluateExpert(*expert_, point) : compiled.evaluate(point));
    ++asked;
  }
  for (; next < curves.x.size(); ++next) add(curves.x[next], known[next]);
  scene_.countEvaluations(asked);
  return compare(reference, {places, forces});
}

QString ReferenceController::differenceText(const std::optional<ReferenceDifference>& difference) const {
  if (!difference) return tr("no range in common");
  const fuzzy::Variable& x = scene_.xVariable();
  const std::string& unit = scene_.model()->model.output.unit;
  return tr("RMS %1 · largest %2 at %3 · over %4")
      .arg(forceText(difference->rms_n, unit), forceText(difference->largest_n, unit),
           placeText(x, difference->largest_at), rangeText(x, difference->from, difference->to));
}

}  // namespace tactus::workbench
