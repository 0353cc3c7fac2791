#include "app/workbench/labs/origins/origin_finder.h"

#include <algorithm>
#include <utility>

#include "app/workbench/labs/data/influence_text.h"

namespace tactus::workbench {

OriginFinder::OriginFinder(LabData& data, LabModel& model, QObject* parent)
    : QObject(parent), data_(data), model_(model) {
  connect(&model_, &LabModel::builtChanged, this, &OriginFinder::find);
  connect(&data_, &LabData::studyChanged, this, [this] {
    if (isAsked() && data_.study() == nullptr) emit changed();
  });
}

void OriginFinder::ask(OriginQuestion question, const QString& not_of_study) {
  question_ = std::move(question);
  not_of_study_ = not_of_study;
  origin_ = nullptr;
  influences_.clear();
  work_.drop();
  influence_work_.drop();
  const bool wanted = not_of_study_.isEmpty();
  data_.setWanted(*this, wanted);
  model_.setWanted(*this, wanted);
  emit changed();
  if (wanted) find();
}

void OriginFinder::close() {
  question_.reset();
  origin_ = nullptr;
  influences_.clear();
  work_.drop();
  influence_work_.drop();
  data_.setWanted(*this, false);
  model_.setWanted(*this, false);
  emit changed();
}

QString OriginFinder::failure() const {
  if (!not_of_study_.isEmpty()) return not_of_study_;
  if (!data_.failure().isEmpty()) return data_.failure();
  return model_.failure();
}

void OriginFinder::find() {
  if (!question_ || !not_of_study_.isEmpty()) return;
  influence_work_.drop();
  if (model_.built() == nullptr) {
    work_.drop();
    origin_ = nullptr;
    influences_.clear();
    emit changed();
    return;
  }
  work_.run([this, question = *question_, built = model_.built(), study = model_.builtFrom(),
             settings = model_.builtWith()](const std::stop_token&) {
    const auto found = std::make_shared<const Origin>(originOf(question, *built, *study, settings));
    return [this, found, built, study, settings] {
      origin_ = found;
      of_ = built;
      study_ = study;
      settings_ = settings;
      influences_.assign(found->records.size(), std::nullopt);
      wanted_.reset();
      emit changed();
      compareNext();
    };
  });
}

void OriginFinder::askInfluence(std::size_t row) {
  if (row >= influences_.size() || influences_[row]) return;
  wanted_ = row;
  if (!influence_work_.isBusy()) compareNext();
}

// One at a time, so that the one that is asked for never waits for more than one.
void OriginFinder::compareNext() {
  const auto is_open = [this](std::size_t row) { return row < influences_.size() && !influences_[row]; };
  std::optional<std::size_t> row = std::exchange(wanted_, std::nullopt);
  if (row && !is_open(*row)) row.reset();
  for (std::size_t i = 0; !row && i < std::min(kMostUnasked, influences_.size()); ++i) {
    if (is_open(i)) row = i;
  }
  if (!row) return;
  influence_work_.run(
      [this, row = *row, origin = origin_, built = of_, study = study_, settings = settings_](const std::stop_token&) {
        auto moved = influenceOf(origin->records[row], *built, *study, settings);
        return [this, row, moved = std::move(moved)] {
          influences_[row] = moved;
          emit influenceChanged(row);
          compareNext();
        };
      });
}

QString OriginFinder::influenceSentence(std::size_t row) const {
  if (origin_ == nullptr || row >= influences_.size() || !influences_[row]) return {};
  const OriginRecord& record = origin_->records[row];
  return influenceText(QStringLiteral("%1, %2").arg(record.participant, record.what), *influences_[row], of_->model);
}

}  // namespace tactus::workbench
