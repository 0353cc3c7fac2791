#include "app/workbench/labs/depth/depth_lab.h"

#include <QBuffer>
#include <QComboBox>
#include <QDir>
#include <QImageReader>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <gtest/gtest.h>

#include "app/session/study_procedure.h"
#include "app/workbench/kit/number_box.h"
#include "app/workbench/labs/data/settings_price.h"
#include "app/workbench/labs/depth/depth_canvas.h"
#include "app/workbench/labs/depth/depth_lab_view.h"
#include "app/workbench/labs/depth/dicom_image.h"
#include "app/workbench/labs/depth/length_page.h"
#include "app/workbench/labs/frame/lab_screen.h"
#include "core/procedure/procedure.h"
#include "core/store/study_records.h"

#include "tests/gui/labs/lab_study_file.h"
#include "tests/gui/sample_study.h"

namespace tactus::workbench {
namespace {

using tests::comesTrue;

class DepthLabTest : public testing::Test {
 protected:
  void SetUp() override {
    tests::makeStudyFile(path);
    study.open(path);
    screen.addLab(QStringLiteral("Depth"), view, &lab);
    screen.resize(1200, 700);
    screen.show();
    ASSERT_TRUE(comesTrue([this] { return study.isOpen() && !study.isOpening(); }));
  }
  void settle() {
    ASSERT_TRUE(comesTrue([this] { return !study.isBusy(); }));
  }
  /// A gray image of 300 x 400 px as a file.
  QString imageFile() const {
    QImage image(300, 400, QImage::Format_Grayscale8);
    image.fill(Qt::lightGray);
    const QString file = folder.filePath(QStringLiteral("scan.png"));
    EXPECT_TRUE(image.save(file));
    return file;
  }
  void click(const elicitation::ImagePoint& point) {
    QTest::mouseClick(&view->canvas(), Qt::LeftButton, {}, view->canvas().onScreen(point).toPoint());
  }

  QTemporaryDir folder;
  QString path = folder.filePath(QStringLiteral("study.tactus"));
  StudyConnection study;
  LabData data{study};
  SettingsPrice price{data};
  DepthLab lab{data, [] { return QStringLiteral("tester"); }};
  LabScreen screen{data};
  DepthLabView* view = new DepthLabView(lab, price);
};

TEST_F(DepthLabTest, ClicksMakeTheWayAndEachIsStoredAndUndone) {
  view->load(imageFile());
  ASSERT_EQ(view->canvas().image().size(), QSize(300, 400));
  click({50, 50});
  click({50, 350});
  ASSERT_TRUE(lab.path());
  // 300 px of 0.33 mm; a click is a pixel of the screen, which is less than one of the image's millimeters.
  EXPECT_NEAR(lab.path()->lengthMm(), 99, 1.5);
  settle();
  QTest::keyClick(&screen, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_FALSE(lab.path());
  EXPECT_EQ(lab.measurement().path.size(), 1U);
  QTest::keyClick(&screen, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_TRUE(lab.path());
  settle();
  const auto kept = lab.measurement();

  // It is there after the study was closed.
  study.close();
  ASSERT_TRUE(comesTrue([this] { return !study.isOpen(); }));
  EXPECT_TRUE(lab.measurement().path.empty());
  const auto stored = store::depthMeasurement(tests::lookInto(path));
  ASSERT_TRUE(stored && *stored);
  EXPECT_TRUE((*stored)->image_of) << "the image is stored once";
  study.open(path);
  ASSERT_TRUE(comesTrue([&] { return lab.measurement() == kept; }));
  EXPECT_EQ(view->canvas().image().size(), QSize(300, 400));
}

TEST_F(DepthLabTest, ADraggedBoundaryMovesTheTerms) {
  view->showExample();
  ASSERT_TRUE(lab.path());
  const QPointF from = view->canvas().onScreen(lab.path()->at(70));
  const QPointF to = view->canvas().onScreen(lab.path()->at(80));
  QTest::mousePress(&view->canvas(), Qt::LeftButton, {}, from.toPoint());
  QMouseEvent move(QEvent::MouseMove, to, view->canvas().mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
  QCoreApplication::sendEvent(&view->canvas(), &move);
  QTest::mouseRelease(&view->canvas(), Qt::LeftButton, {}, to.toPoint());
  EXPECT_NEAR(lab.measurement().boundaries[0].depth_mm, 80, 1);
  EXPECT_NEAR(lab.terms().terms[0].points[3], 90, 1);
  EXPECT_NEAR(lab.terms().terms[1].points[0], 70, 1);
}

// facts/participant.md 1.4: the landmarks of the drawing, mm, at their depths.
TEST_F(DepthLabTest, TheExampleHasItsDepthsWithinAMillimeter) {
  const auto drawn = exampleImage(*procedure::defaultProcedure());
  ASSERT_TRUE(drawn);
  const ExampleImage& example = *drawn;
  // Of any procedure with a picture whose way is as long as it says.
  EXPECT_TRUE(exampleImage(*procedure::builtIn("male-urethral-catheter")));
  auto bent = *procedure::defaultProcedure();
  bent.pictures.front().way_mm[bent.pictures.front().way_mm.size() / 2] += 20;
  EXPECT_FALSE(exampleImage(bent));
  bent.pictures.clear();
  EXPECT_FALSE(exampleImage(bent));
  const auto way = elicitation::TubePath::through(example.path, example.mm_per_px);
  ASSERT_TRUE(way);
  EXPECT_NEAR(example.mm_per_px, 0.33, 0.001);
  EXPECT_NEAR(way->lengthMm(), 514, 1);
  // The drawing is 620 mm high and begins at (-152, -168) mm; narrower than the image, so it is in its middle.
  const double left_mm = -152 + 412 / 2.0 - example.image.width() * example.mm_per_px / 2;
  const double top_mm = -168 + 620 / 2.0 - example.image.height() * example.mm_per_px / 2;
  struct Row {
    double depth_mm, x, y;
  };
  for (const Row& row : {Row{20, 16.3, -7.8},
                         {64, 60, -2.3},
                         {94, 85.6, 10},
                         {115, 90.1, 30.4},
                         {150, 90.5, 65.4},
                         {200, 102, 113.9},
                         {290, 127.5, 200},
                         {440, 105.4, 343.9},
                         {470, 96.7, 372.5}}) {
    const elicitation::ImagePoint place{(row.x - left_mm) / example.mm_per_px, (row.y - top_mm) / example.mm_per_px};
    EXPECT_NEAR(way->depthNear(place), row.depth_mm, 1) << row.depth_mm;
  }
}

TEST_F(DepthLabTest, WhatIsNoImageIsSaid) {
  EXPECT_FALSE(readImage("no image", QStringLiteral("a.txt")));
  EXPECT_FALSE(isDicom("no image"));
}

// Two gray pixels, uncompressed, in the fewest tags that a baseline TIFF has (TIFF 6.0, section 4).
QByteArray smallTiff() {
  QByteArray bytes("II*\0\x08\0\0\0\x08\0", 10);
  const auto tag = [&](int number, int type, int value) {
    for (const int two : {number, type, 1, 0, value, 0}) {
      bytes += static_cast<char>(two & 0xff);
      bytes += static_cast<char>(two >> 8);
    }
  };
  tag(256, 3, 2);    // columns
  tag(257, 3, 1);    // rows
  tag(258, 3, 8);    // bits
  tag(259, 3, 1);    // no compression
  tag(262, 3, 1);    // 0 is black
  tag(273, 4, 110);  // where the pixels begin: 8 + 2 + 8 tags of 12 bytes + 4
  tag(278, 3, 1);    // rows in the strip
  tag(279, 4, 2);    // bytes of the strip
  return bytes + QByteArray("\0\0\0\0\x20\xe0", 6);
}

TEST_F(DepthLabTest, ATiffImageIsReadOrTheMissingPackageIsNamed) {
  const auto image = readImage(smallTiff(), QStringLiteral("scan.tif"));
  if (QImageReader::supportedImageFormats().contains("tiff")) {
    ASSERT_TRUE(image) << image.error().message();
    EXPECT_EQ(image->size(), QSize(2, 1));
    EXPECT_EQ(qGray(image->pixel(0, 0)), 0x20);
    EXPECT_EQ(qGray(image->pixel(1, 0)), 0xe0);
  } else {
    EXPECT_EQ(image.error().message(),
              "scan.tif: found a TIFF image, wanted PNG or JPEG, or the package qt6-image-formats-plugins, with which "
              "TIFF can be read");
  }
}

// A camera held upright writes lying pixels and the turn as a number (EXIF 2.3, Orientation 6: turn right).
TEST_F(DepthLabTest, AnUprightPhotographStandsUpright) {
  QImage lying(40, 20, QImage::Format_RGB32);
  lying.fill(Qt::black);
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 10; ++x) lying.setPixel(x, y, qRgb(255, 255, 255));
  }
  QByteArray jpeg;
  QBuffer buffer(&jpeg);
  buffer.open(QIODevice::WriteOnly);
  ASSERT_TRUE(lying.save(&buffer, "JPEG", 95));
  const QByteArray exif(
      "\xff\xe1\0\x22"
      "Exif\0\0MM\0*\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0\x06\0\0\0\0\0\0",
      36);
  const auto image = readImage(jpeg.left(2) + exif + jpeg.mid(2), QStringLiteral("photo.jpg"));
  ASSERT_TRUE(image) << image.error().message();
  ASSERT_EQ(image->size(), QSize(20, 40));
  // What was at the left is at the top.
  EXPECT_GT(qGray(image->pixel(10, 3)), 200);
  EXPECT_LT(qGray(image->pixel(10, 35)), 50);
}

// The study holds the image itself.
TEST_F(DepthLabTest, AnImageThatIsDeletedLaterStaysInTheStudy) {
  const QString file = imageFile();
  view->load(file);
  settle();
  ASSERT_TRUE(QFile::remove(file));
  study.close();
  ASSERT_TRUE(comesTrue([this] { return !study.isOpen(); }));
  study.open(path);
  ASSERT_TRUE(comesTrue([this] { return !lab.image().isEmpty(); }));
  EXPECT_EQ(view->canvas().image().size(), QSize(300, 400));
}

// Where DCMTK or GDCM are installed, the sentence is theirs; where they are not, it names them.
TEST_F(DepthLabTest, ADicomFileWithoutAPictureIsRefused) {
  QByteArray dicom(128, '\0');
  dicom += "DICM";
  ASSERT_TRUE(isDicom(dicom));
  const auto refused = dicomImage(dicom, QStringLiteral("scan.dcm"));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message().find("scan.dcm: found a DICOM image"), 0U) << refused.error().message();
  // On the screen it comes from another thread, and the study stays without an image.
  const QString file = folder.filePath(QStringLiteral("scan.dcm"));
  QFile bytes(file);
  ASSERT_TRUE(bytes.open(QIODevice::WriteOnly));
  bytes.write(dicom);
  bytes.close();
  view->load(file);
  ASSERT_TRUE(comesTrue([this] { return !view->isConverting(); }));
  EXPECT_TRUE(lab.image().isEmpty());
}

// The programs themselves are stand-ins here: what they are asked for, and what is made of their answers.
TEST_F(DepthLabTest, AConvertedDicomImageBringsItsScale) {
  const QString programs = folder.filePath(QStringLiteral("bin"));
  ASSERT_TRUE(QDir().mkdir(programs));
  const auto script = [&](const char* name, const QByteArray& body) {
    QFile file(programs + QLatin1Char('/') + QLatin1String(name));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("#!/bin/sh\n" + body);
    file.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
  };
  // Without a window of gray values in the file the first way fails.
  script("dcm2pnm", "[ \"$2\" = --use-window ] && exit 1\n/bin/cp '" + imageFile().toUtf8() + "' \"$4\"\n");
  // It prints three pictures; the first program writes one of them only by its number.
  script(
      "dcmdump",
      "printf '%s\\n' '(0028,0008) IS [3]   # 2, 1 NumberOfFrames' '(0028,0030) DS [0.5\\0.5]   # 8, 2 PixelSpacing' "
      "'(7fe0,0010) OB 00\\00   # 2, 1 PixelData'\n");
  script("dcmj2pnm",
         "[ \"$2$3$4\" = --min-max-window--frame2 ] || exit 1\n/bin/cp '" + imageFile().toUtf8() + "' \"$6\"\n");
  const QByteArray path_before = qgetenv("PATH");
  qputenv("PATH", programs.toUtf8());
  QByteArray dicom(128, '\0');
  dicom += "DICM";
  const auto image = dicomImage(dicom, QStringLiteral("scan.dcm"));
  const int pictures = dicomPictures(dicom);
  ASSERT_TRUE(QFile::remove(programs + QStringLiteral("/dcm2pnm")));
  const auto second = dicomImage(dicom, QStringLiteral("scan.dcm"), 2);
  const auto third = dicomImage(dicom, QStringLiteral("scan.dcm"), 3);
  script("dcmdump", "printf '%s\\n' '(0002,0010) UI =LittleEndianExplicit  # 20, 1 TransferSyntaxUID'\n");
  const auto none = dicomImage(dicom, QStringLiteral("report.dcm"));
  script("dcmdump", "echo 'F: premature end of stream' >&2\nexit 1\n");
  const auto half = dicomImage(dicom, QStringLiteral("half.dcm"));
  script(
      "dcmdump",
      "printf '%s\\n' '(0002,0010) UI =MPEG2MainProfileAtMainLevel  # 20, 1' '(7fe0,0010) OB (PixelSequence #=2)'\n");
  const auto film = dicomImage(dicom, QStringLiteral("film.dcm"));
  qputenv("PATH", path_before);
  EXPECT_EQ(pictures, 3);
  EXPECT_TRUE(second);
  const auto said = [](const base::Result<DicomImage>& result) {
    return result ? std::string("an image") : result.error().message();
  };
  EXPECT_EQ(said(third),
            "scan.dcm: found a DICOM image that the installed programs cannot convert, wanted one without compression, "
            "or PNG, JPEG or TIFF");
  EXPECT_EQ(said(none), "report.dcm: found a DICOM file without an image, wanted one with an image");
  EXPECT_EQ(said(half), "half.dcm: found a DICOM image that ends too early, wanted the whole file: copy it again");
  EXPECT_EQ(said(film),
            "film.dcm: found a DICOM image that the installed programs cannot convert (MPEG2MainProfileAtMainLevel), "
            "wanted one without compression, or PNG, JPEG or TIFF");
  ASSERT_TRUE(image) << image.error().message();
  EXPECT_EQ(QImage::fromData(image->png).size(), QSize(300, 400));
  EXPECT_EQ(image->mm_per_px, 0.5);
  lab.setImage(image->png, QStringLiteral("scan.dcm"), image->mm_per_px);
  EXPECT_EQ(lab.measurement().mm_per_px, 0.5);
}

TEST_F(DepthLabTest, TheModelTakesTheMeasuredDepthsOnlyOnRequest) {
  data.hold(lab);
  ASSERT_TRUE(comesTrue([this] { return data.study() != nullptr; }));
  EXPECT_FALSE(lab.isMeasured());
  view->showExample();
  EXPECT_TRUE(lab.isMeasured());
  EXPECT_EQ(data.settings().depths, elicitation::DepthsFrom::kTemplate);
  auto* const page = view->findChild<DepthTermPage*>();
  ASSERT_NE(page, nullptr);
  page->choice().setCurrentIndex(1);
  emit page->choice().activated(1);
  EXPECT_EQ(data.settings().depths, elicitation::DepthsFrom::kMeasured);
  EXPECT_EQ(data.settings().measured_depths, lab.measurement());
  // What is measured next is what the model has next.
  QSignalSpy changed(&data, &LabData::settingsChanged);
  auto wanted = lab.measurement();
  wanted.scale = 0.93;
  lab.show(wanted);
  lab.commit(QStringLiteral("scale"));
  EXPECT_EQ(data.settings().measured_depths->scale, 0.93);
  EXPECT_EQ(changed.size(), 1);
  lab.undo();
  EXPECT_EQ(data.settings().measured_depths->scale, 1);
  settle();
}

// The study of the demo has answers, so a change of its depths has a price.
TEST(DepthPrice, TheNextMeasurementHasItsPriceBesideTheTermsOfBefore) {
  QTemporaryDir folder;
  StudyConnection study;
  LabData data(study);
  SettingsPrice price(data);
  DepthLab lab(data, [] { return QStringLiteral("tester"); });
  LabScreen screen(data);
  auto* const view = new DepthLabView(lab, price);
  screen.addLab(QStringLiteral("Depth"), view, &lab);
  screen.resize(1200, 700);
  screen.show();
  study.open(tests::demoStudyIn(folder));
  data.hold(lab);
  ASSERT_TRUE(comesTrue([&] { return data.study() != nullptr; }));
  view->showExample();
  lab.setDepthsFrom(elicitation::DepthsFrom::kMeasured);
  price.setSeen(true);
  QTest::qWait(SettingsPrice::kTogetherMs + 100);  // what follows sooner is one change with this one
  const std::vector<fuzzy::Term> before = lab.terms().terms;
  auto wanted = lab.measurement();
  wanted.scale = 0.93;
  lab.show(wanted);
  lab.commit(QStringLiteral("scale"));
  ASSERT_TRUE(comesTrue([&] { return price.sentence().contains(QStringLiteral("at most")); }))
      << price.sentence().toStdString();
  EXPECT_TRUE(price.sentence().contains(QStringLiteral("measured depths"))) << price.sentence().toStdString();
  // The form asks about five regions, of which the esophagus reaches the end; the others are as they were measured.
  const auto former = price.formerTerms(lab.depth().id);
  ASSERT_EQ(former.size(), 5U);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(former[i], before[i]) << before[i].id;
  ASSERT_TRUE(comesTrue([&] { return !study.isBusy(); }));
}

// 0.38696 * 52.5 = 20.3154, plus 30.37 or 36.37 cm; the target is 47 to 54 cm with the template's sphincter at 44 cm.
TEST_F(DepthLabTest, ATypedLengthGivesThreeFormulasAndIsStored) {
  auto* const page = view->findChild<LengthPage*>();
  ASSERT_NE(page, nullptr);
  NumberBox& box = page->lengthBox();
  box.selectAll();
  QTest::keyClicks(&box, QStringLiteral("52,5"));
  QTest::keyClick(&box, Qt::Key_Return);
  EXPECT_EQ(lab.measurement().nose_ear_xiphoid_mm, 525);
  EXPECT_EQ(page->lengthText(0), QStringLiteral("52.5 cm"));
  EXPECT_EQ(page->lengthText(1), QStringLiteral("50.7 cm"));
  EXPECT_EQ(page->lengthText(2), QStringLiteral("56.7 cm"));
  EXPECT_TRUE(page->targetText().contains(QStringLiteral("47 to 54 cm"))) << page->targetText().toStdString();
  auto wanted = lab.measurement();
  wanted.boundaries.back().depth_mm = 420;
  lab.show(wanted);
  EXPECT_TRUE(page->targetText().contains(QStringLiteral("45 to 52 cm"))) << page->targetText().toStdString();
  settle();
  study.close();
  ASSERT_TRUE(comesTrue([this] { return !study.isOpen(); }));
  study.open(path);
  ASSERT_TRUE(comesTrue([this] { return lab.measurement().nose_ear_xiphoid_mm == 525; }));
}

TEST_F(DepthLabTest, MeasuresTheWayOfAnotherProcedure) {
  data.hold(lab);
  const auto catheter = procedure::builtIn("male-urethral-catheter");
  const QString other = folder.filePath(QStringLiteral("catheter.tactus"));
  tests::makeStudyFile(other, [&catheter](store::StudyFile& file, study::RecordIds& ids) {
    session::SessionTools tools{[] { return study::Moment{1, 1}; }, ids};
    ASSERT_TRUE(session::keepProcedure(file, catheter, tools));
  });
  study.open(other);
  ASSERT_TRUE(comesTrue([&] { return lab.depth() == catheter->wayInput(); }));
  ASSERT_TRUE(comesTrue([this] { return study.isOpen() && !study.isOpening() && !study.isBusy(); }));
  ASSERT_EQ(lab.measurement().boundaries.size(), 5U);
  EXPECT_TRUE(comesTrue([this] {
    const auto labels = view->findChildren<QLabel*>();
    return std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
      return label->isVisible() && label->text().startsWith(QStringLiteral("Prostate |"));
    });
  }));
  // Its picture is an example too.
  const auto buttons = view->findChildren<QPushButton*>();
  EXPECT_TRUE(std::any_of(buttons.begin(), buttons.end(), [](const QPushButton* button) {
    return button->isVisible() && button->text().remove(QLatin1Char('&')).contains(QStringLiteral("example"));
  }));
  auto wanted = lab.measurement();
  wanted.boundaries[0].depth_mm += 2;
  lab.show(wanted);
  lab.commit(QStringLiteral("boundary"));
  ASSERT_TRUE(comesTrue([this] { return !study.isBusy(); }));
  EXPECT_NE(lab.terms().terms, catheter->wayInput().terms);
  study.open(path);
  ASSERT_TRUE(comesTrue([&] { return lab.depth() == procedure::defaultProcedure()->wayInput(); }));
  const auto stored = store::depthMeasurement(tests::lookInto(other));
  ASSERT_TRUE(stored && *stored);
  EXPECT_EQ(elicitation::readMeasurement((*stored)->text)->boundaries[0].depth_mm, wanted.boundaries[0].depth_mm);
}

}  // namespace
}  // namespace tactus::workbench
