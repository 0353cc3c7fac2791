#include "app/workbench/labs/depth/length_page.h"

#include <QFormLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <algorithm>
#include <cmath>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/kit/number_box.h"
#include "app/workbench/labs/depth/depth_lab.h"
#include "app/workbench/labs/depth/depth_settings.h"
#include "app/workbench/plot/chart.h"
#include "app/workbench/plot/plot_menu.h"
#include "app/workbench/plot/plot_style.h"
#include "app/workbench/plot/term_marks.h"
#include "elicitation/depth/depth_measurement.h"

namespace tactus::workbench {
namespace {

constexpr double kMmPerCm = 10;
constexpr double kRegionsBottom = 3.7;  // above the bars, which are at 1, 2 and 3
constexpr double kRegionsTop = 4.2;
constexpr double kBarHalf = 0.26;
constexpr double kLeastShownMm = 40;  // a shorter region has no room for its name

}  // namespace

QString centimeters(double length_mm) { return quantityText(length_mm / kMmPerCm, "cm", 1); }

QString formulaName(elicitation::LengthFormula formula) {
  switch (formula) {
    case elicitation::LengthFormula::kNoseEarXiphoid: return LengthPage::tr("Nose – ear – xiphoid");
    case elicitation::LengthFormula::kHanson: return LengthPage::tr("Hanson");
    case elicitation::LengthFormula::kCorrected: return LengthPage::tr("Corrected");
  }
  return {};
}

namespace {

Chart lengthChart(const fuzzy::Variable& depth, const std::vector<elicitation::InsertionLength>& lengths,
                  const elicitation::DepthRange& target) {
  double end_mm = std::max(depth.max, target.to_mm);
  for (const auto& one : lengths) end_mm = std::max(end_mm, one.length_mm);
  Chart chart{{.universe = depth, .label = LengthPage::tr("From the nostril (cm)"), .grid = false}, {.grid = false}};
  chart.x.universe.unit = "cm";
  chart.x.universe.min = 0;
  chart.x.universe.max = std::ceil(end_mm / 50) * 50 / kMmPerCm;
  chart.y.range = {0.5, kRegionsTop + 0.1};
  const auto bar = [&chart](double from_mm, double to_mm, double bottom, double top, const QColor& fill) {
    chart.parts.emplace_back(ChartBar{from_mm / kMmPerCm, to_mm / kMmPerCm, bottom, top, fill});
  };
  const auto say = [&chart](double at_mm, double height, const QString& words, const QColor& ink, Qt::Alignment side) {
    const QPointF at(at_mm / kMmPerCm, height);
    chart.parts.emplace_back(ChartText{words, at, side | Qt::AlignVCenter, ink, QMargins(4, 0, 4, 0)});
  };
  QColor band = theme::accent();
  band.setAlphaF(0.16F);
  bar(target.from_mm, target.to_mm, 0.5, kRegionsBottom, theme::onCard(band));
  const auto boundaries = elicitation::boundariesOf(depth.terms);
  double from_mm = depth.min;
  for (std::size_t k = 0; k < depth.terms.size(); ++k) {
    const double to_mm = k < boundaries.size() ? boundaries[k].depth_mm : depth.max;
    const QColor fill = termFill(depth, depth.terms, k);
    bar(from_mm, to_mm, kRegionsBottom, kRegionsTop, fill);
    if (to_mm - from_mm >= 2 * kLeastShownMm) {
      say((from_mm + to_mm) / 2, (kRegionsBottom + kRegionsTop) / 2, labelOf(depth.terms[k]), theme::inkOn(fill),
          Qt::AlignHCenter);
    }
    from_mm = to_mm;
  }
  double row = 3;
  for (const auto& one : lengths) {
    const QColor line = theme::readableLine(one.in_target ? theme::accent() : theme::mutedInk());
    bar(0, one.length_mm, row - kBarHalf, row + kBarHalf, line);
    say(0, row, formulaName(one.formula), theme::inkOn(line), Qt::AlignLeft);
    say(one.length_mm, row, centimeters(one.length_mm), theme::inkOn(line), Qt::AlignRight);
    --row;
  }
  return chart;
}

constexpr double kCm = 10;          // mm
constexpr double kExampleMm = 500;  // before a length is typed
constexpr int kHighestPlot = 400;   // px: bars that are higher say no more

fuzzy::Variable lengthRange(const QString& name) {
  fuzzy::Variable out;
  out.id = "nose_ear_xiphoid";
  out.label = name.toStdString();
  out.unit = "cm";
  out.min = elicitation::kNoseEarXiphoidMm.from_mm / kCm;
  out.max = elicitation::kNoseEarXiphoidMm.to_mm / kCm;
  return out;
}

// The end of the esophagus: of the person on the image, or of the template.
double sphincterMm(const DepthLab& lab) {
  const auto& boundaries = lab.measurement().boundaries;
  return boundaries.empty() ? elicitation::kSphincterMm : boundaries.back().depth_mm;
}

PlotTable lengthTable(const DepthLab& lab, double nex_mm) {
  PlotTable table;
  table.file = QStringLiteral("insertion-length");
  table.caption << LengthPage::tr("Insertion length by bedside formulas")
                << LengthPage::tr("nose – ear – xiphoid %1 · anatomical scale %2")
                       .arg(centimeters(nex_mm), numberText(lab.measurement().scale));
  table.columns = {"formula", "length_mm", "beyond_sphincter_mm", "in_target"};
  const auto lengths = elicitation::insertionLengths(nex_mm, lab.measurement().scale, sphincterMm(lab));
  if (!lengths) return table;
  for (const auto& one : *lengths) {
    table.rows.push_back({std::string(name(one.formula)), one.length_mm, one.beyond_sphincter_mm,
                          std::string(one.in_target ? "yes" : "no")});
  }
  return table;
}

}  // namespace

LengthPage::LengthPage(DepthLab& lab, QWidget* parent)
    : QWidget(parent),
      lab_(lab),
      length_(new NumberBox(lengthRange(tr("Nose – ear – xiphoid")), 0.5, this)),
      example_(mutedWords({}, this)),
      plot_(new ChartView(this, {900, 340})),
      target_(mutedWords({}, this)) {
  length_->setToolTip(
      tr("Type the length from the tip of the nose over the lobe of the ear to the end of the breastbone, along the "
         "tube."));
  auto* menu = new PlotMenu(
      *plot_, [this] { return lengthTable(lab_, lab_.measurement().nose_ear_xiphoid_mm.value_or(kExampleMm)); }, this);
  plot_->setMinimumSize(280, 170);
  plot_->setMaximumHeight(kHighestPlot);
  plot_->setAccessibleName(tr("Length of the tube by each formula"));
  plot_->plot().yAxis->setVisible(false);
  plot_->plot().axisRect()->setAutoMargins(QCP::msBottom);
  plot_->plot().axisRect()->setMargins(QMargins(theme::kGrid, 0, theme::kGrid, 0));
  auto* sources =
      mutedWords(tr("Hanson: 0.38696 × length + 30.37 cm; corrected: 0.38696 × length + 36.37 cm (Hanson 1979, "
                    "biblio.ugent.be/publication/8599660). The plain length is too short in 96.7 % of people, "
                    "gauged by the tip (Chen 2014, PMC3919749). Target: Boeykens 2023, Crit Care 27:317. The "
                    "tilt of the head can change the needed length by up to 5 cm."),
                 this);
  makeColumn(this,
             {pageHead(tr("&Nose – ear – xiphoid of a person"), length_, menu),
              example_,
              {plot_, 1},
              makeTable(),
              target_,
              sources,
              spring()},
             theme::kGrid, {0, theme::kGrid, 0, 0});
  connect(length_, &QDoubleSpinBox::valueChanged, this, [this] {
    auto wanted = lab_.measurement();
    wanted.nose_ear_xiphoid_mm = length_->exact() * kCm;
    lab_.show(wanted);
    lab_.commit(tr("nose – ear – xiphoid length"));
  });
  connect(&lab_, &DepthLab::measurementChanged, this, &LengthPage::refreshState);
  refreshState();
}

QWidget* LengthPage::makeTable() {
  auto* table = new QWidget(this);
  auto* grid = new QGridLayout(table);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(theme::kGrid);
  grid->setVerticalSpacing(theme::kGrid / 2);
  grid->setColumnStretch(0, 1);
  const QString heads[] = {tr("Formula"), tr("Length"), tr("Beyond sphincter"), tr("In target")};
  for (int column = 0; column < 4; ++column) {
    auto* head = new QLabel(heads[column], table);
    setMuted(*head);
    grid->addWidget(head, 0, column, column == 0 ? Qt::AlignLeft : Qt::AlignRight);
  }
  const elicitation::LengthFormula formulas[] = {elicitation::LengthFormula::kNoseEarXiphoid,
                                                 elicitation::LengthFormula::kHanson,
                                                 elicitation::LengthFormula::kCorrected};
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const int line = static_cast<int>(i) + 1;
    rows_[i] = {new QLabel(table), new QLabel(table), new QLabel(table)};
    auto* formula = new QLabel(formulaName(formulas[i]), table);
    grid->addWidget(formula, line, 0);
    for (QLabel* cell : {formula, rows_[i].length, rows_[i].beyond, rows_[i].target}) cell->setFont(theme::smallFont());
    grid->addWidget(rows_[i].length, line, 1, Qt::AlignRight);
    grid->addWidget(rows_[i].beyond, line, 2, Qt::AlignRight);
    grid->addWidget(rows_[i].target, line, 3, Qt::AlignRight);
  }
  return table;
}

QString LengthPage::lengthText(std::size_t formula) const { return rows_[formula].length->text(); }

QString LengthPage::targetText() const { return target_->text(); }

void LengthPage::refreshState() {
  const auto& measurement = lab_.measurement();
  const double nex_mm = measurement.nose_ear_xiphoid_mm.value_or(kExampleMm);
  const QSignalBlocker quiet(length_);
  length_->setExact(nex_mm / kCm);
  example_->setText(measurement.nose_ear_xiphoid_mm
                        ? tr("Stored with the study. It moves neither the terms nor the target; the anatomical scale "
                             "at the left moves both.")
                        : tr("An example: type the length of a person. It moves neither the terms nor the target; the "
                             "anatomical scale at the left moves both."));
  const double sphincter_mm = sphincterMm(lab_);
  const auto target = elicitation::targetDepth(measurement.scale, sphincter_mm);
  target_->setText(tr("The tip should lie %1 to %2 from the nostril: 3 to 10 cm beyond the lower esophageal sphincter, "
                      "which is the boundary of esophagus and stomach, here at %3 (scale %4).")
                       .arg(numberText(target.from_mm / kCm, 1), centimeters(target.to_mm),
                            centimeters(sphincter_mm * measurement.scale), numberText(measurement.scale)));
  const auto lengths = elicitation::insertionLengths(nex_mm, measurement.scale, sphincter_mm);
  for (std::size_t i = 0; lengths && i < rows_.size(); ++i) {
    const auto& one = (*lengths)[i];
    rows_[i].length->setText(centimeters(one.length_mm));
    rows_[i].beyond->setText(centimeters(one.beyond_sphincter_mm));
    rows_[i].target->setText(one.in_target ? tr("yes")
                             : one.length_mm < target.from_mm
                                 ? tr("%1 too short").arg(centimeters(target.from_mm - one.length_mm))
                                 : tr("%1 too long").arg(centimeters(one.length_mm - target.to_mm)));
  }
  plot_->setChart(lengthChart(lab_.terms(), lengths ? *lengths : std::vector<elicitation::InsertionLength>(), target));
}

}  // namespace tactus::workbench
