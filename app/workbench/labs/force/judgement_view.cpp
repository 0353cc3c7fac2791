#include "app/workbench/labs/force/judgement_view.h"

#include <QComboBox>
#include <QHeaderView>
#include <QMenu>
#include <QPainter>
#include <QPainterPath>
#include <QSignalBlocker>
#include <algorithm>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/cards.h"
#include "app/workbench/kit/force_word.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/kit/quiet_table.h"
#include "app/workbench/labs/force/force_lab.h"
#include "app/workbench/labs/force/judgement_grid.h"

namespace tactus::workbench {
namespace {

constexpr double kWordGap = 2;  // px around what is painted
constexpr double kFold = 9;     // px, the corner of a corrected judgement

using Judged = study::ForceJudgement::Kind;

void paintOne(QPainter& painter, const QRectF& place, const session::JudgedForce& judged,
              const fuzzy::Variable& words) {
  const session::JudgedWord word = judgedWord(judged.record);
  const QString label = judgedText(words, word);
  QColor color;
  for (std::size_t i = 0; i < words.terms.size(); ++i) {
    if (word.kind == Judged::kTerm && words.terms[i].id == word.term) color = theme::force(i, words.terms.size());
  }
  if (color.isValid()) {
    paintForceWord(painter, place, {label, color, judged.counts});
  } else {
    paintNoWord(painter, place);
    painter.setPen(theme::mutedInk());
    painter.drawText(place.adjusted(4, 0, -4, 0), Qt::AlignCenter | Qt::TextWordWrap,
                     word.kind == Judged::kNoAnswer ? QStringLiteral("–") : label);
  }
  if (judged.before.empty()) return;
  QPainterPath fold(place.topRight());
  fold.lineTo(place.right() - kFold, place.top());
  fold.lineTo(place.right(), place.top() + kFold);
  fold.closeSubpath();
  painter.fillPath(fold, theme::accent());
}

}  // namespace

JudgementDelegate::JudgementDelegate(const JudgementGrid& grid, QObject* parent)
    : QStyledItemDelegate(parent), grid_(grid) {}

void JudgementDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
  paintGround(*painter, option);
  const auto judgements = grid_.at(index);
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setFont(option.font);
  const QRectF place = QRectF(option.rect).adjusted(kWordGap, kWordGap, -kWordGap, -kWordGap);
  const double width = place.width() / static_cast<double>(std::max<std::size_t>(1, judgements.size()));
  for (std::size_t i = 0; i < judgements.size(); ++i) {
    const QRectF part(place.left() + width * static_cast<double>(i), place.top(), width, place.height());
    paintOne(*painter, judgements.size() > 1 ? part.adjusted(0, 0, -1, 0) : part, *judgements[i], grid_.words());
  }
  // The style paints the ground of a selection; the words would hide it.
  if (option.state.testFlag(QStyle::State_Selected)) {
    painter->setBrush(Qt::NoBrush);
    painter->setPen(QPen(theme::ink(), 2));
    painter->drawRoundedRect(place, 4, 4);
  }
  painter->restore();
}

namespace {

constexpr int kJudgementRow = 34;     // px
constexpr int kJudgementColumn = 66;  // px, two lines of the longest word

// Series in the order in which they were judged.
std::vector<std::string> seriesIn(const std::vector<session::JudgedForce>& all) {
  std::vector<std::string> names;
  for (const session::JudgedForce& one : all) {
    if (std::find(names.begin(), names.end(), one.record.series) == names.end()) names.push_back(one.record.series);
  }
  std::stable_partition(names.begin(), names.end(), [](const std::string& name) { return name == "ascending"; });
  return names;
}

}  // namespace

JudgementView::JudgementView(QWidget* parent)
    : QWidget(parent),
      grid_(new JudgementGrid(this)),
      view_(makeQuietTable(*grid_, tr("Judgements of each participant"), this)),
      series_(new QComboBox(this)),
      hint_(new ElidedLabel(this)) {
  view_->setItemDelegate(new JudgementDelegate(*grid_, view_));
  view_->setSelectionBehavior(QAbstractItemView::SelectItems);
  view_->setFont(theme::smallFont());
  QHeaderView* const names = view_->verticalHeader();
  names->setDefaultSectionSize(kJudgementRow);
  names->setSectionResizeMode(QHeaderView::Fixed);
  names->setHighlightSections(false);
  names->setSectionsClickable(false);
  names->show();
  view_->horizontalHeader()->setMinimumSectionSize(kJudgementColumn);
  view_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  series_->setAccessibleName(tr("Series of forces"));
  series_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  setMuted(*hint_);
  tell({});
  makeColumn(this, {makeRow({series_, {hint_, 1}}), {view_, 1}}, theme::kGrid, inset(theme::kGrid));
  connect(series_, &QComboBox::activated, this, &JudgementView::showSeries);
  connect(view_, &QTableView::activated, this, &JudgementView::openMenu);
  connect(view_, &QTableView::doubleClicked, this, &JudgementView::openMenu);
  connect(view_->selectionModel(), &QItemSelectionModel::currentChanged, this, [this](const QModelIndex& index) {
    const auto chosen = grid_->at(index);
    if (!chosen.empty()) emit judgementChosen(*chosen.back());
  });
  view_->setContextMenuPolicy(Qt::CustomContextMenu);
  connect(view_, &QTableView::customContextMenuRequested, this,
          [this](QPoint place) { openMenu(view_->indexAt(place)); });
}

void JudgementView::setJudgements(const fuzzy::Variable& words, std::vector<session::JudgedForce> all) {
  words_ = words;
  all_ = std::move(all);
  const QVariant shown = series_->currentData();
  const QSignalBlocker quiet(series_);
  series_->clear();
  for (const std::string& name : seriesIn(all_)) series_->addItem(seriesText(name), text(name));
  series_->setCurrentIndex(std::max(0, series_->findData(shown)));
  series_->setVisible(series_->count() > 1);
  showSeries();
  showWanted();
}

void JudgementView::showJudgement(const std::string& participant, const std::string& series, double force_n) {
  wanted_ = {participant, series, force_n};
  showWanted();
}

void JudgementView::showWanted() {
  if (!wanted_ || series_->count() == 0) return;
  const Wanted wanted = *std::exchange(wanted_, std::nullopt);
  const int series = series_->findData(text(wanted.series));
  if (series < 0) return;
  series_->setCurrentIndex(series);
  showSeries();
  const int column = grid_->columnOf(wanted.force_n);
  for (int row = 0; column >= 0 && row < grid_->rowCount(); ++row) {
    if (grid_->participant(row) != wanted.participant) continue;
    view_->setCurrentIndex(grid_->index(row, column));
    view_->setFocus();
  }
}

void JudgementView::showSeries() {
  const QModelIndex before = view_->currentIndex();
  grid_->setJudgements(words_, all_, series_->currentData().toString().toStdString());
  const QModelIndex same = grid_->index(before.row(), before.column());
  if (same.isValid()) view_->setCurrentIndex(same);
}

void JudgementView::tell(const QString& sentence) {
  hint_->setFullText(sentence.isEmpty() ? tr("Double-click a judgement to correct it. The old one stays in the study.")
                                        : sentence);
}

void JudgementView::showForce(double force_n) {
  const int column = grid_->columnOf(force_n);
  if (column < 0 || grid_->rowCount() == 0) return;
  const int row = std::max(0, view_->currentIndex().row());
  view_->setCurrentIndex(grid_->index(row, column));
}

void JudgementView::openMenu(const QModelIndex& index) {
  const auto judgements = grid_->at(index);
  if (judgements.empty() || view_->findChild<QMenu*>() != nullptr) return;
  auto* menu = new QMenu(view_);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  for (const session::JudgedForce* judged : judgements) {
    addMenuHeading(*menu,
                   tr("%1 at %2: %3, corrected to")
                       .arg(harmless(text(judged->participant)), quantityText(judged->record.commanded_n, words_.unit),
                            judgedText(words_, judgedWord(judged->record))));
    for (const session::JudgedWord& word : offeredWords(words_, all_, *judged)) {
      menu->addAction(judgedText(words_, word), this,
                      [this, judged = *judged, word] { emit correctionAsked(judged, word); });
    }
  }
  menu->popup(view_->viewport()->mapToGlobal(view_->visualRect(index).bottomLeft()));
}

}  // namespace tactus::workbench
