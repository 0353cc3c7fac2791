#include "app/workbench/feel/procedure.h"

#include <QCoreApplication>
#include <QFile>
#include <cmath>

#include "app/workbench/base/display_text.h"
#include "app/workbench/model/patient.h"
#include "core/base/check.h"
#include "core/base/json/json_members.h"
#include "core/base/text.h"

namespace tactus::workbench {
namespace {

constexpr int kSteps = 4000;

}  // namespace

std::vector<DepthRegion> depthRegions(const fuzzy::Variable& depth) {
  std::vector<DepthRegion> regions;
  std::optional<std::size_t> before;
  for (int i = 0; i <= kSteps; ++i) {
    const double x = std::lerp(depth.min, depth.max, static_cast<double>(i) / kSteps);
    const auto term = strongestTerm(depth, x);
    if (term && term != before) {
      // What touches begins where the one before ends.
      if (before) regions.back().to_mm = x;
      regions.push_back({labelOf(depth.terms[*term]), x, x, depth.terms[*term].id});
    } else if (term) {
      regions.back().to_mm = x;
    }
    before = term;
  }
  return regions;
}

std::optional<std::size_t> regionAt(const std::vector<DepthRegion>& regions, double depth_mm) {
  for (std::size_t i = 0; i < regions.size(); ++i) {
    const bool last = i + 1 == regions.size();
    if (depth_mm >= regions[i].from_mm && (depth_mm < regions[i].to_mm || (last && depth_mm <= regions[i].to_mm)))
      return i;
  }
  return std::nullopt;
}
}  // namespace tactus::workbench

// Outside of every namespace, as Qt wants it: a resource of a static library has to be asked for.
static void initFeelResource() { Q_INIT_RESOURCE(feel); }

namespace tactus::workbench {

base::Result<std::vector<ProcedureStep>> readProcedure(const QByteArray& json) {
  const auto read = [](base::JsonMembers& members, std::optional<base::Error>& error) {
    std::vector<ProcedureStep> steps;
    std::optional<double> deepest_mm;
    for (const base::JsonValue value : members.elements(base::required("steps"))) {
      base::JsonMembers step(value, error);
      std::string title, text;
      ProcedureStep& out = steps.emplace_back();
      step.text(base::required("title"), title);
      step.textOrEmpty("text", text);
      step.number("from_mm", out.from_mm);
      step.refuseOthers();
      out.title = QString::fromStdString(title);
      out.text = QString::fromStdString(text);
      if (deepest_mm && (!out.from_mm || *out.from_mm <= *deepest_mm))
        step.refuse("from_mm", "more than " + base::formatNumber(*deepest_mm) + ", the depth of the step before");
      if (out.from_mm) deepest_mm = out.from_mm;
    }
    if (steps.empty()) members.refuse("steps", "no steps", "at least one step");
    members.refuseOthers();
    return steps;
  };
  return base::readJson({json.constData(), static_cast<std::size_t>(json.size())}, {}, read);
}

std::vector<ProcedureStep> ngtProcedure() {
  initFeelResource();
  QFile file(QStringLiteral(":/tactus/procedure.json"));
  TACTUS_CHECK(file.open(QIODevice::ReadOnly));
  auto steps = readProcedure(file.readAll());
  TACTUS_CHECK(steps.has_value());
  // lupdate finds the texts through tactus_data_words.
  for (ProcedureStep& step : *steps) {
    step.title = QCoreApplication::translate("Procedure", step.title.toUtf8());
    step.text = QCoreApplication::translate("Procedure", step.text.toUtf8());
  }
  return std::move(*steps);
}

std::optional<std::size_t> stepAt(const std::vector<ProcedureStep>& steps, double depth_mm) {
  std::optional<std::size_t> at;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (steps[i].from_mm && *steps[i].from_mm <= depth_mm) at = i;
  }
  return at;
}

}  // namespace tactus::workbench
