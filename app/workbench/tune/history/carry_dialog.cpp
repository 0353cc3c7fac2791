#include "app/workbench/tune/history/carry_dialog.h"

#include <QHeaderView>
#include <QHideEvent>
#include <QItemSelectionModel>
#include <QLabel>
#include <QProgressBar>
#include <QShowEvent>
#include <QTableView>
#include <algorithm>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/buttons.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/kit/quiet_table.h"

namespace tactus::workbench {
namespace {

constexpr int kWidth = 980;   // px
constexpr int kHeight = 460;  // px; the curves stay in sight beside it
constexpr int kLeastLines = 8;
constexpr int kWhat = 0;
constexpr int kRemark = 4;
constexpr int kPercent = 100;

}  // namespace

CarryDialog::CarryDialog(CarryController& carry, QWidget* parent)
    : QDialog(parent),
      carry_(carry),
      model_(columns()),
      title_(new QLabel(tr("Edits on the open model"), this)),
      head_(new QLabel(this)),
      table_(makeQuietTable(model_, tr("Edits of the earlier version"), this)),
      detail_(new WrappedLabel(this)),
      progress_(new QProgressBar(this)),
      stop_(new QPushButton(tr("Stop"), this)),
      sum_(new QLabel(this)),
      all_(new QPushButton(this)),
      go_(new PrimaryButton(QString(), this)) {
  setWindowTitle(tr("Carry edits over"));
  setModal(false);
  resize(kWidth, kHeight);
  title_->setFont(theme::headingFont());
  for (QLabel* label : {head_, sum_}) {
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
  }
  table_->setMouseTracking(true);
  readWhole(*table_);
  keepFitted(*table_, [this] { table_->setMinimumHeight(kLeastLines * table_->fontMetrics().lineSpacing()); });
  QHeaderView* const heads = table_->horizontalHeader();
  heads->setSectionResizeMode(QHeaderView::ResizeToContents);
  heads->setSectionResizeMode(kWhat, QHeaderView::Stretch);
  heads->setSectionResizeMode(kRemark, QHeaderView::Stretch);
  table_->setObjectName(QStringLiteral("carried_edits"));
  detail_->setTextFormat(Qt::PlainText);
  detail_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  keepFitted(*detail_, [this] { detail_->setMinimumHeight(3 * detail_->fontMetrics().lineSpacing()); });
  setInk(*detail_, theme::mutedInk());
  progress_->setRange(0, kPercent);
  progress_->setTextVisible(false);
  progress_->setAccessibleName(tr("What each edit moves"));
  auto* const close = new QPushButton(tr("Close"), this);
  close->setAutoDefault(false);
  stop_->setAutoDefault(false);
  all_->setAutoDefault(false);
  go_->setDefault(true);

  makeColumn(this,
             {title_,
              head_,
              {table_, 1},
              detail_,
              makeRow({{progress_, 1}, stop_}),
              makeRow({{sum_, 1}, all_, close, go_}, theme::kGrid)},
             2 * theme::kGrid, inset(3 * theme::kGrid));

  keepWhole(*this);

  connect(&carry_, &CarryController::rowsChanged, this, &CarryDialog::showRows);
  for (Computation* one : {&carry_.list(), &carry_.sum()}) {
    connect(one, &Computation::changed, this, &CarryDialog::showBusy);
    connect(one, &Computation::valueChanged, this, &CarryDialog::showBusy);
  }
  connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this] {
    showDetail();
    carry_.preview(selected());
  });
  connect(table_, &QTableView::entered, this,
          [this](const QModelIndex& index) { carry_.preview(static_cast<std::size_t>(index.row())); });
  connect(stop_, &QPushButton::clicked, &carry_.list(), &Computation::cancel);
  connect(close, &QPushButton::clicked, this, &QDialog::close);
  connect(all_, &QPushButton::clicked, this, [this] {
    const auto& rows = carry_.rows();
    const bool any_left = std::any_of(rows.begin(), rows.end(),
                                      [](const CarryRow& row) { return row.content.canApply() && !row.chosen; });
    carry_.chooseAll(any_left);
  });
  connect(go_, &QPushButton::clicked, this, &CarryDialog::carryOver);
  showRows();
}

std::vector<Column<CarryRow>> CarryDialog::columns() {
  using Row = CarryRow;
  const auto words = [](const std::string& one) { return harmless(text(one)); };
  const auto take = [this](const Row& row, const QVariant& value) {
    for (std::size_t r = 0; r < carry_.rows().size(); ++r) {
      if (carry_.rows()[r].edit == row.edit) carry_.choose(r, value.toInt() == Qt::Checked);
    }
    return true;
  };
  const auto checked = [](const Row& row) {
    if (!row.content.canApply()) return QVariant();
    return QVariant(static_cast<int>(row.chosen ? Qt::Checked : Qt::Unchecked));
  };
  std::vector<Column<Row>> out = {
      {tr("Edit"),
       [words](const Row& row) { return words(row.content.what); },
       Qt::AlignLeft,
       {},
       {{Qt::CheckStateRole, checked}},
       take},
      {tr("Was"), [words](const Row& row) { return words(row.content.before); }},
      {tr("You made it"), [words](const Row& row) { return words(row.content.after); }},
      {tr("Moves the force"), [this](const Row& row) { return row.price ? priceText(*row.price) : QString(); },
       Qt::AlignLeft,
       tr("The largest change of the averaged force by this edit alone, in newtons and just-noticeable differences")},
      {tr("Remark"), [words](const Row& row) {
         const QString note = words(row.content.note);
         return row.content.outcome == editing::CarriedEdit::Outcome::kConflict ? tr("Conflict: %1").arg(note) : note;
       }}};
  out = withRole<Row>(std::move(out), Qt::ToolTipRole);
  return withRole<Row>(std::move(out), Qt::ForegroundRole, [](const Row& row) {
    return row.content.canApply() ? QVariant() : QVariant(theme::mutedInk());
  });
}

void CarryDialog::bringUp(editing::StateId tuned) {
  carry_.begin(tuned);
  show();
  raise();
  activateWindow();
  table_->setFocus();
}

void CarryDialog::showEvent(QShowEvent* event) {
  QDialog::showEvent(event);
  for (Computation* one : {&carry_.list(), &carry_.sum()}) one->hold(*this);
  showBusy();
}

void CarryDialog::hideEvent(QHideEvent* event) {
  QDialog::hideEvent(event);
  for (Computation* one : {&carry_.list(), &carry_.sum()}) one->hold(*this, false);
  // A window that is only minimized comes back with what it showed.
  if (!event->spontaneous()) carry_.end();
}

void CarryDialog::leaveEvent(QEvent* event) {
  QDialog::leaveEvent(event);
  carry_.preview(selected());
}

std::optional<std::size_t> CarryDialog::selected() const {
  const QModelIndex index = table_->selectionModel()->currentIndex();
  if (!index.isValid() || static_cast<std::size_t>(index.row()) >= carry_.rows().size()) return std::nullopt;
  return static_cast<std::size_t>(index.row());
}

// `0.032 N (0.4 JND)`
QString CarryDialog::priceText(const editing::EditImpact& price) const {
  QStringList parts;
  if (!price.at.empty()) {
    QString change = forceChangeText(price.largest_n, carry_.unit());
    if (carry_.unit() == "N") change += tr(" (%1 JND)").arg(numberText(price.noticeable, 1));
    parts << change;
  }
  if (price.opened > 0) parts << tr("leaves a hole");
  if (price.closed > 0) parts << tr("fills a hole");
  return parts.isEmpty() ? tr("not at all") : parts.join(QStringLiteral(" · "));
}

QString CarryDialog::headText() const {
  QStringList out;
  const auto& rows = carry_.rows();
  const auto count = [&](auto which) { return static_cast<int>(std::count_if(rows.begin(), rows.end(), which)); };
  const int conflicts =
      count([](const CarryRow& row) { return row.content.outcome == editing::CarriedEdit::Outcome::kConflict; });
  out << tr("%n edit(s) of “%1”, each tried alone on the open model. Those that you choose become one step, which Undo "
            "takes back.",
            nullptr, static_cast<int>(rows.size()))
             .arg(carry_.source());
  if (conflicts > 0) {
    out << tr("%n of them put(s) something else in the place of what the new model has of its own; choose what counts.",
              nullptr, conflicts);
  }
  if (const QStringList names = carry_.sourceSignOffs(); !names.isEmpty()) {
    out << tr("That version was signed off by %1; the sign-off stays with it.").arg(names.join(QStringLiteral(", ")));
  }
  if (const QStringList names = carry_.targetSignOffs(); !names.isEmpty()) {
    out << tr("The open model was signed off by %1 without these edits.").arg(names.join(QStringLiteral(", ")));
  }
  return out.join(QLatin1Char(' '));
}

void CarryDialog::showRows() {
  const bool same = model_.rows().size() == carry_.rows().size();
  model_.updateRows(carry_.rows());
  if (!same && !carry_.rows().empty()) table_->selectRow(0);
  const auto& rows = carry_.rows();
  const auto can = std::count_if(rows.begin(), rows.end(), [](const CarryRow& row) { return row.content.canApply(); });
  const auto chosen = static_cast<int>(carry_.chosenCount());
  all_->setText(chosen < can || can == 0 ? tr("Choose all") : tr("Choose none"));
  all_->setEnabled(can > 0);
  go_->setText(tr("Carry over %n edit(s)", nullptr, chosen));
  go_->setEnabled(chosen > 0);
  showDetail();
  showBusy();
}

void CarryDialog::showDetail() {
  const auto row = selected();
  if (!row) return detail_->clear();
  const CarryRow& one = carry_.rows()[*row];
  QStringList out;
  out << tr("%1: %2 to %3.")
             .arg(harmless(text(one.content.what)), harmless(text(one.content.before)),
                  harmless(text(one.content.after)));
  if (one.price && !one.price->at.empty()) {
    out << tr("Most at %1: %2 instead of %3.")
               .arg(carry_.placeText(one.price->at), forceText(one.price->after_n, carry_.unit()),
                    forceText(one.price->before_n, carry_.unit()));
  }
  if (!one.content.note.empty()) out << harmless(text(one.content.note));
  detail_->setText(out.join(QLatin1Char(' ')));
}

void CarryDialog::showBusy() {
  const bool busy = carry_.list().isBusy();
  progress_->setVisible(busy);
  stop_->setVisible(busy);
  progress_->setValue(static_cast<int>(carry_.list().progress() * kPercent));
  const QString failure = carry_.failure();
  if (!carry_.isActive()) return;
  if (!failure.isEmpty()) {
    head_->setText(failure);
  } else if (carry_.rows().empty()) {
    head_->setText(busy ? tr("Comparing “%1” with the model from which it was tuned…").arg(carry_.source())
                        : tr("“%1” has no edit that the open model lacks.").arg(carry_.source()));
  } else {
    head_->setText(headText());
  }
  const editing::EditImpact* const sum = carry_.together();
  if (carry_.chosenCount() == 0) {
    sum_->setText(tr("Nothing is chosen."));
  } else {
    sum_->setText(sum == nullptr ? tr("Together: …") : tr("Together: %1").arg(impactText(*sum, carry_.unit())));
  }
}

void CarryDialog::carryOver() {
  if (carry_.carry()) close();
}

}  // namespace tactus::workbench
