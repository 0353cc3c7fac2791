#include <QButtonGroup>
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

namespace tactus::workbench {

PatientControls::PatientControls(SceneController& scene, FeelController& feel, QWidget* parent)
    : QWidget(parent),
      scene_(scene),
      feel_(feel),
      lubrication_(new QLabel(tr("Lubrication"), this)),
      terms_(new QWidget(this)),
      terms_layout_(new QHBoxLayout(terms_)),
      term_buttons_(new QButtonGroup(this)),
      neck_(new QPushButton(this)) {
  terms_layout_->setContentsMargins(0, 0, 0, 0);
  terms_layout_->setSpacing(2);
  // Checked where the value is; the group must not insist, because a value may be in no term.
  term_buttons_->setExclusive(false);
  neck_->setCheckable(true);
  neck_->setFont(theme::smallFont());
  // Both texts have their place.
  keepFitted(*neck_, [this] {
    neck_->setMinimumWidth(neck_->fontMetrics().horizontalAdvance(tr("Flex the neck")) + 2 * theme::kGrid);
  });
  lubrication_->setFont(theme::smallFont());
  neck_->setFocusPolicy(Qt::TabFocus);
  neck_->setToolTip(tr("Flex the neck or raise the head within a second; the force follows (F8)"));

  auto* lubrication = makeRow({lubrication_, terms_, spring(1)}, theme::kGrid / 2);
  auto* neck = makeRow({neck_, spring(1)}, kStyleGap);
  rows_ = new QBoxLayout(QBoxLayout::LeftToRight, this);
  rows_->setContentsMargins(0, 0, 0, 0);
  rows_->setSpacing(theme::kGrid / 2);
  rows_->addLayout(lubrication);
  rows_->addLayout(neck, 1);

  connect(term_buttons_, &QButtonGroup::idClicked, this, [this](int term) {
    const auto input = inputNamed(scene_.model()->model, kLubricationId);
    const fuzzy::Variable& variable = scene_.model()->model.inputs[*input];
    scene_.setValue(*input, coreMiddle(variable, variable.terms[static_cast<std::size_t>(term)]));
    showValues();
  });
  connect(neck_, &QPushButton::clicked, &feel_, &FeelController::setNeckFlexed);
  connect(&scene_, &SceneController::modelChanged, this, &PatientControls::build);
  connect(&scene_, &SceneController::modelEdited, this, &PatientControls::build);
  connect(&scene_, &SceneController::valueChanged, this, &PatientControls::onValue);
  if (scene_.model()) build();
}

void PatientControls::fit(int room) {
  const int choices = terms_->minimumSizeHint().width();
  const int name = lubrication_->minimumSizeHint().width() + rows_->spacing();
  const bool stacked = name + choices + rows_->spacing() + neck_->minimumWidth() > room;
  lubrication_->setVisible(has_lubrication_ && (!stacked || name + choices <= room));
  const auto direction = stacked ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight;
  if (rows_->direction() != direction) rows_->setDirection(direction);
}

int PatientControls::leastWidth() const { return std::max(terms_->minimumSizeHint().width(), neck_->minimumWidth()); }

void PatientControls::build() {
  const fuzzy::ForceModel& model = scene_.model()->model;
  const auto lubrication = inputNamed(model, kLubricationId);
  const auto neck = inputNamed(model, kNeckFlexionId);
  has_lubrication_ = lubrication.has_value();
  if (!has_lubrication_) lubrication_->hide();
  terms_->setVisible(lubrication.has_value());
  neck_->setVisible(neck && neckPostures(model.inputs[*neck]).has_value());
  const std::vector<fuzzy::Term> none;
  const std::vector<fuzzy::Term>& terms = lubrication ? model.inputs[*lubrication].terms : none;

  const QList<QAbstractButton*> old = term_buttons_->buttons();
  bool same = old.size() == static_cast<qsizetype>(terms.size());
  for (qsizetype i = 0; same && i < old.size(); ++i)
    same = old[i]->text() == labelOf(terms[static_cast<std::size_t>(i)]);
  if (!same) {
    qDeleteAll(old);
    for (std::size_t i = 0; i < terms.size(); ++i) {
      auto* button = new QPushButton(labelOf(terms[i]), terms_);
      button->setCheckable(true);
      button->setFocusPolicy(Qt::TabFocus);
      button->setToolTip(tr("Set the lubrication to %1").arg(labelOf(terms[i])));
      button->setFont(theme::smallFont());
      keepFitted(*button, [button] {
        QFont chosen = button->font();
        chosen.setBold(true);
        button->setMinimumWidth(QFontMetrics(chosen).horizontalAdvance(button->text()) + 2 * theme::kGrid);
      });
      terms_layout_->addWidget(button);
      term_buttons_->addButton(button, static_cast<int>(i));
    }
  }
  showValues();
}

void PatientControls::onValue(std::size_t input) {
  const std::string& id = scene_.model()->model.inputs[input].id;
  if (id == kLubricationId || id == kNeckFlexionId) showValues();
}

void PatientControls::showValues() {
  const fuzzy::ForceModel& model = scene_.model()->model;
  if (const auto input = inputNamed(model, kLubricationId)) {
    const auto term = strongestTerm(model.inputs[*input], scene_.value(*input));
    const QList<QAbstractButton*> buttons = term_buttons_->buttons();
    for (qsizetype i = 0; i < buttons.size(); ++i) {
      const bool chosen = term == static_cast<std::size_t>(i);
      // Bold too: in the dark look a button that is down is hard to tell from one that is not.
      QFont font = theme::smallFont();
      font.setBold(chosen);
      buttons[i]->setFont(font);
      buttons[i]->setChecked(chosen);
    }
  }
  const bool flexed = feel_.isNeckFlexed();
  neck_->setChecked(flexed);
  neck_->setText(flexed ? tr("Raise head") : tr("Flex the neck"));
}

}  // namespace tactus::workbench
