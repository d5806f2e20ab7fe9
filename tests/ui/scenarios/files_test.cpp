// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/projector_file.h"
#include "cad2slam/io/sha256.h"
#include "ui/document/project_commands.h"
#include "ui/main_window/exports.h"
#include "ui/main_window/program_actions.h"
#include "ui/main_window/recovery.h"
#include "ui/main_window/report.h"
#include "ui/support/documents.h"
#include "ui/support/office_window.h"

#include <QFile>
#include <QMessageBox>
#include <QPushButton>
#include <QRegularExpression>
#include <QTimer>

#include <algorithm>
#include <csignal>

#include <sys/resource.h>

using namespace cad2slam;
using test::OfficeWindow;

namespace {

bool copyOffice(const QString& to) {
  bool good = QDir().mkpath(to);
  for (const char* name : {"blueprint.yaml", "blueprint.png", "slam_1.yaml", "slam_1.png"})
    good = good && QFile::copy(OfficeWindow::sample(name), to + QLatin1Char('/') + QLatin1String(name));
  return good;
}

void write(const QString& path, const QByteArray& text) {
  QFile file(path);
  QVERIFY(file.open(QIODevice::WriteOnly));
  file.write(text);
}

/// Presses a button of the question that is about to come up.
void answerNextQuestion(QMessageBox::StandardButton button) {
  auto* timer = new QTimer(qApp);
  QObject::connect(timer, &QTimer::timeout, timer, [timer, button] {
    auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    if (!box) return;
    timer->deleteLater();
    box->button(button)->click();
  });
  timer->start(20);
}

/// While it lives no file of this process can grow beyond so many bytes: what a full disk does.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit small{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallDisk() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

 private:
  void (*handler_)(int);
  rlimit before_{};
};

}  // namespace

class FilesTest : public QObject {
  Q_OBJECT

 private:
  std::optional<test::Sandbox> sandbox_;

 private slots:
  void init() { sandbox_.emplace(); }

  void saveAndOpenGiveTheSameProject() {
    const QString path = sandbox_->path(QStringLiteral("site.c2sproj"));
    std::string saved;
    {
      OfficeWindow office;
      office.addExact(5);
      office.click(Side::kSlam, {1.0, 1.0});
      office.window.view(Side::kBlueprint).zoomBy(3.0);
      QVERIFY(office.window.files().saveProjectTo(path));
      QVERIFY(!office.document().isModified());
      saved = test::fingerprint(office.document());
    }
    OfficeWindow again(false);
    QVERIFY(again.window.files().openProject(path));
    QVERIFY(again.waitUntilReady());
    QCOMPARE(test::fingerprint(again.document()), saved);
    QVERIFY(again.document().pending().has_value());
    QVERIFY(!again.document().isModified());
    QVERIFY(again.waitUntilSolved());
  }

  void viewsAreWhereTheyWereAndFittedOnesFitAnyWindow() {
    const QString path = sandbox_->path(QStringLiteral("site.c2sproj"));
    ViewState moved;
    {
      OfficeWindow office;
      office.window.view(Side::kSlam).zoomBy(3.0);
      office.window.view(Side::kSlam).setRotation(0.5);
      moved = office.window.view(Side::kSlam).viewState();
      QVERIFY(office.window.view(Side::kBlueprint).isFitted());
      QVERIFY(office.window.files().saveProjectTo(path));
    }
    OfficeWindow again(false);
    again.window.resize(1000, 700);
    QVERIFY(again.window.files().openProject(path));
    QVERIFY(again.waitUntilReady());
    QVERIFY(again.window.view(Side::kSlam).viewState() == moved);
    const MapView& blueprint = again.window.view(Side::kBlueprint);
    QTRY_VERIFY_WITH_TIMEOUT(blueprint.isFitted(), test::kPatience);
    const MapFrame& frame = *blueprint.frame();
    for (const Eigen::Vector2d& corner : {Eigen::Vector2d(0, 0), Eigen::Vector2d(frame.width(), frame.height())})
      QVERIFY(blueprint.isInView(toQPointF(frame.metricFromPixel(corner)), 0.0));
  }

  void aProjectSavedBeforeItsImagesWereReadOpensFitted() {
    const QString path = sandbox_->path(QStringLiteral("site.c2sproj"));
    {
      MainWindow window;  // never shown, and saved at once
      QVERIFY(window.files().setImage(Side::kBlueprint, OfficeWindow::sample("blueprint.yaml")));
      QVERIFY(window.files().setImage(Side::kSlam, OfficeWindow::sample("slam_1.yaml")));
      QVERIFY(window.files().saveProjectTo(path));
    }
    OfficeWindow again(false);
    QVERIFY(again.window.files().openProject(path));
    QVERIFY(again.waitUntilReady());
    for (const Side side : {Side::kBlueprint, Side::kSlam})
      QTRY_VERIFY_WITH_TIMEOUT(again.window.view(side).isFitted(), test::kPatience);
  }

  void scenario19_aFolderThatCannotBeWrittenKeepsTheOldFile() {
    OfficeWindow office;
    office.addExact(3);
    const QString file = sandbox_->path(QStringLiteral("file"));
    write(file, "not a folder");
    QVERIFY(!office.window.files().saveProjectTo(file + QStringLiteral("/site.c2sproj")));
    QVERIFY(office.document().isModified());
    QVERIFY(office.hasMessage(QStringLiteral("save")));
    QVERIFY(office.window.files().saveProjectTo(sandbox_->path(QStringLiteral("elsewhere.c2sproj"))));
    QVERIFY(!office.hasMessage(QStringLiteral("save")) || office.hasMessage(QStringLiteral("saved")));
  }

  void scenario19_aFullDiskKeepsTheOldFile() {
    OfficeWindow office;
    office.addExact(3);
    const QString path = sandbox_->path(QStringLiteral("site.c2sproj"));
    QVERIFY(office.window.files().saveProjectTo(path));
    const std::string old = formatProject(readProject(toPath(path)).value(), toPath(path));
    office.addExact(3, 3);
    {
      const SmallDisk full(64);
      QVERIFY(!office.window.files().saveProjectTo(path));
      QVERIFY(!office.window.exports().exportAnchors(sandbox_->path(QStringLiteral("anchors.csv"))));
      office.window.recovery().autosave().flush();  // fails as well, which is said and nothing more
    }
    QVERIFY(office.hasMessage(QStringLiteral("save")));
    QVERIFY(office.document().isModified());
    QCOMPARE(formatProject(readProject(toPath(path)).value(), toPath(path)), old);
    QVERIFY(!QFile::exists(sandbox_->path(QStringLiteral("anchors.csv"))));
    QVERIFY(office.window.files().saveProjectTo(path));
    QVERIFY(!office.hasMessage(QStringLiteral("save-")));
    QCOMPARE(readProject(toPath(path)).value().slam_maps.at(0).anchors.size(), std::size_t(6));
  }

  void scenario20_movedRenamedAndReplacedImages() {
    const QString here = sandbox_->path(QStringLiteral("here"));
    const QString there = sandbox_->path(QStringLiteral("there"));
    QVERIFY(copyOffice(here));
    {
      OfficeWindow office(false);
      QVERIFY(office.setMaps(here + QStringLiteral("/blueprint.yaml"), here + QStringLiteral("/slam_1.yaml")));
      office.addExact(4);
      QVERIFY(office.window.files().saveProjectTo(here + QStringLiteral("/site.c2sproj")));
    }
    QVERIFY(QDir().rename(here, there));
    {
      OfficeWindow office(false);
      QVERIFY(office.window.files().openProject(there + QStringLiteral("/site.c2sproj")));
      QVERIFY(office.waitUntilReady());
      QVERIFY(!office.hasMessage(QStringLiteral("image-")));
    }
    QVERIFY(QFile::rename(there + QStringLiteral("/slam_1.png"), there + QStringLiteral("/renamed.png")));
    {
      OfficeWindow office(false);
      QVERIFY(office.window.files().openProject(there + QStringLiteral("/site.c2sproj")));
      QTRY_VERIFY_WITH_TIMEOUT(office.hasMessage(QStringLiteral("image-1")), test::kPatience);
      QCOMPARE(office.document().anchors().size(), std::size_t(4));
      const std::filesystem::path image = office.document().currentMap()->raster.metadata.image;
      RasterProblem problem{
          RasterProblem::Kind::kMissing, Side::kSlam, office.document().currentMapName(), image, {}, 0, {}};
      QVERIFY(office.window.files().relocate(problem, there + QStringLiteral("/renamed.png")));
      QVERIFY(office.waitUntilReady());
      QVERIFY(office.waitUntilSolved());
      QVERIFY(!office.hasMessage(QStringLiteral("image-1")));
    }
    QVERIFY(QFile::rename(there + QStringLiteral("/renamed.png"), there + QStringLiteral("/slam_1.png")));
    // Another picture of the same size: an export says so, and names the picture that was solved on.
    const QString picture = there + QStringLiteral("/blueprint.png");
    QImage changed(picture);
    changed.setPixel(0, 0, changed.pixel(0, 0) == qRgb(255, 255, 255) ? qRgb(0, 0, 0) : qRgb(255, 255, 255));
    QVERIFY(changed.save(picture));
    {
      OfficeWindow office(false);
      const QString projector = sandbox_->path(QStringLiteral("changed.c2s"));
      QVERIFY(office.openSolved(there + QStringLiteral("/site.c2sproj")));
      const auto checks = exportChecks(office.session());
      QVERIFY(std::any_of(checks.begin(), checks.end(), [](const ExportCheck& check) {
        return check.verdict == ExportCheck::Verdict::kWarning &&
               check.sentence.contains(QStringLiteral("not the image"));
      }));
      QVERIFY(office.window.exports().exportProjector(projector));
      QCOMPARE(readProjectorFile(toPath(projector)).value().info.blueprint.image_sha256,
               sha256HexOfFile(toPath(picture)).value());
    }
    QVERIFY(QFile::remove(there + QStringLiteral("/blueprint.png")));
    QVERIFY(QImage(50, 40, QImage::Format_Grayscale8).save(there + QStringLiteral("/blueprint.png")));
    {
      OfficeWindow office(false);
      QVERIFY(office.window.files().openProject(there + QStringLiteral("/site.c2sproj")));
      QTRY_VERIFY_WITH_TIMEOUT(office.hasMessage(QStringLiteral("image-0")), test::kPatience);
      QCOMPARE(office.document().anchors().size(), std::size_t(4));
    }
  }

  void scenario20_whatIsSaidOfAnImageGoesWithIt() {
    const QString folder = sandbox_->path(QStringLiteral("here"));
    QVERIFY(copyOffice(folder));
    const QString project = folder + QStringLiteral("/site.c2sproj");
    const QString other = sandbox_->path(QStringLiteral("other.png"));
    QVERIFY(QFile::copy(folder + QStringLiteral("/blueprint.png"), other));
    {
      OfficeWindow office(false);
      QVERIFY(office.setMaps(folder + QStringLiteral("/blueprint.yaml"), folder + QStringLiteral("/slam_1.yaml")));
      QTRY_VERIFY_WITH_TIMEOUT(!office.session().rasters().isLoading(), test::kPatience);
      QVERIFY(office.window.files().saveProjectTo(project));
    }
    QImage changed(folder + QStringLiteral("/blueprint.png"));
    changed.invertPixels();
    QVERIFY(changed.save(folder + QStringLiteral("/blueprint.png")));
    OfficeWindow office(false);
    std::vector<RasterProblem> problems;
    connect(&office.session().rasters(), &RasterStore::problem, this,
            [&](const RasterProblem& problem) { problems.push_back(problem); });
    QVERIFY(office.window.files().openProject(project));
    QTRY_VERIFY_WITH_TIMEOUT(office.hasMessage(QStringLiteral("image-0")), test::kPatience);
    QVERIFY(office.window.files().setImage(Side::kBlueprint, other, 0.05));
    QVERIFY(!office.hasMessage(QStringLiteral("image-0")));
    QVERIFY(office.waitUntilReady());
    // What comes too late, a dialog that was still open for instance, does no harm.
    const std::string before = test::fingerprint(office.document());
    QCOMPARE(problems.size(), std::size_t(1));
    office.window.files().acceptChanged(problems[0]);
    QVERIFY(!office.window.files().relocate(problems[0], folder + QStringLiteral("/slam_1.png")));
    QCOMPARE(test::fingerprint(office.document()), before);
    office.document().undoStack().undo();
    QTRY_VERIFY_WITH_TIMEOUT(office.hasMessage(QStringLiteral("image-0")), test::kPatience);
    office.document().reset(Project{}, {});
    QVERIFY(!office.hasMessage(QStringLiteral("image-0")));
  }

  void aSlamImageThatBreaksOffIsNamed() {
    const QString folder = sandbox_->path(QStringLiteral("damaged"));
    QVERIFY(copyOffice(folder));
    QFile picture(folder + QStringLiteral("/slam_1.png"));
    QVERIFY(picture.resize(picture.size() / 2));
    OfficeWindow office(false);
    QVERIFY(office.window.files().setImage(Side::kBlueprint, folder + QStringLiteral("/blueprint.yaml")));
    QVERIFY(office.window.files().setImage(Side::kSlam, folder + QStringLiteral("/slam_1.yaml")));
    QTRY_VERIFY_WITH_TIMEOUT(office.hasMessage(QStringLiteral("image-1")), test::kPatience);
    QVERIFY(!office.session().isReady());
  }

  void scenario21_messyAnchorFilesAreReadAndBadLinesNamed() {
    OfficeWindow office;
    const QString path = sandbox_->path(QStringLiteral("messy.csv"));
    write(path,
          "# from the site\nid ; blueprint_x ; blueprint_y ; slam_x ; slam_y\n 1 ; 1,5 ; 2,5 ; 3,5 ; 4,5 \n"
          "2;nonsense;1;1;1\n3;1,25;2;3;4\n1;9;9;9;9\n");
    QVERIFY(office.window.exports().importAnchors(path));
    QCOMPARE(office.document().anchors().size(), std::size_t(2));
    QCOMPARE(office.document().anchor(1)->in_blueprint, Eigen::Vector2d(1.5, 2.5));
    QString told;
    for (const Message& message : office.window.messages().messages())
      if (message.id == QStringLiteral("import")) told = message.text;
    QVERIFY2(told.contains(QStringLiteral("line 4")) && told.contains(QStringLiteral("line 6")), qPrintable(told));

    const QString first = sandbox_->path(QStringLiteral("first.csv"));
    const QString second = sandbox_->path(QStringLiteral("second.csv"));
    QVERIFY(office.window.exports().exportAnchors(first));
    office.document().undoStack().undo();
    QVERIFY(office.document().anchors().empty());
    QVERIFY(office.window.exports().importAnchors(first));
    QVERIFY(office.window.exports().exportAnchors(second));
    QFile a(first);
    QFile b(second);
    QVERIFY(a.open(QIODevice::ReadOnly) && b.open(QIODevice::ReadOnly));
    QCOMPARE(a.readAll(), b.readAll());
  }

  void scenario21_pointsOfQgisAreReadInPixels() {
    OfficeWindow office;
    const MapFrame& slam = *office.session().rasters().frame(Side::kSlam);
    QByteArray text("mapX,mapY,sourceX,sourceY,enable,dX,dY,residual\n");
    for (std::size_t k = 0; k < 5; ++k) {
      const Eigen::Vector2d pixel = slam.pixelFromMetric(office.pairs[k].in_slam);
      for (const double number : {office.pairs[k].in_blueprint.x(), office.pairs[k].in_blueprint.y(), pixel.x()})
        text += QByteArray::number(number, 'g', 17) + ',';
      text += QByteArray::number(-pixel.y(), 'g', 17) + ",1,0,0,0\n";
    }
    const QString path = sandbox_->path(QStringLiteral("slam.png.points"));
    write(path, text);
    QVERIFY(office.window.exports().importAnchors(path));
    QCOMPARE(office.document().anchors().size(), std::size_t(5));
    for (std::size_t k = 0; k < 5; ++k) {
      QVERIFY((office.document().anchors()[k].in_blueprint - office.pairs[k].in_blueprint).norm() < 1e-9);
      QVERIFY((office.document().anchors()[k].in_slam - office.pairs[k].in_slam).norm() < 1e-9);
    }
    OfficeWindow empty(false);
    QVERIFY(!empty.window.exports().importAnchors(path));
  }

  void scenario23_badMapsAreNamedAndNothingIsLost() {
    OfficeWindow office;
    office.addExact(3);
    const std::string before = test::fingerprint(office.document());
    const QString yaml = sandbox_->path(QStringLiteral("bad.yaml"));
    for (const QByteArray& text :
         {QByteArray("image: nowhere.png\nresolution: 0.05\norigin: [0, 0, 0]\n"), QByteArray("resolution: -1\n"),
          QByteArray("\0\1\2", 3), QByteArray("image: [1\n")}) {
      write(yaml, text);
      QVERIFY(!office.window.files().setImage(Side::kSlam, yaml));
      QVERIFY(office.hasMessage(QStringLiteral("choose-image")));
      QCOMPARE(test::fingerprint(office.document()), before);
    }
  }

  void scenario23_aYawThatOthersIgnoreIsTold() {
    OfficeWindow office;
    const QString yaml = sandbox_->path(QStringLiteral("turned.yaml"));
    QVERIFY(QImage(9, 9, QImage::Format_Grayscale8).save(sandbox_->path(QStringLiteral("a.png"))));
    write(yaml, "{image: a.png, resolution: 1, origin: [0, 0, 0.5], negate: 0, occupied_thresh: 1, free_thresh: 0}");
    QVERIFY(office.window.files().setImage(Side::kSlam, yaml));
    QVERIFY(office.hasMessage(QStringLiteral("yaml-note")));
  }

  void scenario25_exportRefusesChecksAndReadsBack() {
    const QString path = sandbox_->path(QStringLiteral("site.c2s"));
    OfficeWindow office;
    QCOMPARE(exportChecks(office.session()).front().verdict, ExportCheck::Verdict::kRefused);
    QVERIFY(!office.window.exports().exportProjector(path));
    QVERIFY(!QFile::exists(path));
    office.addExact(10);
    edit::moveAnchor(office.document(), 4, Side::kSlam, office.pairs[3].in_slam + Eigen::Vector2d(3.0, 0.0),
                     office.document().newGesture());
    QVERIFY(office.waitUntilSolved());
    const auto checks = exportChecks(office.session());
    QVERIFY(std::any_of(checks.begin(), checks.end(), [](const ExportCheck& check) {
      return check.verdict == ExportCheck::Verdict::kWarning && check.sentence.contains(QLatin1Char('4'));
    }));
    QVERIFY(office.window.exports().exportProjector(path, QStringLiteral("anchor 4 fits badly")));
    const ProjectorData warned = readProjectorFile(toPath(path)).value();
    QCOMPARE(warned.info.note, std::string("anchor 4 fits badly"));
    QCOMPARE(warned.info.slam.image_sha256.size(), std::size_t(64));
    QVERIFY(!warned.check_poses.empty());

    office.document().undoStack().undo();
    QVERIFY(office.waitUntilSolved());
    const QString fixed = sandbox_->path(QStringLiteral("fixed.c2s"));
    QVERIFY(office.window.exports().exportProjector(fixed));
    QVERIFY(readProjectorFile(toPath(fixed)).value().node_slam[0].translation != warned.node_slam[0].translation);
    QVERIFY(office.window.exports().inspectProjector(path));
    QVERIFY(office.hasMessage(QStringLiteral("inspect")));
  }

  void scenario25_aProjectorTellsItsOriginAndAnotherImageIsFlagged() {
    const QString here = sandbox_->path(QStringLiteral("here"));
    QVERIFY(copyOffice(here));
    OfficeWindow office(false);
    QVERIFY(office.setMaps(here + QStringLiteral("/blueprint.yaml"), here + QStringLiteral("/slam_1.yaml")));
    office.addExact(6);
    QVERIFY(office.waitUntilSolved());
    QVERIFY(office.window.files().saveProjectTo(here + QStringLiteral("/tower.c2sproj")));
    const QString path = sandbox_->path(QStringLiteral("site.c2s"));
    QVERIFY(office.window.exports().exportProjector(path));
    const auto told = [&] {
      for (const Message& message : office.window.messages().messages())
        if (message.id == QStringLiteral("inspect")) return message;
      return Message{};
    };
    QVERIFY(office.window.exports().inspectProjector(path));
    const Message same = told();
    const ProjectorInfo info = readProjectorFile(toPath(path)).value().info;
    QVERIFY(same.severity == Severity::kNote);
    QVERIFY2(same.text.contains(QStringLiteral("tower")), qPrintable(same.text));
    QVERIFY2(same.text.contains(QLocale().toString(QDate::currentDate(), QLocale::ShortFormat)), qPrintable(same.text));
    for (const std::string& hash : {info.blueprint.image_sha256, info.slam.image_sha256})
      QVERIFY2(same.text.contains(toQString(hash).left(12)), qPrintable(same.text));
    // The same name, other pixels.
    QImage picture(here + QStringLiteral("/blueprint.png"));
    picture.invertPixels();
    QVERIFY(picture.save(here + QStringLiteral("/inverted.png")));
    const std::filesystem::path image = office.document().project().blueprint.metadata.image;
    QVERIFY(office.window.files().relocate({RasterProblem::Kind::kChanged, Side::kBlueprint, {}, image, {}, 0, {}},
                                           here + QStringLiteral("/inverted.png")));
    QVERIFY(office.waitUntilReady());
    QTRY_VERIFY_WITH_TIMEOUT(office.hasMessage(QStringLiteral("image-0")), test::kPatience);
    QVERIFY(office.pressCure(QStringLiteral("image-0"), QStringLiteral("Use this one")));
    QVERIFY(!office.hasMessage(QStringLiteral("image-0")));
    QVERIFY(office.window.exports().inspectProjector(path));
    QVERIFY(told().severity == Severity::kWarning);
    QVERIFY2(told().text.contains(QStringLiteral("blueprint is not the image")), qPrintable(told().text));
  }

  void theReportIsAPdfWithEveryAnchor() {
    OfficeWindow office;
    office.addExact(6);
    QVERIFY(office.waitUntilSolved());
    edit::rename(office.document(), 2, "pillar & <door>");
    const QString html = reportHtml(office.session(), {{}, {QStringLiteral("look at anchor 3")}});
    QVERIFY(html.contains(QStringLiteral("pillar &amp; &lt;door&gt;")));
    QVERIFY(html.contains(QStringLiteral("look at anchor 3")));
    for (const Anchor& anchor : office.document().anchors())
      QVERIFY(html.contains(QRegularExpression(QStringLiteral("<td[^>]*>%1</td>").arg(anchor.id))));
    const QString path = sandbox_->path(QStringLiteral("report.pdf"));
    QVERIFY(saveReport(office.window, path));
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QVERIFY(file.read(5) == "%PDF-" && file.size() > 10'000);
    QVERIFY(!saveReport(office.window, sandbox_->path(QStringLiteral("no/such/folder/report.pdf"))));
    QVERIFY(office.hasMessage(QStringLiteral("report")));
  }

  void scenario28_closeAsksOnlyWhereSomethingIsUnsaved() {
    OfficeWindow office;
    const QString path = sandbox_->path(QStringLiteral("site.c2sproj"));
    office.addExact(2);
    answerNextQuestion(QMessageBox::Cancel);
    QVERIFY(!office.window.close());
    QVERIFY(office.window.isVisible());
    QCOMPARE(office.document().anchors().size(), std::size_t(2));
    QVERIFY(office.window.files().saveProjectTo(path));
    office.addExact(1, 2);
    answerNextQuestion(QMessageBox::Save);
    QVERIFY(office.window.close());
    QCOMPARE(readProject(toPath(path)).value().slam_maps.at(0).anchors.size(), std::size_t(3));
    office.window.show();
    QVERIFY(office.window.close());  // nothing unsaved: no question
    office.window.show();
    office.addExact(1, 3);
    answerNextQuestion(QMessageBox::Discard);
    QVERIFY(office.window.close());
    QCOMPARE(readProject(toPath(path)).value().slam_maps.at(0).anchors.size(), std::size_t(3));
  }
};

QTEST_MAIN(FilesTest)
#include "files_test.moc"
