// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/dropped_files.h"

#include "cad2slam/io/map_file.h"
#include "ui/support/office_window.h"

#include <QDialog>
#include <QFile>
#include <QTimer>

using namespace cad2slam;
using test::OfficeWindow;

class DroppedFilesTest : public QObject {
  Q_OBJECT

 private:
  std::optional<test::Sandbox> sandbox_;

 private slots:
  void init() { sandbox_.emplace(); }

  void aWholeSiteCanBeDroppedInAnyOrder_data() {
    QTest::addColumn<QStringList>("names");
    const QString anchors = QStringLiteral("anchors_1.csv");
    const QString blueprint = QStringLiteral("blueprint.yaml");
    const QString slam = QStringLiteral("slam_1.yaml");
    QTest::newRow("as a file manager sorts") << QStringList{anchors, blueprint, slam};
    QTest::newRow("anchors last") << QStringList{blueprint, slam, anchors};
  }
  void aWholeSiteCanBeDroppedInAnyOrder() {
    QFETCH(QStringList, names);
    OfficeWindow office(false);
    QStringList paths;
    for (const QString& name : names) paths += OfficeWindow::sample(qPrintable(name));
    emit office.window.views().filesDropped(Side::kBlueprint, paths);
    QVERIFY(office.waitUntilReady());
    QTRY_COMPARE_WITH_TIMEOUT(office.document().anchors().size(), office.pairs.size(), test::kPatience);
    QVERIFY(office.hasMessage(QStringLiteral("import")));
  }

  void anImageThatAMapNamesIsNoMapOfItsOwn_data() {
    QTest::addColumn<QStringList>("names");
    const QString yaml = QStringLiteral("slam_1.yaml");
    const QString image =
        toQString(readMapYaml(toPath(OfficeWindow::sample("slam_1.yaml")))->metadata.image.filename());
    QTest::newRow("the image first") << QStringList{image, yaml};
    QTest::newRow("the YAML first") << QStringList{yaml, image};
  }
  void anImageThatAMapNamesIsNoMapOfItsOwn() {
    QFETCH(QStringList, names);
    OfficeWindow office(false);
    QVERIFY(office.window.files().setImage(Side::kBlueprint, OfficeWindow::sample("blueprint.yaml")));
    QStringList paths;
    for (const QString& name : names) paths += OfficeWindow::sample(qPrintable(name));
    bool asked = false;
    QTimer::singleShot(0, qApp, [&] {
      auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
      asked = dialog != nullptr;
      if (dialog) dialog->reject();
    });
    emit office.window.views().filesDropped(Side::kSlam, paths);
    QVERIFY(office.waitUntilReady());
    QVERIFY(!asked);
    QCOMPARE(office.document().project().slam_maps.size(), std::size_t(1));
    QCOMPARE(office.document().currentMap()->raster.metadata.resolution_m_per_px,
             readMapYaml(toPath(OfficeWindow::sample("slam_1.yaml")))->metadata.resolution_m_per_px);
  }

  void pointsOfQgisWaitForBothImages() {
    OfficeWindow office(false);
    const QString path = sandbox_->path(QStringLiteral("slam.points"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(
        "mapX,mapY,sourceX,sourceY,enable,dX,dY,residual\n1,1,10,-20,1,0,0,0\n5,1,90,-20,1,0,0,0\n"
        "5,6,90,-110,1,0,0,0\n");
    file.close();
    emit office.window.views().filesDropped(
        Side::kBlueprint, {path, OfficeWindow::sample("blueprint.yaml"), OfficeWindow::sample("slam_1.yaml")});
    QVERIFY(office.waitUntilReady());
    QTRY_COMPARE_WITH_TIMEOUT(office.document().anchors().size(), std::size_t(3), test::kPatience);
  }

  void anchorsWithoutAMapSayWhatIsMissing() {
    OfficeWindow office(false);
    emit office.window.views().filesDropped(Side::kSlam, {OfficeWindow::sample("anchors_1.csv")});
    QVERIFY(office.hasMessage(QStringLiteral("import")));
    QVERIFY(office.document().anchors().empty());
  }

  void anchorsOfAProjectThatWasLeftAreNotImported() {
    OfficeWindow office(false);
    emit office.window.views().filesDropped(
        Side::kBlueprint, {OfficeWindow::sample("anchors_1.csv"), OfficeWindow::sample("blueprint.yaml"),
                           OfficeWindow::sample("slam_1.yaml")});
    office.document().reset(Project{}, {});
    office.loadMaps();
    QVERIFY(office.document().anchors().empty());
  }
};

QTEST_MAIN(DroppedFilesTest)
#include "dropped_files_test.moc"
