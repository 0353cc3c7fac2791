#include "app/workbench/program_options.h"

#include <QApplication>
#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QRegularExpression>
#include <QTranslator>
#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/session/study_procedure.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/participant/kit/wordbook.h"
#include "core/base/error.h"
#include "core/base/text.h"

namespace tactus::workbench {
namespace {

bool add(QCoreApplication& application, const QLocale& locale, const QString& name, const QString& folder) {
  auto translator = std::make_unique<QTranslator>();
  if (!translator->load(locale, name, QStringLiteral("_"), folder)) return false;
  translator->setParent(&application);
  return QCoreApplication::installTranslator(translator.release());
}

}  // namespace

void installTranslations(QCoreApplication& application, const QLocale& locale) {
  const QString carried = QStringLiteral(":/i18n");
  const QString name = QStringLiteral("tactus");
  add(application, QLocale(QLocale::English), name, carried);
  if (locale.language() == QLocale::English || !add(application, locale, name, carried)) return;
  // The buttons of Qt's own dialogs, where the system has them.
  add(application, locale, QStringLiteral("qtbase"), QLibraryInfo::path(QLibraryInfo::TranslationsPath));
}

namespace {

struct OptionText {
  Q_DECLARE_TR_FUNCTIONS(OptionText)
};

constexpr auto kTakePart = "take-part";
constexpr auto kRehearse = "rehearse";
constexpr auto kSpeed = "speed";
constexpr auto kStudy = "study";
constexpr auto kScreens = "screens";
constexpr auto kSize = "size";
constexpr auto kScale = "scale";
constexpr auto kWidth = "width";
constexpr auto kText = "text";
constexpr auto kDark = "dark";
constexpr auto kLanguage = "language";
constexpr auto kPack = "pack";

constexpr int kSmallest = 320;  // px; below it no screen can be recognized
constexpr int kLargest = 8192;
constexpr double kLeastScale = 0.5;
constexpr double kMostScale = 4;
constexpr double kLeastSpeed = 0.1;
constexpr double kMostSpeed = 1000;

tl::unexpected<base::Error> refuse(const char* option, const QString& found, const char* wanted) {
  return base::fail(base::ErrorCode::kValue, std::string("--") + option, base::quoted(found.toStdString()), wanted);
}

base::Result<QSize> sizeOf(const QString& text) {
  static const QRegularExpression kPattern(QStringLiteral("^(\\d{1,5})x(\\d{1,5})$"));
  const auto match = kPattern.match(text);
  const QSize size(match.captured(1).toInt(), match.captured(2).toInt());
  const auto fits = [](int length) { return length >= kSmallest && length <= kLargest; };
  if (!fits(size.width()) || !fits(size.height())) {
    return refuse(kSize, text, "width and height in px, from 320 to 8192, as in 1280x720");
  }
  return size;
}

/// Those of the screens' own texts, and of the pack.
std::vector<QString> languagesOf(const PictureSettings& pictures) {
  std::vector<QString> out;
  for (const nurse::Language& language : nurse::kLanguages) out.push_back(language.id);
  if (pictures.pack == nullptr) return out;
  for (const std::string& language : pictures.pack->languages) {
    const QString id = QString::fromStdString(language);
    if (std::find(out.begin(), out.end(), id) == out.end()) out.push_back(id);
  }
  return out;
}

base::Result<PictureSettings> picturesOf(const QCommandLineParser& parser) {
  PictureSettings pictures;
  pictures.folder = parser.value(QLatin1String(kScreens));
  if (parser.isSet(QLatin1String(kSize))) {
    TACTUS_TRY(auto size, sizeOf(parser.value(QLatin1String(kSize))));
    pictures.size = size;
  }
  if (parser.isSet(QLatin1String(kScale))) {
    const QString text = parser.value(QLatin1String(kScale));
    bool number = false;
    pictures.scale = QLocale::c().toDouble(text, &number);
    if (!number || !(pictures.scale >= kLeastScale && pictures.scale <= kMostScale)) {
      return refuse(kScale, text, "a number from 0.5 to 4");
    }
  }
  if (parser.isSet(QLatin1String(kWidth))) {
    const QString text = parser.value(QLatin1String(kWidth));
    bool number = false;
    const int width = QLocale::c().toInt(text, &number);
    if (!number || width < kSmallest || width > kLargest) return refuse(kWidth, text, "px, from 320 to 8192");
    pictures.widest_px = width;
  }
  pictures.dark = parser.isSet(QLatin1String(kDark));
  if (parser.isSet(QLatin1String(kText))) {
    const QString text = parser.value(QLatin1String(kText));
    pictures.text_percent = QLocale::c().toInt(text);
    const auto& sizes = appearance::kTextSizes;
    if (std::find(sizes.begin(), sizes.end(), pictures.text_percent) == sizes.end())
      return refuse(kText, text, "100, 125 or 150");
  }
  if (parser.isSet(QLatin1String(kPack))) {
    TACTUS_TRY(pictures.pack, session::readPack(parser.value(QLatin1String(kPack)).toStdString()));
    pictures.language = QString::fromStdString(pictures.pack->languages.front());
  }
  if (parser.isSet(QLatin1String(kLanguage))) {
    pictures.language = parser.value(QLatin1String(kLanguage));
    const std::vector<QString> known = languagesOf(pictures);
    if (std::find(known.begin(), known.end(), pictures.language) == known.end()) {
      QStringList wanted(known.begin(), known.end() - 1);
      const QString list = wanted.join(QStringLiteral(", ")) + QStringLiteral(" or ") + known.back();
      return refuse(kLanguage, pictures.language, list.toUtf8().constData());
    }
  }
  pictures.study = parser.value(QLatin1String(kStudy));
  return pictures;
}

base::Result<RehearseSettings> rehearseOf(const QCommandLineParser& parser) {
  RehearseSettings rehearse;
  rehearse.study = parser.value(QLatin1String(kStudy));
  if (!parser.isSet(QLatin1String(kSpeed))) return rehearse;
  const QString text = parser.value(QLatin1String(kSpeed));
  bool number = false;
  rehearse.speed = QLocale::c().toDouble(text, &number);
  if (!number || !(rehearse.speed >= kLeastSpeed && rehearse.speed <= kMostSpeed)) {
    return refuse(kSpeed, text, "a number from 0.1 to 1000");
  }
  return rehearse;
}

/// An option that would be ignored: of the rehearsal or the pictures without them, or the second of two modes.
base::Result<void> requireTogether(const QCommandLineParser& parser) {
  const auto set = [&parser](const char* name) { return parser.isSet(QLatin1String(name)); };
  const auto alone = [](const char* option, const std::string& mode) {
    return base::fail(base::ErrorCode::kValue, std::string("--") + option, "it alone", "--" + mode + " beside it");
  };
  if (set(kSpeed) && !set(kRehearse)) return alone(kSpeed, kRehearse);
  for (const char* name : {kSize, kScale, kWidth, kText, kDark, kLanguage, kPack}) {
    if (set(name) && !set(kScreens)) return alone(name, kScreens);
  }
  if (set(kPack) && set(kStudy)) {
    return base::fail(base::ErrorCode::kValue, std::string("--") + kPack, "--study beside it",
                      "one of them: the screens of a pack need no study");
  }
  if (set(kStudy) && !set(kRehearse) && !set(kScreens)) {
    return base::fail(base::ErrorCode::kValue, std::string("--") + kStudy, "it alone",
                      "--rehearse or --screens beside it");
  }
  std::vector<std::string> modes;
  for (const char* name : {kTakePart, kRehearse, kScreens}) {
    if (set(name)) modes.push_back(std::string("--") + name);
  }
  const QStringList files = parser.positionalArguments();
  for (const QString& file : files) modes.push_back(base::quoted(file.toStdString()));
  if (modes.size() < 2) return {};
  return base::fail(base::ErrorCode::kValue, {}, base::joined(modes, " and "),
                    "one of them (the study of --rehearse and --screens is named by --study)");
}

}  // namespace

void describeOptions(QCommandLineParser& parser) {
  parser.setApplicationDescription(OptionText::tr("Explore force models of expert nurses."));
  parser.addHelpOption();
  parser.addVersionOption();
  const auto option = [&parser](const char* name, const QString& help, const QString& value) {
    parser.addOption({QLatin1String(name), help, value});
  };
  option(kTakePart, OptionText::tr("Show the screens of the participants of <study>, and nothing else."),
         OptionText::tr("study"));
  parser.addOption({QLatin1String(kRehearse),
                    OptionText::tr("A simulated nurse does a whole session on the screens; ends when it is stored.")});
  option(kSpeed, OptionText::tr("How many times faster than the clock the rehearsal is; 1 without this option."),
         OptionText::tr("factor"));
  option(kStudy,
         OptionText::tr(
             "The study of the rehearsal or of the pictures; without this option a new one, or the demo study."),
         OptionText::tr("study"));
  option(kScreens,
         OptionText::tr("Save a picture of every screen in <folder>, from the demo study, without a display."),
         OptionText::tr("folder"));
  option(kSize, OptionText::tr("Size of these pictures in px, before the scale; 1280x720 without this option."),
         OptionText::tr("WxH"));
  option(kScale, OptionText::tr("Scale of these pictures: 2 for a screen with twice the dots."),
         OptionText::tr("scale"));
  option(kWidth, OptionText::tr("Width in px above which these pictures are made smaller."), OptionText::tr("width"));
  option(kText, OptionText::tr("Size of the text of these pictures in percent: 100, 125 or 150."),
         OptionText::tr("percent"));
  parser.addOption({QLatin1String(kDark), OptionText::tr("These pictures in the dark look.")});
  option(kLanguage, OptionText::tr("Language of these pictures: en, zh-Hant, zh-Hans, or another one of the pack."),
         OptionText::tr("language"));
  option(kPack,
         OptionText::tr("Only the screens of the participants, for the procedure <pack>: a folder, or the name of one "
                        "that the program carries."),
         OptionText::tr("pack"));
  parser.addPositionalArgument(QStringLiteral("file"), OptionText::tr("A model (*.tactus.json) or a study (*.tactus)."),
                               QStringLiteral("[file]"));
}

base::Result<ProgramOptions> readOptions(const QCommandLineParser& parser) {
  if (auto ok = requireTogether(parser); !ok) return tl::unexpected(ok.error());
  ProgramOptions options;
  if (const QStringList files = parser.positionalArguments(); !files.isEmpty()) options.file = files.first();
  options.take_part = parser.value(QLatin1String(kTakePart));
  if (parser.isSet(QLatin1String(kRehearse))) {
    TACTUS_TRY(auto rehearse, rehearseOf(parser));
    options.rehearse = std::move(rehearse);
  }
  if (parser.isSet(QLatin1String(kScreens))) {
    TACTUS_TRY(auto pictures, picturesOf(parser));
    options.pictures = std::move(pictures);
  }
  return options;
}

void prepareForPictures(const PictureSettings& pictures) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  qputenv("QT_SCALE_FACTOR", QByteArray::number(pictures.scale));
}

void calmForPictures() {
  QLocale::setDefault(QLocale::c());
  QApplication::setCursorFlashTime(0);
  for (const Qt::UIEffect effect : {Qt::UI_AnimateMenu, Qt::UI_FadeMenu, Qt::UI_AnimateCombo, Qt::UI_AnimateTooltip,
                                    Qt::UI_FadeTooltip, Qt::UI_AnimateToolBox}) {
    QApplication::setEffectEnabled(effect, false);
  }
}

}  // namespace tactus::workbench
