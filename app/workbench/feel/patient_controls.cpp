#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <algorithm>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/feel/feel_controller.h"
#include "app/workbench/feel/feel_panel.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/model/patient.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/model/shown_procedure.h"

namespace tactus::workbench {
namespace {

/// The pack's word for the gesture to the last pose, or back to the first one.
QString poseWord(const SceneController& scene, const char* way) {
  const auto input =
      scene.model() != nullptr ? posedInput(scene.procedure().get(), scene.model()->model) : std::nullopt;
  if (!input) return {};
  const std::string& id = scene.model()->model.inputs[*input].id;
  return inProgramLanguage(scene.procedure()->words.at("pose." + id + way));
}

}  // namespace

PatientControls::PatientControls(SceneController& scene, FeelController& feel, QWidget* parent)
    : QWidget(parent), scene_(scene), feel_(feel), pose_(new QPushButton(this)) {
  pose_->setCheckable(true);
  pose_->setFont(theme::smallFont());
  // Both texts have their place.
  keepFitted(*pose_, [this] { fitPose(); });
  pose_->setFocusPolicy(Qt::TabFocus);
  pose_->setToolTip(tr("Change the pose within a second; the force follows (F8)"));

  rows_ = new QBoxLayout(QBoxLayout::LeftToRight, this);
  rows_->setContentsMargins(0, 0, 0, 0);
  rows_->setSpacing(theme::kGrid / 2);
  rows_->addLayout(makeRow({pose_, spring(1)}, kStyleGap), 1);

  connect(pose_, &QPushButton::clicked, &feel_, &FeelController::setPosed);
  connect(&scene_, &SceneController::modelChanged, this, &PatientControls::build);
  connect(&scene_, &SceneController::modelEdited, this, &PatientControls::build);
  connect(&scene_, &SceneController::procedureChanged, this, &PatientControls::build);
  connect(&scene_, &SceneController::valueChanged, this, &PatientControls::onValue);
  build();
}

void PatientControls::fitPose() {
  const QFontMetrics metrics = pose_->fontMetrics();
  pose_->setMinimumWidth(std::max(metrics.horizontalAdvance(poseWord(scene_, ".on")),
                                  metrics.horizontalAdvance(poseWord(scene_, ".off"))) +
                         2 * theme::kGrid);
}

void PatientControls::fit(int room) {
  const int gap = rows_->spacing();
  const auto widthOf = [gap](const Row& row) {
    return row.name->minimumSizeHint().width() + gap + row.terms->minimumSizeHint().width();
  };
  int all = pose_->isHidden() ? 0 : pose_->minimumWidth();
  for (const Row& row : conditions_) all += widthOf(row) + gap;
  const bool stacked = all > room;
  for (const Row& row : conditions_) row.name->setVisible(!stacked || widthOf(row) <= room);
  const auto direction = stacked ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight;
  if (rows_->direction() != direction) rows_->setDirection(direction);
}

int PatientControls::leastWidth() const {
  int least = pose_->isHidden() ? 0 : pose_->minimumWidth();
  for (const Row& row : conditions_) least = std::max(least, row.terms->minimumSizeHint().width());
  return least;
}

QStringList PatientControls::wordsOf() const {
  QStringList out{poseWord(scene_, ".on")};
  if (scene_.model() == nullptr) return out;
  const fuzzy::ForceModel& model = scene_.model()->model;
  const auto posed = posedInput(scene_.procedure().get(), model);
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    if (isMovedByHand(model.inputs[i]) || i == posed) continue;
    out << QString::number(i) << shortLabelOf(model.inputs[i]);
    for (const fuzzy::Term& term : model.inputs[i].terms) out << labelOf(term);
  }
  return out;
}

PatientControls::Row PatientControls::makeRowOf(std::size_t input) {
  const fuzzy::Variable& variable = scene_.model()->model.inputs[input];
  Row row{input, new QWidget(this), nullptr, nullptr, {}};
  row.name = new QLabel(shortLabelOf(variable), row.holder);
  row.name->setFont(theme::smallFont());
  row.terms = new QWidget(row.holder);
  auto* terms = new QHBoxLayout(row.terms);
  terms->setContentsMargins(0, 0, 0, 0);
  terms->setSpacing(2);
  for (std::size_t t = 0; t < variable.terms.size(); ++t) {
    auto* button = new QPushButton(labelOf(variable.terms[t]), row.terms);
    // Checked where the value is; none where it is in no term.
    button->setCheckable(true);
    button->setFocusPolicy(Qt::TabFocus);
    button->setToolTip(tr("Set %1 to %2").arg(shortLabelOf(variable), labelOf(variable.terms[t])));
    button->setFont(theme::smallFont());
    keepFitted(*button, [button] {
      QFont chosen = button->font();
      chosen.setBold(true);
      button->setMinimumWidth(QFontMetrics(chosen).horizontalAdvance(button->text()) + 2 * theme::kGrid);
    });
    connect(button, &QPushButton::clicked, this, [this, input, t] {
      const fuzzy::Variable& now = scene_.model()->model.inputs[input];
      scene_.setValue(input, coreMiddle(now, now.terms[t]));
      showValues();
    });
    terms->addWidget(button);
    row.buttons.push_back(button);
  }
  makeRow(row.holder, {row.name, row.terms, spring(1)}, theme::kGrid / 2);
  return row;
}

void PatientControls::build() {
  QStringList words = wordsOf();
  if (words != words_) {
    words_ = std::move(words);
    for (const Row& row : conditions_) delete row.holder;
    conditions_.clear();
    if (scene_.model() != nullptr) {
      const fuzzy::ForceModel& model = scene_.model()->model;
      const auto posed = posedInput(scene_.procedure().get(), model);
      for (std::size_t i = 0; i < model.inputs.size(); ++i) {
        if (isMovedByHand(model.inputs[i]) || i == posed) continue;
        conditions_.push_back(makeRowOf(i));
        rows_->insertWidget(static_cast<int>(conditions_.size()) - 1, conditions_.back().holder);
      }
      fitPose();
    }
  }
  pose_->setVisible(!words_.front().isEmpty());
  if (scene_.model() != nullptr) showValues();
}

void PatientControls::onValue(std::size_t input) {
  if (!isMovedByHand(scene_.model()->model.inputs[input])) showValues();
}

void PatientControls::showValues() {
  const fuzzy::ForceModel& model = scene_.model()->model;
  for (const Row& row : conditions_) {
    const auto term = strongestTerm(model.inputs[row.input], scene_.value(row.input));
    for (std::size_t t = 0; t < row.buttons.size(); ++t) {
      const bool chosen = term == t;
      // Bold too: in the dark look a button that is down is hard to tell from one that is not.
      QFont font = theme::smallFont();
      font.setBold(chosen);
      row.buttons[t]->setFont(font);
      row.buttons[t]->setChecked(chosen);
    }
  }
  const bool posed = feel_.isPosed();
  pose_->setChecked(posed);
  pose_->setText(poseWord(scene_, posed ? ".off" : ".on"));
}

}  // namespace tactus::workbench
