// A card of a lab: its heading with buttons beside it, and its content below.
#pragma once

#include <QString>
#include <QTableView>
#include <QWidget>
#include <functional>

#include "app/workbench/base/plot_table.h"
#include "app/workbench/kit/cards.h"
#include "app/workbench/labs/data/lab_data.h"

class QHBoxLayout;
class QLabel;
class QSlider;

namespace tactus::workbench {

// A setting of a lab: its name, a slider, and a box for the exact number.

class NumberBox;

class SettingRow : public QWidget {
  Q_OBJECT

 public:
  struct Range {
    double min;
    double max;
    double step;     ///< of the slider
    QString unit{};  ///< for the screen; empty: none
    bool whole = false;
  };
  SettingRow(const QString& name, const QString& what, const Range& range, QWidget* parent = nullptr);

  double value() const { return value_; }
  /// Shows `value`; emits nothing.
  void setValue(double value);

 signals:
  /// The person moved the slider or typed a number; `value` is in the range.
  void changed(double value);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void setByHand(double value);

  Range range_;
  double value_;
  QLabel* name_;
  QSlider* slider_;
  NumberBox* box_;
};

// How tables look in the labs: quiet ones (kit/quiet_table.h) with roomy cells, as wide as their place.

/// A table of `model`, without row heads, as wide as its place; `stretched`: the column that takes the room, -1: each
/// column has its width and the last one takes the rest.
QTableView* makeLabTable(QAbstractItemModel& model, int stretched, const QString& accessible_name, QWidget* parent);

/// The same over a QSortFilterProxyModel: a click on a head sorts the rows by `kOrderRole`; at first, and after a third
/// click, they stand in the order of `model`.
QTableView* makeSortedLabTable(QAbstractItemModel& model, int stretched, const QString& accessible_name,
                               QWidget* parent);

// The caption of a picture or table of a lab: the study, what is shown, and whose data are simulated.

/// A table without columns for a plot of the open study. `suffix` ends the proposed file name: `-pulls`. `notes`:
/// further lines of the caption.
PlotTable labTable(const LabData& data, const QString& what, const QString& suffix, const QStringList& notes = {});

/// A lab on the screen: what it shows is computed while it is visible.
class LabView : public QWidget {
  Q_OBJECT

 public:
  /// `title`: for the window. `set_wanted`: tells the lab whether it is visible.
  LabView(const QString& name, const QString& title, std::function<void(bool wanted)> set_wanted, QWidget* parent);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  std::function<void(bool)> set_wanted_;
};

class LabCard : public Card {
  Q_OBJECT

 public:
  /// `brief`: the heading where `title` does not fit.
  LabCard(const QString& title, QWidget* content, const QString& brief = {});

  /// Adds `tool` at the right of the heading.
  void addTool(QWidget* tool);

 private:
  QHBoxLayout* head_;
};

}  // namespace tactus::workbench
