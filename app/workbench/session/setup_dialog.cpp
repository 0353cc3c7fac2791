// The dialog that checks the set-up.
#include <QApplication>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScreen>
#include <QVBoxLayout>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/kit/number_box.h"
#include "app/workbench/session/setup_check.h"
#include "app/workbench/session/take_part.h"

namespace tactus::workbench {
namespace {

using session::SetupItem;

constexpr int kWidth = 100 * theme::kGrid;  // px
constexpr int kMarkWidth = 9 * theme::kGrid;
constexpr int kNameWidth = 12 * theme::kGrid;

QString nameOf(SetupItem item) {
  switch (item) {
    case SetupItem::kDevice: return SetupDialog::tr("Device");
    case SetupItem::kForce: return SetupDialog::tr("Force");
    case SetupItem::kLatency: return SetupDialog::tr("Latency");
    case SetupItem::kScreens: return SetupDialog::tr("Screens");
    case SetupItem::kSound: return SetupDialog::tr("Sound");
    case SetupItem::kLanguage: return SetupDialog::tr("Languages");
    case SetupItem::kConsent: return SetupDialog::tr("Consent");
    case SetupItem::kDisk: return SetupDialog::tr("Disk");
  }
  return {};
}

// Never by color alone.
QString wordOf(SetupCheck::State state) {
  switch (state) {
    case SetupCheck::State::kOpen: return SetupDialog::tr("○ open");
    case SetupCheck::State::kRunning: return SetupDialog::tr("… checking");
    case SetupCheck::State::kGood: return SetupDialog::tr("✓ good");
    case SetupCheck::State::kBad: return SetupDialog::tr("✗ not good");
  }
  return {};
}

fuzzy::Variable grams() {
  fuzzy::Variable out;
  out.id = "scale";
  out.unit = "g";
  out.max = 500;
  return out;
}

std::vector<QSize> screensOf(const QWidget& researcher) {
  const QScreen& nurse = screenForParticipant(*researcher.screen());
  std::vector<QSize> out = {nurse.size()};
  for (const QScreen* one : QGuiApplication::screens()) {
    if (one != &nurse) out.push_back(one->size());
  }
  return out;
}

}  // namespace

SetupDialog::SetupDialog(StudyConnection& study, DeviceSession& device, QWidget* parent)
    : QDialog(parent),
      check_(
          study, device, [parent] { return screensOf(*parent); }, utcNowMs),
      instruction_(new QLabel(this)),
      directions_(new QWidget(this)),
      scale_acts_(new QWidget(this)),
      repeat_(new QPushButton(tr("&Repeat the self-test"), this)),
      push_(new QPushButton(tr("&Push with 0.5 N"), this)),
      scale_(new NumberBox(grams(), 1, this)),
      verdict_(new QLabel(this)),
      again_(new QPushButton(tr("Check everything &again"), this)),
      close_(new QPushButton(tr("&Close"), this)) {
  setWindowTitle(tr("Check the set-up"));
  setMinimumWidth(appearance::scaled(kWidth));
  build();
  connect(&check_, &SetupCheck::changed, this, &SetupDialog::showState);
  connect(&check_, &SetupCheck::done, this, &SetupDialog::certified);
  connect(&search_, &DeviceSearch::found, this, [this] { check_.begin(deviceToFeel(search_.list())); });
  look();
  showState();
}

void SetupDialog::look() { search_.search(); }

void SetupDialog::build() {
  auto* title = new QLabel(tr("Is everything ready for a session?"), this);
  title->setFont(theme::titleFont());
  auto* intro = new QLabel(this);
  intro->setText(
      tr("It takes about 90 seconds. The result is stored with each session of the next 12 hours on this "
         "device; sessions without it are marked."));
  setInk(*intro, theme::mutedInk());
  for (QLabel* label : {intro, instruction_, verdict_}) label->setWordWrap(true);

  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(theme::kGrid);
  grid->setVerticalSpacing(theme::kGrid / 2);
  grid->setColumnMinimumWidth(0, kMarkWidth);
  grid->setColumnMinimumWidth(1, kNameWidth);
  grid->setColumnStretch(2, 1);
  int at = 0;
  for (const SetupItem item : session::kSetupItems) {
    Line& line = lines_[static_cast<std::size_t>(item)];
    line = {new QLabel(this), new QLabel(this)};
    auto* name = new QLabel(nameOf(item), this);
    name->setFont(theme::headingFont());
    line.found->setTextFormat(Qt::PlainText);
    line.found->setWordWrap(true);
    grid->addWidget(line.mark, at, 0, Qt::AlignTop);
    grid->addWidget(name, at, 1, Qt::AlignTop);
    grid->addWidget(line.found, at++, 2, Qt::AlignTop);
    if (item == SetupItem::kForce) grid->addWidget(makeForceActs(), at++, 2);
    if (item == SetupItem::kSound) grid->addWidget(makeSoundActs(), at++, 2);
  }

  again_->setAutoDefault(false);
  close_->setDefault(true);
  connect(again_, &QPushButton::clicked, this, &SetupDialog::look);
  connect(close_, &QPushButton::clicked, this, &QDialog::accept);
  auto* foot = new QHBoxLayout;
  foot->setSpacing(theme::kGrid);
  foot->addWidget(verdict_, 1);
  for (QPushButton* button : {again_, close_}) {
    button->setMinimumSize(button->sizeHint().width() + 2 * theme::kGrid, 4 * theme::kGrid);
    foot->addWidget(button);
  }
  verdict_->setFont(theme::headingFont());

  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(3 * theme::kGrid, 2 * theme::kGrid, 3 * theme::kGrid, 2 * theme::kGrid);
  layout->setSpacing(theme::kGrid + 4);
  layout->addWidget(title);
  layout->addWidget(intro);
  layout->addLayout(grid);
  layout->addLayout(foot);
}

QWidget* SetupDialog::makeForceActs() {
  auto* box = new QWidget(this);
  auto* answers = new QHBoxLayout(directions_);
  answers->setContentsMargins(0, 0, 0, 0);
  answers->setSpacing(theme::kGrid);
  const std::pair<QString, devices::Felt> felt[] = {{tr("Toward me"), devices::Felt::kToward},
                                                    {tr("Away from me"), devices::Felt::kAway},
                                                    {tr("Nothing"), devices::Felt::kNothing}};
  for (const auto& [word, direction] : felt) {
    auto* button = new QPushButton(word, directions_);
    button->setAutoDefault(false);
    connect(button, &QPushButton::clicked, this, [this, direction = direction] { check_.feltDirection(direction); });
    answers->addWidget(button);
  }
  answers->addStretch(1);

  auto* scale_text = new QLabel(tr("Or by a kitchen scale: rest the handle on it, press its button and"), scale_acts_);
  auto* shows = new QLabel(tr("it shows"), scale_acts_);
  auto* unit = new QLabel(tr("g more"), scale_acts_);
  auto* take = new QPushButton(tr("&Take it"), scale_acts_);
  for (QPushButton* button : {repeat_, push_, take}) button->setAutoDefault(false);
  scale_->setAccessibleName(tr("What the scale shows more, g"));
  connect(repeat_, &QPushButton::clicked, &check_, &SetupCheck::repeatForce);
  connect(push_, &QPushButton::clicked, &check_, &SetupCheck::pushOnScale);
  connect(take, &QPushButton::clicked, this, [this] {
    if (scale_->commit()) check_.scaleShowed(scale_->exact());
  });
  auto* row = new QHBoxLayout;
  row->setSpacing(theme::kGrid);
  for (QWidget* one : {static_cast<QWidget*>(push_), static_cast<QWidget*>(shows), static_cast<QWidget*>(scale_),
                       static_cast<QWidget*>(unit), static_cast<QWidget*>(take), static_cast<QWidget*>(repeat_)}) {
    row->addWidget(one);
  }
  row->addStretch(1);
  auto* scale = new QVBoxLayout(scale_acts_);
  scale->setContentsMargins(0, 0, 0, 0);
  scale->setSpacing(theme::kGrid / 2);
  setInk(*scale_text, theme::mutedInk());
  scale->addWidget(scale_text);
  scale->addLayout(row);

  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, theme::kGrid / 2);
  column->setSpacing(theme::kGrid / 2);
  instruction_->setFont(theme::headingFont());
  column->addWidget(instruction_);
  column->addWidget(directions_);
  column->addWidget(scale_acts_);
  return box;
}

QWidget* SetupDialog::makeSoundActs() {
  auto* box = new QWidget(this);
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 0, theme::kGrid / 2);
  row->setSpacing(theme::kGrid);
  auto* play = new QPushButton(tr("Play the &tone of a call"), box);
  auto* heard = new QPushButton(tr("I &heard it"), box);
  auto* silent = new QPushButton(tr("I did &not hear it"), box);
  connect(play, &QPushButton::clicked, this, [] { QApplication::beep(); });
  connect(heard, &QPushButton::clicked, this, [this] { check_.heard(true); });
  connect(silent, &QPushButton::clicked, this, [this] { check_.heard(false); });
  for (QPushButton* button : {play, heard, silent}) {
    button->setAutoDefault(false);
    row->addWidget(button);
  }
  row->addStretch(1);
  return box;
}

void SetupDialog::showState() {
  int good = 0;
  for (const SetupItem item : session::kSetupItems) {
    const SetupCheck::Row& row = check_.row(item);
    const Line& line = lines_[static_cast<std::size_t>(item)];
    if (row.state == SetupCheck::State::kGood) ++good;
    line.mark->setText(wordOf(row.state));
    line.found->setText(harmless(row.found));
    setInk(*line.mark, row.state == SetupCheck::State::kBad ? theme::errorInk() : theme::ink());
  }
  instruction_->setText(check_.instruction());
  instruction_->setVisible(!check_.instruction().isEmpty());
  directions_->setVisible(check_.asksDirection());
  scale_acts_->setVisible(check_.mayPush());
  const int all = static_cast<int>(session::kSetupItems.size());
  verdict_->setText(!check_.isDone() ? tr("%1 of %2 good so far.").arg(good).arg(all)
                    : good == all ? tr("All good: sessions of the next 12 hours on this device are marked as checked.")
                                  : tr("%1 of %2 good: sessions are marked as not checked.").arg(good).arg(all));
}

}  // namespace tactus::workbench
