#include "app/workbench/tune/history/history_panel.h"

#include <QApplication>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>
#include <algorithm>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/refresh.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/open_model.h"
#include "app/workbench/tune/history/compare_controller.h"
#include "app/workbench/tune/history/history_model.h"

namespace tactus::workbench {
namespace {

using RowPlace = editing::HistoryRow::Place;

constexpr int kLevelWidth = 2 * theme::kGrid;  // px
constexpr int kMostLevels = 6;                 // deeper branches stand below each other
constexpr int kDotRadius = 4;
constexpr double kBadgeShare = 0.45;  // of the width of a row, at most

int levelOf(const editing::HistoryRow& row) { return static_cast<int>(std::min<std::size_t>(row.level, kMostLevels)); }

int treeWidth(const editing::HistoryRow& row) { return theme::kGrid + (levelOf(row) + 1) * kLevelWidth; }

struct Badge {
  QString text;
  QColor ink;
  QColor fill;
};

}  // namespace

HistoryDelegate::HistoryDelegate(const HistoryModel& model, QObject* parent)
    : QStyledItemDelegate(parent), model_(model) {}

QSize HistoryDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& /*index*/) const {
  const int lines = option.fontMetrics.height() + QFontMetrics(theme::smallFont()).height();
  return {option.fontMetrics.averageCharWidth() * 20, lines + theme::kGrid};
}

void HistoryDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
  const editing::HistoryRow& row = model_.row(index.row());
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  QColor fill = theme::accent();
  const bool under_mouse = option.state.testFlag(QStyle::State_MouseOver);
  if (row.place == RowPlace::kCurrent || under_mouse) {
    fill.setAlphaF(row.place == RowPlace::kCurrent ? 0.14F : 0.07F);
    painter->setPen(Qt::NoPen);
    painter->setBrush(fill);
    painter->drawRoundedRect(option.rect.adjusted(0, 1, 0, -1), 4, 4);
  }
  if (option.state.testFlag(QStyle::State_HasFocus)) {
    painter->setPen(theme::accent());
    painter->setBrush(Qt::NoBrush);
    painter->drawRoundedRect(QRectF(option.rect).adjusted(0.5, 1.5, -0.5, -1.5), 4, 4);
  }
  paintTree(*painter, option.rect, index.row());

  const bool behind = row.place == RowPlace::kUndone || row.place == RowPlace::kBranch;
  const QRect inside = option.rect.adjusted(treeWidth(row), 4, -theme::kGrid, -4);
  QFont font = option.font;
  if (row.place == RowPlace::kCurrent) font.setWeight(QFont::DemiBold);
  const QFontMetrics metrics(font);
  QRect first(inside.topLeft(), QSize(inside.width(), metrics.height()));
  first.setRight(first.right() - paintBadges(*painter, first, index));
  painter->setFont(font);
  painter->setPen(behind ? theme::mutedInk() : theme::ink());
  painter->drawText(first, Qt::AlignLeft | Qt::AlignVCenter,
                    metrics.elidedText(index.data().toString(), Qt::ElideRight, first.width()));
  const QRect second(inside.left(), inside.top() + metrics.height(), inside.width(),
                     inside.height() - metrics.height());
  painter->setFont(theme::smallFont());
  painter->setPen(theme::mutedInk());
  painter->drawText(second, Qt::AlignLeft | Qt::AlignVCenter,
                    painter->fontMetrics().elidedText(index.data(HistoryModel::kEffectRole).toString(), Qt::ElideRight,
                                                      second.width()));
  painter->restore();
}

void HistoryDelegate::paintTree(QPainter& painter, const QRect& area, int row_number) const {
  const editing::HistoryRow& row = model_.row(row_number);
  const int level = levelOf(row);
  const auto x = [&](int of) { return area.left() + theme::kGrid + of * kLevelWidth + kDotRadius + 0.5; };
  const QPointF dot(x(level), area.top() + 4 + QFontMetrics(QApplication::font()).height() / 2.0);
  const double top = area.top();
  const double bottom = area.bottom() + 1;
  painter.setPen(QPen(theme::border(), 1.5));
  painter.setBrush(Qt::NoBrush);
  // The lines beside a branch continue below it.
  for (int outer = 0; outer < level; ++outer) painter.drawLine(QPointF(x(outer), top), QPointF(x(outer), bottom));
  if (row.starts && level > 0) {
    QPainterPath bend(QPointF(x(level - 1), top));
    bend.quadTo(QPointF(x(level - 1), dot.y()), dot);
    painter.drawPath(bend);
  } else if (!row.starts) {
    painter.drawLine(QPointF(dot.x(), top), dot);
  }
  if (row.goes_on) painter.drawLine(dot, QPointF(dot.x(), bottom));

  const bool behind = row.place == RowPlace::kUndone || row.place == RowPlace::kBranch;
  painter.setPen(QPen(behind ? theme::mutedInk() : theme::accent(), 1.5));
  painter.setBrush(row.place == RowPlace::kCurrent ? theme::accent() : theme::card());
  const double radius = row.place == RowPlace::kCurrent ? kDotRadius + 0.5 : kDotRadius - 0.5;
  painter.drawEllipse(dot, radius, radius);
}

int HistoryDelegate::paintBadges(QPainter& painter, const QRect& line, const QModelIndex& index) const {
  std::vector<Badge> badges;
  for (const QString& who : index.data(HistoryModel::kSignOffsRole).toStringList()) {
    badges.push_back({QStringLiteral("✓ ") + who, theme::card(), theme::accent()});
  }
  for (const QString& name : index.data(HistoryModel::kSnapshotsRole).toStringList()) {
    badges.push_back({name, theme::warningInk(), theme::warningFill()});
  }
  if (badges.empty()) return 0;
  painter.setFont(theme::smallFont());
  const QFontMetrics metrics(theme::smallFont());
  const int most = static_cast<int>(line.width() * kBadgeShare);
  int used = 0;
  for (auto badge = badges.rbegin(); badge != badges.rend(); ++badge) {
    const int room = most - used - 2 * theme::kGrid;
    if (room < 4 * theme::kGrid) break;
    const QString shown = metrics.elidedText(badge->text, Qt::ElideRight, room);
    const int width = metrics.horizontalAdvance(shown) + 2 * theme::kGrid;
    const QRect pill(line.right() - used - width, line.top(), width, line.height());
    painter.setPen(Qt::NoPen);
    painter.setBrush(badge->fill);
    painter.drawRoundedRect(pill, pill.height() / 2.0, pill.height() / 2.0);
    painter.setPen(badge->ink);
    painter.drawText(pill, Qt::AlignCenter, shown);
    used += width + 4;
  }
  return used + 4;
}

namespace {

constexpr int kSideWidth = 36 * theme::kGrid;  // px
constexpr int kRoomForBoth = 80 * theme::kGrid;
constexpr int kLongestName = 60;  // letters

}  // namespace

HistoryPanel::HistoryPanel(EditController& edits, CompareController& compare, SceneController& scene,
                           AuthorName& author, QWidget* parent)
    : Card(parent),
      edits_(edits),
      compare_(compare),
      author_(author),
      model_(new HistoryModel(edits, this)),
      view_(new QListView(this)),
      versions_(new QWidget(this)),
      side_(nullptr),
      switch_(new QToolButton(this)),
      snapshot_(new QLineEdit(this)),
      name_it_(new QPushButton(tr("Name version"), this)),
      expert_(new QComboBox(this)),
      sign_off_(new QPushButton(this)),
      author_field_(new QLineEdit(author.name(), this)),
      refresh_(new Refresh(this, [this] { list(); })) {
  view_->setModel(model_);
  view_->setItemDelegate(new HistoryDelegate(*model_, view_));
  view_->setFrameShape(QFrame::NoFrame);
  view_->setUniformItemSizes(true);
  view_->setMouseTracking(true);
  view_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  view_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  view_->setContextMenuPolicy(Qt::CustomContextMenu);
  view_->setAccessibleName(tr("History"));
  snapshot_->setPlaceholderText(tr("Name the current state"));
  snapshot_->setAccessibleName(tr("Name of a snapshot"));
  snapshot_->setMaxLength(kLongestName);
  name_it_->setToolTip(tr("Keep the current state under this name (Ctrl+Shift+N)"));
  name_it_->setEnabled(false);

  makeColumn(versions_, {{view_, 1}, makeRow({{snapshot_, 1}, name_it_})});
  side_ = makeSide(compare, scene);
  makeColumn(this, {{switch_, 0, Qt::AlignRight}, {makeRow({{versions_, 1}, side_}, 2 * theme::kGrid), 1}}, 4,
             inset(theme::kGrid));
  new RowStop({snapshot_, name_it_}, this);

  connect(&edits_, &EditController::historyChanged, refresh_, &Refresh::request);
  connect(&edits_, &EditController::effectsChanged, refresh_, &Refresh::request);
  connect(&edits_, &EditController::modelReset, this, &HistoryPanel::listExperts);
  connect(view_, &QListView::clicked, this, &HistoryPanel::visit);
  connect(view_, &QListView::activated, this, &HistoryPanel::visit);
  connect(view_, &QListView::customContextMenuRequested, this, &HistoryPanel::openMenu);
  connect(snapshot_, &QLineEdit::textChanged, this,
          [this](const QString& name) { name_it_->setEnabled(edits_.isOpen() && !name.trimmed().isEmpty()); });
  connect(snapshot_, &QLineEdit::returnPressed, this, &HistoryPanel::takeSnapshot);
  connect(name_it_, &QPushButton::clicked, this, &HistoryPanel::takeSnapshot);
  connect(expert_, &QComboBox::currentTextChanged, this,
          [this](const QString& who) { sign_off_->setEnabled(edits_.isOpen() && !who.trimmed().isEmpty()); });
  connect(expert_->lineEdit(), &QLineEdit::returnPressed, this, &HistoryPanel::takeSignOff);
  connect(&edits_, &EditController::feltChanged, this, &HistoryPanel::showFelt);
  connect(sign_off_, &QPushButton::clicked, this, &HistoryPanel::takeSignOff);
  connect(author_field_, &QLineEdit::editingFinished, this, [this] { author_.setName(author_field_->text()); });
  connect(switch_, &QToolButton::clicked, this, [this] { showSide(!side_asked_); });
  listExperts();
  showParts();
  refresh_->request();
}

void HistoryPanel::resizeEvent(QResizeEvent* event) {
  Card::resizeEvent(event);
  showParts();
}

void HistoryPanel::showParts() {
  const bool narrow = width() < kRoomForBoth;
  switch_->setVisible(narrow);
  switch_->setText(side_asked_ ? tr("‹ Show versions") : tr("Compare, sign off ›"));
  versions_->setVisible(!narrow || !side_asked_);
  side_->setVisible(!narrow || side_asked_);
  // Alone it takes all there is.
  side_->setMaximumWidth(narrow ? QWIDGETSIZE_MAX : kSideWidth);
}

void HistoryPanel::showSide(bool shown) {
  side_asked_ = shown;
  showParts();
}

QWidget* HistoryPanel::makeSide(CompareController& compare, SceneController& scene) {
  expert_->setEditable(true);
  expert_->setInsertPolicy(QComboBox::NoInsert);
  expert_->setAccessibleName(tr("Expert who signs off"));
  expert_->setMinimumContentsLength(6);
  expert_->lineEdit()->setPlaceholderText(tr("Type the expert's code"));
  showFelt();
  sign_off_->setEnabled(false);
  author_field_->setPlaceholderText(tr("Enter your name, the author of your edits"));
  author_field_->setAccessibleName(tr("Your name"));
  author_field_->setMaxLength(kLongestName);

  auto* side = new QWidget;
  auto* signing = makeRow({{expert_, 1}, sign_off_});
  new RowStop({expert_, sign_off_}, this);
  auto* form = new QFormLayout;
  form->setSpacing(theme::kGrid);
  form->addRow(tr("Sign-off"), signing);
  form->addRow(tr("Edits by"), author_field_);
  auto* card = new CompareCard(compare, scene, side);
  connect(card, &CompareCard::feelBlindRequested, this, &HistoryPanel::feelBlindRequested);
  connect(card, &CompareCard::tellRequested, this, &HistoryPanel::tellRequested);
  makeColumn(side, {card, form, spring(1)}, 2 * theme::kGrid, {0, 0, theme::kGrid, 0});
  // A low panel scrolls it.
  auto* scroll = new QScrollArea(this);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setMinimumWidth(kSideWidth);
  scroll->setWidget(side);
  for (QWidget* surface : {static_cast<QWidget*>(scroll->viewport()), side}) surface->setAutoFillBackground(false);
  return scroll;
}

void HistoryPanel::visit(const QModelIndex& index) {
  const editing::StateId state = model_->row(index.row()).state;
  edits_.returnTo(state);
  if (edits_.history().current() == state) emit visited(state);
}

void HistoryPanel::list() {
  model_->refresh();
  if (const auto row = model_->currentRow()) {
    view_->setCurrentIndex(model_->index(*row, 0));
    view_->scrollTo(model_->index(*row, 0));
  }
}

void HistoryPanel::listExperts() {
  const QString typed = expert_->currentText();
  expert_->clear();
  if (edits_.isOpen()) {
    for (const fuzzy::Expert& expert : edits_.model().experts) expert_->addItem(text(expert.id));
  }
  expert_->setCurrentText(typed);
}

void HistoryPanel::takeSnapshot() {
  if (!name_it_->isEnabled()) return;
  edits_.snapshot(snapshot_->text());
  snapshot_->clear();
  view_->setFocus();
}

// The button says what the sign-off will read.
void HistoryPanel::showFelt() {
  const editing::Felt& felt = edits_.felt();
  const bool any = felt.strokes > 0;
  sign_off_->setText(any ? tr("Feels right") : tr("Approve unfelt"));
  sign_off_->setAccessibleName(sign_off_->text());
  sign_off_->setToolTip(any ? tr("Sign off what was felt: %n stroke(s) on this state, on %1 (Ctrl+Shift+G)", nullptr,
                                 static_cast<int>(felt.strokes))
                                  .arg(text(felt.device))
                            : tr("Approve this state without feeling it: the sign-off will read “approved without "
                                 "feeling”. Feel one stroke on it for “feels right” (Ctrl+Shift+G)"));
}

void HistoryPanel::takeSignOff() {
  if (!sign_off_->isEnabled()) return;
  edits_.signOff(expert_->currentText());
}

void HistoryPanel::openMenu(const QPoint& at) {
  const QModelIndex index = view_->indexAt(at);
  if (!index.isValid()) return;
  const editing::StateId state = model_->row(index.row()).state;
  QMenu menu(this);
  connect(menu.addAction(tr("Return to this state")), &QAction::triggered, this,
          [this, state] { edits_.returnTo(state); });
  QAction* const carry = menu.addAction(tr("Carry its edits over to this model…"));
  carry->setEnabled(state != edits_.history().current());
  connect(carry, &QAction::triggered, this, [this, state] { emit carryAsked(state); });
  menu.addSeparator();
  const auto as = [&](const QString& name, CompareSide side) {
    connect(menu.addAction(name), &QAction::triggered, this, [this, state, side] {
      compare_.choose(side, {CompareChoice::Kind::kState, state, {}});
      showSide(true);
    });
  };
  as(tr("Compare: this is A"), CompareSide::kA);
  as(tr("Compare: this is B"), CompareSide::kB);
  menu.exec(view_->viewport()->mapToGlobal(at));
}

void HistoryPanel::askSnapshot() {
  showSide(false);
  snapshot_->setFocus(Qt::ShortcutFocusReason);
}

void HistoryPanel::askSignOff() {
  showSide(true);
  expert_->setFocus(Qt::ShortcutFocusReason);
}

void HistoryPanel::askAuthor() {
  showSide(true);
  author_field_->setFocus(Qt::ShortcutFocusReason);
  author_field_->selectAll();
}

}  // namespace tactus::workbench
