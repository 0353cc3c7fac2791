#include "tests/gui/shown_texts.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAction>
#include <QComboBox>
#include <QCommandLinkButton>
#include <QDoubleSpinBox>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QTabBar>
#include <QWidget>
#include <qcustomplot.h>

namespace tactus::tests {
namespace {

class Collector {
 public:
  void look(QWidget& window) {
    ofWidget(window);
    for (QWidget* widget : window.findChildren<QWidget*>()) ofWidget(*widget);
    for (QAction* action : window.findChildren<QAction*>()) ofAction(*action);
  }

  std::vector<ShownText> texts;

 private:
  void add(const QObject& holder, const char* kind, const QString& text) {
    if (text.isEmpty()) return;
    QString where;
    for (const QObject* object = &holder; object != nullptr; object = object->parent()) {
      const QString part = QString::fromLatin1(object->metaObject()->className()).section(QStringLiteral("::"), -1);
      where.prepend(where.isEmpty() ? part : part + QLatin1Char('/'));
    }
    texts.push_back({where + QLatin1Char(' ') + QLatin1String(kind), text});
  }

  void ofAction(const QAction& action) {
    add(action, "text", action.text());
    add(action, "tool tip", action.toolTip());
    add(action, "status tip", action.statusTip());
  }

  void ofWidget(QWidget& widget) {
    add(widget, "title", widget.windowTitle());
    add(widget, "tool tip", widget.toolTip());
    add(widget, "status tip", widget.statusTip());
    add(widget, "what's this", widget.whatsThis());
    add(widget, "accessible name", widget.accessibleName());
    add(widget, "accessible description", widget.accessibleDescription());
    if (const auto* label = qobject_cast<QLabel*>(&widget)) add(widget, "text", label->text());
    if (const auto* button = qobject_cast<QAbstractButton*>(&widget)) add(widget, "text", button->text());
    if (const auto* link = qobject_cast<QCommandLinkButton*>(&widget)) add(widget, "description", link->description());
    if (const auto* group = qobject_cast<QGroupBox*>(&widget)) add(widget, "group", group->title());
    if (const auto* menu = qobject_cast<QMenu*>(&widget)) add(widget, "menu", menu->title());
    if (const auto* line = qobject_cast<QLineEdit*>(&widget)) add(widget, "placeholder", line->placeholderText());
    if (const auto* box = qobject_cast<QDoubleSpinBox*>(&widget)) {
      add(widget, "prefix", box->prefix());
      add(widget, "suffix", box->suffix());
      add(widget, "special value", box->specialValueText());
    }
    if (const auto* tabs = qobject_cast<QTabBar*>(&widget)) {
      for (int i = 0; i < tabs->count(); ++i) {
        add(widget, "tab", tabs->tabText(i));
        add(widget, "tab's tool tip", tabs->tabToolTip(i));
      }
    }
    if (const auto* box = qobject_cast<QComboBox*>(&widget)) ofModel(widget, *box->model());
    if (const auto* view = qobject_cast<QAbstractItemView*>(&widget); view != nullptr && view->model() != nullptr) {
      ofModel(widget, *view->model());
    }
    if (auto* plot = qobject_cast<QCustomPlot*>(&widget)) ofPlot(*plot);
  }

  void ofModel(const QWidget& view, const QAbstractItemModel& model) {
    constexpr int kRoles[] = {Qt::DisplayRole, Qt::ToolTipRole, Qt::AccessibleTextRole, Qt::StatusTipRole};
    for (int column = 0; column < model.columnCount(); ++column) {
      for (const int role : kRoles) {
        add(view, "header", model.headerData(column, Qt::Horizontal, role).toString());
        for (int row = 0; row < model.rowCount(); ++row) {
          add(view, "item", model.index(row, column).data(role).toString());
        }
      }
    }
  }

  void ofPlot(QCustomPlot& plot) {
    for (const QCPAxis* axis : {plot.xAxis, plot.yAxis, plot.xAxis2, plot.yAxis2}) add(plot, "axis", axis->label());
    for (int i = 0; i < plot.itemCount(); ++i) {
      if (const auto* text = qobject_cast<QCPItemText*>(plot.item(i))) add(plot, "words", text->text());
    }
    for (int i = 0; i < plot.graphCount(); ++i) add(plot, "line", plot.graph(i)->name());
  }
};

}  // namespace

std::vector<ShownText> shownTexts(QWidget& window) {
  Collector collector;
  collector.look(window);
  return std::move(collector.texts);
}

}  // namespace tactus::tests
