#include "app/workbench/feel/procedure.h"

#include <QCoreApplication>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "core/base/check.h"

// Outside of every namespace, as Qt wants it: a resource of a static library has to be asked for.
static void initFeelResource() { Q_INIT_RESOURCE(feel); }

namespace tactus::workbench {
namespace {

std::string placeOfStep(qsizetype index) { return "steps[" + std::to_string(index) + "]"; }

}  // namespace

base::Result<std::vector<ProcedureStep>> readProcedure(const QByteArray& json) {
  using base::ErrorCode;
  QJsonParseError problem;
  const QJsonDocument document = QJsonDocument::fromJson(json, &problem);
  if (problem.error != QJsonParseError::NoError)
    return base::fail(ErrorCode::kSyntax, "character " + std::to_string(problem.offset),
                      problem.errorString().toStdString(), "JSON");
  const QJsonArray list = document.object().value(QLatin1String("steps")).toArray();
  if (list.isEmpty()) return base::fail(ErrorCode::kSchema, "steps", "none", "a list of steps");

  std::vector<ProcedureStep> steps;
  std::optional<double> deepest_mm;
  for (qsizetype i = 0; i < list.size(); ++i) {
    const QJsonObject object = list[i].toObject();
    ProcedureStep step;
    step.title = object.value(QLatin1String("title")).toString();
    step.text = object.value(QLatin1String("text")).toString();
    if (step.title.isEmpty()) return base::fail(ErrorCode::kSchema, placeOfStep(i) + ".title", "nothing", "a text");
    const QJsonValue from = object.value(QLatin1String("from_mm"));
    if (from.isDouble()) step.from_mm = from.toDouble();
    if (deepest_mm && (!step.from_mm || *step.from_mm <= *deepest_mm))
      return base::fail(ErrorCode::kValue, placeOfStep(i) + ".from_mm", "no depth beyond that of the step before",
                        "depths that rise");
    if (step.from_mm) deepest_mm = step.from_mm;
    steps.push_back(std::move(step));
  }
  return steps;
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
