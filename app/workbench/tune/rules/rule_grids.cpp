#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QMenu>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/cards.h"
#include "app/workbench/kit/force_word.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/tune/rules/rule_editor.h"

namespace tactus::workbench {
namespace {

constexpr double kGap = 3;           // px, between cells
constexpr double kGridGap = 6;       // px, above the title of a grid
constexpr double kTallestRow = 3.5;  // lines of text; a taller cell only moves the words apart

double headHeight(const RuleGridGeometry::Needs& needs) { return 2 * needs.line + 4; }
double titleHeight(const RuleGridGeometry::Needs& needs) { return needs.line + 4 + kGridGap; }
// Two lines, so that a bar fits below a word.
double smallestRow(const RuleGridGeometry::Needs& needs) { return 2 * needs.line + kGap; }

std::size_t allRows(const RuleGridGeometry::Needs& needs) {
  return std::accumulate(needs.rows.begin(), needs.rows.end(), std::size_t{0});
}

double fixedHeight(const RuleGridGeometry::Needs& needs) {
  return headHeight(needs) + static_cast<double>(needs.rows.size()) * titleHeight(needs);
}

}  // namespace

RuleGridGeometry::RuleGridGeometry(Needs needs, QSizeF room) : needs_(std::move(needs)), width_(room.width()) {
  const auto columns = static_cast<double>(std::max<std::size_t>(1, needs_.columns));
  const auto rows = static_cast<double>(std::max<std::size_t>(1, allRows(needs_)));
  cell_width_ = std::max(needs_.cell, (room.width() - needs_.row_head) / columns);
  cell_height_ = std::clamp((room.height() - fixedHeight(needs_)) / rows, smallestRow(needs_),
                            std::max(smallestRow(needs_), kTallestRow * needs_.line));
}

QSizeF RuleGridGeometry::smallest(const Needs& needs) {
  return {needs.row_head + needs.cell * static_cast<double>(needs.columns),
          fixedHeight(needs) + smallestRow(needs) * static_cast<double>(allRows(needs))};
}

double RuleGridGeometry::rowTop(std::size_t grid, std::size_t row) const {
  const auto before =
      std::accumulate(needs_.rows.begin(), needs_.rows.begin() + static_cast<std::ptrdiff_t>(grid), row);
  return headHeight(needs_) + static_cast<double>(grid + 1) * titleHeight(needs_) +
         cell_height_ * static_cast<double>(before);
}

QRectF RuleGridGeometry::cell(const RuleCell& cell) const {
  return {needs_.row_head + cell_width_ * static_cast<double>(cell.column), rowTop(cell.grid, cell.row),
          cell_width_ - kGap, cell_height_ - kGap};
}

QRectF RuleGridGeometry::columnHead(std::size_t column) const {
  return {needs_.row_head + cell_width_ * static_cast<double>(column), 0, cell_width_, headHeight(needs_)};
}

QRectF RuleGridGeometry::corner() const { return {0, 0, needs_.row_head - theme::kGrid, headHeight(needs_)}; }

QRectF RuleGridGeometry::title(std::size_t grid) const {
  const double height = titleHeight(needs_);
  return {0, rowTop(grid, 0) - height, width_, height};
}

QRectF RuleGridGeometry::rowHead(std::size_t grid, std::size_t row) const {
  return {0, rowTop(grid, row), needs_.row_head - theme::kGrid, cell_height_ - kGap};
}

std::optional<RuleCell> RuleGridGeometry::at(QPointF place) const {
  for (std::size_t g = 0; g < needs_.rows.size(); ++g) {
    for (std::size_t r = 0; r < needs_.rows[g]; ++r) {
      const RuleCell first{g, r, 0};
      const double top = cell(first).top();
      if (place.y() < top || place.y() >= top + cell_height_) continue;
      const double column = (place.x() - needs_.row_head) / cell_width_;
      if (column < 0 || column >= static_cast<double>(needs_.columns)) return std::nullopt;
      return RuleCell{g, r, static_cast<std::size_t>(column)};
    }
  }
  return std::nullopt;
}

namespace {

constexpr double kWordMargin = 13;   // px, around a word in its cell, with the bar of the strength
constexpr double kShortHead = 72;    // px, of the name of a row that stays on one line
constexpr double kWidestHead = 120;  // px

QFont boldFont() {
  QFont font = theme::smallFont();
  font.setWeight(QFont::DemiBold);
  return font;
}

// A term that holds at the place that is read stands out; bold where there is room.
void setHeadInk(QPainter& painter, bool holds, const QString& label, double width) {
  const bool bold = holds && brokenWidth(label, QFontMetricsF(boldFont())) <= width;
  painter.setFont(bold ? boldFont() : theme::smallFont());
  painter.setPen(holds ? theme::readableText(theme::accent()) : theme::mutedInk());
}

QString nameOf(const std::vector<fuzzy::Term>& terms, std::size_t term) {
  return term < terms.size() ? labelOf(terms[term]) : QString();
}

}  // namespace

RuleGrids::RuleGrids(RuleController& rules, QWidget* parent) : QWidget(parent), rules_(rules), flash_(new Flash(this)) {
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Rules as grids of force words"));
  // Other rules may stand in other places, also before they are shown.
  connect(&rules_, &RuleController::rulesChanged, this, &RuleGrids::measureAnew);
  connect(&rules_, &RuleController::selectionChanged, this, [this] {
    if (!isVisible()) return;
    const auto selected = rules_.selected();
    setAccessibleDescription(selected ? tipOf(*selected) : QString());
    update();
  });
  connect(&rules_.selection(), &Selection::rulesPointed, flash_, &Flash::start);
}

RuleGridGeometry::Needs RuleGrids::measured() const {
  RuleGridGeometry::Needs needs;
  if (!rules_.isOpen()) return needs;
  const QFontMetricsF metrics(boldFont());
  needs.line = std::ceil(metrics.height());
  for (const RuleController::Grid& grid : rules_.grids()) {
    needs.rows.push_back(grid.cells.rows.size());
    needs.columns = grid.cells.columns.size();
    for (const fuzzy::Term& term : rules_.terms(grid.id.condition)) {
      const double whole = metrics.horizontalAdvance(labelOf(term));
      needs.row_head = std::max(needs.row_head, whole <= kShortHead ? whole : brokenWidth(labelOf(term), metrics));
    }
  }
  needs.row_head = std::min(std::ceil(needs.row_head), kWidestHead) + 12;
  const QFontMetricsF words(theme::smallFont());
  for (const fuzzy::Term& word : rules_.words()) {
    needs.cell = std::max(needs.cell, std::ceil(brokenWidth(labelOf(word), words)) + kWordMargin);
  }
  return needs;
}

void RuleGrids::measureAnew() {
  needs_.reset();
  geometry_.reset();
}

const RuleGridGeometry::Needs& RuleGrids::needs() const {
  if (!needs_) needs_ = measured();
  return *needs_;
}

QSize RuleGrids::minimumSizeHint() const {
  const QSizeF size = RuleGridGeometry::smallest(needs());
  return {static_cast<int>(std::ceil(size.width())), static_cast<int>(std::ceil(size.height()))};
}

const RuleGridGeometry& RuleGrids::places() const {
  if (!geometry_) geometry_ = RuleGridGeometry(needs(), size());
  return *geometry_;
}

void RuleGrids::showRules() {
  // Only another number of rows or columns lays the panel out anew.
  if (minimumSize() != minimumSizeHint()) setMinimumSize(minimumSizeHint());
  const auto selected = rules_.selected();
  setAccessibleDescription(selected ? tipOf(*selected) : QString());
  update();
}

void RuleGrids::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  geometry_.reset();
}

void RuleGrids::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() != QEvent::FontChange) return;
  measureAnew();
  if (isVisible()) showRules();
}

void RuleGrids::mousePressEvent(QMouseEvent* event) {
  if (!rules_.isOpen()) return;
  if (const auto cell = places().at(event->position())) rules_.select(cell);
}

void RuleGrids::contextMenuEvent(QContextMenuEvent* event) {
  if (!rules_.isOpen() || !rules_.selected()) return;
  QPoint at = event->globalPos();
  if (event->reason() == QContextMenuEvent::Keyboard) at = mapToGlobal(cellRect(*rules_.selected()).center());
  makeMenu()->popup(at);
}

QMenu* RuleGrids::makeMenu() {
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  const auto& words = rules_.words();
  const auto selected = rules_.selected();
  for (std::size_t w = 0; w < words.size(); ++w) {
    QPixmap chip(16, 16);
    chip.fill(theme::force(w, words.size()));
    QAction* action = menu->addAction(chip, labelOf(words[w]));
    if (w < 9)
      action->setText(
          QStringLiteral("&%1 %2").arg(w + 1).arg(labelOf(words[w]).replace(QLatin1Char('&'), QLatin1String("&&"))));
    connect(action, &QAction::triggered, &rules_, [this, w] { rules_.answer(w); });
  }
  menu->addSeparator();
  QAction* none = menu->addAction(tr("No answer"));
  none->setEnabled(selected && rules_.cell(*selected).rule);
  connect(none, &QAction::triggered, &rules_, [this] { rules_.answer(std::nullopt); });
  QAction* go = menu->addAction(tr("&Go where it acts"));
  go->setEnabled(none->isEnabled());
  connect(go, &QAction::triggered, &rules_, &RuleController::goWhereItActs);
  QAction* origin = menu->addAction(tr("Where does this come from?"));
  origin->setEnabled(none->isEnabled());
  connect(origin, &QAction::triggered, &rules_, &RuleController::originAsked);
  return menu;
}

void RuleGrids::keyPressEvent(QKeyEvent* event) {
  const bool plain = (event->modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
  if (!rules_.isOpen() || !plain || !(answerKey(event->key()) || moveKey(event->key()))) QWidget::keyPressEvent(event);
}

bool RuleGrids::answerKey(int key) {
  if (key >= Qt::Key_1 && key <= Qt::Key_9) {
    const auto word = static_cast<std::size_t>(key - Qt::Key_1);
    if (word >= rules_.words().size()) return false;
    rules_.answerAndGoOn(word);
    return true;
  }
  switch (key) {
    case Qt::Key_Delete:
    case Qt::Key_Backspace: rules_.answer(std::nullopt); return true;
    case Qt::Key_Space: rules_.goOn(); return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      if (const auto cell = rules_.selected()) makeMenu()->popup(mapToGlobal(cellRect(*cell).center()));
      return true;
    default: return false;
  }
}

bool RuleGrids::moveKey(int key) {
  switch (key) {
    case Qt::Key_Left: rules_.step(-1, 0); return true;
    case Qt::Key_Right: rules_.step(1, 0); return true;
    case Qt::Key_Up: rules_.step(0, -1); return true;
    case Qt::Key_Down: rules_.step(0, 1); return true;
    case Qt::Key_PageUp: rules_.stepGrid(-1); return true;
    case Qt::Key_PageDown: rules_.stepGrid(1); return true;
    case Qt::Key_Home: rules_.stepToEnd(false); return true;
    case Qt::Key_End: rules_.stepToEnd(true); return true;
    default: return false;
  }
}

bool RuleGrids::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip || !rules_.isOpen()) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  if (const auto cell = places().at(help->pos())) {
    QToolTip::showText(help->globalPos(), tipOf(*cell), this, cellRect(*cell));
  } else {
    QToolTip::hideText();
  }
  return true;
}

QString RuleGrids::tipOf(const RuleCell& place) const {
  const editing::GridCell& cell = rules_.cell(place);
  const QString conditions = rules_.conditionsOf(place);
  if (!cell.rule) return tr("%1: no rule").arg(conditions);
  const auto word = rules_.wordOf(cell.then);
  QString tip = tr("Rule %1: %2 THEN %3")
                    .arg(*cell.rule + 1)
                    .arg(conditions, word ? labelOf(rules_.words()[*word]) : text(cell.then));
  if (cell.weight < 1) tip += tr(", weight %1").arg(numberText(cell.weight, 3));
  if (!cell.enabled) tip += tr(", disabled");
  if (cell.conflict) tip += tr("; conflicts with a rule for %1").arg(rules_.otherAnswers(place).join(tr(" and ")));
  const double strength = rules_.strength(*cell.rule);
  if (strength > 0) tip += tr("; acts here with %1").arg(numberText(strength, 3));
  return tip;
}

void RuleGrids::paintEvent(QPaintEvent* /*event*/) {
  if (!rules_.isOpen()) return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(theme::smallFont());
  if (rules_.grids().empty()) {
    painter.setPen(theme::mutedInk());
    painter.drawText(rect(), static_cast<int>(Qt::AlignCenter) | Qt::TextWordWrap,
                     tr("A grid needs two inputs. The rules of this model are in the list."));
    return;
  }
  paintHeads(painter);
  for (std::size_t g = 0; g < rules_.grids().size(); ++g) paintGrid(painter, g);
  paintSelection(painter);
}

void RuleGrids::paintHeads(QPainter& painter) const {
  const std::vector<fuzzy::Term>& columns = rules_.terms(rules_.region());
  for (std::size_t c = 0; c < columns.size(); ++c) {
    const QRectF place = places().columnHead(c);
    setHeadInk(painter, rules_.membership(rules_.region(), c) > 0, labelOf(columns[c]), place.width());
    painter.drawText(place, Qt::AlignCenter,
                     brokenLabel(labelOf(columns[c]), place.width(), QFontMetricsF(painter.font())));
  }
}

void RuleGrids::paintGrid(QPainter& painter, std::size_t grid) const {
  const RuleController::Grid& shown = rules_.grids()[grid];
  const fuzzy::Variable& input = rules_.input(shown.id.condition);
  const QRectF title = places().title(grid).adjusted(0, 6, 0, 0);
  painter.setPen(theme::ink());
  painter.setFont(boldFont());
  painter.drawText(title, Qt::AlignLeft | Qt::AlignVCenter, labelOf(input));
  const double used = QFontMetricsF(painter.font()).horizontalAdvance(labelOf(input)) + theme::kGrid;
  painter.setFont(theme::smallFont());
  painter.setPen(theme::mutedInk());
  painter.drawText(title.adjusted(used, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter,
                   placeText(input, rules_.valueHere(shown.id.condition)));

  const std::vector<fuzzy::Term>& rows = rules_.terms(shown.id.condition);
  for (std::size_t r = 0; r < shown.cells.rows.size(); ++r) {
    const QRectF head = places().rowHead(grid, r);
    setHeadInk(painter, rules_.membership(shown.id.condition, r) > 0, nameOf(rows, r), head.width());
    painter.drawText(head, Qt::AlignRight | Qt::AlignVCenter,
                     brokenLabel(nameOf(rows, r), head.width(), QFontMetricsF(painter.font())));
    painter.setFont(theme::smallFont());
    for (std::size_t c = 0; c < shown.cells.columns.size(); ++c) paintCell(painter, {grid, r, c});
  }
}

void RuleGrids::paintCell(QPainter& painter, const RuleCell& place) const {
  const editing::GridCell& cell = rules_.cell(place);
  const QRectF rect = places().cell(place);
  if (!cell.rule) {
    paintNoWord(painter, rect);
    return;
  }
  const auto word = rules_.wordOf(cell.then);
  if (!word) return;
  const auto& words = rules_.words();
  paintForceWord(painter, rect,
                 {labelOf(words[*word]), theme::force(*word, words.size()), cell.enabled, cell.weight, cell.conflict,
                  rules_.strength(*cell.rule)});
}

void RuleGrids::paintSelection(QPainter& painter) const {
  const auto selected = rules_.selected();
  if (!selected) return;
  // Two rings, so that it is seen on every color; pale while the keys go elsewhere.
  const QRectF place = places().cell(*selected);
  painter.setBrush(Qt::NoBrush);
  if (flash_->strength() > 0) {
    QColor glow = theme::accent();
    glow.setAlphaF(static_cast<float>(flash_->strength()));
    painter.setPen(QPen(glow, 6));
    painter.drawRoundedRect(place.adjusted(-3, -3, 3, 3), 7, 7);
  }
  painter.setPen(QPen(hasFocus() ? theme::ink() : theme::mutedInk(), hasFocus() ? 2.5 : 1.5));
  painter.drawRoundedRect(place.adjusted(-1, -1, 1, 1), 5, 5);
  painter.setPen(QPen(theme::card(), 1));
  painter.drawRoundedRect(place.adjusted(1, 1, -1, -1), 3, 3);
}

}  // namespace tactus::workbench
