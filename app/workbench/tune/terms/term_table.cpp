#include <QComboBox>
#include <QCoreApplication>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QStringList>
#include <QToolButton>
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "app/editing/edit.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/buttons.h"
#include "app/workbench/kit/cards.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/kit/number_box.h"
#include "app/workbench/plot/term_marks.h"
#include "app/workbench/tune/terms/membership_editor.h"
#include "app/workbench/tune/terms/term_controller.h"
#include "core/fuzzy/membership.h"

class QWidget;

namespace tactus::workbench {

// Small forms for a whole term: split it, or remove it together with its rules.

class TermController;

/// Asks below `anchor` for the cuts, then splits the term. `terms` outlives `parent`.
void askSplit(TermController& terms, const std::string& term, const QWidget& anchor, QWidget* parent);
/// Removes the term. Asks first if rules name it.
void askRemove(TermController& terms, const std::string& term, const QWidget& anchor, QWidget* parent);

namespace {

using fuzzy::Term;

constexpr int kMostParts = 8;

struct TermForms {
  Q_DECLARE_TR_FUNCTIONS(TermForms)
};

QString cutsText(const std::vector<double>& cuts, const fuzzy::Variable& variable) {
  QStringList parts;
  for (const double cut : cuts) parts << text(editing::numberText(variable, cut));
  return parts.join(QStringLiteral("; "));
}

// Places that cut the part of the core inside the universe into equal parts.
std::vector<double> equalCuts(const fuzzy::Variable& variable, const Term& term, int parts) {
  const auto shape = fuzzy::MembershipFunction::of(term);
  const double from = std::max(shape.b, variable.min);
  const double to = std::min(shape.c, variable.max);
  std::vector<double> cuts;
  for (int i = 1; i < parts; ++i) cuts.push_back(roundedPlace(variable, from + (to - from) * i / parts));
  return cuts;
}

}  // namespace

void askSplit(TermController& terms, const std::string& term, const QWidget& anchor, QWidget* parent) {
  const Term* const found = fuzzy::findTerm(terms.terms(), term);
  if (found == nullptr) return;
  const Term whole = *found;
  const fuzzy::Variable variable = terms.variable();
  auto* form = new PopupForm(TermForms::tr("Split %1").arg(labelOf(whole)), TermForms::tr("Split"), parent);
  const int rules = static_cast<int>(terms.rulesOf(term));
  const bool output = variable.id == terms.model().output.id;
  if (rules > 0 && !output) {
    form->setNote(
        TermForms::tr("Its %n rule(s) are copied to each part, so the force stays as it is until you change a part.",
                      nullptr, rules));
  }
  auto* parts = new NumberBox({"parts", {}, "1", 2, kMostParts, {}}, 1, form);
  parts->setWhole();
  parts->setButtonSymbols(QAbstractSpinBox::UpDownArrows);
  parts->setFixedWidth(parts->sizeHint().width());
  parts->setAccessibleName(TermForms::tr("Number of parts"));
  auto* cuts = new QLineEdit(cutsText(equalCuts(variable, whole, 2), variable), form);
  cuts->setAccessibleName(TermForms::tr("Cuts"));
  auto* picture = new CutPicture(variable, whole, form);
  picture->setCuts(equalCuts(variable, whole, 2));
  form->addField(TermForms::tr("Parts:"), parts);
  const QString unit = unitText(variable.unit);
  form->addField(unit.isEmpty() ? TermForms::tr("Cuts:") : TermForms::tr("Cuts (%1):").arg(unit), cuts);
  form->addField(TermForms::tr("Drag:"), picture);
  QObject::connect(parts, &NumberBox::valueChanged, form, [variable, whole, cuts, picture](double count) {
    picture->setCuts(equalCuts(variable, whole, static_cast<int>(count)));
    cuts->setText(cutsText(picture->cuts(), variable));
  });
  QObject::connect(picture, &CutPicture::moved, cuts,
                   [variable, cuts](const std::vector<double>& places) { cuts->setText(cutsText(places, variable)); });
  QObject::connect(cuts, &QLineEdit::textEdited, picture, [picture, unit](const QString& typed) {
    if (const auto places = typedNumbers(typed, unit)) picture->setCuts(*places);
  });
  QObject::connect(form, &PopupForm::accepted, form, [&terms, term, cuts, parts, unit, form] {
    if (!parts->commit()) {
      form->setNote(parts->refusal());
      return;
    }
    const auto places = typedNumbers(cuts->text(), unit);
    if (!places) {
      form->setNote(
          TermForms::tr("%1 Type the cuts with semicolons between them, such as 290; 365.").arg(places.error()));
      return;
    }
    if (const QString why = terms.whyNotSplit(term, *places); !why.isEmpty()) {
      form->setNote(why);
      return;
    }
    form->close();
    terms.split(term, *places);
  });
  form->openAt(anchor);
}

void askRemove(TermController& terms, const std::string& term, const QWidget& anchor, QWidget* parent) {
  const int rules = static_cast<int>(terms.rulesOf(term));
  if (rules == 0) {
    terms.remove(term, false);
    return;
  }
  const Term* const found = fuzzy::findTerm(terms.terms(), term);
  if (found == nullptr) return;
  auto* form = new PopupForm(TermForms::tr("Remove %1").arg(labelOf(*found)),
                             TermForms::tr("Remove it and its %n rule(s)", nullptr, rules), parent);
  form->setNote(TermForms::tr("%n rule(s) name this term and go with it. Undo brings all back.", nullptr, rules));
  QObject::connect(form, &PopupForm::accepted, form, [&terms, term, form] {
    form->close();
    terms.remove(term, true);
  });
  form->openAt(anchor);
}

namespace {

using fuzzy::Shape;
using fuzzy::Term;

enum TermColumn { kSwatch, kName, kShape, kFirstPoint, kMore = kFirstPoint + 4, kColumns };

constexpr int kSwatchSide = 12;  // px
constexpr int kNarrowestName = 64;
constexpr int kMostWidth = 520;  // px that the table needs at most: as much as a window of 1280 px leaves it
constexpr int kMoreWidth = 22;
constexpr int kFewestRows = 4;  // with the head

// A triangle has its peak where a trapezoid has its left shoulder; a Gaussian its mean.
int columnOf(Shape shape, std::size_t point) {
  if (shape == Shape::kTriangle && point == 2) return kFirstPoint + 3;
  if (shape == Shape::kGaussian) return kFirstPoint + 1 + static_cast<int>(point);
  return kFirstPoint + static_cast<int>(point);
}

QString shapeText(Shape shape) {
  switch (shape) {
    case Shape::kTrapezoid: return TermTable::tr("Trapezoid");
    case Shape::kTriangle: return TermTable::tr("Triangle");
    case Shape::kGaussian: return TermTable::tr("Gaussian");
  }
  return {};
}

}  // namespace

TermTable::TermTable(TermController& terms, QWidget* parent) : QScrollArea(parent), terms_(terms) {
  setFrameShape(QFrame::NoFrame);
  setAccessibleName(tr("Terms as numbers"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  setWidgetResizable(true);
  setBackgroundRole(QPalette::Base);
  connect(&terms_, &TermController::listChanged, this, &TermTable::build);
  connect(&terms_, &TermController::termsChanged, this, &TermTable::refreshState);
  connect(&terms_, &TermController::locksChanged, this, &TermTable::showLocks);
  connect(&terms_, &TermController::selectionChanged, this, &TermTable::showSelection);
}

// With large text the plot comes first.
QSize TermTable::sizeHint() const {
  const QSize all = QScrollArea::sizeHint();
  return folded_ ? QSize(all.width(), minimumHeight()) : all;
}

void TermTable::showEvent(QShowEvent* event) {
  // Hidden, it followed nothing.
  build();
  QScrollArea::showEvent(event);
}

void TermTable::changeEvent(QEvent* event) {
  QScrollArea::changeEvent(event);
  // The columns are as wide as their texts; later, because the parts get their fonts now.
  if (event->type() == QEvent::FontChange) QMetaObject::invokeMethod(this, &TermTable::build, Qt::QueuedConnection);
}

bool TermTable::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::FocusIn || building_) return QScrollArea::eventFilter(watched, event);
  for (std::size_t t = 0; t < rows_.size(); ++t) {
    const Row& row = rows_[t];
    if (watched == row.name || watched == row.shapes) terms_.select(Grip{t, Grip::Part::kTerm, 0, false});
    for (std::size_t p = 0; p < row.points.size(); ++p) {
      if (watched == row.points[p].number) terms_.select(Grip{t, Grip::Part::kVertex, p, false});
    }
  }
  return QScrollArea::eventFilter(watched, event);
}

bool TermTable::sameRows() const {
  const std::vector<Term>& terms = terms_.terms();
  return std::equal(rows_.begin(), rows_.end(), terms.begin(), terms.end(),
                    [](const Row& row, const Term& term) { return row.term == term.id && row.shape == term.shape; });
}

void TermTable::refreshState() {
  if (!isVisible()) return;
  if (sameRows()) {
    showValues();
  } else {
    build();
  }
}

void TermTable::build() {
  if (!isVisible()) return;
  building_ = true;
  auto* content = new QWidget;
  auto* grid = new QGridLayout(content);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(3);
  grid->setVerticalSpacing(2);
  grid->setColumnStretch(kName, 1);
  grid->setColumnMinimumWidth(kName, kNarrowestName);
  rows_.clear();
  if (terms_.isOpen()) {
    buildHeads(*grid);
    for (std::size_t i = 0; i < terms_.terms().size(); ++i) buildRow(*grid, i);
    grid->setRowStretch(static_cast<int>(terms_.terms().size()) + 1, 1);
  }
  // The old rows may be in the middle of a signal of theirs.
  if (QWidget* old = takeWidget()) old->deleteLater();
  setWidget(content);
  // The numbers are never cut off; what is left of the width belongs to the names. With large text the shapes go into
  // the menus of the rows. Where that is not enough the table scrolls by itself, so that the plot above it keeps its
  // place.
  const int beside = verticalScrollBar()->sizeHint().width();
  folded_ = content->minimumSizeHint().width() + beside > kMostWidth;
  if (folded_) foldShapes(*grid);
  const int whole = content->minimumSizeHint().width() + beside;
  setMinimumWidth(std::min(whole, kMostWidth));
  // All rows where there is room for them, and never more room than rows: the rest belongs to the plot.
  const int row = content->sizeHint().height() / (static_cast<int>(rows_.size()) + 1);
  const int bar = whole > kMostWidth ? horizontalScrollBar()->sizeHint().height() : 0;
  setMaximumHeight(content->sizeHint().height() + 2 + bar);
  setMinimumHeight(std::min(maximumHeight(), (folded_ ? kFewestRows + 1 : kFewestRows) * row));
  updateGeometry();
  building_ = false;
  showValues();
  showLocks();
  showSelection();
}

void TermTable::buildHeads(QGridLayout& grid) {
  const QString unit = unitText(terms_.variable().unit);
  const std::pair<int, QString> heads[] = {{kName, tr("Term")},
                                           {kShape, tr("Shape")},
                                           {kFirstPoint, tr("Foot")},
                                           {kFirstPoint + 1, tr("Shoulder")},
                                           {kFirstPoint + 2, tr("Shoulder")},
                                           {kFirstPoint + 3, unit.isEmpty() ? tr("Foot") : tr("Foot (%1)").arg(unit)}};
  for (const auto& [column, head] : heads) {
    auto* label = new QLabel(head);
    setMuted(*label);
    label->setAlignment(column >= kFirstPoint ? Qt::AlignHCenter | Qt::AlignVCenter : Qt::AlignLeft | Qt::AlignVCenter);
    grid.addWidget(label, 0, column);
  }
}

void TermTable::buildRow(QGridLayout& grid, std::size_t index) {
  const Term& term = terms_.terms()[index];
  const int place = static_cast<int>(index) + 1;
  Row row;
  row.term = term.id;
  row.shape = term.shape;
  row.band = new QWidget;
  row.band->setAutoFillBackground(true);
  row.band->setBackgroundRole(QPalette::Window);
  grid.addWidget(row.band, place, 0, 1, kColumns);

  auto* swatch = new QLabel;
  swatch->setFixedSize(kSwatchSide, kSwatchSide);
  swatch->setAutoFillBackground(true);
  swatch->setBackgroundRole(QPalette::Window);
  QPalette colors = swatch->palette();
  colors.setColor(QPalette::Window, termFill(terms_.variable(), terms_.terms(), index));
  swatch->setPalette(colors);
  auto* framed = new QWidget;
  makeRow(framed, {swatch}, theme::kGrid, {6, 0, 2, 0});
  grid.addWidget(framed, place, kSwatch);

  row.name = new ElidedEdit;
  row.name->setToolTip(tr("Id in the model: %1").arg(text(term.id)));
  row.name->installEventFilter(this);
  grid.addWidget(row.name, place, kName);

  row.shapes = new QComboBox;
  for (const fuzzy::Shape shape : fuzzy::kShapes) row.shapes->addItem(shapeText(shape), static_cast<int>(shape));
  row.shapes->setCurrentIndex(row.shapes->findData(static_cast<int>(term.shape)));
  row.shapes->setFont(theme::smallFont());
  row.shapes->setFocusPolicy(Qt::StrongFocus);
  row.shapes->installEventFilter(this);
  grid.addWidget(row.shapes, place, kShape);

  for (std::size_t p = 0; p < term.points.size(); ++p) row.points.push_back(buildPoint(grid, index, p));
  buildMore(grid, index, row);
  QList<QWidget*> parts{row.name, row.shapes};
  for (const Point& point : row.points) parts << point.number << point.lock;
  new RowStop(parts << row.more, row.band);

  const std::string id = term.id;
  QLineEdit* const name = row.name;
  connect(name, &QLineEdit::editingFinished, this, [this, id, name] {
    // From now on it shows the name that the term has, also after an undo.
    name->setModified(false);
    const Term* const now = fuzzy::findTerm(terms_.terms(), id);
    if (now != nullptr && name->text().trimmed() != labelOf(*now)) terms_.rename(id, name->text());
  });
  QComboBox* const shapes = row.shapes;
  connect(shapes, &QComboBox::activated, this, [this, id, shapes] {
    terms_.convert(id, static_cast<fuzzy::Shape>(shapes->currentData().toInt()));
    refreshState();
  });
  rows_.push_back(std::move(row));
}

TermTable::Point TermTable::buildPoint(QGridLayout& grid, std::size_t index, std::size_t point) {
  const fuzzy::Variable& variable = terms_.variable();
  const Term& term = terms_.terms()[index];
  const double range = variable.max - variable.min;
  Point out;
  out.number = new NumberBox(variable, editing::editStep(variable, editing::StepSize::kFine));
  out.number->setSuffix({});
  const bool sigma = term.shape == fuzzy::Shape::kGaussian && point == 1;
  if (term.shape == fuzzy::Shape::kGaussian) out.number->setPrefix(sigma ? QStringLiteral("σ ") : QStringLiteral("µ "));
  out.number->setRange(sigma ? 0 : variable.min - range, sigma ? 10 * range : variable.max + range);
  // Room for the end of the universe with two decimals.
  out.number->setFont(theme::smallFont());
  out.number->setRoomFor(numberText(variable.max) + (sigma ? QStringLiteral("σ .0 ") : QStringLiteral(".00 ")));
  const QString name = text(editing::pointName(term.shape, point));
  out.number->setToolTip(tr("Move the %1: type a value, or use the arrow keys").arg(name));
  out.number->installEventFilter(this);

  out.lock = new LockButton;
  out.lock->setToolTip(tr("Lock the %1 in place").arg(name));

  auto* cell = new QWidget;
  makeRow(cell, {out.number, out.lock}, 0);
  grid.addWidget(cell, static_cast<int>(index) + 1, columnOf(term.shape, point));

  const std::string id = term.id;
  connect(out.number, &NumberBox::valueChanged, this, [this, id, point](double value) {
    terms_.setPoint(id, point, value);
    refreshState();
  });
  connect(out.lock, &LockButton::toggled, this,
          [this, id, point](bool locked) { terms_.setLocked(id, point, locked); });
  return out;
}

void TermTable::foldShapes(QGridLayout& grid) {
  grid.itemAtPosition(0, kShape)->widget()->hide();
  for (const Row& row : rows_) {
    row.shapes->hide();
    row.shape_menu->menuAction()->setVisible(true);
  }
  grid.invalidate();
}

void TermTable::buildMore(QGridLayout& grid, std::size_t index, Row& row) {
  const Term& term = terms_.terms()[index];
  const std::string id = term.id;
  auto* more = new QToolButton;
  more->setText(QStringLiteral("⋯"));
  more->setAutoRaise(true);
  more->setFixedWidth(kMoreWidth);
  more->setToolTip(tr("Split or remove the term"));
  auto* menu = new QMenu(more);
  menu->setToolTipsVisible(true);
  QAction* split = menu->addAction(tr("&Split…"));
  split->setEnabled(term.shape == fuzzy::Shape::kTrapezoid);
  split->setToolTip(split->isEnabled() ? tr("Cut the term into parts; its rules are copied to each")
                                       : tr("Only a trapezoid can be split: convert the term first"));
  QAction* remove = menu->addAction(tr("&Remove"));
  remove->setEnabled(terms_.terms().size() > 1);
  connect(more, &QToolButton::clicked, menu,
          [menu, more] { menu->popup(more->mapToGlobal(QPoint(0, more->height()))); });
  grid.addWidget(more, static_cast<int>(index) + 1, kMore);
  connect(split, &QAction::triggered, this, [this, id, more] { askSplit(terms_, id, *more, this); });
  connect(remove, &QAction::triggered, this, [this, id, more] { askRemove(terms_, id, *more, this); });
  row.more = more;
  row.shape_menu = menu->addMenu(tr("S&hape"));
  row.shape_menu->menuAction()->setVisible(false);
  for (const fuzzy::Shape shape : fuzzy::kShapes) {
    QAction* choice = row.shape_menu->addAction(shapeText(shape), this, [this, id, shape] {
      terms_.convert(id, shape);
      refreshState();
    });
    choice->setEnabled(term.shape != shape);
  }
}

void TermTable::showValues() {
  if (!terms_.isOpen() || !sameRows()) return;
  for (std::size_t t = 0; t < rows_.size(); ++t) {
    const Term& term = terms_.terms()[t];
    const QString label = labelOf(term);
    nameRow(rows_[t], term);
    if (!rows_[t].name->hasFocus() || !rows_[t].name->isModified()) {
      rows_[t].name->setText(label);
      rows_[t].name->setCursorPosition(0);
    }
    const QSignalBlocker no_shape(rows_[t].shapes);
    rows_[t].shapes->setCurrentIndex(rows_[t].shapes->findData(static_cast<int>(term.shape)));
    for (std::size_t p = 0; p < rows_[t].points.size(); ++p) {
      const QSignalBlocker no_number(rows_[t].points[p].number);
      rows_[t].points[p].number->setValue(term.points[p]);
    }
  }
}

void TermTable::nameRow(const Row& row, const Term& term) {
  const QString label = labelOf(term);
  row.name->setAccessibleName(tr("Name of %1").arg(label));
  row.shapes->setAccessibleName(tr("Shape of %1").arg(label));
  row.more->setAccessibleName(tr("More for %1").arg(label));
  for (std::size_t p = 0; p < row.points.size(); ++p) {
    const QString point = text(editing::pointName(term.shape, p));
    row.points[p].number->setAccessibleName(QStringLiteral("%1: %2").arg(label, point));
    row.points[p].lock->setAccessibleName(tr("Lock the %1 of %2").arg(point, label));
  }
}

void TermTable::showLocks() {
  for (const Row& row : rows_) {
    for (std::size_t p = 0; p < row.points.size(); ++p) {
      const QSignalBlocker no_lock(row.points[p].lock);
      row.points[p].lock->setChecked(terms_.isLocked(row.term, p));
      row.points[p].lock->update();
    }
  }
}

void TermTable::showSelection() {
  for (std::size_t t = 0; t < rows_.size(); ++t) {
    const bool selected = terms_.selected() && terms_.selected()->term == t;
    QColor tint = termFill(terms_.variable(), terms_.terms(), t);
    tint.setAlphaF(0.14F);
    QPalette colors = rows_[t].band->palette();
    colors.setColor(QPalette::Window, selected ? tint : QColor(Qt::transparent));
    rows_[t].band->setPalette(colors);
    QPalette name = rows_[t].name->palette();
    name.setColor(QPalette::Base, Qt::transparent);
    rows_[t].name->setPalette(name);
  }
}

}  // namespace tactus::workbench
