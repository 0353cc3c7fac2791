// Text that people see goes through tr(), so that lupdate finds it. What grep can see of that: literals of the
// workbench that read as words, and literals given to what shows text. What it cannot see:
// tests/gui/visible_text_test.cpp.
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "tests/architecture/cpp_literals.h"

namespace tactus {
namespace {

namespace fs = std::filesystem;
using tests::Literal;
using tests::literalsOf;

// Calls, with spaces around their names. A text in one of these is translated, or is no text of the screen: patterns of
// dates, the widest text of a field, names of classes, objects and styles. Errors are English sentences, made by
// core/base/error.h. `phrase` and `counted` take ids of the nurse's texts, of which an unknown one stops the program.
constexpr std::string_view kNotShown =
    " tr translate QT_TRANSLATE_NOOP toString horizontalAdvance inherits setObjectName create fail inFile refuse "
    "too_many qputenv phrase "
    "counted ";

// Give a text to the screen: a literal with letters in it is seen.
constexpr std::string_view kShows =
    " setText setFullText setToolTip setStatusTip setWhatsThis setWindowTitle setTitle setAccessibleName"
    " setAccessibleDescription setPlaceholderText setPrefix setSuffix setSpecialValueText setTabText setTabToolTip "
    "setNote"
    " setLabel setDescription addAction addMenu addItem addRow addTab addField insertItem insertTab QLabel QPushButton"
    " QCheckBox QRadioButton QGroupBox QCommandLinkButton QAction QMenu PopupForm drawText drawElided showError "
    "showNote"
    " showMessage say sayError sayDone said refused failed reported restored about question warning critical "
    "information ";

struct Exception {
  std::string_view file;  ///< the end of its path
  std::string_view text;
  std::string_view reason;
};

constexpr Exception kExceptions[] = {
    {"plot/landmark_marks.cpp", "%1  %2, %3 mm: %4 (%5)", "a unit"},
    {"feel/feel_panel.cpp", "<span style=\\\"color:%1\\\">■</span> %2", "marks without a word"},
    {"feel/feel_panel.cpp", "<br>", "markup"},
    {"base/utf8_locale.cpp", "UTF-8", "the name of an encoding"},
    {"base/utf8_locale.cpp", "LC_ALL", "the name of a variable"},
    {"base/utf8_locale.cpp", "LC_MESSAGES", "the name of a variable"},
    {"base/utf8_locale.cpp", "LANG", "the name of a variable"},
    {"workbench/main.cpp", "Tactus", "the folder of the settings"},
    {"participant/participant_window.cpp", "Tactus", "the name of the program"},
    {"screens/sample_screens.cpp", "thunderstorm marmalade", "a code"},
    {"screens/sample_screens.cpp", "School of Nursing, 2766 0000", "of the sample study"},
    {"workbench/main.cpp", "tactus-workbench: %s\\n", "the command line"},
    {"workbench/main.cpp", "Tactus Workbench", "the name of the program"},
    {"plot/plot_menu.cpp", "PNG", "the name of a format"},
    {"labs/depth/dicom_image.cpp", "DICM", "the mark of a format"},
    {"labs/depth/dicom_image.cpp", "PNG", "the name of a format"},
    {"labs/depth/dicom_image.cpp", "premature end", "in what a program prints"},
    {"labs/depth/depth_lab_view.cpp", "II*\\0", "the mark of a format"},
    {"labs/depth/depth_lab_view.cpp", "MM\\0*", "the mark of a format"},
    {"base/file_dialog.cpp", "fileNameEdit", "the name of a widget"},
    {"base/theme.cpp", "Fusion", "the name of a style"},
    {"labs/frame/lab_card.cpp", "Fusion", "the name of a style"},
    {"desktop/system_look.cpp", "org.freedesktop.portal.Desktop", "a name on the bus"},
    {"desktop/system_look.cpp", "org.freedesktop.portal.Settings", "a name on the bus"},
    {"desktop/system_look.cpp", "SettingChanged", "a name on the bus"},
    {"desktop/system_look.cpp", "Read", "a name on the bus"},
    {"understand/curves/curve_overlays.cpp", "under the curves", "the name of a layer"},
    {"understand/curves/curve_overlays.cpp", "over the curves", "the name of a layer"},
    {"anatomy/picture_view.cpp",
     "<path id=\\\"lit\\\" d=\\\"%1\\\" fill=\\\"%2\\\" stroke=\\\"%3\\\" stroke-width=\\\"%4\\\" ", "markup"},
    {"anatomy/picture_view.cpp", "<svg xmlns=\\\"http://www.w3.org/2000/svg\\\" viewBox=\\\"%1 %2 %3 %4\\\">%5</svg>",
     "markup"},
    {"tune/contracts/contract_form.cpp", "JND", "a unit"},
    {"participant/kit/wordbook.h", "zh-Hant", "the id of a language"},
    {"participant/kit/wordbook.h", "zh-Hans", "the id of a language"},
    {"workbench/program_options.cpp", " or ", "what is wanted, in an error"},
    {"participant/kit/participant_state.h", "zh-Hant", "the id of a language"},
    {"participant/kit/participant_state.h", "zh-Hans", "the id of a language"},
    {"participant/kit/wordbook.cpp", "DejaVu Sans", "the name of a font"},
    {"participant/kit/wordbook.cpp", "Noto Sans CJK TC", "the name of a font"},
    {"participant/kit/wordbook.cpp", "Noto Sans CJK SC", "the name of a font"},
    {"shell/demo_maker.cpp", "Tactus demo", "the name of a folder, found again in every language"},
    {"base/display_text.cpp", "English", "a language by its own name"},
    {"collect/protocol_view.cpp", "zh-Hant", "the id of a language"},
    {"collect/protocol_view.cpp", "zh-Hans", "the id of a language"},
    {"base/display_text.cpp", "zh-Hant", "the id of a language"},
    {"base/display_text.cpp", "zh-Hans", "the id of a language"},
    {"collect/protocol_controller.cpp", "language '", "the place in an error"},
    {"workbench/collect_pictures.cpp", "zh-Hant", "the id of a language"},
    {"workbench/collect_pictures.cpp", "This study is run by the School of Nursing. Questions: ask the researcher.",
     "stored in the study of the pictures"},
    {"workbench/features/study_feature.cpp", "Study", "stands in the report, which is in English"},
    {"workbench/features/study_feature.cpp", "Program", "stands in the report, which is in English"},
    {"workbench/features/study_feature.cpp", "Created (UTC)", "stands in the report, which is in English"},
    {"feel/recordings/feel_store.cpp", " alone", "stored in the study, the same in every language"},
};

bool isLetter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

bool hasWord(std::string_view text) {
  for (std::size_t i = 0; i + 1 < text.size(); ++i) {
    if (isLetter(text[i]) && isLetter(text[i + 1])) return true;
  }
  return false;
}

// Ids are one lower-case word, with underscores; names of files and settings have dots, slashes and dashes.
bool readsAsWords(std::string_view text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == ' ') return true;
    if (std::isupper(static_cast<unsigned char>(text[i])) != 0 && i + 1 < text.size() && isLetter(text[i + 1])) {
      return true;
    }
  }
  return false;
}

bool isFileEnding(std::string_view text) { return text.starts_with('.') || text.starts_with(":/"); }

bool isOneOf(const std::string& call, std::string_view names) {
  const auto colons = call.rfind("::");
  const std::string name = colons == std::string::npos ? call : call.substr(colons + 2);
  return !name.empty() && names.find(' ' + name + ' ') != std::string_view::npos;
}

bool isBare(const Literal& literal) {
  if (!hasWord(literal.text) || isFileEnding(literal.text)) return false;
  const auto stands_in = [&](std::string_view names) {
    return std::any_of(literal.calls.begin(), literal.calls.end(),
                       [&](const std::string& call) { return isOneOf(call, names); });
  };
  if (stands_in(kNotShown)) return false;
  return readsAsWords(literal.text) || stands_in(kShows);
}

const Exception* exceptionFor(const std::string& file, const Literal& literal) {
  const auto* const it = std::find_if(std::begin(kExceptions), std::end(kExceptions), [&](const Exception& exception) {
    return file.ends_with(exception.file) && literal.text == exception.text;
  });
  return it == std::end(kExceptions) ? nullptr : it;
}

std::vector<std::string> bareTexts(std::string_view source) {
  std::vector<std::string> out;
  for (const Literal& literal : literalsOf(source)) {
    if (isBare(literal)) out.push_back(literal.text);
  }
  return out;
}

TEST(BareText, IsSeenWhereItIsGivenToTheScreen) {
  EXPECT_EQ(bareTexts("label->setText(QStringLiteral(\"over\"));"), std::vector<std::string>{"over"});
  EXPECT_EQ(bareTexts("new QLabel(on ? tr(\"On\") : QString(\"off\"), this)"), std::vector<std::string>{"off"});
  EXPECT_EQ(bareTexts("constexpr auto kTitle = \"Force here\";"), std::vector<std::string>{"Force here"});
  EXPECT_EQ(bareTexts("// \"A comment\"\nint n = 1'000; char c = '\"'; auto s = \"A \\\" quote\";"),
            std::vector<std::string>{"A \\\" quote"});
}

TEST(BareText, IsNothingThatIsTranslatedOrNoWord) {
  for (const char* source :
       {"label->setText(tr(\"Over\"));", "setText(Words::tr(\"%1 of %2\").arg(tr(\"a b\")))", "setLabel(\"N\")",
        "settings.value(QLatin1String(\"curves/ghost\"))", "parts.join(QStringLiteral(\" · \"))",
        "#include \"A header.h\"\n", "path + QStringLiteral(\".tactus.json\")", "setText(when.toString(\"HH:mm\"))"}) {
    EXPECT_EQ(bareTexts(source), std::vector<std::string>()) << source;
  }
}

TEST(BareText, IsNowhereInTheWorkbench) {
  int seen = 0;
  std::set<const Exception*> used;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(TACTUS_SOURCE_DIR) / "app" / "workbench")) {
    const std::string path = entry.path().generic_string();
    if (!path.ends_with(".h") && !path.ends_with(".cpp")) continue;
    std::ifstream file(entry.path());
    const std::string source{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    for (const Literal& literal : literalsOf(source)) {
      ++seen;
      if (!isBare(literal)) continue;
      const Exception* const exception = exceptionFor(path, literal);
      used.insert(exception);
      EXPECT_NE(exception, nullptr) << path << ":" << literal.line << ": \"" << literal.text
                                    << "\" is seen, but not translated: tr() it, or enter it above";
    }
  }
  EXPECT_GT(seen, 800);
  for (const Exception& exception : kExceptions) {
    EXPECT_TRUE(used.contains(&exception)) << "no longer needed: " << exception.text << ", " << exception.reason;
  }
}

}  // namespace
}  // namespace tactus
