#include "app/workbench/collect/protocol_field.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QSignalBlocker>
#include <QToolButton>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/collect/protocol_controller.h"

namespace tactus::workbench {
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
  connect(&protocol_, &ProtocolController::changed, this, &ProtocolField::follow);
  follow();
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
    case Kind::kText:
      break;
  }
  auto* box = new QLineEdit(this);
  connect(box, &QLineEdit::textEdited, this, set);
  return box;
}

QString ProtocolField::trouble() const {
  const auto& problem = protocol_.problem();
  return problem && problem->field == spec_.name ? problem->sentence : QString();
}

// What is typed stays as it is typed, also where it is refused.
void ProtocolField::follow() {
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
