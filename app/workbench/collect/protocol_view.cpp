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
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/session/study_protocol.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/collect/protocol_controller.h"
#include "app/workbench/kit/buttons.h"
#include "app/workbench/kit/cards.h"
#include "core/haptics/safety/limit_settings.h"
#include "core/haptics/safety/thermal_budget.h"

namespace tactus::workbench {
namespace {

using Kind = ProtocolFieldSpec::Kind;

constexpr auto kLanguages = "languages";
constexpr int kKeyLetters = 6;  // core/store/research_key.h

QStringList listOf(const QString& value) { return value.split(QLatin1Char(','), Qt::SkipEmptyParts); }

// Those of the participants' screens.
QStringList knownLanguages() { return {QStringLiteral("en"), QStringLiteral("zh-Hant"), QStringLiteral("zh-Hans")}; }

ProtocolFieldSpec number(const char* name, const QString& label, const QString& unit = {}, const QString& help = {}) {
  return {name, label, Kind::kNumber, unit, help, {}};
}

ProtocolFieldSpec flag(const char* name, const QString& label, const QString& help = {}) {
  return {name, label, Kind::kFlag, {}, help, {}};
}

}  // namespace

void ProtocolView::addParts() {
  QVBoxLayout* const section =
      addSection(tr("Parts"), tr("What a session consists of, in this order. The practice before each part is not "
                                 "counted."));
  auto* const presets = new QHBoxLayout;
  presets->setSpacing(theme::kGrid);
  presets->addWidget(new QLabel(tr("To begin with"), sections_.last()));
  const auto add_preset = [&](const char* id, const QString& name, const QString& tip) {
    auto* const button = new QPushButton(name, sections_.last());
    button->setToolTip(tip);
    connect(button, &QPushButton::clicked, this, [this, preset = std::string(id)] { protocol_.usePreset(preset); });
    presets->addWidget(button);
  };
  add_preset("published", tr("Set as published"),
             tr("Set what the paper did: one ascending series, questions in the form's order"));
  add_preset("recommended", tr("Set as recommended"),
             tr("Set what we recommend: forces rise and fall, with catch trials and a rest after ten; speeds by Latin "
                "square, questions drawn within blocks"));
  add_preset("short", tr("Set for 20 minutes"), tr("Set a session for a trial or a busy ward"));
  presets->addStretch(1);
  section->addLayout(presets);
  load_ = new QLabel(sections_.last());
  load_->setWordWrap(true);
  load_->setTextFormat(Qt::PlainText);
  setInk(*load_, theme::mutedInk());
  section->addWidget(load_);
  section->addWidget(new PartList(protocol_, sections_.last()));
}

void ProtocolView::addSpeed() {
  QVBoxLayout* const section = addSection(tr("Speed"));
  putField(*section, number("speed.strokes", tr("Insertions at each speed"), {}, tr("Slow, medium and fast each.")));
  putField(*section, number("speed.practice", tr("Practice before them")));
  putField(*section, {"speed.order",
                      tr("Order of the speeds"),
                      Kind::kWord,
                      {},
                      {},
                      {{QStringLiteral("as_given"), tr("slow, medium, fast")},
                       {QStringLiteral("latin_square"), tr("in turn, by Latin square")},
                       {QStringLiteral("shuffled"), tr("drawn for each participant")}}});
}

void ProtocolView::addForces() {
  const QString newton = QStringLiteral("N");
  QVBoxLayout* const section =
      addSection(tr("Forces"), tr("The ascending series of the published experiment, and two additions against its "
                                  "errors of habituation and expectation."));
  putField(*section, number("force.ladder.lowest_n", tr("Lowest force"), newton));
  putField(*section, number("force.ladder.highest_n", tr("Highest force"), newton));
  putField(*section, number("force.ladder.step_n", tr("Step"), newton));
  ladder_ = new QLabel(sections_.last());
  ladder_->setWordWrap(true);
  ladder_->setTextFormat(Qt::PlainText);
  setInk(*ladder_, theme::mutedInk());
  section->addWidget(ladder_);
  putField(*section, {"force.familiarisation_n",
                      tr("Practice forces"),
                      Kind::kText,
                      newton,
                      tr("With commas between them. They are judged like the others and never counted."),
                      {}});
  putField(*section, flag("force.ascending", tr("Ascending series"), tr("Ends at “beyond what I meet in practice”.")));
  putField(*section, flag("force.descending", tr("Descending series"), tr("From where the ascending one ended.")));
  putField(*section,
           number("force.ladder_catches", tr("Catch trials in each series"), {},
                  tr("Half blanks, half hidden repeats; 0 to 4. They tell whether the words follow the hand.")));
  putField(*section, flag("force.random", tr("Random block"), tr("Forces in an order drawn for each participant.")));
  putField(*section, number("force.random_steps.lowest_n", tr("Random: lowest force"), newton));
  putField(*section, number("force.random_steps.highest_n", tr("Random: highest force"), newton));
  putField(*section, number("force.random_steps.step_n", tr("Random: step"), newton));
  putField(*section, number("force.random_repeats", tr("Random: times each")));
  putField(*section, number("force.catch_share", tr("Random: share of catch trials"), {},
                            tr("Blanks and hidden repeats: 0.1 to 0.15, or 0.")));
  putField(*section, number("force.pause_s", tr("Pause before each force"), QStringLiteral("s"),
                            tr("Longer where the device must rest.")));
  putField(*section, number("force.hold_limit_s", tr("Longest hold of a large force"), QStringLiteral("s")));
  putField(*section, number("force.rest_every", tr("A rest after every"), tr("forces"), tr("0: no rests.")));
  putField(*section, number("force.attempts_most", tr("Attempts at a force"), {},
                            tr("A judgement without movement, or of a force that was cut, is asked again so often.")));
}

void ProtocolView::addQuestions() {
  QVBoxLayout* const section = addSection(tr("Questions"));
  putField(*section,
           {"item_order",
            tr("Order of the questions"),
            Kind::kWord,
            {},
            tr("The last two follow from what each participant has answered so far. All questions are asked."),
            {{QStringLiteral("fixed"), tr("as in the form")},
             {QStringLiteral("within_blocks"), tr("drawn within each block of five")},
             {QStringLiteral("shuffled"), tr("drawn for each participant")},
             {QStringLiteral("least_known"), tr("next what is least known of the force")},
             {QStringLiteral("least_known_in_blocks"), tr("the same within each block")}}});
}

void ProtocolView::addLanguages() {
  QVBoxLayout* const section =
      addSection(tr("Languages and consent"),
                 tr("The consent screen makes general statements of the parts and the device above. Below them stands "
                    "this text: who runs the study, the approval of the ethics committee; then whom to ask."));
  putField(*section, {"contact",
                      tr("Whom a participant can ask"),
                      Kind::kText,
                      {},
                      tr("A name and a telephone number. Without it no session of a person begins."),
                      {}});
  putField(
      *section,
      {"consent_version", tr("Version of the consent text"), Kind::kText, {}, tr("Stored with each consent."), {}});
  for (const QString& language : knownLanguages()) {
    auto* box = new QCheckBox(tr("Offer %1").arg(languageName(language)), sections_.last());
    connect(box, &QCheckBox::clicked, this, [this, language](bool on) { offer(language, on); });
    languages_.insert(language, box);
    section->addWidget(box);
    const std::string name = "consent." + language.toStdString();
    auto* consent = new ProtocolField(
        protocol_, {name, tr("Consent text, %1").arg(languageName(language)), Kind::kLongText, {}, {}, {}},
        sections_.last());
    consents_.insert(language, consent);
    section->addWidget(consent);
    auto* statements = new ProtocolField(protocol_,
                                         {"statements." + language.toStdString(),
                                          tr("Instead of the general statements, %1").arg(languageName(language)),
                                          Kind::kLongText,
                                          {},
                                          tr("Empty: the general ones, which follow the parts and the device."),
                                          {}},
                                         sections_.last());
    statements_.insert(language, statements);
    section->addWidget(statements);
  }
}

void ProtocolView::addDevice() {
  const QString newton = QStringLiteral("N");
  QVBoxLayout* const section = addSection(
      tr("Device"), tr("The device that the forces are meant for. A force that it cannot hold is refused here."));
  putField(*section, {"device.name", tr("Name"), Kind::kText, {}, tr("Empty: any device."), {}});
  putField(*section, {"grip",
                      tr("How its button holds"),
                      Kind::kWord,
                      {},
                      tr("A switch that is squeezed all the time changes the feel. Stored with each session."),
                      {{QStringLiteral("held"), tr("while it is kept pressed")},
                       {QStringLiteral("latch"), tr("from one press to the next")}}});
  putField(*section, number("device.friction_n", tr("Its own friction"), newton,
                            tr("Measured against forward motion; added to the felt force. Empty: not measured.")));
  putField(*section, number("device.force_cap_n", tr("Largest force"), newton));
  putField(*section,
           number("device.continuous_force_n", tr("Largest continuous force"), newton, tr("0.88 N for a Touch.")));
}

void ProtocolView::addKey() {
  QVBoxLayout* const section =
      addSection(tr("Research key"), tr("The passphrase that leads from the participant's screens back to this window. "
                                        "It is stored as a hash and can be changed at any time."));
  key_state_ = new QLabel(sections_.last());
  key_ = new QLineEdit(sections_.last());
  key_again_ = new QLineEdit(sections_.last());
  key_trouble_ = new QLabel(sections_.last());
  set_key_ = new QPushButton(tr("Set the key"), sections_.last());
  remove_key_ = new QPushButton(tr("Remove it"), sections_.last());
  key_->setAccessibleName(tr("New research key"));
  key_again_->setAccessibleName(tr("The same key again"));
  key_->setPlaceholderText(tr("New key, at least %1 letters").arg(kKeyLetters));
  key_again_->setPlaceholderText(tr("Type it again"));
  setInk(*key_trouble_, theme::mutedInk());
  auto* row = new QHBoxLayout;
  row->setSpacing(theme::kGrid);
  for (QLineEdit* field : {key_, key_again_}) {
    field->setEchoMode(QLineEdit::Password);
    row->addWidget(field, 1);
    connect(field, &QLineEdit::textChanged, this, &ProtocolView::refreshState);
  }
  row->addWidget(set_key_);
  row->addWidget(remove_key_);
  section->addWidget(key_state_);
  section->addLayout(row);
  section->addWidget(key_trouble_);
  connect(set_key_, &QPushButton::clicked, this, [this] { protocol_.setKey(key_->text()); });
  connect(remove_key_, &QPushButton::clicked, this, [this] { protocol_.setKey({}); });
  connect(&protocol_, &ProtocolController::keyStored, this, [this] {
    key_->clear();
    key_again_->clear();
  });
}

// In the order of the participants' screens.
void ProtocolView::offer(const QString& language, bool in) {
  QStringList now = listOf(protocol_.value(kLanguages));
  if (in && !now.contains(language)) {
    now << language;
    std::sort(now.begin(), now.end(), [order = knownLanguages()](const QString& one, const QString& other) {
      return order.indexOf(one) < order.indexOf(other);
    });
  }
  if (!in) now.removeAll(language);
  protocol_.set(kLanguages, now.join(QLatin1Char(',')));
}

void ProtocolView::followLists() {
  const QStringList languages = listOf(protocol_.value(kLanguages));
  for (auto box = languages_.begin(); box != languages_.end(); ++box) {
    box.value()->setChecked(languages.contains(box.key()));
    consents_.value(box.key())->setVisible(languages.contains(box.key()));
    statements_.value(box.key())->setVisible(languages.contains(box.key()));
  }
  const bool enough = key_->text().toUtf8().size() >= kKeyLetters;
  const bool same = key_->text() == key_again_->text();
  key_state_->setText(protocol_.hasKey() ? tr("A key is set.") : tr("No key is set."));
  set_key_->setText(protocol_.hasKey() ? tr("Change the key") : tr("Set the key"));
  set_key_->setEnabled(protocol_.mayStore() && enough && same);
  remove_key_->setVisible(protocol_.hasKey());
  key_trouble_->setText(key_->text().isEmpty() ? QString()
                        : !enough              ? tr("At least %1 letters.").arg(kKeyLetters)
                        : !same                ? tr("The two are not the same yet.")
                                               : QString());
  key_trouble_->setVisible(!key_trouble_->text().isEmpty());
}

// What the series is, and the largest force that the device can hold so long.
void ProtocolView::followForces() {
  const session::StudyProtocol& draft = protocol_.draft();
  const experiments::ForceSettings& force = draft.settings.force;
  const bool bad = protocol_.problem() && protocol_.problem()->field.starts_with("force.ladder");
  const double largest_n = haptics::largestHoldN(force.ramp_s, force.hold_limit_s, draft.device.continuous_force_n,
                                                 haptics::LimitSettings().thermal_window_s);
  const QString holds = tr("The device can hold %1 N for %2 s.")
                            .arg(numberText(std::min(largest_n, draft.device.force_cap_n)))
                            .arg(numberText(force.hold_limit_s));
  ladder_->setText(bad ? holds
                       : tr("%n force(s), from %1 to %2 N.", nullptr, force.ladder.count())
                                 .arg(numberText(force.ladder.lowest_n))
                                 .arg(numberText(force.ladder.highest_n)) +
                             QLatin1Char(' ') + holds);
}

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
  connect(&protocol_, &ProtocolController::changed, this, &ProtocolView::refreshState);
  refreshState();
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

void ProtocolView::followLoad() {
  const session::ProtocolLoad load = session::loadOf(protocol_.draft());
  QString text = tr("About %1 minutes: %2 insertions, %3 judged forces, %4 questions.")
                     .arg(std::lround(load.minutes))
                     .arg(load.strokes)
                     .arg(load.judgements)
                     .arg(load.questions);
  if (load.heat_share > 0) {
    text += QLatin1Char(' ') +
            tr("The motors work at %1 % of what they can hold for long.").arg(std::lround(100 * load.heat_share));
    if (load.heat_share > 1) text += QLatin1Char(' ') + tr("The device will rest longer than the protocol asks.");
  }
  load_->setText(text);
}

void ProtocolView::refreshState() {
  followLists();
  followForces();
  followLoad();
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
  setInk(*foot_, problem && !protocol_.isNew() ? theme::errorInk() : theme::ink());
  if (problem && protocol_.isNew()) {
    foot_->setText(
        tr("Still needed before it can be stored: the consent text, which says whose study it is and whom to "
           "ask."));
  } else if (problem) {
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
