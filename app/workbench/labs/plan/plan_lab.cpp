#include "app/workbench/labs/plan/plan_lab.h"

#include <algorithm>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "core/base/text.h"

namespace tactus::workbench {

PlanLab::PlanLab(LabData& data, LabModel& model, QObject* parent)
    : QObject(parent), data_(data), model_(model), simulated_([this] { return order(); }, &PlanLab::simulate) {
  simulated_.needs(data_);
  simulated_.needs(model_);
  connect(&simulated_, &Computation::valueChanged, this, &PlanLab::takePlan);
  connect(&model_, &Computation::valueChanged, &simulated_, &Computation::refresh);
  connect(&data_, &LabData::studyChanged, &simulated_, &Computation::refresh);
  connect(&data_.connection(), &StudyConnection::procedureChanged, this, [this] {
    wish_.region.clear();
    emit regionsChanged();
    simulated_.forget();
  });
}

void PlanLab::setWanted(bool wanted) { simulated_.hold(*this, wanted); }

void PlanLab::setWish(const PlanWish& wish) {
  if (wish == wish_) return;
  wish_ = wish;
  simulated_.refresh();
  emit changed();
}

void PlanLab::setPrecisionN(double precision_n) {
  if (precision_n == precision_n_) return;
  precision_n_ = precision_n;
  takePlan();
}

std::optional<PlanLab::Order> PlanLab::order() const {
  // A model on its way is waited for.
  if (data_.isReading() || model_.isBusy()) return std::nullopt;
  return Order{data_.connection().procedure(), model_.inputs(), data_.settings().force_terms, wish_};
}

PlanLab::Simulated::Answer PlanLab::simulate(const Order& order, const RunOf<planning::PlannedStudy>& run) {
  planning::PlanSettings settings;
  settings.region = order.wish.region;
  settings.most_nurses = order.wish.most_nurses;
  settings.studies = static_cast<std::size_t>(order.wish.studies);
  settings.force_terms = order.force_terms;
  const auto during = [&]() -> std::optional<planning::PlannedStudy> {
    if (!order.built) return std::nullopt;
    auto planned =
        planning::planDuring(order.built->study->study, *order.built->model, order.built->settings, settings);
    return planned ? std::optional(std::move(*planned)) : std::nullopt;
  };
  auto planned = during();
  if (!planned) planned = planning::planBefore(order.about, settings);
  const auto done = planning::simulate(*planned, [&run](double share) {
    run.progress(share);
    return !run.stop.stop_requested();
  });
  if (!done) {
    if (done.error().code == base::ErrorCode::kCancelled) return nullptr;
    return tl::unexpected(text(done.error().message()));
  }
  return std::make_shared<const planning::PlannedStudy>(std::move(*planned));
}

void PlanLab::takePlan() {
  plan_.reset();
  if (simulated_.value() != nullptr) {
    plan_ = *simulated_.value();
    plan_->settings.precision_n = precision_n_;
    plan_->plan.cheapest = planning::cheapestOf(plan_->plan, precision_n_);
  }
  emit changed();
}

std::vector<Column<PlanRow>> planColumns() {
  using Row = PlanRow;
  return {{PlanLab::tr("Questions"), &Row::questions, Qt::AlignRight},
          {PlanLab::tr("Nurses"), &Row::nurses, Qt::AlignRight},
          {PlanLab::tr("Error"), &Row::error, Qt::AlignRight,
           PlanLab::tr("Root mean square of the averaged force less the mean force of other nurses.")},
          {PlanLab::tr("95 %"), &Row::interval, Qt::AlignRight,
           PlanLab::tr("Interval of the error for this number of simulated studies.")},
          {PlanLab::tr("95 % of studies below"), &Row::p95, Qt::AlignRight},
          {PlanLab::tr("Hours"), &Row::hours, Qt::AlignRight, PlanLab::tr("Of all nurses together.")},
          {QString(), &Row::note}};
}

std::vector<PlanRow> planRows(const planning::PlannedStudy& planned) {
  std::vector<PlanRow> rows;
  const auto& designs = planned.plan.designs;
  for (std::size_t i = 0; i < designs.size(); ++i) {
    const auto& one = designs[i];
    PlanRow row;
    row.nurses = QString::number(one.design.nurses);
    row.questions = QString::number(one.design.questions);
    // Every number has its three digits: the column is read from above.
    const auto newtons = [](double force_n) { return text(base::formatFixed(force_n, 3)); };
    row.error = PlanLab::tr("%1 N").arg(newtons(one.error_n));
    row.interval = PlanLab::tr("%1 to %2 N").arg(newtons(one.low_n), newtons(one.high_n));
    row.p95 = PlanLab::tr("%1 N").arg(newtons(one.p95_n));
    row.hours = PlanLab::tr("%1 h").arg(text(base::formatFixed(one.hours, 1)));
    const bool now = planned.now && one.design == *planned.now;
    if (planned.plan.cheapest == i) row.note = now ? PlanLab::tr("now, the cheapest") : PlanLab::tr("the cheapest");
    if (row.note.isEmpty() && now) row.note = PlanLab::tr("now");
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace tactus::workbench
