#include "app/workbench/labs/speed/speed_settings.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "app/workbench/base/theme.h"
#include "app/workbench/labs/frame/setting_row.h"
#include "app/workbench/labs/speed/speed_lab.h"

namespace tactus::workbench {
namespace {

using elicitation::Averaging;
using elicitation::SpeedCentres;

QLabel* makeCaption(const QString& words, QWidget* buddy, QWidget* parent) {
  auto* caption = new QLabel(words, parent);
  caption->setBuddy(buddy);
  return caption;
}

}  // namespace

SpeedSettingsPanel::SpeedSettingsPanel(SpeedLab& lab, QWidget* parent)
    : Card(parent),
      lab_(lab),
      clusters_(new SettingRow(tr("Clusters c"),
                               tr("The model has one term for each cluster: another number shows clusters alone."),
                               {2, 8, 1, {}, true}, this)),
      fuzziness_(new SettingRow(tr("Fuzziness m"),
                                tr("The exponent m of Eq. 1: near 1 the clusters are crisp; above 5 the centers "
                                   "stick to samples."),
                                {1.05, 6, 0.05}, this)),
      alpha_(new SettingRow(tr("Ramp end α"),
                            tr("The membership at the ends of a ramp. 1: center points have membership 1, as the "
                               "paper says, and medium is a triangle. 0.95: the ramp fits the membership best."),
                            {0.51, 1, 0.01}, this)),
      trim_(new SettingRow(tr("Trimming"),
                           tr("Samples below this share of their stroke's peak speed are left out: the start and the "
                              "stop of each stroke."),
                           {0, 0.95, 0.01}, this)),
      centres_(new QComboBox(this)),
      averaging_(new QComboBox(this)),
      note_(new QLabel(this)) {
  centres_->addItem(tr("clusters of all samples"));
  centres_->addItem(tr("means of the levels"));
  centres_->setAccessibleName(tr("Centers of the terms"));
  averaging_->addItem(tr("mean"));
  averaging_->addItem(tr("weighted mean"));
  averaging_->addItem(tr("median"));
  averaging_->setAccessibleName(tr("Average over the participants"));
  setMuted(*note_);
  note_->setWordWrap(true);
  auto* title = new QLabel(tr("Settings"), this);
  title->setFont(theme::headingFont());
  auto* defaults = new QPushButton(tr("Reset to &defaults"), this);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(2 * theme::kGrid, theme::kGrid + 4, 2 * theme::kGrid, 2 * theme::kGrid);
  layout->setSpacing(theme::kGrid);
  layout->addWidget(title);
  for (QWidget* row : {clusters_, fuzziness_, alpha_, trim_}) layout->addWidget(row);
  layout->addWidget(makeCaption(tr("Centers"), centres_, this));
  layout->addWidget(centres_);
  layout->addWidget(makeCaption(tr("Average"), averaging_, this));
  layout->addWidget(averaging_);
  layout->addWidget(defaults);
  layout->addWidget(note_);
  layout->addStretch(1);

  connect(clusters_, &SettingRow::changed, this,
          [this](double value) { lab_.setClusters(static_cast<std::size_t>(value)); });
  connect(fuzziness_, &SettingRow::changed, &lab_, &SpeedLab::setFuzziness);
  connect(alpha_, &SettingRow::changed, &lab_, &SpeedLab::setAlpha);
  connect(trim_, &SettingRow::changed, &lab_, &SpeedLab::setTrim);
  connect(centres_, &QComboBox::currentIndexChanged, this,
          [this](int index) { lab_.setCentres(index == 1 ? SpeedCentres::kLevelMeans : SpeedCentres::kClusters); });
  connect(averaging_, &QComboBox::currentIndexChanged, this,
          [this](int index) { lab_.setAveraging(static_cast<Averaging>(index)); });
  connect(defaults, &QPushButton::clicked, &lab_, &SpeedLab::setDefaults);
  connect(&lab_, &SpeedLab::settingsChanged, this, &SpeedSettingsPanel::follow);
  follow();
}

void SpeedSettingsPanel::follow() {
  const elicitation::SpeedTermSettings& settings = lab_.settings();
  const bool means = settings.centres == SpeedCentres::kLevelMeans;
  clusters_->setValue(static_cast<double>(lab_.clusters()));
  clusters_->setEnabled(!means);
  fuzziness_->setValue(settings.fcm.m);
  alpha_->setValue(settings.alpha);
  trim_->setValue(settings.trim);
  const QSignalBlocker quiet_centres(centres_);
  const QSignalBlocker quiet_averaging(averaging_);
  centres_->setCurrentIndex(means ? 1 : 0);
  averaging_->setCurrentIndex(static_cast<int>(lab_.averaging()));
  note_->setText(
      !means && lab_.clusters() != 3
          ? tr("With %1 clusters there are no terms: the model has three, Slow, Medium and Fast.").arg(lab_.clusters())
          : tr("These settings make the model of all labs, and are stored in it."));
}

}  // namespace tactus::workbench
