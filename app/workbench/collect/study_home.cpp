#include "app/workbench/collect/study_home.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPainter>
#include <QPainterPath>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/collect/participant_table.h"
#include "app/workbench/collect/study_overview.h"
#include "app/workbench/kit/buttons.h"
#include "app/workbench/kit/cards.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/kit/notes.h"
#include "app/workbench/kit/quiet_table.h"

namespace tactus::workbench {
namespace {

constexpr int kMark = 16;  // px
constexpr int kRow = 7 * theme::kGrid;

void paintTick(QPainter& painter, const QRectF& mark) {
  QPainterPath tick;
  tick.moveTo(mark.left() + 0.25 * kMark, mark.top() + 0.52 * kMark);
  tick.lineTo(mark.left() + 0.44 * kMark, mark.top() + 0.70 * kMark);
  tick.lineTo(mark.left() + 0.76 * kMark, mark.top() + 0.32 * kMark);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(theme::card(), 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPath(tick);
}

// Full: done; a share of a pie: partly; an empty ring: open; a bar: left out; an arrow: imported.
void paintMark(QPainter& painter, const StepState& state, const QRectF& mark) {
  const QColor ink = theme::accent();
  painter.setPen(QPen(state.word == StepWord::kOpen ? theme::mutedInk() : ink, 1.6));
  painter.setBrush(Qt::NoBrush);
  const QPointF center = mark.center();
  switch (state.word) {
    case StepWord::kNotPart:
      painter.setPen(QPen(theme::border().darker(120), 1.6, Qt::SolidLine, Qt::RoundCap));
      painter.drawLine(center - QPointF(3, 0), center + QPointF(3, 0));
      break;
    case StepWord::kOpen: painter.drawEllipse(mark.adjusted(1, 1, -1, -1)); break;
    case StepWord::kPartly: {
      painter.drawEllipse(mark.adjusted(1, 1, -1, -1));
      const double share = state.share.wanted > 0 ? static_cast<double>(state.share.done) / state.share.wanted : 0.5;
      painter.setPen(Qt::NoPen);
      painter.setBrush(ink);
      painter.drawPie(mark.adjusted(3, 3, -3, -3), 90 * 16, -static_cast<int>(share * 360 * 16));
      break;
    }
    case StepWord::kDone:
      painter.setBrush(ink);
      painter.drawEllipse(mark.adjusted(0.5, 0.5, -0.5, -0.5));
      paintTick(painter, mark);
      break;
    case StepWord::kSkipped:
      painter.setPen(QPen(theme::mutedInk(), 1.6, Qt::SolidLine, Qt::RoundCap));
      painter.drawEllipse(mark.adjusted(1, 1, -1, -1));
      painter.drawLine(center - QPointF(3.5, 0), center + QPointF(3.5, 0));
      break;
    case StepWord::kUnknown: painter.drawText(mark, Qt::AlignCenter, QStringLiteral("?")); break;
    case StepWord::kGiven:
      painter.drawEllipse(mark.adjusted(1, 1, -1, -1));
      painter.drawLine(center - QPointF(0, 4), center + QPointF(0, 3.5));
      painter.drawLine(center + QPointF(0, 3.5), center + QPointF(-3, 0.5));
      painter.drawLine(center + QPointF(0, 3.5), center + QPointF(3, 0.5));
      break;
  }
}

void paintStep(QPainter& painter, const StepState& state, const QRect& cell, const QColor& ink) {
  const QFont font = theme::smallFont();
  const QString word = stateText(state);
  const int text_height = word.isEmpty() ? 0 : QFontMetrics(font).height() + 2;
  const int top = cell.center().y() - (kMark + text_height) / 2;
  paintMark(painter, state, QRectF(cell.center().x() - kMark / 2, top, kMark, kMark));
  painter.setPen(ink);
  painter.setFont(font);
  painter.drawText(QRect(cell.left(), top + kMark + 2, cell.width(), text_height), Qt::AlignHCenter | Qt::AlignTop,
                   word);
}

void paintCode(QPainter& painter, const ParticipantRow& row, const QRect& cell, const QColor& ink) {
  const QRect inside = cell.adjusted(2 * theme::kGrid, 0, -theme::kGrid, 0);
  const QFont name = theme::headingFont();
  const int height = QFontMetrics(name).height();
  const QFont badge = theme::smallFont();
  const bool marked = row.simulated || row.virtual_device || row.setup_unchecked;
  const int badge_height = marked ? QFontMetrics(badge).height() + 4 : 0;
  const int top = inside.center().y() - (height + (marked ? badge_height + 2 : 0)) / 2;
  painter.setFont(name);
  painter.setPen(ink);
  const QString code = QFontMetrics(name).elidedText(row.code, Qt::ElideRight, inside.width());
  painter.drawText(QRect(inside.left(), top, inside.width(), height), Qt::AlignLeft | Qt::AlignVCenter, code);
  if (!marked) return;
  const QString word = row.simulated        ? StudyHome::tr("SIMULATED")
                       : row.virtual_device ? StudyHome::tr("VIRTUAL")
                                            : StudyHome::tr("SET-UP NOT CHECKED");
  const QRect box(inside.left(), top + height + 2, QFontMetrics(badge).horizontalAdvance(word) + theme::kGrid,
                  badge_height);
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme::warningFill());
  painter.drawRoundedRect(box, 4, 4);
  painter.setFont(badge);
  painter.setPen(theme::warningInk());
  painter.drawText(box, Qt::AlignCenter, word);
}

}  // namespace

void StepDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
  const auto* const table = dynamic_cast<const ParticipantTable*>(index.model());
  if (table == nullptr) return;
  const ParticipantRow& row = table->row(index.row());
  const bool selected = option.state.testFlag(QStyle::State_Selected);
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  if (selected) {
    QColor fill = theme::accent();
    fill.setAlphaF(0.12F);
    painter->fillRect(option.rect, theme::onCard(fill));
    if (index.column() == ParticipantTable::kCode) {
      painter->fillRect(QRect(option.rect.topLeft(), QSize(3, option.rect.height())), theme::accent());
    }
  }
  painter->setPen(QPen(theme::grid(), 1));
  painter->drawLine(option.rect.bottomLeft(), option.rect.bottomRight());
  if (const auto step = ParticipantTable::stepOf(index.column())) {
    const bool is_next = row.next == step && !row.stopped && row.trouble.isEmpty();
    paintStep(*painter, row.at(*step), option.rect, is_next ? theme::ink() : theme::mutedInk());
  } else if (index.column() == ParticipantTable::kCode) {
    paintCode(*painter, row, option.rect, theme::ink());
  } else {
    const bool next = index.column() == ParticipantTable::kNext;
    const bool warns = next && (row.stopped || !row.trouble.isEmpty());
    painter->setFont(next ? theme::headingFont() : theme::smallFont());
    painter->setPen(warns ? theme::warningInk() : next ? theme::ink() : theme::mutedInk());
    const QRect inside = option.rect.adjusted(theme::kGrid, 0, -theme::kGrid, 0);
    painter->drawText(inside, Qt::AlignLeft | Qt::AlignVCenter,
                      painter->fontMetrics().elidedText(index.data().toString(), Qt::ElideRight, inside.width()));
  }
  if (option.state.testFlag(QStyle::State_HasFocus)) {
    painter->setBrush(Qt::NoBrush);
    painter->setPen(QPen(theme::accent(), 1.5));
    painter->drawRect(QRectF(option.rect).adjusted(1.5, 1.5, -1.5, -2.5));
  }
  painter->restore();
}

QSize StepDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
  return {QStyledItemDelegate::sizeHint(option, index).width(), kRow};
}

namespace {

constexpr int kInvitationWidth = 60 * theme::kGrid;  // px
constexpr int kStepWidth = 9 * theme::kGrid;         // px at 100 %
constexpr int kRowHeight = 7 * theme::kGrid;

// The participants' table: quiet lines, one selected row.
QTableView* makeTable(ParticipantTable& model, QWidget* parent) {
  QTableView* const view = makeQuietTable(model, StudyHome::tr("Participants"), parent);
  view->setItemDelegate(new StepDelegate(view));
  view->verticalHeader()->setDefaultSectionSize(kRowHeight);
  QHeaderView* const head = view->horizontalHeader();
  head->setDefaultAlignment(Qt::AlignCenter);
  head->setMinimumHeight(4 * theme::kGrid);
  keepFitted(*view, [view, &model] {
    const QFontMetrics metrics(theme::smallFont());
    for (int column = 0; column < model.columnCount(); ++column) {
      const QString title = model.headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
      const int width = std::max(metrics.horizontalAdvance(title) + theme::kGrid, appearance::scaled(kStepWidth));
      view->setColumnWidth(column, ParticipantTable::stepOf(column) ? width : width + 2 * theme::kGrid);
    }
    // The longest words that stand there.
    const int next = QFontMetrics(theme::headingFont()).horizontalAdvance(stepName(CollectStep::kDeviceCheck));
    view->setColumnWidth(ParticipantTable::kNext, next + 3 * theme::kGrid);
  });
  head->setSectionResizeMode(ParticipantTable::kCode, QHeaderView::Stretch);
  head->setMinimumSectionSize(6 * theme::kGrid);
  return view;
}

}  // namespace

StudyHome::StudyHome(CollectController& collect, QWidget* parent)
    : QWidget(parent),
      collect_(collect),
      table_(new ParticipantTable(collect, this)),
      name_(new ElidedLabel(this)),
      summary_(new QLabel(this)),
      data_(new NotesButton(this)),
      protocol_(new QPushButton(tr("Open the &protocol…"), this)),
      add_(new QPushButton(tr("&Add participant"), this)),
      usability_(new QPushButton(tr("Fill in the &usability form"), this)),
      start_(new PrimaryButton(tr("S&tart a session"), this)),
      hint_(new Card(this)),
      hint_text_(new QLabel(hint_)),
      hint_act_(new QPushButton(hint_)),
      pages_(new QStackedWidget(this)),
      view_(makeTable(*table_, this)),
      chosen_(new QLabel(this)),
      record_(new QPushButton(tr("Show the &record…"), this)),
      withdraw_(new QPushButton(tr("&Withdraw…"), this)) {
  auto* hint = new QHBoxLayout(hint_);
  hint->setContentsMargins(2 * theme::kGrid, theme::kGrid, theme::kGrid, theme::kGrid);
  hint->setSpacing(2 * theme::kGrid);
  hint_text_->setWordWrap(true);
  hint_text_->setTextFormat(Qt::PlainText);
  hint->addWidget(hint_text_, 1);
  hint->addWidget(hint_act_);

  auto* list = new Card(this);
  auto* inside = new QVBoxLayout(list);
  inside->setContentsMargins(1, theme::kGrid / 2, 1, 1);
  inside->setSpacing(0);
  inside->addWidget(view_, 1);
  inside->addWidget(makeFoot());
  pages_->addWidget(list);
  pages_->addWidget(makeInvitation());

  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(theme::kGrid, theme::kGrid, theme::kGrid, theme::kGrid);
  layout->setSpacing(theme::kGrid + 4);
  layout->addWidget(makeHead());
  layout->addWidget(hint_);
  layout->addWidget(pages_, 1);
  connectAll();
  refreshState();
}

QWidget* StudyHome::makeHead() {
  name_->setFont(theme::titleFont());
  setInk(*summary_, theme::mutedInk());
  summary_->setTextFormat(Qt::PlainText);
  auto* titles = new QVBoxLayout;
  titles->setSpacing(2);
  titles->addWidget(name_);
  auto* second = new QHBoxLayout;
  second->setSpacing(theme::kGrid);
  second->addWidget(summary_);
  second->addWidget(data_);
  second->addStretch(1);
  titles->addLayout(second);
  for (QPushButton* button : {protocol_, usability_, add_})
    button->setMinimumSize(button->sizeHint().width() + 2 * theme::kGrid, 4 * theme::kGrid);
  return new FoldingRow(titles, makeRow({spring(1), protocol_, usability_, add_, start_}), this);
}

// Nothing is empty without saying what to do.
QWidget* StudyHome::makeInvitation() {
  auto* page = new Card(this);
  auto* box = new QWidget(page);
  box->setFixedWidth(kInvitationWidth);
  auto* title = new QLabel(tr("No participants yet"), box);
  title->setFont(theme::titleFont());
  title->setAlignment(Qt::AlignHCenter);
  auto* text = new QLabel(tr("Set the protocol first: forces, questions, languages and the consent text. Then add "
                             "participants, or start a session: who is new gets a code of two words on the screen."),
                          box);
  text->setWordWrap(true);
  text->setAlignment(Qt::AlignHCenter);
  setInk(*text, theme::mutedInk());
  auto* protocol = new QPushButton(tr("Set the protocol…"), box);
  connect(&collect_, &CollectController::changed, protocol,
          [protocol, &study = collect_.study()] { protocol->setEnabled(!study.isReadOnly()); });
  auto* add = new QPushButton(tr("Add the first participant"), box);
  auto* fill = new QPushButton(tr("Fill with simulated nurses…"), box);
  connect(fill, &QPushButton::clicked, this, &StudyHome::fillAsked);
  connect(protocol, &QPushButton::clicked, this, &StudyHome::protocolAsked);
  connect(add, &QPushButton::clicked, &collect_, &CollectController::addParticipant);
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(theme::kGrid);
  buttons->addStretch(1);
  for (QPushButton* button : {protocol, add}) {
    button->setMinimumSize(button->sizeHint().width() + 3 * theme::kGrid, 5 * theme::kGrid);
    buttons->addWidget(button);
  }
  buttons->addStretch(1);
  auto* column = new QVBoxLayout(box);
  column->setSpacing(2 * theme::kGrid);
  column->addWidget(title);
  column->addWidget(text);
  column->addLayout(buttons);
  column->addWidget(fill, 0, Qt::AlignHCenter);
  auto* layout = new QVBoxLayout(page);
  layout->addWidget(box, 0, Qt::AlignCenter);
  return page;
}

QWidget* StudyHome::makeFoot() {
  auto* foot = new QWidget(this);
  chosen_->setTextFormat(Qt::PlainText);
  setInk(*chosen_, theme::mutedInk());
  auto* row = new QHBoxLayout(foot);
  row->setContentsMargins(2 * theme::kGrid, theme::kGrid, theme::kGrid, theme::kGrid);
  row->setSpacing(theme::kGrid);
  row->addWidget(chosen_, 1);
  for (QPushButton* button : {record_, withdraw_}) {
    button->setMinimumSize(button->sizeHint().width() + 2 * theme::kGrid, 4 * theme::kGrid);
    QSizePolicy kept = button->sizePolicy();
    kept.setRetainSizeWhenHidden(true);
    button->setSizePolicy(kept);
    row->addWidget(button);
  }
  return foot;
}

void StudyHome::connectAll() {
  connect(&collect_, &CollectController::changed, this, &StudyHome::refreshState);
  connect(&collect_, &CollectController::added, this, &StudyHome::showAdded);
  connect(protocol_, &QPushButton::clicked, this, &StudyHome::protocolAsked);
  connect(add_, &QPushButton::clicked, &collect_, &CollectController::addParticipant);
  connect(usability_, &QPushButton::clicked, this, &StudyHome::usabilityAsked);
  const auto start = [this] {
    const auto person = selected();
    const ParticipantRow* const row = person ? collect_.row(*person) : nullptr;
    emit startAsked(row == nullptr || row->simulated ? QString() : row->code);
  };
  connect(start_, &QPushButton::clicked, this, start);
  const auto record = [this] {
    if (const auto person = selected()) emit recordAsked(*person);
  };
  connect(view_, &QTableView::activated, this, record);
  connect(record_, &QPushButton::clicked, this, record);
  connect(withdraw_, &QPushButton::clicked, this, [this] {
    if (const auto person = selected()) emit withdrawAsked(*person);
  });
  connect(view_->selectionModel(), &QItemSelectionModel::selectionChanged, this, &StudyHome::showSelection);
  connect(hint_act_, &QPushButton::clicked, this, [this] {
    const StudyOverview& overview = collect_.overview();
    if (std::exchange(newest_, std::nullopt)) {
      showHints();
    } else if (overview.protocol.version == 0) {
      emit protocolAsked();
    } else if (!overview.has_key) {
      emit keyAsked();
    } else {
      wantsSetup() ? emit setupAsked() : emit answersAsked();
    }
  });
}

void StudyHome::showData(const BuildNotes& notes) {
  data_->setNotes(tr("Look at the data first: %1").arg(notes.data.size()), {dataGroup(notes)}, true);
}

std::optional<study::RecordId> StudyHome::selected() const {
  const QModelIndexList rows = view_->selectionModel()->selectedRows();
  if (rows.isEmpty()) return std::nullopt;
  return table_->row(rows.first().row()).person;
}

void StudyHome::select(const study::RecordId& person) {
  const int row = table_->rowOf(person);
  if (row < 0) return;
  view_->selectRow(row);
  view_->scrollTo(table_->index(row, 0));
}

void StudyHome::refreshState() {
  const StudyOverview& overview = collect_.overview();
  const auto count = static_cast<int>(overview.rows.size());
  name_->setFullText(collect_.study().fileName());
  const QString protocol = overview.protocol.version == 0 ? tr("no protocol yet")
                           : overview.protocol.locked
                               ? tr("protocol version %1").arg(overview.protocol.version)
                               : tr("protocol version %1, a draft").arg(overview.protocol.version);
  QString setup;
  if (const auto* checked = collect_.setup()) {
    setup = QStringLiteral(" · ") + (checked->isGood() ? tr("set-up checked %1") : tr("set-up not good %1"))
                                        .arg(lastSeenText(checked->utc_ms, utcNowMs()));
  }
  summary_->setText(tr("%n participant(s)", nullptr, count) + QStringLiteral(" · ") + protocol + setup);
  pages_->setCurrentIndex(count > 0 ? 0 : 1);
  const StudyConnection& study = collect_.study();
  protocol_->setEnabled(study.isOpen() && !collect_.isSessionRunning());
  const QString locked = study.isReadOnly()
                             ? tr("The study is open for reading only, because %1.").arg(study.readOnlyReason())
                             : QString();
  for (QPushButton* button : {usability_, add_, static_cast<QPushButton*>(start_)}) {
    button->setEnabled(study.takesOrders() && !collect_.isSessionRunning());
  }
  for (QPushButton* button : {add_, static_cast<QPushButton*>(start_), withdraw_}) button->setToolTip(locked);
  usability_->setToolTip(
      !locked.isEmpty() ? locked
                        : tr("Ask a clinical teacher who tried the model six questions, with a code of their own"));
  if (newest_ && collect_.row(*newest_) != nullptr && selected() != newest_) select(*newest_);
  showSelection();
  showHints();
}

void StudyHome::showSelection() {
  const auto person = selected();
  const ParticipantRow* const row = person ? collect_.row(*person) : nullptr;
  const bool real = row != nullptr && !row->simulated;
  start_->setText(!real                   ? tr("S&tart a session")
                  : row->last_seen_ms > 0 ? tr("Con&tinue with %1").arg(harmless(row->code))
                                          : tr("S&tart with %1").arg(harmless(row->code)));
  start_->updateGeometry();
  withdraw_->setEnabled(row != nullptr && collect_.study().takesOrders() && !collect_.isWithdrawing() &&
                        !collect_.isSessionRunning());
  withdraw_->setVisible(row != nullptr);
  record_->setVisible(row != nullptr);
  if (row == nullptr) {
    chosen_->setText(tr("Choose a participant to continue, or start a session for a new one."));
  } else if (!row->trouble.isEmpty()) {
    chosen_->setText(harmless(row->trouble));
  } else if (row->simulated) {
    chosen_->setText(tr("%1 is simulated: a program gave all of these answers.").arg(harmless(row->code)));
  } else if (row->virtual_device) {
    chosen_->setText(
        tr("%1 moved a device that gives no force: what was judged there does not count. Start again with a "
           "device.")
            .arg(harmless(row->code)));
  } else if (row->setup_unchecked) {
    chosen_->setText(tr("%1: the set-up was not checked before the session. The data count, and are marked.")
                         .arg(harmless(row->code)));
  } else if (row->next) {
    chosen_->setText(tr("%1: the next step is %2.").arg(harmless(row->code), nextText(*row)));
  } else {
    chosen_->setText(tr("%1: everything is done.").arg(harmless(row->code)));
  }
}

// Real persons are about to be asked, and nobody has checked what they will feel.
bool StudyHome::wantsSetup() const {
  const auto& rows = collect_.overview().rows;
  const bool real = std::any_of(rows.begin(), rows.end(), [](const auto& row) { return !row.simulated; });
  const bool checked = collect_.setup() != nullptr && collect_.setup()->isGood();
  return real && !checked && !collect_.study().isReadOnly();
}

void StudyHome::showHints() {
  const StudyOverview& overview = collect_.overview();
  if (newest_ && collect_.row(*newest_) != nullptr) {
    hint_->setColors(theme::card(), theme::accent());
    setInk(*hint_text_, theme::ink());
    hint_text_->setText(tr("The new participant has the code %1. Write it down and hand it over: it is the only way "
                           "back to the answers.")
                            .arg(harmless(collect_.row(*newest_)->code)));
    hint_act_->setText(tr("Done"));
    hint_->show();
    return;
  }
  const bool without_protocol = overview.protocol.version == 0;
  const bool open = collect_.study().isOpen() && !overview.rows.empty();
  // What cannot be changed is no next step.
  const bool warns = open && !collect_.study().isReadOnly() && (without_protocol || !overview.has_key);
  const bool asks = open && wantsSetup();
  const bool leads_on = open && std::all_of(overview.rows.begin(), overview.rows.end(),
                                            [](const auto& row) { return !row.next && row.trouble.isEmpty(); });
  hint_->setVisible(warns || asks || leads_on);
  if (!hint_->isVisibleTo(this)) return;
  if (!warns) {
    hint_->setColors(theme::card(), theme::accent());
    setInk(*hint_text_, theme::ink());
    hint_text_->setText(asks ? tr("The set-up is not checked: device, force, latency, screens, sound, texts, disk. It "
                                  "takes 90 seconds; sessions without it are marked.")
                             : tr("Everybody has done everything. Look at what they said, then build the model."));
    hint_act_->setText(asks ? tr("Check the set-up…") : tr("Look at the answers"));
    return;
  }
  hint_->setColors(theme::warningFill(), theme::warningFill());
  setInk(*hint_text_, theme::warningInk());
  hint_text_->setText(without_protocol
                          ? tr("No protocol is set. Before a person takes part, it must say whose study it is and whom "
                               "to ask.")
                          : tr("No research key is set. Anybody can leave the participant's screens and read the "
                               "answers of the others."));
  hint_act_->setText(without_protocol ? tr("Set the protocol…") : tr("Set a key…"));
}

void StudyHome::showAdded(const study::RecordId& person, const QString& /*code*/) {
  newest_ = person;
  refreshState();
}

}  // namespace tactus::workbench
