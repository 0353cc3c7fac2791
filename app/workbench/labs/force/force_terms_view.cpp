#include "app/workbench/labs/force/force_terms_view.h"

#include <QButtonGroup>
#include <QEvent>
#include <QFontMetrics>
#include <QLabel>
#include <QRadioButton>
#include <QTimer>
#include <algorithm>
#include <numeric>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/labs/force/force_lab.h"
#include "app/workbench/plot/plot_marks.h"
#include "app/workbench/plot/plot_style.h"
#include "app/workbench/plot/term_marks.h"

namespace tactus::workbench {
namespace {

constexpr double kDot = 7;    // px
constexpr int kNarrow = 200;  // px: below it ticks would touch
constexpr int kFewTicks = 2;
constexpr int kUsualTicks = 5;
constexpr float kFill = 0.10F;
constexpr double kAsideShare = 0.014;  // of the axis: equal shares of one force would hide each other

}  // namespace

ForceTermsPlot::ForceTermsPlot(QWidget* parent)
    : ChartView(parent), corners_(new VertexPick(plot(), tr("Click: where does this corner come from?"))) {
  connect(corners_, &VertexPick::picked, this, &ForceTermsPlot::vertexAsked);
  setMinimumSize(120, 96);
  plot().axisRect()->setMinimumMargins(QMargins(0, theme::kGrid / 2, theme::kGrid + 4, 0));
  setAccessibleName(tr("Words of the force"));
}

void ForceTermsPlot::setTerms(const fuzzy::Variable& words, const std::vector<fuzzy::Term>& terms,
                              const std::vector<elicitation::VoteStep>& votes, double end_n,
                              const std::vector<fuzzy::Term>& former) {
  Chart chart{{.universe = words, .grid = false}, membershipAxis()};  // the dots of full shares stay whole
  chart.x.universe.max = end_n;
  has_ghosts_ = addGhosts(chart, words, terms, former, words.min, end_n);
  std::vector<VertexPick::Vertex> corners;
  const double middle = 0.5 * static_cast<double>(words.terms.size() - 1);
  for (std::size_t k = 0; k < words.terms.size(); ++k) {
    const QColor line = termLine(words, words.terms, k);
    if (const fuzzy::Term* const term = fuzzy::findTerm(terms, words.terms[k].id)) {
      const TermOutline outline = outlineOf(*term, words.min, end_n);
      chart.parts.emplace_back(filledLine(outline.x, outline.membership, line, 2, kFill));
      for (std::size_t p = 0; p < term->points.size(); ++p) {
        corners.push_back({term->id, p, term->points[p], p == 0 || p + 1 == term->points.size() ? 0.0 : 1.0});
      }
    }
    ChartLine shares{{}, {}, Qt::NoPen, {ChartDots::Shape::kCircle, kDot, QPen(theme::card(), 1), line}};
    for (const elicitation::VoteStep& step : votes) {
      const int cast = std::accumulate(step.votes.begin(), step.votes.end(), 0);
      if (cast == 0 || step.votes[k] == 0) continue;
      shares.x << step.force_n + kAsideShare * end_n * (static_cast<double>(k) - middle);
      shares.y << static_cast<double>(step.votes[k]) / cast;
    }
    chart.parts.emplace_back(shares);
    chart.legend.push_back({labelOf(words.terms[k]), QPen(line, 2)});
  }
  if (has_ghosts_) chart.legend.push_back({tr("Before the change"), ghostPen(theme::ink())});
  // Ends of the universe come from no answer.
  std::erase_if(corners, [&](const auto& one) { return one.x <= words.min || one.x >= end_n; });
  corners_->setVertices(std::move(corners));
  axis_text_ = axisText(chart.x.universe);
  axis_unit_ = QString::fromStdString(words.unit);
  setChart(chart);
  fitAxis();
}

void ForceTermsPlot::fitAxis() {
  plot().xAxis->ticker()->setTickCount(width() < kNarrow ? kFewTicks : kUsualTicks);
  // The text stands in the middle of the axis, which begins beside the numbers of the other one.
  const QFontMetrics metrics(plot().xAxis->labelFont());
  const int beside = metrics.horizontalAdvance(QStringLiteral("0.5")) + 4 * theme::kGrid;
  plot().xAxis->setLabel(metrics.horizontalAdvance(axis_text_) + beside <= width() ? axis_text_ : axis_unit_);
}

void ForceTermsPlot::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fitAxis();
}

namespace {

constexpr int kDecimals = 3;
constexpr int kFewDecimals = 2;  // in a narrow column; the hint has all

// `S  0.2 · 0.3 · 0.4 · 0.5`: the corners of each word on a line.
QString cornersOf(const std::vector<fuzzy::Term>& terms, int decimals, const QString& after, const QString& between) {
  QStringList lines;
  for (const fuzzy::Term& term : terms) {
    QStringList points;
    for (const double point : term.points) points << numberText(point, decimals);
    lines << initialsOf(labelOf(term)) + after + points.join(between);
  }
  return lines.join(QLatin1Char('\n'));
}

QString wideCorners(const std::vector<fuzzy::Term>& terms) {
  return cornersOf(terms, kDecimals, QStringLiteral("  "), QStringLiteral(" · "));
}

QString narrowCorners(const std::vector<fuzzy::Term>& terms) {
  return cornersOf(terms, kFewDecimals, QStringLiteral(" "), QStringLiteral(" "));
}

// The axes of all methods end at the same force, so that the pictures can be compared.
double commonEnd(const ForceVotes& votes) {
  double end_n = 0;
  for (const ForceMethod& method : votes.methods) {
    if (method.terms) end_n = std::max(end_n, method.terms->output.max);
  }
  return end_n > 0 ? end_n : votes.words.max;
}

}  // namespace

ForceTermsView::ForceTermsView(QWidget* parent) : QWidget(parent) {
  auto* row = makeRow(this, {}, theme::kGrid, inset(theme::kGrid));
  auto* group = new QButtonGroup(this);
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    row->addWidget(makeMethodColumn(i), 1);
    group->addButton(columns_[i].choice, static_cast<int>(i));
  }
  connect(group, &QButtonGroup::idClicked, this,
          [this](int index) { emit chosen(kForceMethods[static_cast<std::size_t>(index)]); });
}

namespace {

QString hintOf(elicitation::ForceTermsFrom from) {
  return ForceTermsView::tr("Take the words of the force in the model from here.") + QLatin1Char('\n') +
         methodRule(from);
}

}  // namespace

QWidget* ForceTermsView::makeMethodColumn(std::size_t index) {
  Column& made = columns_[index];
  auto* column = new QWidget(this);
  made.choice = new QRadioButton(methodName(kForceMethods[index]), column);
  made.choice->setFont(theme::headingFont());
  made.choice->setToolTip(hintOf(kForceMethods[index]));
  made.effect = new QLabel(column);
  made.effect->setToolTip(tr("How far the averaged force moves if the words are taken from here."));
  made.rule = new WrappedLabel(column);
  made.rule->setText(methodRule(kForceMethods[index]));
  made.rule->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  setMuted(*made.rule);
  made.plot = new ForceTermsPlot(column);
  connect(made.plot, &ForceTermsPlot::vertexAsked, this, [this, index](const std::string& term, std::size_t point) {
    if (columns_[index].choice->isChecked()) return emit vertexAsked(term, point);
    // The corners of a method that the model does not use become those of the model first.
    columns_[index].choice->click();
    emit vertexAsked(term, point);
  });
  made.corners = new WrappedLabel(column);
  made.corners->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  made.corners->setTextInteractionFlags(Qt::TextSelectableByMouse);
  setMuted(*made.corners);
  made.head = makeRow({{made.choice, 1}}, kStyleGap);
  makeColumn(column, {made.head, made.effect, made.rule, {made.plot, 1}, made.corners}, theme::kGrid / 2);
  return column;
}

ForceTermsView::Column& ForceTermsView::columnOf(elicitation::ForceTermsFrom from) {
  const auto found = std::find(kForceMethods.begin(), kForceMethods.end(), from);
  return columns_[static_cast<std::size_t>(found - kForceMethods.begin())];
}

void ForceTermsView::setEffect(elicitation::ForceTermsFrom from, const QString& effect) {
  Column& column = columnOf(from);
  column.effect->setText(effect.isEmpty() && column.plot->hasGhosts() ? tr("Dashed: before the change.") : effect);
  column.choice->setToolTip(effect.isEmpty() ? hintOf(from) : hintOf(from) + QLatin1Char('\n') + effect);
}

ForceTermsPlot& ForceTermsView::plot(elicitation::ForceTermsFrom from) { return *columnOf(from).plot; }

void ForceTermsView::addTool(elicitation::ForceTermsFrom from, QWidget* tool) { columnOf(from).head->addWidget(tool); }

void ForceTermsView::setVotes(const ForceVotes& votes, elicitation::ForceTermsFrom chosen,
                              const std::vector<fuzzy::Term>& former) {
  const double end_n = commonEnd(votes);
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const ForceMethod& method = votes.methods[i];
    Column& column = columns_[i];
    column.choice->setEnabled(method.terms.has_value());
    if (kForceMethods[i] == chosen) column.choice->setChecked(true);
    column.terms = method.terms ? method.terms->output.terms : std::vector<fuzzy::Term>();
    column.plot->setTerms(votes.words, column.terms, votes.steps, end_n,
                          kForceMethods[i] == chosen ? former : std::vector<fuzzy::Term>());
    if (method.terms) {
      tellCorners(column);
      QStringList hint(wideCorners(column.terms));
      for (const std::string& note : method.terms->notes) hint << text(note);
      column.corners->setToolTip(hint.join(QLatin1Char('\n')));
    } else {
      column.corners->setText(method.refusal);
      column.corners->setToolTip({});
    }
  }
  fitTexts();
}

// On one line each, however narrow the column is.
void ForceTermsView::tellCorners(const Column& column) {
  if (column.terms.empty()) return;
  const QString whole = wideCorners(column.terms);
  const bool fits = QFontMetrics(column.corners->font()).size(0, whole).width() <= column.plot->width();
  column.corners->setText(fits ? whole : narrowCorners(column.terms));
}

// The rules take the lines of the longest one, so that the pictures stand side by side. Where the view is too low for
// rules, pictures and corners, the rules are hints of the names alone, and so are the newtons where it is lower still.
void ForceTermsView::fitTexts() {
  int rule = 0;
  int corners = 0;
  for (const Column& column : columns_) {
    tellCorners(column);
    const QRect room(0, 0, column.plot->width(), QWIDGETSIZE_MAX);
    const auto heightOf = [&room](const QLabel& label) {
      return QFontMetrics(label.font()).boundingRect(room, Qt::TextWordWrap, label.text()).height();
    };
    rule = std::max(rule, heightOf(*column.rule));
    corners = std::max(corners, heightOf(*column.corners));
  }
  const Column& first = columns_.front();
  const int others = first.choice->sizeHint().height() + first.plot->minimumHeight() + corners + 4 * theme::kGrid;
  const int effect = first.effect->sizeHint().height() + theme::kGrid / 2;
  for (const Column& column : columns_) {
    column.rule->setFixedHeight(rule);
    column.rule->setVisible(rule + effect + others <= height());
    column.effect->setVisible(effect + others <= height());
    column.corners->setMinimumHeight(corners);
  }
}

void ForceTermsView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  // The layout gives the columns their width at once.
  layout()->activate();
  fitTexts();
}

// The labels take their new font after this.
void ForceTermsView::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange) QTimer::singleShot(0, this, &ForceTermsView::fitTexts);
}

}  // namespace tactus::workbench
