#include "app/workbench/labs/rules/grids_view.h"

#include <QColor>
#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QMenu>
#include <QPainter>
#include <QPainterPath>
#include <QRectF>
#include <QScrollBar>
#include <QToolTip>
#include <algorithm>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/cards.h"
#include "app/workbench/kit/force_word.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/labs/rules/expert_grids.h"
#include "app/workbench/plot/term_marks.h"
#include "elicitation/agreement/conflict_map.h"

class QPainter;

namespace tactus::workbench {
namespace {

// How a cell of the grids looks: a word, no word, not asked, or the newtons between the experts.

constexpr double kInset = 1.5;  // px
constexpr double kCellCorner = 3;
constexpr double kMarkPx = 8;

/// `brief`: the initials of the word alone.
void paintAskedCell(QPainter& painter, const QRectF& place, const AskedCell& cell, const fuzzy::Variable& output,
                    bool brief) {
  const QRectF inside = place.adjusted(kInset, kInset, -kInset, -kInset);
  if (!cell.asked) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(QBrush(theme::border(), Qt::BDiagPattern));
    painter.drawRoundedRect(inside, kCellCorner, kCellCorner);
  } else if (cell.word) {
    const QString word = labelOf(output.terms[*cell.word]);
    paintForceWord(painter, inside,
                   {brief ? initialsOf(word) : word, termFill(output, output.terms, *cell.word), cell.weight > 0});
  } else {
    paintNoWord(painter, inside);
  }
  if (!cell.corrected) return;
  QPainterPath fold(inside.topRight());
  fold.lineTo(inside.right() - kMarkPx, inside.top());
  fold.lineTo(inside.right(), inside.top() + kMarkPx);
  fold.closeSubpath();
  painter.fillPath(fold, theme::accent());
}

/// The color of a distance in just-noticeable differences: the card at 0, a warning from 1 on.
QColor distanceColor(double noticeable) {
  // Full color at three just-noticeable differences: beyond that everybody feels it.
  const double share = std::clamp(noticeable / 3, 0.0, 1.0);
  QColor color = theme::warningInk();
  color.setAlphaF(static_cast<float>(0.06 + 0.64 * share));
  return theme::onCard(color);
}

/// `conflict`: null where no expert has a word. With fewer than two words there is nothing to compare.
void paintConflictCell(QPainter& painter, const QRectF& place, const elicitation::CellConflict* conflict) {
  const QRectF inside = place.adjusted(kInset, kInset, -kInset, -kInset);
  const auto has_word = [](const std::string& word) { return !word.empty(); };
  if (conflict == nullptr || std::count_if(conflict->words.begin(), conflict->words.end(), has_word) < 2) {
    painter.setPen(theme::mutedInk());
    painter.drawText(inside, Qt::AlignCenter, QStringLiteral("–"));
    return;
  }
  const QColor fill = distanceColor(conflict->rms_noticeable);
  painter.setPen(Qt::NoPen);
  painter.setBrush(fill);
  painter.drawRoundedRect(inside, kCellCorner, kCellCorner);
  if (conflict->rms_noticeable > 1) {
    painter.setPen(QPen(theme::warningInk(), 1.5));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(inside, kCellCorner, kCellCorner);
  }
  painter.setPen(theme::inkOn(fill));
  painter.drawText(inside, Qt::AlignCenter, QString::number(conflict->rms_n, 'f', 2));
}

constexpr int kNamesPad = 12;  // px right of the names of the rows
constexpr int kDotPx = 8;
constexpr int kWordPad = 10;  // px beside a word in a cell

// The names of the regions are read from below where a column is narrower than they are.
int headsHeight(const ExpertGrids& grids, const QFontMetrics& metrics) {
  int longest = 0;
  for (const GridAxis& column : grids.columns) longest = std::max(longest, metrics.horizontalAdvance(column.label));
  return longest + theme::kGrid;
}

int namesWidth(const ExpertGrids& grids, const QFontMetrics& metrics) {
  int longest = 0;
  for (const GridAxis& row : grids.rows) longest = std::max(longest, metrics.horizontalAdvance(row.label));
  return longest;
}

QString inputName(const std::string& id) {
  QString name = spelled(id);
  if (!name.isEmpty()) name[0] = name[0].toUpper();
  return name;
}

std::vector<std::size_t> breaksOf(const std::vector<GridAxis>& rows) {
  std::vector<std::size_t> breaks;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (rows[i].input != rows[i - 1].input) breaks.push_back(i);
  }
  return breaks;
}

int inputsWidth(const ExpertGrids& grids, const QFontMetrics& metrics) {
  int longest = 0;
  for (const GridAxis& row : grids.rows) longest = std::max(longest, metrics.horizontalAdvance(inputName(row.input)));
  return longest + theme::kGrid;
}

}  // namespace

GridsView::GridsView(RulesLab& lab, QWidget* parent) : QAbstractScrollArea(parent), lab_(lab) {
  setFrameShape(QFrame::NoFrame);
  setFont(theme::smallFont());
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Rules of all experts"));
  viewport()->setAutoFillBackground(false);
  horizontalScrollBar()->setSingleStep(5 * theme::kGrid);
  connect(&lab_, &RulesLab::chosenChanged, viewport(), qOverload<>(&QWidget::update));
}

QSize GridsView::sizeHint() const { return {960, std::max(places_.leastHeight(), 320)}; }

int GridsView::scrolled() const { return horizontalScrollBar()->value(); }

void GridsView::refreshState() {
  layOut();
  viewport()->update();
}

void GridsView::layOut() {
  const ExpertGrids& grids = lab_.grids();
  const QFontMetrics metrics(font());
  places_ = GridPlaces(grids.rows.size(), grids.columns.size(), grids.experts.size(), breaksOf(grids.rows),
                       inputsWidth(grids, metrics) + namesWidth(grids, metrics) + kNamesPad,
                       headsHeight(grids, metrics), viewport()->size(),
                       std::max(GridPlaces::kNarrowest, metrics.horizontalAdvance(QStringLiteral("0.00")) + 4));
  horizontalScrollBar()->setRange(0, std::max(0, places_.width() - viewport()->width()));
  horizontalScrollBar()->setPageStep(std::max(1, viewport()->width() - places_.scrollEdge()));
  verticalScrollBar()->setRange(0, 0);
  setMinimumHeight(places_.leastHeight() + horizontalScrollBar()->sizeHint().height());
  brief_ = std::any_of(grids.output.terms.begin(), grids.output.terms.end(), [&](const fuzzy::Term& word) {
    return brokenWidth(labelOf(word), QFontMetricsF(font())) > places_.cell(0, {}, 0).width() - kWordPad;
  });
  if (block_ > grids.experts.size()) block_ = 1;
}

void GridsView::resizeEvent(QResizeEvent* event) {
  QAbstractScrollArea::resizeEvent(event);
  layOut();
}

void GridsView::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(viewport());
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(font());
  const ExpertGrids& grids = lab_.grids();
  if (grids.rows.empty()) {
    painter.setPen(theme::mutedInk());
    painter.drawText(viewport()->rect(), Qt::AlignCenter | Qt::TextWordWrap,
                     lab_.failure().isEmpty() ? tr("Reading the rules…") : lab_.failure());
    return;
  }
  paintNames(painter);
  paintHeads(painter, 0);
  paintConflicts(painter);
  paintChosen(painter, 0);
  painter.save();
  painter.setClipRect(QRect(places_.scrollEdge(), 0, viewport()->width(), viewport()->height()));
  for (std::size_t e = 0; e < grids.experts.size(); ++e) {
    const QRectF head = places_.blockHead(e + 1, scrolled());
    if (head.right() < places_.scrollEdge() || head.left() > viewport()->width()) continue;
    paintHeads(painter, e + 1);
    paintExpert(painter, e);
    paintChosen(painter, e + 1);
  }
  painter.restore();
}

void GridsView::paintNames(QPainter& painter) const {
  const ExpertGrids& grids = lab_.grids();
  const int names_left = inputsWidth(grids, painter.fontMetrics());
  for (std::size_t row = 0; row < grids.rows.size(); ++row) {
    const QRectF place = places_.rowName(row);
    if (row == 0 || grids.rows[row].input != grids.rows[row - 1].input) {
      painter.setPen(theme::mutedInk());
      painter.drawText(place, Qt::AlignLeft | Qt::AlignVCenter, inputName(grids.rows[row].input));
    }
    painter.setPen(theme::ink());
    painter.drawText(place.adjusted(names_left, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter, grids.rows[row].label);
  }
}

void GridsView::paintHeads(QPainter& painter, std::size_t block) const {
  const ExpertGrids& grids = lab_.grids();
  QRectF head = places_.blockHead(block, scrolled());
  QFont bold = font();
  bold.setBold(true);
  painter.save();
  painter.setFont(bold);
  painter.setPen(theme::ink());
  if (block == 0) {
    painter.drawText(head, Qt::AlignLeft | Qt::AlignVCenter, tr("Apart, in N"));
  } else {
    const GridExpert& expert = grids.experts[block - 1];
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme::expert(expert.number));
    painter.drawEllipse(QRectF(head.left() + 2, head.center().y() - kDotPx / 2.0, kDotPx, kDotPx));
    head.setLeft(head.left() + kDotPx + theme::kGrid);
    painter.setPen(theme::ink());
    const QString name =
        painter.fontMetrics().elidedText(harmless(expert.label), Qt::ElideRight, static_cast<int>(head.width()));
    painter.drawText(head, Qt::AlignLeft | Qt::AlignVCenter, name);
    QStringList more;
    if (expert.weight != 1) more << tr("weight %1").arg(numberText(expert.weight));
    head.setLeft(head.left() + painter.fontMetrics().horizontalAdvance(name + QStringLiteral("  ")));
    painter.setFont(font());
    painter.setPen(theme::mutedInk());
    painter.drawText(head, Qt::AlignLeft | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(more.join(QStringLiteral(" · ")), Qt::ElideRight,
                                                      std::max(0, static_cast<int>(head.width()))));
  }
  painter.setFont(font());
  painter.setPen(theme::mutedInk());
  for (std::size_t column = 0; column < grids.columns.size(); ++column) {
    const QRectF place = places_.columnHead(block, column, scrolled());
    painter.save();
    painter.translate(place.center().x(), place.bottom() - theme::kGrid / 2.0);
    painter.rotate(-90);
    painter.drawText(QRectF(0, -place.width() / 2, place.height(), place.width()), Qt::AlignLeft | Qt::AlignVCenter,
                     grids.columns[column].label);
    painter.restore();
  }
  painter.restore();
}

void GridsView::paintConflicts(QPainter& painter) const {
  const ExpertGrids& grids = lab_.grids();
  for (std::size_t row = 0; row < grids.rows.size(); ++row) {
    for (std::size_t column = 0; column < grids.columns.size(); ++column) {
      const GridPlace place{row, column};
      paintConflictCell(painter, places_.cell(0, place, 0), lab_.conflictAt(place));
    }
  }
}

void GridsView::paintExpert(QPainter& painter, std::size_t expert) const {
  const ExpertGrids& grids = lab_.grids();
  for (std::size_t row = 0; row < grids.rows.size(); ++row) {
    for (std::size_t column = 0; column < grids.columns.size(); ++column) {
      paintAskedCell(painter, places_.cell(expert + 1, {row, column}, scrolled()), grids.at(expert, row, column),
                     grids.output, brief_);
    }
  }
}

void GridsView::paintChosen(QPainter& painter, std::size_t block) const {
  if (!lab_.chosen()) return;
  const QRectF place = places_.cell(block, *lab_.chosen(), scrolled());
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(hasFocus() && block == block_ ? theme::accent() : theme::ink(), 2));
  painter.drawRoundedRect(place.adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
}

QString GridsView::tipOf(const GridPlaces::Hit& hit) const {
  const ExpertGrids& grids = lab_.grids();
  QStringList lines{lab_.textOf(hit.place)};
  if (hit.block == 0) {
    if (const auto* conflict = lab_.conflictAt(hit.place)) {
      lines << tr("%1 between two experts, %2 just-noticeable differences")
                   .arg(quantityText(conflict->rms_n, grids.output.unit, 3), numberText(conflict->rms_noticeable, 1));
    }
    return lines.join(QLatin1Char('\n'));
  }
  const GridExpert& expert = grids.experts[hit.block - 1];
  const AskedCell& cell = grids.at(hit.block - 1, hit.place.row, hit.place.column);
  const QString said = !cell.asked              ? tr("not asked")
                       : cell.word              ? labelOf(grids.output.terms[*cell.word])
                       : cell.without.isEmpty() ? tr("no rule")
                                                : cell.without;
  lines << tr("%1: %2").arg(harmless(expert.label), said);
  if (cell.item > 0) lines << tr("Item %1 of the form").arg(cell.item);
  if (cell.given) lines << tr("A rule given directly");
  if (cell.corrected) lines << tr("Corrected; the old record stays in the study.");
  return lines.join(QLatin1Char('\n'));
}

bool GridsView::viewportEvent(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    const auto* help = static_cast<QHelpEvent*>(event);
    const auto hit = places_.hit(help->pos(), scrolled());
    hit ? QToolTip::showText(help->globalPos(), tipOf(*hit), viewport()) : QToolTip::hideText();
    return true;
  }
  return QAbstractScrollArea::viewportEvent(event);
}

void GridsView::mousePressEvent(QMouseEvent* event) {
  const auto hit = places_.hit(event->position().toPoint(), scrolled());
  if (!hit) return;
  block_ = hit->block;
  lab_.choose(hit->place);
  viewport()->update();
}

void GridsView::mouseDoubleClickEvent(QMouseEvent* event) {
  const auto hit = places_.hit(event->position().toPoint(), scrolled());
  if (hit && hit->block > 0) openMenu(hit->block - 1, hit->place, event->globalPosition().toPoint());
}

void GridsView::contextMenuEvent(QContextMenuEvent* event) {
  const auto hit = places_.hit(viewport()->mapFrom(this, event->pos()), scrolled());
  if (!hit || hit->block == 0) return;
  block_ = hit->block;
  lab_.choose(hit->place);
  openMenu(hit->block - 1, hit->place, event->globalPos());
}

void GridsView::keyPressEvent(QKeyEvent* event) {
  const ExpertGrids& grids = lab_.grids();
  if (grids.rows.empty()) return;
  GridPlace place = lab_.chosen().value_or(GridPlace());
  switch (event->key()) {
    case Qt::Key_Up:
      if (place.row > 0) --place.row;
      break;
    case Qt::Key_Down:
      if (place.row + 1 < grids.rows.size()) ++place.row;
      break;
    case Qt::Key_Left:
      if (place.column > 0) {
        --place.column;
      } else if (block_ > 0) {
        --block_;
        place.column = grids.columns.size() - 1;
      }
      break;
    case Qt::Key_Right:
      if (place.column + 1 < grids.columns.size()) {
        ++place.column;
      } else if (block_ < grids.experts.size()) {
        ++block_;
        place.column = 0;
      }
      break;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      if (block_ > 0 && lab_.chosen()) {
        openMenu(block_ - 1, place,
                 viewport()->mapToGlobal(places_.cell(block_, place, scrolled()).bottomLeft().toPoint()));
      }
      return;
    default: QAbstractScrollArea::keyPressEvent(event); return;
  }
  const QRectF at = places_.cell(block_, place, scrolled());
  if (block_ > 0 && at.left() < places_.scrollEdge()) {
    horizontalScrollBar()->setValue(scrolled() - places_.scrollEdge() + static_cast<int>(at.left()));
  } else if (block_ > 0 && at.right() > viewport()->width()) {
    horizontalScrollBar()->setValue(scrolled() + static_cast<int>(at.right()) - viewport()->width());
  }
  lab_.choose(place);
  viewport()->update();
}

void GridsView::openMenu(std::size_t expert, const GridPlace& place, const QPoint& global) {
  const ExpertGrids& grids = lab_.grids();
  const AskedCell& cell = grids.at(expert, place.row, place.column);
  if (!cell.record) return;
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  addMenuHeading(*menu, tr("%1, %2: correct to").arg(harmless(grids.experts[expert].label), lab_.textOf(place)));
  for (std::size_t word = 0; word < grids.output.terms.size(); ++word) {
    if (cell.word == word) continue;
    menu->addAction(labelOf(grids.output.terms[word]), this,
                    [this, expert, place, word] { lab_.correctWord(expert, place, word); });
  }
  if (!cell.given) {
    menu->addSeparator();
    menu->addAction(tr("cannot tell"), this,
                    [this, expert, place] { lab_.correctStatus(expert, place, study::Answer::Status::kCantTell); });
    menu->addAction(tr("skipped"), this,
                    [this, expert, place] { lab_.correctStatus(expert, place, study::Answer::Status::kSkipped); });
  }
  menu->popup(global);
}

}  // namespace tactus::workbench
