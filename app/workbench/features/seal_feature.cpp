// A reference curve that is locked away before anybody answers, and its opening after the sign-off (docs/evidence.md).
#include <QAction>
#include <QClipboard>
#include <QCoreApplication>
#include <QFileInfo>
#include <QGuiApplication>
#include <QLineEdit>
#include <memory>
#include <utility>
#include <vector>

#include "app/session/sealing.h"
#include "app/version.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/base/file_dialog.h"
#include "app/workbench/features/bench.h"
#include "app/workbench/features/features.h"
#include "app/workbench/kit/form_dialog.h"
#include "app/workbench/kit/number_box.h"
#include "core/base/files/file.h"

namespace tactus::workbench {
namespace {

constexpr int kShortest = 8;  // bytes of a passphrase (store::sealContent)

QLineEdit* secretField() {
  auto* const field = new QLineEdit;
  field->setEchoMode(QLineEdit::Password);
  return field;
}

class SealFeature : public QObject {
  Q_DECLARE_TR_FUNCTIONS(SealFeature)

 public:
  explicit SealFeature(Bench& bench);

 private:
  /// Reads what the study knows of seals, then calls `then` with it.
  void withState(const std::function<void(const session::SealState&)>& then);
  void chooseReference();
  void read(const QString& path, const session::SealState& state);
  /// Asks for the note, the conditions and the passphrase.
  void ask(const session::SealOrder& order, const session::SealState& state);
  void seal(const session::SealOrder& order);
  void askToOpen();
  void open(const QString& passphrase);
  void showOpened(const session::Unsealed& opened);

  Bench& bench_;
};

SealFeature::SealFeature(Bench& bench) : QObject(&bench.features), bench_(bench) {
  WindowMenus& menus = bench.window.menus();
  QAction* const seal = menus.addAction(MenuSlot::kStudyModel, tr("Put a reference curve under &seal…"));
  QAction* const open = menus.addAction(MenuSlot::kStudyModel, tr("Open the sealed &reference…"));
  for (QAction* const action : {seal, open})
    followStudy(bench, action, [&bench] { return bench.study.isOpen() && bench.study.takesOrders(); });
  connect(seal, &QAction::triggered, this, &SealFeature::chooseReference);
  connect(open, &QAction::triggered, this, &SealFeature::askToOpen);
}

void SealFeature::withState(const std::function<void(const session::SealState&)>& then) {
  bench_.study.read(*this, [this, then](const store::StudyFile& file) -> StudyConnection::Deliver {
    auto state = std::make_shared<base::Result<session::SealState>>(session::sealState(file));
    return [this, then, state] {
      if (*state) return then(**state);
      bench_.window.banner().showRemedy(
          tr("The seals of the study were not read. %1").arg(text(state->error().message())),
          {tr("Try again"), [this, then] { withState(then); }});
    };
  });
}

void SealFeature::chooseReference() {
  withState([this](const session::SealState& state) {
    if (!state.trials.empty()) {
      bench_.window.banner().showOffer(
          tr("The study has a sealed reference already: a second curve belongs into a study of its own."),
          {tr("Open the sealed reference…"), [this] { askToOpen(); }});
      return;
    }
    const QString path = file_dialog::getOpenFileName(&bench_.window, tr("Choose the curve to put under seal"),
                                                      QFileInfo(bench_.study.path()).absolutePath(),
                                                      tr("Curves (*.csv);;All files (*)"));
    if (!path.isEmpty()) read(path, state);
  });
}

void SealFeature::read(const QString& path, const session::SealState& state) {
  const auto refuse = [this](const QString& why) {
    bench_.window.banner().showRemedy(tr("Nothing was sealed. %1").arg(why),
                                      {tr("Choose another file…"), [this] { chooseReference(); }});
  };
  session::SealOrder order;
  order.name = shownFileName(path).toStdString();
  auto content = base::readFile(path.toStdString(), store::kMostSealedBytes);
  if (!content) return refuse(text(content.error().message()));
  order.content = std::move(*content);
  if (const auto curve = elicitation::readReferenceCurve(order.content, order.name, *bench_.study.procedure()); !curve)
    return refuse(text(curve.error().message()));
  order.conditions = session::usualConditions(*bench_.study.procedure());
  ask(order, state);
}

void SealFeature::ask(const session::SealOrder& order, const session::SealState& state) {
  QList<FormDialog::Row> rows;
  auto* const note = new QLineEdit;
  note->setPlaceholderText(tr("where the curve comes from"));
  rows << FormDialog::Row(tr("&Note, readable by everyone"), note);
  std::vector<std::pair<std::string, NumberBox*>> conditions;
  for (const fuzzy::Variable& input : bench_.study.procedure()->inputs) {
    const auto usual = order.conditions.find(input.id);
    if (usual == order.conditions.end()) continue;
    auto* const box = new NumberBox(input, (input.max - input.min) / 100);
    box->setExact(usual->second);
    conditions.emplace_back(input.id, box);
    rows << FormDialog::Row(labelOf(input), box);
  }
  auto* const passphrase = secretField();
  auto* const again = secretField();
  rows << FormDialog::Row(tr("&Passphrase"), passphrase) << FormDialog::Row(tr("&Once more"), again);
  QString words =
      tr("%1 is encrypted into the study. Without the passphrase nobody can open it, not even you; it has at "
         "least 8 letters. Give it to somebody who takes no part.")
          .arg(text(order.name));
  if (state.began)
    words += QStringLiteral("\n\n") + tr("The study has answers already: the seal is marked as late for ever.");
  auto* const dialog = new FormDialog(tr("Seal a reference"), words, rows, tr("Seal the curve"), &bench_.window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  const auto look = [dialog, passphrase, again] {
    dialog->setReady(passphrase->text().toUtf8().size() >= kShortest && passphrase->text() == again->text());
  };
  connect(passphrase, &QLineEdit::textChanged, dialog, look);
  connect(again, &QLineEdit::textChanged, dialog, look);
  look();
  connect(dialog, &QDialog::accepted, this, [this, order, note, conditions, passphrase] {
    session::SealOrder asked = order;
    asked.note = note->text().trimmed().toStdString();
    for (const auto& [id, box] : conditions) asked.conditions[id] = box->exact();
    asked.passphrase = passphrase->text().toStdString();
    seal(asked);
  });
  dialog->open();
}

void SealFeature::seal(const session::SealOrder& order) {
  auto sealed = std::make_shared<session::Sealed>();
  bench_.study.order(
      [sealed, order](store::StudyFile& file, study::RecordIds&) -> base::Result<void> {
        TACTUS_TRY(*sealed, session::seal(file, order, kGenerator));
        return {};
      },
      [this, sealed, name = text(order.name)] {
        const QString hash = text(sealed->record.sha256);
        bench_.window.banner().showOffer(
            tr("%n point(s) of %1 are under seal. Keep the passphrase, and the file away from all who answer or edit. "
               "SHA-256 %2",
               nullptr, static_cast<int>(sealed->points))
                .arg(name, hash),
            {tr("Copy the SHA-256"), [hash] { QGuiApplication::clipboard()->setText(hash); }});
      },
      [this, order](const QString& sentence) {
        bench_.window.banner().showRemedy(
            tr("Nothing was sealed. %1").arg(sentence),
            {tr("Try again"), [this, order] { withState([this, order](const auto& state) { ask(order, state); }); }});
      });
}

void SealFeature::askToOpen() {
  withState([this](const session::SealState& state) {
    if (state.trials.empty()) {
      bench_.window.banner().showOffer(tr("The study has no sealed reference."),
                                       {tr("Put a curve under seal…"), [this] { chooseReference(); }});
      return;
    }
    auto* const passphrase = secretField();
    QString words = tr("The opening is noted in the study for ever, and the report lists each later change.");
    if (!state.signed_off)
      words += QStringLiteral("\n\n") +
               tr("No model of the study is signed off yet: an opening now is marked as early for ever.");
    auto* const dialog =
        new FormDialog(tr("Open the sealed reference"), words, {FormDialog::Row(tr("&Passphrase"), passphrase)},
                       tr("Open the seal"), &bench_.window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    const auto look = [dialog, passphrase] { dialog->setReady(passphrase->text().toUtf8().size() >= kShortest); };
    connect(passphrase, &QLineEdit::textChanged, dialog, look);
    look();
    connect(dialog, &QDialog::accepted, this, [this, passphrase] { open(passphrase->text()); });
    dialog->open();
  });
}

void SealFeature::open(const QString& passphrase) {
  auto opened = std::make_shared<session::Unsealed>();
  bench_.study.order(
      [opened, word = passphrase.toStdString()](store::StudyFile& file, study::RecordIds&) -> base::Result<void> {
        TACTUS_TRY(*opened, session::unseal(file, word, kGenerator));
        return {};
      },
      [this, opened] { showOpened(*opened); },
      [this](const QString& sentence) {
        bench_.window.banner().showRemedy(tr("The reference was not opened. %1").arg(sentence),
                                          {tr("Type the passphrase again…"), [this] { askToOpen(); }});
      });
}

void SealFeature::showOpened(const session::Unsealed& opened) {
  ReferenceCurve curve;
  curve.name = tr("Sealed reference");
  curve.input = bench_.study.procedure()->wayInput().id;
  for (const auto& point : opened.points) {
    curve.x.push_back(point.depth_mm);
    curve.force_n.push_back(point.force_n);
  }
  const QString sentence = tr("The reference is open: %n point(s), unchanged since it was sealed.", nullptr,
                              static_cast<int>(curve.x.size()));
  const MessageAct report{tr("Write the report of the study…"), [this] { bench_.report->choose(); }};
  if (!bench_.models.current()) {
    bench_.window.banner().showOffer(sentence, report);
    return;
  }
  bench_.window.banner().showOffer(sentence, report, {tr("Show it over the curves"), [this, curve] {
                                                        bench_.references.add({curve}, tr("The sealed reference"));
                                                        bench_.window.enter(Stage::kUnderstand);
                                                      }});
}

}  // namespace

void addSealing(Bench& bench) { new SealFeature(bench); }

}  // namespace tactus::workbench
