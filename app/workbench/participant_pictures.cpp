#include "app/workbench/participant_pictures.h"

#include "app/workbench/participant/participant_window.h"
#include "app/workbench/participant/screens/panels.h"
#include "app/workbench/participant/screens/closing_screens.h"
#include "app/workbench/participant/screens/sample_screens.h"
#include "app/workbench/picture_album.h"

namespace tactus::workbench {
namespace {

constexpr double kUsualDotsPerInch = 96;

// A screen says where she is; what lies over one is named by its file.
QString titleOf(const QWidget& screen, const QString& name) {
  return screen.accessibleName().isEmpty() ? QString(name).replace(QLatin1Char('_'), QLatin1Char(' '))
                                           : screen.accessibleName();
}

}  // namespace

base::Result<void> addParticipantPictures(PictureAlbum& album, const QString& language, const QSize& size) {
  nurse::Look look;
  if (const auto known = nurse::languageWithId(language)) look.setLanguage(*known);
  look.setScreen(kUsualDotsPerInch, size);
  for (const nurse::SampleScreen& sample : nurse::sampleScreens()) {
    ParticipantWindow window(look, [] {});
    window.resize(size);
    QWidget* const screen = sample.make(look).release();
    if (qobject_cast<nurse::PanelCard*>(screen) != nullptr) {
      window.setScreen(new nurse::RestScreen(look));
      window.cover(screen);
    } else {
      window.setScreen(screen);
    }
    window.show();
    const QString title = titleOf(*screen, sample.name);
    if (auto added = album.add(QStringLiteral("take_part"), sample.name, title, window); !added) return added;
    window.leave();
  }
  return {};
}

}  // namespace tactus::workbench
