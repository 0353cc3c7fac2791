#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QSignalBlocker>
#include <QToolButton>
#include <algorithm>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/collect/protocol_controller.h"
#include "app/workbench/collect/protocol_view.h"

namespace tactus::workbench {
namespace {

constexpr auto kPartsValue = "blocks";
constexpr int kRankWidth = 3 * theme::kGrid;  // px

// Of the published experiment.
const QStringList& publishedOrder() {
  static const QStringList kOrder = {QStringLiteral("speed"), QStringLiteral("force"), QStringLiteral("form")};
  return kOrder;
}

QString partName(const QString& part) {
  const auto place = publishedOrder().indexOf(part);
  return place == 0   ? PartList::tr("Speed: insertions at a named speed")
         : place == 1 ? PartList::tr("Forces: a word for each force that is felt")
                      : PartList::tr("Questions: the force in each situation");
}

}  // namespace

PartList::PartList(ProtocolController& protocol, QWidget* parent) : QWidget(parent), protocol_(protocol) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(theme::kGrid);
  grid->setVerticalSpacing(theme::kGrid / 2);
  grid->setColumnMinimumWidth(0, kRankWidth);
  grid->setColumnStretch(4, 1);
  for (int i = 0; i < kParts; ++i) {
    Row& row = rows_[static_cast<std::size_t>(i)];
    row = {new QLabel(this), new QCheckBox(this), makeArrow(QStringLiteral("↑")), makeArrow(QStringLiteral("↓"))};
    setInk(*row.number, theme::mutedInk());
    grid->addWidget(row.number, i, 0);
    grid->addWidget(row.box, i, 1);
    grid->addWidget(row.earlier, i, 2);
    grid->addWidget(row.later, i, 3);
    connect(row.box, &QCheckBox::clicked, this, [this, i](bool on) { put(shown_[i], on); });
    connect(row.earlier, &QToolButton::clicked, this, [this, i] { move(i, -1); });
    connect(row.later, &QToolButton::clicked, this, [this, i] { move(i, 1); });
  }
  connect(&protocol_, &ProtocolController::changed, this, &PartList::refreshState);
  refreshState();
}

QToolButton* PartList::makeArrow(const QString& text) {
  auto* arrow = new QToolButton(this);
  arrow->setText(text);
  arrow->setFixedSize(4 * theme::kGrid, 4 * theme::kGrid);
  return arrow;
}

void PartList::refreshState() {
  in_ = protocol_.value(kPartsValue).split(QLatin1Char(','), Qt::SkipEmptyParts);
  shown_ = in_;
  for (const QString& part : publishedOrder()) {
    if (!shown_.contains(part)) shown_ << part;
  }
  for (int i = 0; i < kParts; ++i) {
    const Row& row = rows_[static_cast<std::size_t>(i)];
    const QString name = partName(shown_[i]);
    const bool in = i < in_.size();
    row.number->setText(in ? QString::number(i + 1) : QStringLiteral("–"));
    row.box->setText(name);
    row.box->setChecked(in);
    row.earlier->setEnabled(in && i > 0);
    row.later->setEnabled(in && i + 1 < in_.size());
    row.earlier->setAccessibleName(tr("Move earlier: %1").arg(name));
    row.later->setAccessibleName(tr("Move later: %1").arg(name));
    row.earlier->setToolTip(row.earlier->accessibleName());
    row.later->setToolTip(row.later->accessibleName());
  }
}

// A part comes in before those that follow it in the published order.
void PartList::put(const QString& part, bool in) {
  QStringList parts = in_;
  parts.removeAll(part);
  if (in) {
    const auto after = std::find_if(parts.begin(), parts.end(), [&](const QString& one) {
      return publishedOrder().indexOf(one) > publishedOrder().indexOf(part);
    });
    parts.insert(after, part);
  }
  protocol_.set(kPartsValue, parts.join(QLatin1Char(',')));
}

// The keyboard stays with the part.
void PartList::move(int row, int by) {
  QStringList parts = in_;
  parts.move(row, row + by);
  protocol_.set(kPartsValue, parts.join(QLatin1Char(',')));
  const Row& moved = rows_[static_cast<std::size_t>(row + by)];
  QToolButton* const same = by < 0 ? moved.earlier : moved.later;
  (same->isEnabled() ? static_cast<QWidget*>(same) : moved.box)->setFocus();
}

namespace {

using Kind = ProtocolFieldSpec::Kind;

constexpr int kLabelWidth = 24 * theme::kGrid;  // px
constexpr int kNumberWidth = 11 * theme::kGrid;
constexpr int kTextHeight = 16 * theme::kGrid;

// A decimal comma is one too, and the unit may be typed.
QString cleanNumber(QString typed, const QString& unit) {
  typed = typed.trimmed();
  if (!unit.isEmpty() && typed.endsWith(unit)) typed.chop(unit.size());
  return typed.trimmed().replace(QLatin1Char(','), QLatin1Char('.'));
}

}  // namespace

ProtocolField::ProtocolField(ProtocolController& protocol, ProtocolFieldSpec spec, QWidget* parent)
    : QWidget(parent),
      protocol_(protocol),
      spec_(std::move(spec)),
      input_(makeInput()),
      undo_(new QToolButton(this)),
      note_(new QLabel(this)) {
  auto* label = new QLabel(spec_.label, this);
  label->setBuddy(input_);
  label->setWordWrap(true);
  label->setMinimumHeight(3 * theme::kGrid + 4);
  input_->setAccessibleName(spec_.label);
  input_->setAccessibleDescription(spec_.help);
  undo_->setText(QStringLiteral("↺"));
  undo_->setAutoRaise(true);
  undo_->setAccessibleName(tr("Undo the change of %1").arg(spec_.label));
  QSizePolicy kept = undo_->sizePolicy();
  kept.setRetainSizeWhenHidden(true);
  undo_->setSizePolicy(kept);
  note_->setWordWrap(true);
  note_->setTextFormat(Qt::PlainText);
  note_->setFont(theme::smallFont());

  auto* row = new QHBoxLayout;
  row->setSpacing(theme::kGrid);
  row->addWidget(input_);
  if (!spec_.unit.isEmpty()) row->addWidget(new QLabel(spec_.unit, this));
  row->addWidget(undo_, 0, Qt::AlignTop);
  if (spec_.kind == Kind::kNumber || spec_.kind == Kind::kWord || spec_.kind == Kind::kFlag) row->addStretch(1);
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(2 * theme::kGrid);
  grid->setVerticalSpacing(2);
  grid->setColumnMinimumWidth(0, kLabelWidth);
  grid->setColumnStretch(1, 1);
  grid->addWidget(label, 0, 0, Qt::AlignTop);
  grid->addLayout(row, 0, 1);
  grid->addWidget(note_, 1, 1);
  label->setFixedWidth(kLabelWidth);

  connect(undo_, &QToolButton::clicked, this, [this] { protocol_.reset(spec_.name); });
  connect(&protocol_, &ProtocolController::changed, this, &ProtocolField::refreshState);
  refreshState();
}

QWidget* ProtocolField::makeInput() {
  const auto set = [this](const QString& value) { protocol_.set(spec_.name, value); };
  switch (spec_.kind) {
    case Kind::kFlag: {
      auto* box = new QCheckBox(this);
      connect(box, &QCheckBox::toggled, this,
              [set](bool on) { set(on ? QStringLiteral("true") : QStringLiteral("false")); });
      return box;
    }
    case Kind::kWord: {
      auto* box = new QComboBox(this);
      for (const ProtocolFieldSpec::Word& word : spec_.words) box->addItem(word.label, word.value);
      connect(box, &QComboBox::activated, this, [set, box](int index) { set(box->itemData(index).toString()); });
      return box;
    }
    case Kind::kLongText: {
      auto* box = new QPlainTextEdit(this);
      box->setTabChangesFocus(true);
      box->setMinimumHeight(kTextHeight);
      connect(box, &QPlainTextEdit::textChanged, this, [set, box] { set(box->toPlainText()); });
      return box;
    }
    case Kind::kNumber: {
      auto* box = new QLineEdit(this);
      box->setFixedWidth(kNumberWidth);
      connect(box, &QLineEdit::textEdited, this,
              [this, set](const QString& typed) { set(cleanNumber(typed, spec_.unit)); });
      return box;
    }
    case Kind::kText: break;
  }
  auto* box = new QLineEdit(this);
  connect(box, &QLineEdit::textEdited, this, set);
  return box;
}

QString ProtocolField::trouble() const {
  const auto& problem = protocol_.problem();
  return problem && !protocol_.isNew() && problem->field == spec_.name ? problem->sentence : QString();
}

// What is typed stays as it is typed, also where it is refused.
void ProtocolField::refreshState() {
  const QString value = protocol_.value(spec_.name);
  const QSignalBlocker quiet(input_);
  const bool refused = !trouble().isEmpty();
  if (auto* flag = qobject_cast<QCheckBox*>(input_)) {
    flag->setChecked(value == QLatin1String("true"));
  } else if (auto* words = qobject_cast<QComboBox*>(input_)) {
    words->setCurrentIndex(words->findData(value));
  } else if (auto* lines = qobject_cast<QPlainTextEdit*>(input_)) {
    if (lines->toPlainText() != value) lines->setPlainText(value);
  } else if (auto* line = qobject_cast<QLineEdit*>(input_)) {
    const bool typing = line->hasFocus() && line->isModified();
    if (!(typing && (refused || cleanNumber(line->text(), spec_.unit) == value)) && line->text() != value) {
      line->setText(value);
      line->setCursorPosition(0);
    }
  }
  const bool changed = protocol_.version() > 0 && (protocol_.isChanged(spec_.name) || refused);
  const QString before = protocol_.storedValue(spec_.name);
  undo_->setVisible(changed && !protocol_.isStoring());
  undo_->setToolTip(spec_.kind == Kind::kNumber && !before.isEmpty() ? tr("Set back to %1").arg(before)
                                                                     : tr("Undo this change"));
  note_->setText(refused ? harmless(trouble()) : spec_.help);
  setInk(*note_, refused ? theme::errorInk() : theme::mutedInk());
  note_->setVisible(!note_->text().isEmpty());
}

}  // namespace tactus::workbench
