#include "app/workbench/participant/own_model_trial.h"

#include <QPointer>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "core/store/model_versions.h"

namespace tactus::workbench {

void OwnModelTrial::prepare(const std::string& code) {
  if (std::exchange(asked_, true) || !study_.takesOrders()) return;
  const auto made = std::make_shared<base::Result<OwnModel>>(base::fail(base::ErrorCode::kData, "", "", ""));
  study_.order(
      [made, code](store::StudyFile& file, study::RecordIds& ids) -> base::Result<void> {
        *made = ownModel(file, code);
        if (!*made) return {};
        auto version = (*made)->version;
        version.id = ids.next();
        (*made)->version.id = version.id;
        return store::append(file, version);
      },
      [self = QPointer(this), made] {
        if (!self) return;
        if (*made) {
          self->model_ = std::make_shared<const OwnModel>(std::move(**made));
        } else {
          self->refused_ = text(made->error().message());
        }
        emit self->changed();
      },
      [self = QPointer(this)](const QString& sentence) {
        if (!self) return;
        self->refused_ = sentence;
        emit self->changed();
      });
}

void OwnModelTrial::feel() {
  ForceOrders force;
  force.source = haptics::ForceSource::kInsertion;
  force.scene = model_->scene;
  force.placement = device_.newNumber();
  force.start_depth_mm = model_->regions[region_].from_mm - model_->depthOffsetMm();
  device_.setForce(force);
}

void OwnModelTrial::look(std::span<const haptics::Sample> samples) {
  for (const haptics::Sample& sample : samples) {
    if (sample.enabled && sample.source == haptics::ForceSource::kInsertion) felt_ = sample;
  }
}

session::OwnModelPlace OwnModelTrial::place() const {
  const haptics::Sample sample = felt_.value_or(device_.latest());
  return {model_->version.id, model_->regions[region_].id, sample.depth_mm + model_->depthOffsetMm(), sample.force_n};
}

session::Note OwnModelTrial::mark() {
  ++marks_;
  return session::ownModelMark(place());
}

session::Note OwnModelTrial::say(const QString& comparison) {
  using session::OwnModelVerdict;
  const auto verdict = comparison == QLatin1String("lighter")   ? OwnModelVerdict::kLighter
                       : comparison == QLatin1String("heavier") ? OwnModelVerdict::kHeavier
                                                                : OwnModelVerdict::kAboutRight;
  const auto note = session::ownModelVerdict({model_->version.id, model_->regions[region_].id, {}, {}}, verdict);
  marks_ = 0;
  felt_.reset();
  if (region_ + 1 < model_->regions.size()) {
    ++region_;
  } else {
    done_ = true;
  }
  return note;
}

OwnModelState OwnModelTrial::state(bool runs) const {
  OwnModelState out;
  out.unavailable = refused_;
  out.marks = marks_;
  out.ready = model_ != nullptr && runs;
  if (model_ == nullptr) return out;
  const OwnRegion& region = model_->regions[region_];
  out.region = QString::fromStdString(region.id);
  out.from_mm = region.from_mm;
  out.number = static_cast<int>(region_) + 1;
  out.count = static_cast<int>(model_->regions.size());
  return out;
}

const std::vector<QPointF>& OwnModelTrial::curve() const {
  static const std::vector<QPointF> kNone;
  return model_ != nullptr ? model_->curve : kNone;
}

}  // namespace tactus::workbench
