#include "app/workbench/deliver/bundle_panel.h"

#include <QClipboard>
#include <QDesktopServices>
#include <QGridLayout>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QStackedWidget>
#include <QUrl>
#include <algorithm>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/refresh.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/deliver/readiness.h"
#include "app/workbench/deliver/readiness_panel.h"
#include "app/workbench/kit/buttons.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/kit/notes.h"
#include "app/workbench/kit/quiet_table.h"

namespace tactus::workbench {
namespace {

QLabel* wrapped(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  return label;
}

}  // namespace

BundlePanel::BundlePanel(BundleMaker& maker, const ReadinessController& readiness, QWidget* parent)
    : Card(parent),
      maker_(maker),
      readiness_(readiness),
      make_(new PrimaryButton(tr("Make the bundle…"), this)),
      waits_for_(wrapped({}, this)),
      body_(new QStackedWidget(this)) {
  make_->setObjectName(QStringLiteral("make_bundle"));
  setMuted(*waits_for_);
  for (QWidget* page : {contents_ = makeContents(), work_ = makeWork(), result_ = makeResult()}) body_->addWidget(page);
  makeColumn(this, {makeRow({make_, {waits_for_, 1}}, 2 * theme::kGrid), {body_, 1}}, 2 * theme::kGrid,
             inset(2 * theme::kGrid));

  connect(make_, &QPushButton::clicked, this, &BundlePanel::wanted);
  auto* refresh = new Refresh(this, [this] { showState(); });
  connect(&maker_, &BundleMaker::changed, refresh, &Refresh::request);
  connect(&readiness_, &ReadinessController::changed, refresh, &Refresh::request);
  refresh->request();
}

void BundlePanel::addBelow(QWidget* row) { layout()->addWidget(row); }

QWidget* BundlePanel::makeContents() {
  auto* page = new QWidget(body_);
  auto* layout = new QGridLayout(page);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setHorizontalSpacing(2 * theme::kGrid);
  layout->setVerticalSpacing(theme::kGrid);
  layout->setColumnStretch(1, 1);
  auto* head = wrapped(
      tr("A bundle is one folder with everything that a simulator team needs, and how exact each file is:"), page);
  layout->addWidget(head, 0, 0, 1, 2);
  const std::pair<QString, QString> parts[] = {
      {tr("Model"), tr("the native file, for libtactus: C, C++, Python and C#")},
      {tr("Checks"), tr("points with their exact forces, to test a reader of one's own")},
      {tr("Experts"), tr("each expert for fuzzylite, jFuzzyLogic, MATLAB, Octave and IEEE 1855")},
      {tr("C source"), tr("the fastest way to a force, without any library")},
      {tr("Table"), tr("a look-up table, where nothing else is possible")},
      {tr("Report"), tr("the model on two printed pages")}};
  int row = 1;
  for (const auto& [name, what] : parts) {
    auto* file = new QLabel(name, page);
    file->setFont(theme::headingFont());
    layout->addWidget(file, row, 0, Qt::AlignTop);
    layout->addWidget(wrapped(what, page), row++, 1);
  }
  layout->setRowStretch(row, 1);
  return page;
}

QWidget* BundlePanel::makeWork() {
  auto* page = new QWidget(body_);
  doing_ = wrapped({}, page);
  progress_ = new QProgressBar(page);
  progress_->setTextVisible(false);
  progress_->setAccessibleName(tr("Progress of the bundle"));
  cancel_ = new QPushButton(tr("Cancel"), page);
  makeColumn(page, {doing_, makeRow({{progress_, 1}, cancel_}), spring(1)}, kStyleGap);
  connect(cancel_, &QPushButton::clicked, &maker_, &BundleMaker::cancel);
  return page;
}

QWidget* BundlePanel::makeResult() {
  auto* page = new QWidget(body_);
  sign_ = new ReadinessSign(page);
  said_ = wrapped({}, page);
  said_->setFont(theme::headingFont());
  said_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  folder_ = new ElidedLabel(page);
  setMuted(*folder_);
  fingerprint_ = wrapped({}, page);
  fingerprint_->setObjectName(QStringLiteral("bundle_fingerprint"));
  fingerprint_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  fingerprint_->setToolTip(
      tr("Tell it to the receiver by another way than the bundle: tactus verify prints the same, or it is another "
         "bundle."));
  notes_ = wrapped({}, page);
  open_ = new QPushButton(tr("Open folder"), page);
  act_ = new QPushButton(page);
  act_->setObjectName(QStringLiteral("bundle_act"));
  table_ = makeQuietTable(files_, tr("Files of the bundle, with the largest error of each"), page);
  table_->setObjectName(QStringLiteral("bundle_files"));
  table_->setTextElideMode(Qt::ElideMiddle);
  table_->verticalHeader()->setDefaultSectionSize(3 * theme::kGrid);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);

  auto* layout = new QGridLayout(page);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setHorizontalSpacing(theme::kGrid + theme::kGrid / 2);
  layout->setVerticalSpacing(theme::kGrid / 2);
  layout->setColumnStretch(1, 1);
  layout->addWidget(sign_, 0, 0, Qt::AlignTop);
  layout->addWidget(said_, 0, 1);
  layout->addWidget(folder_, 1, 1);
  layout->addWidget(open_, 0, 2, 2, 1, Qt::AlignVCenter);
  layout->addWidget(act_, 0, 3, 2, 1, Qt::AlignVCenter);
  layout->addWidget(fingerprint_, 2, 1, 1, 3);
  layout->addWidget(notes_, 3, 1, 1, 3);
  layout->addWidget(table_, 4, 0, 1, 4);
  layout->setRowStretch(4, 1);
  connect(open_, &QPushButton::clicked, this, &BundlePanel::openFolder);
  connect(act_, &QPushButton::clicked, this, &BundlePanel::act);
  return page;
}

QString BundlePanel::waitsFor() const {
  if (readiness_.lines().empty()) return tr("Open a model first.");
  if (readiness_.blocks()) return tr("Settle the holes first: a simulator must know where there is no force.");
  return {};
}

QString BundlePanel::workText() const {
  const QString name = shownFileName(maker_.folder());
  switch (maker_.doing()) {
    case BundleMaker::Doing::kMaking:
      if (!maker_.mayCancel()) break;
      return maker_.all() == 0 ? tr("Making %1…").arg(name)
                               : tr("Making %1: part %2 of %3…").arg(name).arg(maker_.done() + 1).arg(maker_.all());
    case BundleMaker::Doing::kWriting:
      if (!maker_.mayCancel()) break;
      return tr("Writing %1…").arg(name);
    case BundleMaker::Doing::kReadingBack: return tr("Reading %1 back…").arg(name);
    case BundleMaker::Doing::kNothing: return {};
  }
  return tr("Canceling…");
}

void BundlePanel::showState() {
  const bool works = maker_.doing() != BundleMaker::Doing::kNothing;
  const QString waits_for = waitsFor();
  make_->setEnabled(!works && waits_for.isEmpty());
  waits_for_->setText(waits_for);
  if (works) {
    doing_->setText(workText());
    // Without a maximum the bar only says that there is work.
    progress_->setMaximum(maker_.doing() == BundleMaker::Doing::kMaking ? static_cast<int>(maker_.all()) : 0);
    progress_->setValue(static_cast<int>(maker_.done()));
    cancel_->setEnabled(maker_.mayCancel());
    body_->setCurrentWidget(work_);
    return;
  }
  showResult();
}

void BundlePanel::showResult() {
  const auto& delivered = maker_.delivered();
  const bool any = delivered || !maker_.failure().isEmpty();
  body_->setCurrentWidget(any ? result_ : contents_);
  if (!any) return;
  files_.setRows(delivered ? delivered->files : std::vector<DeliveredFile>());
  table_->setVisible(delivered.has_value());
  open_->setVisible(delivered.has_value());
  folder_->setVisible(delivered.has_value());
  fingerprint_->setVisible(delivered.has_value());
  act_->setVisible(!delivered || !delivered->ok);
  act_->setText(delivered && maker_.asked() == BundleMaker::Doing::kMaking ? tr("Make it again…")
                                                                           : tr("Choose another folder…"));
  QStringList notes;
  if (!delivered) {
    sign_->setState(Readiness::kBlocks);
    said_->setText(maker_.failure());
  } else {
    const int files = static_cast<int>(delivered->files.size());
    sign_->setState(!delivered->ok ? Readiness::kBlocks : maker_.isOld() ? Readiness::kLook : Readiness::kReady);
    said_->setText(delivered->ok ? (delivered->made ? tr("Made and read back: %n file(s), each within its tolerance",
                                                         nullptr, files)
                                                    : tr("Read: %n file(s), each within its tolerance", nullptr, files))
                                 : tr("Not every file is what it promises"));
    folder_->setFullText(harmless(delivered->folder));
    fingerprint_->setText(tr("Fingerprint %1").arg(delivered->fingerprint));
    const auto wrong = std::find_if(delivered->files.begin(), delivered->files.end(),
                                    [](const DeliveredFile& file) { return !file.ok; });
    if (wrong != delivered->files.end()) notes << wrong->wrong;
    notes << delivered->warnings;
    if (maker_.isOld()) notes << tr("The open model is another one: its forces differ, or how it is felt.");
  }
  notes_->setText(notes.join(QLatin1Char('\n')));
  notes_->setVisible(!notes.isEmpty());
}

void BundlePanel::openFolder() {
  const auto& delivered = maker_.delivered();
  if (!delivered) return;
  if (!QDesktopServices::openUrl(QUrl::fromLocalFile(delivered->folder)))
    sayError(*this,
             tr("The folder was not opened, because no program of this computer shows folders. The bundle is in %1")
                 .arg(harmless(delivered->folder)),
             {tr("Copy its path"), [path = delivered->folder] { QGuiApplication::clipboard()->setText(path); }});
}

void BundlePanel::act() { maker_.asked() == BundleMaker::Doing::kMaking ? emit wanted() : emit readBackWanted(); }

}  // namespace tactus::workbench
