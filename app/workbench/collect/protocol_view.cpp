#include "app/workbench/collect/protocol_view.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/collect/protocol_controller.h"
#include "app/workbench/collect/protocol_field.h"
#include "app/workbench/kit/cards.h"
#include "app/workbench/kit/buttons.h"

namespace tactus::workbench {
namespace {

constexpr int kIndexWidth = 22 * theme::kGrid;  // px
constexpr int kPageWidth = 112 * theme::kGrid;

}  // namespace

ProtocolView::ProtocolView(ProtocolController& protocol, std::function<QString()> author, QWidget* parent)
    : QWidget(parent),
      protocol_(protocol),
      author_(std::move(author)),
      state_(new QLabel(this)),
      index_(new QListWidget(this)),
      scroll_(new QScrollArea(this)),
      column_(nullptr),
      foot_(new QLabel(this)),
      reason_(new QLineEdit(this)),
      discard_(new QPushButton(tr("&Discard the changes"), this)),
      store_(new PrimaryButton(tr("&Store"), this)) {
  index_->setFixedWidth(kIndexWidth);
  index_->setFrameShape(QFrame::NoFrame);
  index_->setAccessibleName(tr("Sections of the protocol"));
  index_->viewport()->setAutoFillBackground(false);
  index_->setSpacing(2);

  auto* page = new QWidget(scroll_);
  column_ = new QVBoxLayout(page);
  column_->setContentsMargins(0, 0, theme::kGrid, 0);
  column_->setSpacing(2 * theme::kGrid);
  scroll_->setMaximumWidth(kPageWidth);
  scroll_->setWidget(page);
  scroll_->setWidgetResizable(true);
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll_->viewport()->setAutoFillBackground(false);
  page->setAutoFillBackground(false);
  addParts();
  addSpeed();
  addForces();
  addQuestions();
  addLanguages();
  addDevice();
  addKey();
  column_->addStretch(1);

  auto* middle = new QHBoxLayout;
  middle->setSpacing(2 * theme::kGrid);
  middle->addWidget(index_);
  middle->addWidget(scroll_, 1);
  middle->addStretch(0);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(theme::kGrid, theme::kGrid, theme::kGrid, theme::kGrid);
  layout->setSpacing(theme::kGrid + 4);
  layout->addWidget(makeHead());
  layout->addLayout(middle, 1);
  layout->addWidget(makeFoot());

  connect(index_, &QListWidget::currentRowChanged, this, &ProtocolView::showSection);
  connect(&protocol_, &ProtocolController::changed, this, &ProtocolView::follow);
  follow();
}

QWidget* ProtocolView::makeHead() {
  auto* head = new QWidget(this);
  auto* back = new QPushButton(tr("‹ &Participants"), head);
  back->setMinimumSize(back->sizeHint().width() + theme::kGrid, 4 * theme::kGrid);
  auto* title = new QLabel(tr("Protocol of the study"), head);
  title->setFont(theme::titleFont());
  setInk(*state_, theme::mutedInk());
  auto* row = new QHBoxLayout(head);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(2 * theme::kGrid);
  row->addWidget(back);
  row->addWidget(title);
  row->addWidget(state_, 1);
  connect(back, &QPushButton::clicked, this, &ProtocolView::leave);
  return head;
}

QWidget* ProtocolView::makeFoot() {
  auto* foot = new Card(this);
  foot_->setTextFormat(Qt::PlainText);
  foot_->setWordWrap(true);
  reason_->setPlaceholderText(tr("Why does it change?"));
  reason_->setAccessibleName(tr("Reason of the change"));
  reason_->setMinimumHeight(4 * theme::kGrid);
  discard_->setMinimumSize(discard_->sizeHint().width() + 2 * theme::kGrid, 4 * theme::kGrid);
  auto* row = new QHBoxLayout(foot);
  row->setContentsMargins(2 * theme::kGrid, theme::kGrid, theme::kGrid, theme::kGrid);
  row->setSpacing(theme::kGrid);
  row->addWidget(foot_, 3);
  row->addWidget(reason_, 2);
  row->addWidget(discard_);
  row->addWidget(store_);
  connect(reason_, &QLineEdit::textChanged, this, &ProtocolView::followFoot);
  connect(discard_, &QPushButton::clicked, &protocol_, &ProtocolController::discard);
  connect(store_, &QPushButton::clicked, this, &ProtocolView::store);
  connect(&protocol_, &ProtocolController::stored, reason_, &QLineEdit::clear);
  return foot;
}

QVBoxLayout* ProtocolView::addSection(const QString& title, const QString& note) {
  auto* card = new Card(this);
  auto* heading = new QLabel(title, card);
  heading->setFont(theme::titleFont());
  auto* section = new QVBoxLayout(card);
  section->setContentsMargins(3 * theme::kGrid, 2 * theme::kGrid, 2 * theme::kGrid, 3 * theme::kGrid);
  section->setSpacing(theme::kGrid + 4);
  section->addWidget(heading);
  if (!note.isEmpty()) {
    auto* text = new QLabel(note, card);
    text->setWordWrap(true);
    setInk(*text, theme::mutedInk());
    section->addWidget(text);
  }
  column_->addWidget(card);
  sections_ << card;
  auto* item = new QListWidgetItem(title, index_);
  item->setSizeHint(QSize(0, 4 * theme::kGrid));
  return section;
}

void ProtocolView::putField(QVBoxLayout& section, ProtocolFieldSpec spec) {
  section.addWidget(new ProtocolField(protocol_, std::move(spec), sections_.last()));
}

void ProtocolView::showSection(int index) {
  if (index < 0 || index >= sections_.size()) return;
  const QSignalBlocker quiet(index_);
  index_->setCurrentRow(index);
  scroll_->verticalScrollBar()->setValue(sections_[index]->y());
}

void ProtocolView::showKey() { showSection(static_cast<int>(sections_.size()) - 1); }

void ProtocolView::store() { protocol_.store(reason_->text(), author_()); }

void ProtocolView::follow() {
  followLists();
  followForces();
  followFoot();
  state_->setText(protocol_.version() == 0 ? tr("none is stored yet")
                  : protocol_.isLocked()   ? tr("version %1, which participants follow").arg(protocol_.version())
                                           : tr("version %1, a draft").arg(protocol_.version()));
}

void ProtocolView::followFoot() {
  const bool amends = protocol_.isLocked() && protocol_.isDirty();
  const auto& problem = protocol_.problem();
  const bool reasoned = !amends || !reason_->text().trimmed().isEmpty();
  reason_->setVisible(amends);
  discard_->setVisible(protocol_.changes() > 0 || (problem && protocol_.version() > 0));
  discard_->setEnabled(!protocol_.isStoring());
  store_->setEnabled(protocol_.mayStore() && protocol_.isDirty() && !problem && reasoned && !protocol_.isStoring());
  store_->setText(amends ? tr("&Store version %1").arg(protocol_.version() + 1) : tr("&Store"));
  setInk(*foot_, problem ? theme::errorInk() : theme::ink());
  if (problem) {
    foot_->setText(problem->field.empty()
                       ? harmless(problem->sentence)
                       : tr("One setting has to be corrected first. %1").arg(harmless(problem->sentence)));
  } else if (protocol_.isStoring()) {
    foot_->setText(tr("Storing…"));
  } else if (amends) {
    foot_->setText(tr("Participants follow version %1. The change becomes version %2, for the sessions from now on.")
                       .arg(protocol_.version())
                       .arg(protocol_.version() + 1));
  } else if (protocol_.version() == 0) {
    foot_->setText(tr("Store the protocol before the first session. It stays a draft until a participant follows it."));
  } else if (protocol_.changes() > 0) {
    foot_->setText(tr("%n change(s) not stored.", nullptr, protocol_.changes()));
  } else {
    foot_->setText(protocol_.isLocked() ? tr("Everything is stored. A change would become a new version.")
                                        : tr("Everything is stored. The first session will lock it."));
  }
}

// Nothing that was typed is lost by accident.
void ProtocolView::leave() {
  if (protocol_.changes() > 0) {
    const auto answer =
        QMessageBox::question(this, tr("Changes not stored"),
                              tr("%n change(s) of the protocol are not stored.", nullptr, protocol_.changes()),
                              QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Cancel);
    if (answer != QMessageBox::Discard) return;
    protocol_.discard();
  }
  emit left();
}

}  // namespace tactus::workbench
