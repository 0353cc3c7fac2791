#include "app/workbench/labs/speed/stroke_influence.h"

#include "app/workbench/labs/data/influence_text.h"

namespace tactus::workbench {

StrokeInfluence::StrokeInfluence(LabModel& model, QObject* parent) : QObject(parent), model_(model) {
  connect(&model_, &LabModel::builtChanged, this, &StrokeInfluence::compare);
}

void StrokeInfluence::ask(const elicitation::StrokeKey& stroke, const QString& which) {
  asked_ = stroke;
  which_ = which;
  model_.setWanted(*this, true);
  compare();
}

void StrokeInfluence::stop() {
  asked_.reset();
  work_.drop();
  model_.setWanted(*this, false);
  tell({});
}

void StrokeInfluence::compare() {
  if (!asked_) return;
  const auto built = model_.built();
  if (built == nullptr) {
    work_.drop();
    return tell(model_.failure().isEmpty() ? tr("%1: building the model…").arg(which_) : model_.failure());
  }
  tell(tr("%1: comparing the force with and without it…").arg(which_));
  work_.run([this, built, study = model_.builtFrom(), with = model_.builtWith(), stroke = *asked_,
             which = which_](const std::stop_token&) {
    const auto moved =
        elicitation::withoutStroke(*built, study->study, with, stroke.participant, stroke.level, stroke.stroke);
    return [this, sentence = influenceText(which, moved, built->model)] { tell(sentence); };
  });
}

void StrokeInfluence::tell(const QString& sentence) {
  sentence_ = sentence;
  emit told();
}

}  // namespace tactus::workbench
