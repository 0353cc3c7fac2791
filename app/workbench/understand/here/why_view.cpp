#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPaintEvent>
#include <QPainter>
#include <QResizeEvent>
#include <QToolTip>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/figures/colors.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/plot/term_marks.h"
#include "app/workbench/understand/here/rule_panel.h"
#include "core/fuzzy/membership.h"

namespace tactus::workbench {
namespace {

constexpr double kLineGap = 5;        // px, above and below the text of a line together
constexpr double kCellGap = 10;       // px, between cells
constexpr double kBarHeight = 9;      // px
constexpr double kShortestBars = 36;  // px, of the room for both directions
constexpr double kLongestBars = 220;
constexpr double kMostName = 0.45;  // of the line, beside bars
constexpr double kBetweenColumns = 24;
constexpr double kWordsShare = 0.43;      // of two columns; the others have more numbers
constexpr double kCharactersForTwo = 76;  // the least width for two columns side by side
constexpr int kNarrowestWhy = 220;        // px
constexpr std::size_t kRulesOfMove = 4;   // the strongest: a move is felt through few

double whyLineHeight() { return QFontMetricsF(theme::smallFont()).height() + kLineGap; }

/// What a click on another line shows below it.
bool isBelow(const WhyView::Line& line) {
  using Kind = WhyView::Kind;
  return line.kind == Kind::kRule || line.kind == Kind::kAnswer || line.kind == Kind::kTerm;
}

bool isSteady(const WhyView::Line& line) {
  return line.kind == WhyView::Kind::kHead || line.kind == WhyView::Kind::kNote;
}

QColor colorOfWord(const fuzzy::ForceModel& model, const std::string& word) {
  const auto& terms = model.output.terms;
  const auto found = std::find_if(terms.begin(), terms.end(), [&](const auto& term) { return term.id == word; });
  if (found == terms.end()) return theme::accent();
  return termFill(model.output, terms, static_cast<std::size_t>(found - terms.begin()));
}

/// Places for the numbers: as wide as the widest of the same column, section by section.
std::vector<double> widthsFrom(const std::vector<WhyView::Line>& lines, std::size_t head) {
  const QFontMetricsF metrics(theme::smallFont());
  std::vector<double> widths;
  for (std::size_t i = head; i < lines.size() && (i == head || lines[i].kind != WhyView::Kind::kHead); ++i) {
    for (qsizetype cell = 1; cell < lines[i].cells.size(); ++cell) {
      const auto column = static_cast<std::size_t>(cell - 1);
      if (column >= widths.size()) widths.resize(column + 1, 0);
      widths[column] = std::max(widths[column], metrics.horizontalAdvance(lines[i].cells[cell]));
    }
  }
  return widths;
}

}  // namespace

WhyView::WhyView(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Why this force: words, experts and moves"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void WhyView::set(std::shared_ptr<const OpenModel> open, std::vector<double> point, std::optional<std::size_t> expert,
                  std::shared_ptr<const analysis::Reasons> reasons) {
  open_ = std::move(open);
  point_ = std::move(point);
  expert_ = expert;
  reasons_ = std::move(reasons);
  makeLines();
}

void WhyView::setAnswersKnown(bool known) {
  if (std::exchange(answers_known_, known) != known) makeLines();
}

void WhyView::clear() {
  reasons_ = nullptr;
  makeLines();
}

std::vector<std::size_t> WhyView::rulesOf(std::size_t expert, const std::string& term) const {
  std::vector<std::size_t> out;
  if (!reasons_) return out;
  for (const analysis::RulePull& rule : reasons_->balance.rules) {
    if (rule.expert == expert && open_->model.experts[expert].rules[rule.rule].then == term) out.push_back(rule.rule);
  }
  return out;
}

void WhyView::makeLines() {
  words_.clear();
  others_.clear();
  if (reasons_ && reasons_->fired) {
    addWords();
    addExperts();
    addMoves();
  }
  // A rule may stand below a word and below a move.
  for (auto* lines : {&words_, &others_}) {
    QString above;
    for (Line& line : *lines) {
      if (!isBelow(line)) above = QString::number(static_cast<int>(line.kind)) + line.cells[0];
      line.key = isBelow(line) ? above + QLatin1Char('\n') + line.cells[0] : above;
    }
  }
  const Line* const line = current();
  setAccessibleDescription(line != nullptr ? line->cells.join(QStringLiteral(", ")) : QString());
  fit();
  update();
}

void WhyView::addWords() {
  const fuzzy::ForceModel& model = open_->model;
  words_.push_back({Kind::kHead, {tr("Word"), tr("share"), tr("pull")}});
  for (const analysis::WordPull& word : reasons_->balance.words) {
    Line line{Kind::kWord,
              {text(analysis::wordLabel(model, word.term)), tr("%1 %").arg(100 * word.share, 0, 'f', 1),
               text(analysis::signedNewtons(word.pull_n))}};
    line.pull_n = word.pull_n;
    line.color = colorOfWord(model, word.term);
    line.term = word.term;
    words_.push_back(std::move(line));
    if (word.term != chosen_) continue;
    for (const analysis::RulePull& rule : reasons_->balance.rules) {
      if (model.experts[rule.expert].rules[rule.rule].then == word.term) addRule(words_, rule);
    }
  }
}

// With the way to the answer behind it once it is chosen.
void WhyView::addRule(std::vector<Line>& lines, const analysis::RulePull& rule) const {
  const fuzzy::ForceModel& model = open_->model;
  const QString who = labelOf(model.experts[rule.expert]);
  Line said{Kind::kRule,
            {tr("%1, rule %2: %3")
                 .arg(who, QString::number(rule.rule + 1), text(analysis::conditionsOf(model, rule.expert, rule.rule))),
             QString(), text(analysis::signedNewtons(rule.pull_n))}};
  said.expert = rule.expert;
  said.rule = rule.rule;
  lines.push_back(said);
  if (!answers_known_ || chosen_rule_ != std::pair(rule.expert, rule.rule)) return;
  Line answer{Kind::kAnswer, {tr("The answer of %1 behind rule %2…").arg(who).arg(rule.rule + 1)}};
  answer.expert = rule.expert;
  answer.rule = rule.rule;
  lines.push_back(std::move(answer));
}

void WhyView::addExperts() {
  if (reasons_->balance.experts.size() < 2) return;
  const fuzzy::ForceModel& model = open_->model;
  const std::vector<std::size_t> numbers = figures::expertNumbers(model.experts);
  others_.push_back({Kind::kHead, {tr("Expert"), tr("force"), tr("change if left out")}});
  for (const analysis::ExpertPull& expert : reasons_->balance.experts) {
    Line line{Kind::kExpert,
              {labelOf(model.experts[expert.expert]), forceText(expert.force_n, model.output.unit),
               text(analysis::signedNewtons(-expert.leave_one_out_n.value_or(0)))}};
    line.expert = expert.expert;
    line.color = theme::expert(numbers[expert.expert]);
    others_.push_back(std::move(line));
  }
}

void WhyView::addMoves() {
  const fuzzy::ForceModel& model = open_->model;
  others_.push_back({Kind::kHead, {tr("Felt when"), tr("at"), tr("by"), tr("force")}});
  const std::size_t head = others_.size();
  for (const analysis::Counterfactual& move : reasons_->counterfactuals) {
    if (move.kind != analysis::Counterfactual::Kind::kNoticeable) continue;
    const fuzzy::Variable& input = model.inputs[move.input];
    const QString by = (move.delta < 0 ? QString() : QStringLiteral("+")) + QString::number(move.delta, 'f', 3);
    Line line{Kind::kMove,
              {shortLabelOf(input), text(analysis::withUnit(move.value, input)), by,
               text(analysis::signedNewtons(move.force_n - reasons_->balance.force_n))}};
    line.input = move.input;
    others_.push_back(std::move(line));
    if (move.input == chosen_move_) addMoved(move);
  }
  if (others_.size() == head)
    others_.back() = Line{Kind::kNote, {tr("No input alone makes a difference that is felt.")}};
}

const std::vector<fuzzy::Term>& WhyView::termsOf(const fuzzy::Variable& input) const {
  return expert_ ? fuzzy::termsFor(open_->model.experts[*expert_], input) : input.terms;
}

// A move acts by the terms that hold more or less after it, and by the rules that have them as a condition.
void WhyView::addMoved(const analysis::Counterfactual& move) {
  const fuzzy::Variable& input = open_->model.inputs[move.input];
  std::vector<std::string> moved;
  for (const fuzzy::Term& term : termsOf(input)) {
    const auto membership = fuzzy::MembershipFunction::of(term);
    const double before = membership(point_[move.input]);
    const double after = membership(move.value);
    if (before == after) continue;
    Line line{Kind::kTerm,
              {tr("Term %1: membership %2 → %3").arg(labelOf(term), numberText(before, 2), numberText(after, 2))}};
    line.input = move.input;
    line.term = term.id;
    moved.push_back(term.id);
    others_.push_back(std::move(line));
  }
  std::size_t shown = 0;
  for (const analysis::RulePull& rule : reasons_->balance.rules) {
    const auto& conditions = open_->model.experts[rule.expert].rules[rule.rule].conditions;
    const bool acts = std::any_of(conditions.begin(), conditions.end(), [&](const fuzzy::Condition& one) {
      return one.input == input.id && std::find(moved.begin(), moved.end(), one.term) != moved.end();
    });
    if (acts && shown++ < kRulesOfMove) addRule(others_, rule);
  }
}

std::vector<WhyView::Placed> WhyView::placed() const {
  const double height = whyLineHeight();
  const QFontMetricsF metrics(theme::smallFont());
  const bool two = !words_.empty() && !others_.empty() && width() >= kCharactersForTwo * metrics.averageCharWidth();
  const double first = two ? (width() - kBetweenColumns) * kWordsShare : width();
  std::vector<Placed> out;
  const auto add = [&](const std::vector<Line>& lines, double left, double right, double top) {
    std::vector<double> widths;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (i == 0 || lines[i].kind == Kind::kHead) widths = widthsFrom(lines, i);
      if (i > 0 && lines[i].kind == Kind::kHead) top += theme::kGrid / 2.0;
      out.push_back({&lines[i], QRectF(left, top, right - left, height), widths});
      top += height;
    }
    return top;
  };
  const double below = add(words_, 0, first, 0);
  add(others_, two ? first + kBetweenColumns : 0, width(), two || words_.empty() ? 0 : below + theme::kGrid / 2.0);
  return out;
}

void WhyView::fit() {
  double bottom = 0;
  for (const Placed& one : placed()) bottom = std::max(bottom, one.place.bottom());
  const int height = static_cast<int>(std::ceil(bottom));
  if (height != minimumHeight() || height != maximumHeight()) setFixedHeight(height);
}

QSize WhyView::sizeHint() const { return {640, minimumHeight()}; }

QSize WhyView::minimumSizeHint() const { return {kNarrowestWhy, minimumHeight()}; }

void WhyView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fit();
}

void WhyView::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) fit();
}

void WhyView::paintEvent(QPaintEvent* event) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(theme::smallFont());
  for (const Placed& one : placed()) {
    if (one.place.toAlignedRect().intersects(event->rect())) paintLine(painter, one);
  }
}

void WhyView::paintLine(QPainter& painter, const Placed& placed) const {
  const Line& line = *placed.line;
  const QFontMetricsF metrics(theme::smallFont());
  const QRectF& place = placed.place;
  const bool open =
      (line.kind == Kind::kWord && line.term == chosen_) || (line.kind == Kind::kMove && line.input == chosen_move_);
  if (&line == current() || open) {
    painter.setPen(QPen(theme::accent(), hasFocus() && &line == current() ? 2 : 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(place.adjusted(1, 1, -1, -1), 4, 4);
  }
  painter.setPen(line.kind == Kind::kHead || line.kind == Kind::kNote ? theme::mutedInk() : theme::ink());
  QRectF room = place.adjusted(theme::kGrid / 2.0, 0, -theme::kGrid / 2.0, 0);
  // The last number at the right edge, the others before it; the share before the bars.
  const bool bars =
      line.kind == Kind::kWord || line.kind == Kind::kRule || (line.kind == Kind::kHead && &line == words_.data());
  for (qsizetype cell = line.cells.size() - 1; cell > (bars ? 1 : 0); --cell) {
    painter.drawText(room, Qt::AlignRight | Qt::AlignVCenter, line.cells[cell]);
    room.setRight(room.right() - placed.widths[static_cast<std::size_t>(cell - 1)] - kCellGap);
  }
  if (bars && line.kind != Kind::kRule) {
    const double least = std::max(kShortestBars, room.width() * (1 - kMostName) - placed.widths[0] - kCellGap);
    const double length = std::min(kLongestBars, least);
    const QRectF area(room.right() - length, room.top(), length, room.height());
    room.setRight(area.left() - kCellGap);
    painter.drawText(room, Qt::AlignRight | Qt::AlignVCenter, line.cells[1]);
    room.setRight(room.right() - placed.widths[0] - kCellGap);
    if (line.pull_n) {
      double strongest = 0;
      for (const Line& one : words_) strongest = std::max(strongest, std::abs(one.pull_n.value_or(0)));
      const double reach = strongest > 0 ? *line.pull_n / strongest * length / 2 : 0;
      const QRectF bar(std::min(area.center().x(), area.center().x() + reach), area.center().y() - kBarHeight / 2,
                       std::abs(reach), kBarHeight);
      painter.save();
      painter.setPen(QPen(theme::border(), 1));
      painter.setBrush(line.color);
      painter.drawRect(bar);
      painter.setPen(QPen(theme::mutedInk(), 1));
      painter.drawLine(QPointF(area.center().x(), area.top()), QPointF(area.center().x(), area.bottom()));
      painter.restore();
    }
  }
  if (isBelow(line)) room.setLeft(room.left() + (line.kind == Kind::kAnswer ? 4 : 2) * theme::kGrid);
  if (line.kind == Kind::kExpert) {
    painter.save();
    painter.setPen(Qt::NoPen);
    painter.setBrush(line.color);
    painter.drawEllipse(QRectF(room.left(), room.center().y() - 4, 8, 8));
    painter.restore();
    room.setLeft(room.left() + 8 + theme::kGrid / 2.0);
  }
  painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter,
                   metrics.elidedText(line.cells[0], Qt::ElideRight, room.width()));
}

const WhyView::Line* WhyView::lineAt(const QPointF& at) const {
  for (const Placed& one : placed()) {
    if (one.place.contains(at)) return one.line;
  }
  return nullptr;
}

const WhyView::Line* WhyView::current() const {
  if (!current_) return nullptr;
  for (const auto* lines : {&words_, &others_}) {
    for (const Line& line : *lines) {
      if (!isSteady(line) && line.key == *current_) return &line;
    }
  }
  return nullptr;
}

void WhyView::moveTo(const Line& line) {
  current_ = line.key;
  setAccessibleDescription(line.cells.join(QStringLiteral(", ")));
  update();
}

void WhyView::act(const Line& line) {
  switch (line.kind) {
    case Kind::kWord: {
      const std::string term = line.term;
      chosen_ = chosen_ == term ? std::string() : term;
      makeLines();
      if (!chosen_.empty()) emit wordChosen(term);
      break;
    }
    case Kind::kRule: {
      const std::pair rule(line.expert, line.rule);
      if (chosen_rule_ == rule) {
        emit editAsked(rule.first, rule.second);
        break;
      }
      chosen_rule_ = rule;
      makeLines();
      emit ruleChosen(rule.first, rule.second);
      break;
    }
    case Kind::kAnswer: emit answerAsked(line.expert, line.rule); break;
    case Kind::kMove:
      chosen_move_ = chosen_move_ == line.input ? std::nullopt : std::optional(line.input);
      makeLines();
      break;
    case Kind::kTerm: {
      // The own term of the expert whose force is explained, if there is one; else that of all.
      const fuzzy::Variable& input = open_->model.inputs[line.input];
      const bool own = &termsOf(input) != &input.terms;
      emit termAsked({{input.id, own ? open_->model.experts[*expert_].id : std::string()}, line.term});
      break;
    }
    case Kind::kExpert: emit expertChosen(line.expert); break;
    case Kind::kHead:
    case Kind::kNote: break;
  }
}

void WhyView::mousePressEvent(QMouseEvent* event) {
  const Line* const line = lineAt(event->position());
  if (line == nullptr || isSteady(*line) || event->button() != Qt::LeftButton) return;
  moveTo(*line);
  act(*line);
}

void WhyView::mouseDoubleClickEvent(QMouseEvent* event) {
  const Line* const line = lineAt(event->position());
  if (line != nullptr && line->kind == Kind::kRule) emit editAsked(line->expert, line->rule);
}

void WhyView::keyPressEvent(QKeyEvent* event) {
  std::vector<const Line*> lines;
  for (const auto* part : {&words_, &others_}) {
    for (const Line& line : *part) {
      if (!isSteady(line)) lines.push_back(&line);
    }
  }
  const Line* const now = current();
  const auto at = std::find(lines.begin(), lines.end(), now);
  const int key = event->key();
  if ((key == Qt::Key_Return || key == Qt::Key_Enter) && now != nullptr) {
    act(*now);
  } else if (key == Qt::Key_Down && !lines.empty()) {
    moveTo(at == lines.end() ? *lines.front() : at + 1 == lines.end() ? **at : **(at + 1));
  } else if (key == Qt::Key_Up && at != lines.end() && at != lines.begin()) {
    moveTo(**(at - 1));
  } else {
    QWidget::keyPressEvent(event);
  }
}

bool WhyView::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const Line* const line = lineAt(help->pos());
  if (line == nullptr) {
    QToolTip::hideText();
    return true;
  }
  QString says = line->cells.join(QStringLiteral(" · "));
  if (line->kind == Kind::kWord) says += QLatin1Char('\n') + tr("Click to see the rules that say it");
  if (line->kind == Kind::kRule) says += QLatin1Char('\n') + tr("Click to select it, click again to edit it");
  if (line->kind == Kind::kExpert) says += QLatin1Char('\n') + tr("Click to see the rules of this expert");
  if (line->kind == Kind::kMove)
    says += QLatin1Char('\n') + tr("The smallest move of this input that a hand would feel. Click to see the "
                                   "terms and rules by which it acts");
  if (line->kind == Kind::kTerm) says += QLatin1Char('\n') + tr("Click to edit it");
  if (line->kind == Kind::kAnswer) says += QLatin1Char('\n') + tr("Click to see it, and the record of the participant");
  QToolTip::showText(help->globalPos(), says, this);
  return true;
}

}  // namespace tactus::workbench
