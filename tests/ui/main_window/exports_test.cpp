// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/exports.h"

#include "cad2slam/io/map_file.h"
#include "cad2slam/io/projector_file.h"
#include "cad2slam/projection/overlay_picture.h"
#include "ui/support/office_window.h"

#include <QFile>
#include <QProgressDialog>
#include <QPushButton>
#include <QTimer>

#include <map>
#include <memory>

using namespace cad2slam;
using test::OfficeWindow;

/// What can happen while an export is being solved.
class ExportsTest : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<test::Sandbox> sandbox_;
  std::unique_ptr<OfficeWindow> office_;
  QString path_;

  [[nodiscard]] QProgressDialog* dialog() const { return office_->window.findChild<QProgressDialog*>(); }

 private slots:
  void init() {
    sandbox_ = std::make_unique<test::Sandbox>();
    path_ = sandbox_->path(QStringLiteral("site.c2s"));
    office_ = std::make_unique<OfficeWindow>();
    office_->addExact(12);
    QVERIFY(office_->waitUntilSolved());
    QVERIFY(office_->window.files().saveProjectTo(sandbox_->path(QStringLiteral("site.c2sproj"))));
  }
  void cleanup() {
    office_.reset();
    sandbox_.reset();
  }

  void aWindowThatIsClosedWaitsForItsExport() {
    bool closed = true;
    bool told = false;
    QTimer once;  // ends with the test
    once.setSingleShot(true);
    connect(&once, &QTimer::timeout, this, [&] {
      closed = office_->window.close();
      told = dialog() && dialog()->isVisible();
    });
    once.start(0);
    QVERIFY(office_->window.exports().exportProjector(path_));
    QVERIFY(!closed && told);
    QVERIFY(office_->window.isVisible());
    QVERIFY(QFile::exists(path_));
    QVERIFY(office_->window.close());
  }

  void cancelledNothingIsWritten() {
    QTimer once;
    once.setSingleShot(true);
    connect(&once, &QTimer::timeout, this, [&] {
      office_->window.close();
      if (dialog()) dialog()->findChild<QPushButton*>()->click();
    });
    once.start(0);
    QVERIFY(!office_->window.exports().exportProjector(path_));
    QVERIFY(office_->hasMessage(QStringLiteral("export-projector")));
    QVERIFY(!QFile::exists(path_));
  }

  void whatIsEditedMeanwhileIsNotInTheFile() {
    QTimer::singleShot(0, qApp, [&] {
      edit::deleteAnchors(office_->document(), {1, 2, 3});
      office_->document().reset(Project{}, {});
    });
    QVERIFY(office_->window.exports().exportProjector(path_));
    const ProjectorData data = readProjectorFile(toPath(path_)).value();
    QCOMPARE(data.anchors.size(), std::size_t(12));
    QCOMPARE(QString::fromStdString(data.info.project), QStringLiteral("site.c2sproj"));
  }

  void theBlueprintIsWrittenAsAMapOfTheRobot() {
    const QString yaml = sandbox_->path(QStringLiteral("site-map.yaml"));
    QVERIFY(office_->window.exports().exportProjector(path_, {}, yaml));
    // As cad2slam-cli warp draws it from the file.
    const LoadedMap map = loadMap(toPath(yaml)).value();
    const MapFrame& slam = *office_->session().rasters().frame(Side::kSlam);
    const Projector projector = loadProjector(toPath(path_)).value();
    const auto& blueprint = office_->session().rasters().grid(Side::kBlueprint);
    const OccupancyGrid warped = warpGrid(projector, true, *blueprint, slam).value();
    QCOMPARE(map.grid.frame().width(), slam.width());
    QCOMPARE(map.grid.frame().height(), slam.height());
    QCOMPARE(map.grid.frame().resolution(), slam.resolution());
    std::map<CellState, int> seen;
    int differ = 0;
    for (int row = 0; row < slam.height(); ++row) {
      for (int column = 0; column < slam.width(); ++column) {
        const Eigen::Vector2d center = slam.metricFromPixel({column + 0.5, row + 0.5});
        ++seen[map.grid.at(center)];
        if (map.grid.at(center) != warped.at(center)) ++differ;
      }
    }
    QCOMPARE(differ, 0);
    QCOMPARE(seen.size(), std::size_t(3));
  }

  void aMapThatIsCancelledOrCannotBeWrittenIsSaid() {
    const QString nowhere = sandbox_->path(QStringLiteral("no such folder/map.yaml"));
    QVERIFY(!office_->window.exports().exportProjector(path_, {}, nowhere));
    QVERIFY(QFile::exists(path_));
    const QString yaml = sandbox_->path(QStringLiteral("site-map.yaml"));
    // The second dialog is that of the map.
    QObject cancels;
    QTimer every;
    connect(&every, &QTimer::timeout, &cancels, [&] {
      if (dialog() && dialog()->labelText().contains(QStringLiteral("map"))) dialog()->cancel();
    });
    every.start(0);
    const bool written = office_->window.exports().exportProjector(path_, {}, yaml);
    every.stop();
    // It may have been quicker than the hand.
    QCOMPARE(QFile::exists(yaml), written);
    QCOMPARE(QFile::exists(sandbox_->path(QStringLiteral("site-map.png"))), written);
  }

  void whatIsSaidOfAProjectorBeginsWithTheVerdict() {
    Exports& exports = office_->window.exports();
    QVERIFY(exports.exportProjector(path_));
    const auto told = [&] {
      for (const Message& message : office_->window.messages().messages())
        if (message.id == QStringLiteral("inspect")) return message.text.section(QLatin1Char('\n'), 0, 0);
      return QString();
    };
    QVERIFY(exports.inspectProjector(path_));
    QCOMPARE(told(), QStringLiteral("site.c2s: It was made from the images that are shown here"));
    office_->document().reset(Project{}, {});
    QVERIFY(exports.inspectProjector(path_));
    QCOMPARE(told(), QStringLiteral("site.c2s: Whether it fits the images of this project is not known"));
    QVERIFY(office_->setMaps(OfficeWindow::sample("blueprint.yaml"), OfficeWindow::sample("slam_2.yaml")));
    QVERIFY(exports.inspectProjector(path_));
    QCOMPARE(told(), QStringLiteral("site.c2s: Its SLAM map is not the one being edited"));
  }

  void aSolveThatWasStoppedIsNamedAndCanBeTakenUpFromTheCheckList() {
    const auto move = [&] {
      const Anchor& anchor = office_->document().anchors()[0];
      edit::moveAnchor(office_->document(), anchor.id, Side::kSlam, anchor.in_slam + Eigen::Vector2d(0.1, 0.0),
                       office_->document().newGesture());
    };
    move();
    office_->window.actionTable()[ActionId::kCancelSolve]->trigger();
    const ExportCheck check = exportChecks(office_->session()).front();
    QCOMPARE(check.verdict, ExportCheck::Verdict::kRefused);
    QVERIFY2(check.sentence.contains(QStringLiteral("stopped")), qPrintable(check.sentence));
    bool pressed = false;
    QTimer::singleShot(0, qApp, [&] {
      auto* dialog = qobject_cast<ExportDialog*>(QApplication::activeModalWidget());
      if (!dialog) return;
      for (QPushButton* button : dialog->findChildren<QPushButton*>()) {
        if (!button->text().contains(QStringLiteral("again"))) continue;
        pressed = true;
        return button->click();
      }
      dialog->reject();
    });
    office_->window.exports().askExportProjector();
    QVERIFY(pressed);
    QVERIFY(office_->waitUntilSolved());
    QVERIFY(exportChecks(office_->session()).front().verdict != ExportCheck::Verdict::kRefused);
    // One that fails, or is not there, is not to be taken up.
    office_->document().reset(Project{}, {});
    QVERIFY(!exportChecks(office_->session()).front().solving_helps);
  }

  void aProgramThatEndsDropsTheSolveAndSaysSo() {
    bool written = true;
    QTimer::singleShot(0, qApp, [&] {
      QTimer::singleShot(0, qApp, [] { QCoreApplication::exit(); });  // runs within the export
      written = office_->window.exports().exportProjector(path_);
    });
    QApplication::exec();
    QVERIFY(!written);
    QVERIFY(office_->hasMessage(QStringLiteral("export-projector")));
    QVERIFY(!QFile::exists(path_));
  }
};

QTEST_MAIN(ExportsTest)
#include "exports_test.moc"
