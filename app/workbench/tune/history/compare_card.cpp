#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <algorithm>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/refresh.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/buttons.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/model/shown_impact.h"
#include "app/workbench/tune/history/compare_controller.h"
#include "app/workbench/tune/history/compare_strip.h"
#include "app/workbench/tune/history/history_panel.h"

namespace tactus::workbench {
namespace {

constexpr int kFewestLetters = 12;         // of a choice, where there is little room
constexpr std::size_t kMostChanges = 100;  // listed; the command line lists all

QComboBox* choiceBox(const QString& name, QWidget* parent) {
  auto* box = new QComboBox(parent);
  box->setAccessibleName(name);
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(kFewestLetters);
  box->setMaxVisibleItems(20);
  return box;
}

/// `+ rule of S4: …`, `− term …`, `term slow of speed: 0, 0, 40, 60 → 0, 0, 45, 60`: ids as words.
QString changeText(const analysis::ModelChange& change) {
  using Kind = analysis::ModelChange::Kind;
  const auto words = [](const std::string& ids) { return harmless(spelled(ids)).remove(QLatin1Char('\'')); };
  const QString place = words(change.place);
  const QString before = words(change.before);
  const QString after = words(change.after);
  switch (change.kind) {
    case Kind::kAdded: return QStringLiteral("+ %1: %2").arg(place, after);
    case Kind::kRemoved: return QStringLiteral("− %1: %2").arg(place, before);
    case Kind::kChanged: break;
  }
  return QStringLiteral("%1: %2 → %3").arg(place, before, after);
}

analysis::ModelChange reversed(analysis::ModelChange change) {
  using Kind = analysis::ModelChange::Kind;
  std::swap(change.before, change.after);
  if (change.kind != Kind::kChanged) change.kind = change.kind == Kind::kAdded ? Kind::kRemoved : Kind::kAdded;
  return change;
}

}  // namespace

CompareCard::CompareCard(CompareController& compare, SceneController& scene, QWidget* parent)
    : QWidget(parent),
      compare_(compare),
      scene_(scene),
      a_(choiceBox(tr("A: the reference version"), this)),
      b_(choiceBox(tr("B: the version to compare"), this)),
      result_(new QLabel(this)),
      help_(new StatisticHelp({Statistic::kNoticeable, Statistic::kRms}, this)),
      place_(new QLabel(this)),
      go_(new QPushButton(tr("Go there"), this)),
      blind_(new QPushButton(tr("Feel blind…"), this)),
      tell_(new QPushButton(tr("Find the stroke that tells…"), this)),
      changes_(new QLabel(this)),
      refresh_list_(new Refresh(this, [this] { list(); })),
      refresh_result_(new Refresh(this, [this] { showResult(); })) {
  auto* head = new QLabel(tr("Compare"), this);
  head->setFont(theme::headingFont());
  for (QLabel* label : {result_, place_, changes_}) {
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  }
  place_->setFont(theme::smallFont());
  changes_->setFont(theme::smallFont());
  changes_->setObjectName(QStringLiteral("compare_changes"));
  go_->setAccessibleName(go_->text());
  go_->setToolTip(tr("Move the operating point to the largest difference"));
  blind_->setToolTip(tr("Feel A and B on the device without knowing which is which"));
  tell_->setToolTip(tr("Search the insertion in which a hand feels the largest difference between A and B"));
  auto* layout = new QGridLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(theme::kGrid);
  layout->setColumnStretch(1, 1);
  layout->addWidget(head, 0, 0, 1, 2);
  layout->addWidget(new CompareSwitch(compare_, this), 0, 2, Qt::AlignRight);
  layout->addWidget(new QLabel(QStringLiteral("A"), this), 1, 0);
  layout->addWidget(a_, 1, 1, 1, 2);
  layout->addWidget(new QLabel(QStringLiteral("B"), this), 2, 0);
  layout->addWidget(b_, 2, 1, 1, 2);
  layout->addWidget(result_, 3, 0, 1, 2);
  layout->addWidget(help_, 3, 2, Qt::AlignRight | Qt::AlignTop);
  layout->addWidget(place_, 4, 0, 1, 3);
  layout->addLayout(makeRow({spring(1), blind_, go_}), 5, 0, 1, 3);
  layout->addLayout(makeRow({spring(1), tell_}), 6, 0, 1, 3);
  layout->addWidget(changes_, 7, 0, 1, 3);

  connect(a_, &QComboBox::activated, this, [this] { choose(*a_, CompareSide::kA); });
  connect(b_, &QComboBox::activated, this, [this] { choose(*b_, CompareSide::kB); });
  connect(go_, &QPushButton::clicked, this, &CompareCard::goThere);
  connect(blind_, &QPushButton::clicked, this, &CompareCard::feelBlindRequested);
  connect(tell_, &QPushButton::clicked, this, &CompareCard::tellRequested);
  connect(&compare_, &CompareController::choicesChanged, refresh_list_, &Refresh::request);
  connect(&compare_, &CompareController::choicesChanged, refresh_result_, &Refresh::request);
  connect(&compare_, &CompareController::resultChanged, refresh_result_, &Refresh::request);
  refresh_list_->request();
  refresh_result_->request();
}

void CompareCard::list() {
  fill(*a_, CompareSide::kA);
  fill(*b_, CompareSide::kB);
}

void CompareCard::fill(QComboBox& box, CompareSide side) {
  const QSignalBlocker quiet(box);
  box.clear();
  const auto options = compare_.options();
  int chosen = -1;
  for (const auto& option : options) {
    if (option.choice == compare_.choice(side)) chosen = box.count();
    box.addItem(option.name);
  }
  // The state before the first edit is not there yet.
  if (chosen < 0 && !options.empty()) {
    chosen = box.count();
    box.addItem(compare_.nameOf(compare_.choice(side)));
  }
  box.setCurrentIndex(chosen);
}

void CompareCard::choose(const QComboBox& box, CompareSide side) {
  const auto options = compare_.options();
  const auto index = static_cast<std::size_t>(box.currentIndex());
  if (index < options.size()) compare_.choose(side, options[index].choice);
}

void CompareCard::showResult() {
  compare_.compute();
  const auto& result = compare_.result();
  place_->setVisible(result && !result->at.empty());
  go_->setVisible(place_->isVisibleTo(this));
  blind_->setVisible(go_->isVisibleTo(this));
  tell_->setEnabled(result.has_value());
  showChanges();
  if (!result) {
    help_->hide();
    result_->setText(scene_.model() != nullptr ? tr("Comparing…") : QString());
    return;
  }
  const std::string& unit = scene_.model()->model.output.unit;
  QString sentence = tr("No difference of the force was found.");
  if (!result->at.empty()) {
    sentence = largestChangeText(result->largest_n, unit, Scope::kAnywhere);
    if (unit == "N") sentence += tr(" (%1 JND from A)").arg(numberText(result->noticeable, 1));
    sentence += tr(" · RMS %1").arg(forceText(result->rms_n, unit));
  }
  help_->setVisible(!result->at.empty());
  if (result->only_one > 0) sentence += QLatin1Char(' ') + tr("In places only one of the two has a force.");
  result_->setText(sentence);
  if (result->at.empty()) return;
  QStringList values;
  const auto& inputs = scene_.model()->model.inputs;
  for (std::size_t i = 0; i < inputs.size() && i < result->at.size(); ++i) {
    values << labelOf(inputs[i]) + QLatin1Char(' ') + quantityText(result->at[i], inputs[i].unit);
  }
  place_->setText(
      tr("A %1, B %2 at %3")
          .arg(forceText(result->a_n, unit), forceText(result->b_n, unit), values.join(QStringLiteral(", "))));
}

void CompareCard::showChanges() {
  const auto& result = compare_.result();
  changes_->setVisible(result.has_value());
  if (!result) return;
  // An arrow leads from what was to what is now.
  const bool back = compare_.choice(CompareSide::kA).kind == CompareChoice::Kind::kOpen;
  auto changes = result->changes;
  for (analysis::ModelChange& change : changes) {
    if (back) change = reversed(std::move(change));
  }
  QStringList lines;
  lines << (changes.empty()
                ? tr("No term, rule or setting differs.")
                : tr("%n term(s), rule(s) or setting(s) differ, %1 → %2:", nullptr, static_cast<int>(changes.size()))
                      .arg(back ? QStringLiteral("B") : QStringLiteral("A"),
                           back ? QStringLiteral("A") : QStringLiteral("B")));
  for (std::size_t i = 0; i < std::min(changes.size(), kMostChanges); ++i) lines << changeText(changes[i]);
  if (changes.size() > kMostChanges)
    lines << tr("and %n more", nullptr, static_cast<int>(changes.size() - kMostChanges));
  changes_->setText(lines.join(QLatin1Char('\n')));
}

void CompareCard::goThere() {
  if (!compare_.result()) return;
  const std::vector<double> at = compare_.result()->at;
  for (std::size_t i = 0; i < at.size(); ++i) scene_.setValue(i, at[i]);
}

}  // namespace tactus::workbench
