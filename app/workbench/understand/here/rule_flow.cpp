#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPaintEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <utility>

#include "app/editing/edit.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/plot/term_marks.h"
#include "app/workbench/understand/here/rule_panel.h"
#include "app/workbench/understand/here/variable_row.h"

namespace tactus::workbench {
namespace {

constexpr double kLine = 50;       // px, height of a rule
constexpr double kStrength = 56;   // px, width of the strengths
constexpr double kNarrowest = 58;  // px, width of a cell
constexpr double kFlowPad = 3;     // px, beside what is in a cell

double lineHeight() { return QFontMetricsF(theme::smallFont()).height(); }
// The name of a column above its value, which is never cut.
double headHeight() { return 2 * lineHeight() + theme::kGrid; }

std::size_t indexOf(const std::vector<fuzzy::Term>& terms, const std::string& id) {
  const auto found = std::find_if(terms.begin(), terms.end(), [&id](const auto& term) { return term.id == id; });
  return static_cast<std::size_t>(found - terms.begin());
}

void drawElided(QPainter& painter, const QRectF& place, Qt::Alignment alignment, const QString& text) {
  painter.drawText(place, static_cast<int>(alignment),
                   painter.fontMetrics().elidedText(text, Qt::ElideRight, static_cast<int>(place.width())));
}

// The id in words where the label has no room: two of them may begin alike.
void drawName(QPainter& painter, const QRectF& place, const fuzzy::Variable& variable) {
  const bool fits = painter.fontMetrics().horizontalAdvance(labelOf(variable)) <= place.width();
  drawElided(painter, place, Qt::AlignLeft | Qt::AlignTop, fits ? labelOf(variable) : shortLabelOf(variable));
}

// A number behind a name, which gives way.
void drawTerm(QPainter& painter, const QRectF& place, const QString& name, double membership) {
  const QString number = QLatin1Char(' ') + numberText(membership);
  const QFontMetrics metrics = painter.fontMetrics();
  const int room = static_cast<int>(place.width()) - metrics.horizontalAdvance(number);
  painter.drawText(place, Qt::AlignLeft | Qt::AlignTop, metrics.elidedText(name, Qt::ElideRight, room) + number);
}

}  // namespace

RuleFlow::RuleFlow(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Rules that act here"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::MinimumExpanding);
}

void RuleFlow::set(std::shared_ptr<const OpenModel> open, const analysis::Explanation& explanation,
                   std::size_t expert) {
  open_ = std::move(open);
  expert_ = expert;
  explained_ = explanation.experts[expert];
  values_.clear();
  for (const analysis::ExplainedInput& input : explanation.inputs) values_.push_back(input.value);

  const std::vector<fuzzy::Rule>& rules = open_->model.experts[expert].rules;
  inputs_.clear();
  for (std::size_t i = 0; i < open_->model.inputs.size(); ++i) {
    const std::string& id = open_->model.inputs[i].id;
    const bool read = std::any_of(rules.begin(), rules.end(), [&id](const fuzzy::Rule& rule) {
      return std::any_of(rule.conditions.begin(), rule.conditions.end(),
                         [&id](const fuzzy::Condition& condition) { return condition.input == id; });
    });
    if (read) inputs_.push_back(i);
  }
  acting_.clear();
  for (const analysis::ExplainedRule& rule : explained_.rules) {
    if (rule.strength > 0) acting_.push_back(rule);
  }
  std::stable_sort(acting_.begin(), acting_.end(),
                   [](const auto& one, const auto& other) { return one.strength > other.strength; });
  updateGeometry();
  update();
}

QSize RuleFlow::sizeHint() const {
  return {640, static_cast<int>(headHeight() + kLine * static_cast<double>(std::max<std::size_t>(1, acting_.size())))};
}

QSize RuleFlow::minimumSizeHint() const {
  return {static_cast<int>(kStrength + kNarrowest * static_cast<double>(inputs_.size() + 1)), sizeHint().height()};
}

void RuleFlow::paintEvent(QPaintEvent* event) {
  if (!open_) return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(theme::smallFont());
  paintHead(painter);
  if (acting_.empty()) {
    painter.setPen(theme::mutedInk());
    painter.drawText(QRectF(0, headHeight(), width(), kLine), Qt::AlignCenter,
                     tr("No rule of %1 fires here.").arg(labelOf(open_->model.experts[expert_])));
  }
  for (std::size_t line = 0; line < acting_.size(); ++line) {
    const bool in_sight = lineTop(line) <= event->rect().bottom() && lineTop(line + 1) >= event->rect().top();
    if (in_sight) paintLine(painter, line);
  }
}

void RuleFlow::setSelected(const std::vector<std::size_t>& rules) {
  if (rules == selected_) return;
  selected_ = rules;
  const auto line = selectedLine();
  setAccessibleDescription(line ? sentenceOf(*line) : QString());
  update();
}

int RuleFlow::selectedBottom() const {
  const auto line = selectedLine();
  return line ? static_cast<int>(lineTop(*line + 1)) : 0;
}

void RuleFlow::mousePressEvent(QMouseEvent* event) {
  const auto line = lineAt(event->position().y());
  if (line && event->button() == Qt::LeftButton) emit chosen(acting_[*line].rule);
}

void RuleFlow::mouseDoubleClickEvent(QMouseEvent* event) {
  if (const auto line = lineAt(event->position().y())) emit editAsked(acting_[*line].rule);
}

void RuleFlow::keyPressEvent(QKeyEvent* event) {
  const auto line = selectedLine();
  const int key = event->key();
  if ((key == Qt::Key_Return || key == Qt::Key_Enter) && line) {
    emit editAsked(acting_[*line].rule);
  } else if (key == Qt::Key_Down && !acting_.empty()) {
    emit chosen(acting_[line ? std::min(*line + 1, acting_.size() - 1) : 0].rule);
  } else if (key == Qt::Key_Up && line && *line > 0) {
    emit chosen(acting_[*line - 1].rule);
  } else {
    QWidget::keyPressEvent(event);
  }
}

bool RuleFlow::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip || !open_) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  if (const auto line = lineAt(help->pos().y())) {
    QToolTip::showText(help->globalPos(),
                       sentenceOf(*line) + QLatin1Char('\n') + tr("Click to select it, double-click to edit it"), this);
    return true;
  }
  QToolTip::hideText();
  return true;
}

QString RuleFlow::sentenceOf(std::size_t line) const {
  const fuzzy::Expert& expert = open_->model.experts[expert_];
  const fuzzy::Rule& rule = expert.rules[acting_[line].rule];
  return tr("Rule %1: %2 THEN %3 is %4")
      .arg(acting_[line].rule + 1)
      .arg(text(editing::conditionsText(open_->model, expert, rule)), labelOf(open_->model.output),
           text(editing::consequentText(open_->model, expert, rule.then)));
}

std::optional<std::size_t> RuleFlow::lineAt(double y) const {
  for (std::size_t line = 0; line < acting_.size(); ++line) {
    if (y >= lineTop(line) && y < lineTop(line + 1)) return line;
  }
  return std::nullopt;
}

std::optional<std::size_t> RuleFlow::selectedLine() const {
  for (std::size_t line = 0; line < acting_.size(); ++line) {
    if (std::find(selected_.begin(), selected_.end(), acting_[line].rule) != selected_.end()) return line;
  }
  return std::nullopt;
}

RuleFlow::Columns RuleFlow::columns(double top, double height) const {
  const double cell = (width() - kStrength) / static_cast<double>(inputs_.size() + 1);
  Columns columns;
  double left = 0;
  for (std::size_t i = 0; i < inputs_.size(); ++i, left += cell) columns.inputs.emplace_back(left, top, cell, height);
  columns.strength = QRectF(left, top, kStrength, height);
  columns.output = QRectF(left + kStrength, top, cell, height);
  return columns;
}

double RuleFlow::lineTop(std::size_t line) const { return headHeight() + kLine * static_cast<double>(line); }

void RuleFlow::paintHead(QPainter& painter) const {
  const Columns place = columns(0, headHeight());
  for (std::size_t i = 0; i < inputs_.size(); ++i) {
    const fuzzy::Variable& input = open_->model.inputs[inputs_[i]];
    const QRectF head = place.inputs[i].adjusted(kFlowPad, 0, -kFlowPad, 0);
    painter.setPen(theme::mutedInk());
    drawName(painter, head, input);
    painter.setPen(theme::ink());
    drawElided(painter, head.adjusted(0, lineHeight(), 0, 0), Qt::AlignLeft | Qt::AlignTop,
               placeText(input, values_[inputs_[i]]));
  }
  painter.setPen(theme::mutedInk());
  drawElided(painter, place.strength.adjusted(0, 0, -8, 0), Qt::AlignRight | Qt::AlignTop, tr("strength"));
  drawName(painter, place.output.adjusted(kFlowPad, 0, -kFlowPad, 0), open_->model.output);
}

void RuleFlow::paintLine(QPainter& painter, std::size_t line) const {
  const double top = lineTop(line);
  if (line % 2 == 0) painter.fillRect(QRectF(0, top, width(), kLine), theme::window());
  if (std::find(selected_.begin(), selected_.end(), acting_[line].rule) != selected_.end()) {
    painter.setPen(QPen(theme::accent(), hasFocus() ? 2 : 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(QRectF(1, top + 1, width() - 2, kLine - 2), 4, 4);
  }
  const Columns place = columns(top, kLine);
  for (std::size_t i = 0; i < inputs_.size(); ++i) paintCondition(painter, place.inputs[i], inputs_[i], acting_[line]);
  paintStrength(painter, place.strength, acting_[line]);
  paintOutput(painter, place.output, acting_[line]);
}

void RuleFlow::paintCondition(QPainter& painter, const QRectF& cell, std::size_t input,
                              const analysis::ExplainedRule& rule) const {
  const fuzzy::Variable& variable = open_->model.inputs[input];
  const fuzzy::Expert& expert = open_->model.experts[expert_];
  const std::vector<fuzzy::Condition>& conditions = expert.rules[rule.rule].conditions;
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    if (conditions[i].input != variable.id) continue;
    const std::vector<fuzzy::Term>& terms = fuzzy::termsFor(expert, variable);
    const std::size_t term = indexOf(terms, conditions[i].term);
    const QColor color = termFill(variable, terms, term);
    const double words = QFontMetricsF(painter.font()).height();
    SetSketch sketch(painter, cell.adjusted(kFlowPad, 3 + words, -kFlowPad, -4), variable);
    sketch.ground();
    sketch.implied(terms[term], rule.memberships[i], fuzzy::Implication::kClip, color);
    sketch.term(terms[term], color);
    sketch.level(rule.memberships[i], values_[input], theme::mutedInk());
    sketch.mark(values_[input], theme::accent());
    // The smallest membership is what counts.
    painter.setPen(i == rule.smallest_condition ? theme::ink() : theme::mutedInk());
    drawTerm(painter, cell.adjusted(kFlowPad, 2, -kFlowPad, 0), labelOf(terms[term]), rule.memberships[i]);
  }
}

void RuleFlow::paintStrength(QPainter& painter, const QRectF& cell, const analysis::ExplainedRule& rule) const {
  const QRectF bar = cell.adjusted(4, cell.height() - 14, -8, -8);
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme::border());
  painter.drawRoundedRect(bar, 3, 3);
  painter.setBrush(theme::accent());
  painter.drawRoundedRect(QRectF(bar.topLeft(), QSizeF(std::max(3.0, bar.width() * rule.strength), bar.height())), 3,
                          3);
  painter.setPen(theme::ink());
  painter.drawText(cell.adjusted(4, 0, -8, -14), Qt::AlignRight | Qt::AlignVCenter, numberText(rule.strength, 3));
}

void RuleFlow::paintOutput(QPainter& painter, const QRectF& cell, const analysis::ExplainedRule& rule) const {
  const fuzzy::Expert& expert = open_->model.experts[expert_];
  const std::vector<fuzzy::Term>& terms = fuzzy::termsFor(expert, open_->model.output);
  const std::size_t term = indexOf(terms, expert.rules[rule.rule].then);
  const QColor color = termFill(open_->model.output, terms, term);
  const double words = QFontMetricsF(painter.font()).height();
  SetSketch sketch(painter, cell.adjusted(kFlowPad, 3 + words, -kFlowPad, -4), open_->model.output);
  sketch.ground();
  // A rule that is not the strongest of its term adds nothing, and its set stays an outline.
  if (rule.wins) sketch.implied(terms[term], rule.strength, open_->model.implication, color);
  sketch.term(terms[term], color);
  painter.setPen(rule.wins ? theme::ink() : theme::mutedInk());
  drawElided(painter, cell.adjusted(kFlowPad, 2, -kFlowPad, 0), Qt::AlignLeft | Qt::AlignTop,
             rule.wins ? labelOf(terms[term]) : tr("%1, as above").arg(labelOf(terms[term])));
}

}  // namespace tactus::workbench
