#include "app/workbench/understand/here/expert_flow.h"

#include <QMouseEvent>
#include <QPaintEvent>
#include <QPainter>
#include <algorithm>

#include "app/figures/colors.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/understand/here/set_sketch.h"

namespace tactus::workbench {
namespace {

constexpr double kExpertHeight = 50;  // px, the least height of an expert
constexpr double kRoomAround = 13;    // px above and below its two lines
constexpr double kDot = 10;           // px
constexpr double kForces = 120;       // px, the least width of force and share
constexpr double kNarrowestSketch = 90;
constexpr int kNarrowestFlow = 340;  // px, of all

// Both lines have their room whatever the size of the text.
double expertHeight() {
  return std::max(kExpertHeight, kRoomAround + QFontMetrics(theme::headingFont()).height() +
                                     QFontMetrics(theme::smallFont()).height());
}

double forcesWidth() {
  const QString share = ExpertFlow::tr("× %1 = %2").arg(QStringLiteral("0.333"), QStringLiteral("0.000 N"));
  return std::max(kForces, QFontMetrics(theme::smallFont()).horizontalAdvance(share) + 2.0 * theme::kGrid);
}

}  // namespace

ExpertFlow::ExpertFlow(const SceneController& scene, QWidget* parent) : QWidget(parent), scene_(scene) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::MinimumExpanding);
  setCursor(Qt::PointingHandCursor);
}

std::size_t ExpertFlow::count() const { return scene_.model() ? scene_.model()->model.experts.size() : 0; }

void ExpertFlow::follow() {
  updateGeometry();
  update();
}

QSize ExpertFlow::sizeHint() const { return {640, static_cast<int>(expertHeight() * static_cast<double>(count()))}; }

QSize ExpertFlow::minimumSizeHint() const { return {kNarrowestFlow, sizeHint().height()}; }

void ExpertFlow::paintEvent(QPaintEvent* event) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  // Of many experts only those in sight.
  const auto first = static_cast<std::size_t>(std::max(0.0, event->rect().top() / expertHeight()));
  const auto last = static_cast<std::size_t>(std::max(0.0, event->rect().bottom() / expertHeight()));
  for (std::size_t expert = first; expert < count() && expert <= last; ++expert) {
    paintLine(painter, expert);
  }
}

void ExpertFlow::mousePressEvent(QMouseEvent* event) {
  const auto line = static_cast<std::size_t>(std::max(0.0, event->position().y()) / expertHeight());
  if (event->button() == Qt::LeftButton && line < count()) emit chosen(line);
}

void ExpertFlow::paintLine(QPainter& painter, std::size_t expert) const {
  const fuzzy::ForceModel& model = scene_.model()->model;
  const analysis::ExplainedExpert& explained = scene_.explanation().experts[expert];
  const double height = expertHeight();
  const double forces_width = forcesWidth();
  const QRectF line(0, height * static_cast<double>(expert), width(), height);
  if (expert % 2 == 0) painter.fillRect(line, theme::window());
  const QColor color = theme::expert(figures::expertNumbers(model.experts)[expert]);
  painter.setPen(Qt::NoPen);
  painter.setBrush(color);
  painter.drawEllipse(QRectF(4, line.center().y() - kDot / 2, kDot, kDot));

  const double sketch_width = std::max(kNarrowestSketch, (width() - forces_width) * 0.25);
  const QRectF words(4 + kDot + theme::kGrid, line.top() + 5, width() - forces_width - sketch_width - kDot - 28,
                     height - 10);
  painter.setPen(theme::ink());
  painter.setFont(theme::headingFont());
  painter.drawText(words, Qt::AlignLeft | Qt::AlignTop,
                   painter.fontMetrics().elidedText(labelOf(model.experts[expert]), Qt::ElideRight,
                                                    static_cast<int>(words.width())));
  painter.setPen(theme::mutedInk());
  painter.setFont(theme::smallFont());
  painter.drawText(
      words, Qt::AlignLeft | Qt::AlignBottom,
      painter.fontMetrics().elidedText(strongestRule(expert), Qt::ElideRight, static_cast<int>(words.width())));

  const QRectF forces(line.right() - forces_width, line.top() + 5, forces_width - theme::kGrid, height - 10);
  SetSketch sketch(painter, QRectF(forces.left() - sketch_width, line.top() + 4, sketch_width - 8, height - 9),
                   model.output);
  sketch.ground();
  if (explained.abstains) {
    painter.setPen(theme::mutedInk());
    painter.drawText(forces, Qt::AlignRight | Qt::AlignVCenter, tr("no rule fires"));
    return;
  }
  sketch.set(explained.aggregated, color);
  sketch.mark(explained.force_n, theme::ink());
  painter.setPen(theme::ink());
  painter.setFont(theme::headingFont());
  painter.drawText(forces, Qt::AlignRight | Qt::AlignTop, forceText(explained.force_n, model.output.unit));
  painter.setPen(theme::mutedInk());
  painter.setFont(theme::smallFont());
  painter.drawText(
      forces, Qt::AlignRight | Qt::AlignBottom,
      tr("× %1 = %2")
          .arg(numberText(explained.weight_share, 3), forceText(explained.contribution_n, model.output.unit)));
}

QString ExpertFlow::strongestRule(std::size_t expert) const {
  const fuzzy::ForceModel& model = scene_.model()->model;
  const std::vector<analysis::ExplainedRule>& rules = scene_.explanation().experts[expert].rules;
  const auto strongest = std::max_element(
      rules.begin(), rules.end(), [](const auto& one, const auto& other) { return one.strength < other.strength; });
  if (strongest == rules.end() || strongest->strength <= 0) return {};
  const auto acting = std::count_if(rules.begin(), rules.end(), [](const auto& rule) { return rule.strength > 0; });
  const fuzzy::Expert& said = model.experts[expert];
  const fuzzy::Rule& rule = said.rules[strongest->rule];
  // The terms alone; the variables stand in the rule viewer of the expert.
  QStringList terms;
  for (const fuzzy::Condition& condition : rule.conditions) {
    const auto input = std::find_if(model.inputs.begin(), model.inputs.end(),
                                    [&condition](const auto& variable) { return variable.id == condition.input; });
    terms << labelOf(*fuzzy::findTerm(fuzzy::termsFor(said, *input), condition.term));
  }
  const QString words = terms.join(QStringLiteral(", ")) + QStringLiteral(" → ") +
                        labelOf(*fuzzy::findTerm(fuzzy::termsFor(said, model.output), rule.then));
  return acting == 1 ? words : tr("%n rule(s) · %1", nullptr, static_cast<int>(acting)).arg(words);
}

}  // namespace tactus::workbench
