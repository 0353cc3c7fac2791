// The sections of the protocol's page.
#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/collect/part_list.h"
#include "app/workbench/collect/protocol_controller.h"
#include "app/workbench/collect/protocol_field.h"
#include "app/workbench/collect/protocol_view.h"
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
                      tr("With commas between them. They are felt, not judged."),
                      {}});
  putField(*section, flag("force.ascending", tr("Ascending series"), tr("Ends at “beyond what I meet in practice”.")));
  putField(*section, flag("force.descending", tr("Descending series"), tr("From where the ascending one ended.")));
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
  putField(*section, {"item_order",
                      tr("Order of the questions"),
                      Kind::kWord,
                      {},
                      {},
                      {{QStringLiteral("fixed"), tr("as in the form")},
                       {QStringLiteral("shuffled"), tr("drawn for each participant")}}});
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
    connect(field, &QLineEdit::textChanged, this, &ProtocolView::follow);
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

}  // namespace tactus::workbench
