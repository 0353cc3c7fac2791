#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QPainter>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/cards.h"
#include "app/workbench/kit/force_word.h"
#include "app/workbench/tune/rules/rule_controller.h"
#include "app/workbench/tune/rules/rule_editor.h"
#include "app/workbench/tune/rules/rule_list_model.h"
#include "app/workbench/tune/rules/rule_weight.h"

namespace tactus::workbench {
namespace {

constexpr int kGlow = 3;  // px, the frame of a row that was pointed at

// The bar of a firing strength along the lower edge, its number above it.
void paintBar(QPainter& painter, const QRectF& place, double strength) {
  const QRectF track = QRectF(place.left() + 4, place.bottom() - 5, place.width() - 8, 3);
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme::border());
  painter.drawRoundedRect(track, 1.5, 1.5);
  painter.setBrush(theme::accent());
  painter.drawRoundedRect(QRectF(track.topLeft(), QSizeF(track.width() * strength, 3)), 1.5, 1.5);
}

}  // namespace

RuleListDelegate::RuleListDelegate(const RuleController& rules, const Flash& flash, QObject* parent)
    : QStyledItemDelegate(parent), rules_(rules), flash_(flash) {}

void RuleListDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
  paintCell(painter, option, index);
  if (!option.state.testFlag(QStyle::State_Selected) || flash_.strength() == 0) return;
  QColor glow = theme::accent();
  glow.setAlphaF(static_cast<float>(flash_.strength()));
  const QRect& row = option.rect;
  painter->fillRect(QRect(row.left(), row.top(), row.width(), kGlow), glow);
  painter->fillRect(QRect(row.left(), row.bottom() + 1 - kGlow, row.width(), kGlow), glow);
}

void RuleListDelegate::paintCell(QPainter* painter, const QStyleOptionViewItem& option,
                                 const QModelIndex& index) const {
  QStyleOptionViewItem shown = option;
  // The frame of a single cell says nothing in a list of whole rows.
  shown.state &= ~QStyle::State_HasFocus;
  if (index.column() != RuleListModel::kConsequent && index.column() != RuleListModel::kStrength) {
    QStyledItemDelegate::paint(painter, shown, index);
    return;
  }
  initStyleOption(&shown, index);
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  if (index.column() == RuleListModel::kConsequent) {
    shown.text.clear();
    QApplication::style()->drawControl(QStyle::CE_ItemViewItem, &shown, painter, shown.widget);
    painter->setFont(option.font);
    paintWord(*painter, QRectF(option.rect).adjusted(3, 2, -3, -2), index);
  } else {
    QApplication::style()->drawControl(QStyle::CE_ItemViewItem, &shown, painter, shown.widget);
    const double strength = index.data(RuleListModel::kActs).toDouble();
    if (strength > 0) paintBar(*painter, option.rect, strength);
  }
  painter->restore();
}

void RuleListDelegate::initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const {
  QStyledItemDelegate::initStyleOption(option, index);
  if (index.column() != RuleListModel::kConditions) return;
  // Where one line is too short, each condition has its own.
  if (option->fontMetrics.horizontalAdvance(option->text) > option->rect.width() - theme::kGrid) {
    option->text = index.data(RuleListModel::kLines).toString();
  }
}

void RuleListDelegate::paintWord(QPainter& painter, const QRectF& place, const QModelIndex& index) const {
  const QVariant word = index.data(RuleListModel::kWord);
  if (!word.isValid()) return;
  paintForceWord(painter, place,
                 {index.data().toString(), theme::force(word.toUInt(), rules_.words().size()),
                  index.data(RuleListModel::kIsEnabled).toBool(), 1, index.data(RuleListModel::kConflict).toBool()});
}

QWidget* RuleListDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem& /*option*/,
                                        const QModelIndex& index) const {
  if (index.column() == RuleListModel::kWeight) {
    NumberBox* box = makeWeightBox(parent);
    box->setMinimumWidth(0);
    box->setMaximumWidth(QWIDGETSIZE_MAX);
    return box;
  }
  auto* words = new QComboBox(parent);
  words->setAccessibleName(tr("Consequent"));
  for (const fuzzy::Term& word : rules_.words()) words->addItem(labelOf(word));
  // Choosing a word commits it; no confirmation follows.
  connect(words, &QComboBox::activated, this, [this, words] {
    auto* self = const_cast<RuleListDelegate*>(this);
    emit self->commitData(words);
    emit self->closeEditor(words);
  });
  return words;
}

void RuleListDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const {
  if (auto* box = qobject_cast<NumberBox*>(editor)) {
    box->setExact(index.data(Qt::EditRole).toDouble());
    box->selectAll();
  } else if (auto* words = qobject_cast<QComboBox*>(editor)) {
    words->setCurrentIndex(index.data(RuleListModel::kWord).toInt());
  }
}

void RuleListDelegate::setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const {
  if (auto* box = qobject_cast<NumberBox*>(editor)) {
    if (box->commit()) model->setData(index, box->exact());
  } else if (auto* words = qobject_cast<QComboBox*>(editor)) {
    model->setData(index, words->currentIndex());
  }
}

bool RuleListDelegate::eventFilter(QObject* editor, QEvent* event) {
  auto* const box = qobject_cast<NumberBox*>(editor);
  if (box != nullptr && event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    const bool leaves = key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_Tab || key == Qt::Key_Backtab;
    // What is no weight stays to be mended; the box says why.
    if (leaves && !box->commit()) return true;
  }
  return QStyledItemDelegate::eventFilter(editor, event);
}

}  // namespace tactus::workbench
