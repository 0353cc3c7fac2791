#include "app/workbench/feel/recordings/feel_marks.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/feel/feel_controller.h"
#include "app/workbench/feel/recordings/feel_store.h"
#include "app/workbench/model/patient.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/study/connection/study_connection.h"
#include "core/store/feel_records.h"

namespace tactus::workbench {
namespace {

constexpr double kSameForceN = 0.005;  // finer than the screen's newtons; a fade of a condition may be under way

}  // namespace

FeelMarks::FeelMarks(FeelController& feel, SceneController& scene, StudyConnection& study, FeelStore& store,
                     QObject* parent)
    : QObject(parent), feel_(feel), scene_(scene), study_(study), store_(store) {
  connect(&study_, &StudyConnection::opened, this, &FeelMarks::readStudy);
  connect(&study_, &StudyConnection::closed, this, [this] {
    marks_.clear();
    emit changed();
  });
}

QString FeelMarks::textOf(const study::FeelMark& mark) const {
  const QString model = mark.setting.model.empty() ? QString() : QStringLiteral(" · ") + text(mark.setting.model);
  return tr("%1 mm · %2 N").arg(numberText(mark.depth_mm, 0), numberText(mark.force_n, 2)) + model;
}

void FeelMarks::readStudy() {
  study_.read(*this, [this](const store::StudyFile& file) -> StudyConnection::Deliver {
    const auto read = std::make_shared<base::Result<std::vector<study::FeelMark>>>(store::feelMarks(file));
    return [this, read] {
      if (!*read) {
        emit said(tr("The marks of the study were not read: %1").arg(text(read->error().message())));
        return;
      }
      marks_ = **read;
      emit changed();
    };
  });
}

void FeelMarks::mark() {
  const haptics::Sample sample = feel_.latest();
  if (!feel_.isRunning() || feel_.isReplay() || !sample.enabled || scene_.model() == nullptr) {
    emit said(tr("Nothing was marked, because the hand does not hold the tool. Hold it, and mark what you feel (F7)."));
    return;
  }
  study::FeelMark mark;
  mark.entry.id = ids_.next();
  mark.entry.when = study::momentNow();
  mark.entry.entered_by = store_.who() ? study::EnteredBy::kParticipant : study::EnteredBy::kResearcher;
  mark.setting = store_.setting();
  mark.depth_mm = feel_.depthMm();
  mark.speed_mm_s = sample.slip_speed_mm_s;
  mark.force_n = sample.force_n;
  mark.model_force_n = sample.model_force_n;
  marks_.push_back(mark);
  emit changed();
  const QString marked = tr("Marked: %1.").arg(textOf(mark));
  if (!study_.takesOrders()) {
    emit said(marked + QLatin1Char(' ') + tr("No study is open, so the mark ends with the program."));
    return;
  }
  const auto shared = std::make_shared<study::FeelMark>(std::move(mark));
  study_.order(
      [shared, visit = store_.visit(), sessions = store_.sessions()](store::StudyFile& file,
                                                                     study::RecordIds& ids) -> base::Result<void> {
        TACTUS_TRY(shared->entry.session, sessions->sessionOf(visit, file, ids));
        return store::append(file, *shared);
      },
      {}, [this](const QString& sentence) { emit said(tr("The mark was not stored: %1").arg(sentence)); });
  emit said(marked);
}

void FeelMarks::returnTo(std::size_t index) {
  if (index >= marks_.size() || scene_.model() == nullptr) return;
  const study::FeelMark mark = marks_[index];
  const auto& inputs = scene_.model()->model.inputs;
  std::vector<double> point = scene_.values();
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const auto condition = mark.setting.conditions.find(inputs[i].id);
    if (fuzzy::roleOf(inputs[i]) == fuzzy::Role::kWay) point[i] = mark.depth_mm;
    if (fuzzy::roleOf(inputs[i]) == fuzzy::Role::kRate) point[i] = std::max(0.0, mark.speed_mm_s);
    if (condition != mark.setting.conditions.end()) point[i] = condition->second;
  }
  scene_.goTo(point);
  if (feel_.isRunning() && !feel_.isReplay()) feel_.newPlacementAt(mark.depth_mm);
  const fuzzy::Evaluation now = scene_.model()->compiled.evaluate(point);
  const QString was =
      tr("Back at the mark: %1 N at %2 mm.").arg(numberText(mark.model_force_n, 2), numberText(mark.depth_mm, 0));
  if (now.fired && std::abs(now.force_n - mark.model_force_n) <= kSameForceN) {
    emit said(was + QLatin1Char(' ') + tr("The open model gives the same force there."));
  } else {
    emit differs(was + QLatin1Char(' ') +
                     (now.fired ? tr("The open model gives %1 N there now.").arg(numberText(now.force_n, 2))
                                : tr("The open model gives no force there now.")),
                 mark.setting.model_version);
  }
}

}  // namespace tactus::workbench
