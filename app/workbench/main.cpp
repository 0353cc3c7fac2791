// tactus-workbench [MODEL|STUDY]: the program with a window.
#include <QApplication>
#include <QIcon>
#include <QLocale>
#include <QSettings>
#include <csignal>
#include <cstdio>
#include <optional>

#include "app/version.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/base/utf8_locale.h"
#include "app/workbench/desktop/system_look.h"
#include "app/workbench/program_options.h"
#include "app/workbench/session/rehearse_start.h"
#include "app/workbench/session/take_part.h"
#include "app/workbench/workbench.h"

namespace {

using namespace tactus::workbench;

constexpr int kWrongUsage = 2;

int fail(const tactus::base::Error& error) {
  std::fprintf(stderr, "tactus-workbench: %s\n", error.message().c_str());
  return 1;
}

void nameProgram() {
  QApplication::setOrganizationName(QStringLiteral("Tactus"));
  QApplication::setApplicationName(QStringLiteral("tactus-workbench"));
  QApplication::setApplicationDisplayName(QStringLiteral("Tactus Workbench"));
  QApplication::setApplicationVersion(
      QString::fromUtf8(tactus::kVersion.data(), static_cast<qsizetype>(tactus::kVersion.size())));
}

int takePictures(QApplication& application, const PictureSettings& pictures) {
  calmForPictures();
  theme::apply(application, pictures.dark ? theme::Look::kDark : theme::Look::kLight);
  appearance::changeTextSize(application, pictures.text_percent);
  const auto written = writeScreenPictures(pictures);
  return written ? 0 : fail(written.error());
}

/// The screens of the participants, and the research mode once the researcher has left them.
int takePart(const QString& study, QSettings& settings) {
  // The window of the one mode closes before that of the other opens.
  QApplication::setQuitOnLastWindowClosed(false);
  std::optional<Workbench> workbench;
  TakePartStart start;
  QObject::connect(&start, &TakePartStart::left, &start, [&](const QString& path) {
    workbench.emplace(settings);
    workbench->window.show();
    QApplication::setQuitOnLastWindowClosed(true);
    workbench->files.open(path);
  });
  QObject::connect(
      &start, &TakePartStart::failed, &start,
      [](const QString& sentence) {
        std::fprintf(stderr, "tactus-workbench: %s\n", qPrintable(sentence));
        QApplication::exit(1);
      },
      Qt::QueuedConnection);
  start.open(study);
  return QApplication::exec();
}

/// A simulated nurse on these screens. 0 when all that she did is in the study.
int rehearse(const RehearseSettings& settings) {
  QApplication::setQuitOnLastWindowClosed(false);
  RehearseStart start(settings);
  const auto print = [](const QByteArray& line) {
    std::printf("%s\n", line.constData());
    std::fflush(stdout);
  };
  print(start.study().toLocal8Bit());
  QObject::connect(&start, &RehearseStart::came, &start, print);
  QObject::connect(
      &start, &RehearseStart::succeeded, &start, [] { QApplication::exit(0); }, Qt::QueuedConnection);
  QObject::connect(
      &start, &RehearseStart::failed, &start,
      [](const QString& sentence) {
        std::fprintf(stderr, "tactus-workbench: %s\n", qPrintable(sentence));
        QApplication::exit(1);
      },
      Qt::QueuedConnection);
  start.begin();
  return QApplication::exec();
}

QStringList argumentsOf(int argc, char** argv) {
  QStringList arguments;
  for (int i = 0; i < argc; ++i) arguments << QString::fromLocal8Bit(argv[i]);
  return arguments;
}

}  // namespace

int main(int argc, char** argv) {
  // A limit on the size of files is then an error that is told, as a full disk is.
  std::signal(SIGXFSZ, SIG_IGN);
  useUtf8Locale();
  QCommandLineParser first_look;
  describeOptions(first_look);
  first_look.parse(argumentsOf(argc, argv));
  const auto read = readOptions(first_look);
  if (!read) {
    fail(read.error());
    return kWrongUsage;
  }
  const auto& pictures = read->pictures;
  if (pictures) prepareForPictures(*pictures);

  QApplication application(argc, argv);
  nameProgram();
  QApplication::setWindowIcon(QIcon(QStringLiteral(":/tactus/icon.svg")));
  installTranslations(application, pictures ? QLocale(pictures->language) : QLocale());
  // In the language of the user: answers --help and --version, and refuses unknown options.
  QCommandLineParser arguments;
  describeOptions(arguments);
  if (!arguments.parse(QApplication::arguments())) {
    std::fprintf(stderr, "tactus-workbench: %s\n", qPrintable(arguments.errorText()));
    return kWrongUsage;
  }
  arguments.process(application);
  if (pictures) return takePictures(application, *pictures);

  QSettings settings;
  appearance::apply(application, settings);
  SystemLook system_look;
  QObject::connect(&system_look, &SystemLook::changed, &application,
                   [&](theme::Look look) { appearance::followSystem(application, settings, look); });
  system_look.refreshState();
  if (read->rehearse) return rehearse(*read->rehearse);
  if (!read->take_part.isEmpty()) return takePart(read->take_part, settings);
  Workbench workbench(settings);
  workbench.window.show();
  if (!read->file.isEmpty()) workbench.files.open(read->file);
  return QApplication::exec();
}
