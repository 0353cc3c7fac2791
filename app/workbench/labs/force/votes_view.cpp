#include "app/workbench/labs/force/votes_view.h"

#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QPainter>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/force_word.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/kit/quiet_table.h"
#include "app/workbench/labs/force/force_lab.h"

namespace tactus::workbench {
namespace {

constexpr double kGap = 3;  // px around what is painted
constexpr double kCorner = 4;

}  // namespace

VoteDelegate::VoteDelegate(const VoteTable& votes, QObject* parent) : QStyledItemDelegate(parent), votes_(votes) {}

void VoteDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
  const int column = index.column();
  const bool is_word = column >= VoteTable::kFirstWord && column < votes_.winnerColumn();
  if (!is_word && column != votes_.winnerColumn()) {
    QStyledItemDelegate::paint(painter, option, index);
    return;
  }
  paintGround(*painter, option);
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setFont(option.font);
  const QRectF place = QRectF(option.rect).adjusted(kGap, kGap, -kGap, -kGap);
  const auto& term = votes_.row(index.row()).term;
  if (is_word) {
    paintVotes(*painter, place, index);
  } else if (term) {
    const auto count = static_cast<std::size_t>(votes_.words());
    paintForceWord(*painter, place, {index.data().toString(), theme::force(*term, count)});
  }
  painter->restore();
}

void VoteDelegate::paintVotes(QPainter& painter, const QRectF& place, const QModelIndex& index) const {
  const auto word = static_cast<std::size_t>(index.column() - VoteTable::kFirstWord);
  const QColor color = theme::force(word, static_cast<std::size_t>(votes_.words()));
  const double share = index.data(VoteTable::kShareRole).toDouble();
  const bool wins = index.data(VoteTable::kWinsRole).toBool();
  if (share > 0) {
    QColor fill = color;
    fill.setAlphaF(0.35F);
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme::onCard(fill));
    painter.drawRoundedRect(QRectF(place.left(), place.top(), place.width() * share, place.height()), kCorner, kCorner);
  }
  if (wins) {
    painter.setPen(QPen(theme::readableLine(color), 2));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(place.adjusted(1, 1, -1, -1), kCorner, kCorner);
  }
  QFont font = painter.font();
  font.setBold(wins);
  painter.setFont(font);
  painter.setPen(share > 0 ? theme::ink() : theme::mutedInk());
  painter.drawText(place, Qt::AlignCenter, index.data().toString());
}

namespace {

constexpr int kVoteRow = 24;        // px
constexpr int kVoteColumn = 36;     // px
constexpr int kWinnerColumn = 86;   // px
constexpr int kReasonColumn = 130;  // px

QString summaryOf(const ForceVotes& votes) {
  int ties = 0;
  int undecided = 0;
  for (const elicitation::VoteStep& step : votes.steps) {
    ties += step.reason == elicitation::VoteReason::kMajority || !step.term ? 0 : 1;
    undecided += step.term ? 0 : 1;
  }
  QString out = VotesView::tr("%n participant(s)", nullptr, votes.enrolled) + QStringLiteral(" · ") +
                VotesView::tr("%n tie(s)", nullptr, ties);
  if (undecided > 0) out += QStringLiteral(" · ") + VotesView::tr("%n force(s) without votes", nullptr, undecided);
  return out;
}

}  // namespace

VotesView::VotesView(QWidget* parent)
    : QWidget(parent),
      table_(new VoteTable(this)),
      view_(makeQuietTable(*table_, tr("Votes for each force"), this)),
      summary_(new ElidedLabel(this)),
      refusal_(new QLabel(this)) {
  view_->setItemDelegate(new VoteDelegate(*table_, view_));
  view_->verticalHeader()->setDefaultSectionSize(kVoteRow);
  setMuted(*summary_);
  setMuted(*refusal_);
  refusal_->setWordWrap(true);
  refusal_->setAlignment(Qt::AlignCenter);
  makeColumn(this, {summary_, {view_, 1}, {refusal_, 1}}, theme::kGrid, inset(theme::kGrid));
  refusal_->hide();
  connect(view_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this](const QModelIndex& index) {
    if (index.isValid()) emit forceChosen(table_->row(index.row()).force_n);
  });
  view_->setContextMenuPolicy(Qt::CustomContextMenu);
  connect(view_, &QTableView::customContextMenuRequested, this, &VotesView::openMenu);
  connect(view_, &QTableView::doubleClicked, this, [this](const QModelIndex& index) {
    emit originAsked(table_->row(index.row()).force_n, table_->wordAt(index.column()));
  });
}

void VotesView::openMenu(const QPoint& place) {
  const QModelIndex index = view_->indexAt(place);
  if (!index.isValid()) return;
  auto* menu = new QMenu(view_);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->addAction(tr("Where does this come from?"), this,
                  [this, force_n = table_->row(index.row()).force_n, word = table_->wordAt(index.column())] {
                    emit originAsked(force_n, word);
                  });
  menu->popup(view_->viewport()->mapToGlobal(place));
}

void VotesView::setVotes(const ForceVotes& votes) {
  const int chosen = view_->currentIndex().row();
  const bool first = table_->rowCount() == 0;
  table_->setVotes(votes);
  summary_->setFullText(votes.refusal.isEmpty() ? summaryOf(votes) : QString());
  refusal_->setText(votes.refusal);
  refusal_->setVisible(!votes.refusal.isEmpty());
  view_->setVisible(votes.refusal.isEmpty());
  if (first) {
    const QFontMetrics metrics(theme::smallFont());
    view_->setColumnWidth(VoteTable::kForce, metrics.horizontalAdvance(QStringLiteral("0.00 N")) + 2 * theme::kGrid);
    for (int column = VoteTable::kFirstWord; column < table_->winnerColumn(); ++column) {
      view_->setColumnWidth(column, kVoteColumn);
    }
    view_->setColumnWidth(table_->reasonColumn(), kReasonColumn);
    view_->horizontalHeader()->setStretchLastSection(true);
  }
  fitReasons();
  if (chosen >= 0 && chosen < table_->rowCount()) view_->selectRow(chosen);
}

// Where there is no room for the reasons, the tool tips of the winners tell them.
void VotesView::fitReasons() {
  if (table_->columnCount() == 0) return;
  int votes = 0;
  for (int column = 0; column < table_->winnerColumn(); ++column) votes += view_->columnWidth(column);
  view_->setColumnHidden(table_->reasonColumn(), view_->width() < votes + kWinnerColumn + kReasonColumn);
  const int room = view_->viewport()->width() - votes;
  view_->setColumnWidth(table_->winnerColumn(), std::clamp(room, kVoteColumn, kWinnerColumn));
}

void VotesView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  layout()->activate();
  fitReasons();
}

}  // namespace tactus::workbench
