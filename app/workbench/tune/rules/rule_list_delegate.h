// Paints the list of rules and edits it in place: force words in their colors, weights as numbers.
#pragma once

#include <QStyledItemDelegate>

namespace tactus::workbench {

class Flash;
class RuleController;

class RuleListDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  /// `flash` lights up the selected rows.
  RuleListDelegate(const RuleController& rules, const Flash& flash, QObject* parent = nullptr);

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  void setEditorData(QWidget* editor, const QModelIndex& index) const override;
  void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override;

 protected:
  bool eventFilter(QObject* editor, QEvent* event) override;
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override;

 private:
  void paintCell(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const;
  void paintWord(QPainter& painter, const QRectF& place, const QModelIndex& index) const;

  const RuleController& rules_;
  const Flash& flash_;
};

}  // namespace tactus::workbench
