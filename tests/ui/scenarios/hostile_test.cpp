// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/project_file.h"
#include "ui/document/project_commands.h"
#include "ui/main_window/exports.h"
#include "ui/support/office_window.h"

#include <QFile>
#include <QLabel>

#include <memory>

using namespace cad2slam;
using test::OfficeWindow;

namespace {

const std::string kMarkup = "x<img src=/dev/zero>";

/// Empty where no widget would take what it shows for HTML, else what it would.
QString richTextIn(const QWidget& window) {
  for (const QLabel* label : window.findChildren<QLabel*>())
    if (label->textFormat() != Qt::PlainText && label->text().contains(QStringLiteral("<img"))) return label->text();
  for (const QWidget* widget : window.findChildren<QWidget*>())
    if (widget->toolTip().contains(QStringLiteral("<img"))) return widget->toolTip();
  return {};
}

}  // namespace

/// Files of other people hold anything.
class HostileTest : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<test::Sandbox> sandbox_;

  /// The sample with some anchors, as a project that was then changed by hand.
  template <class Change>
  [[nodiscard]] QString projectWith(Change change) {
    OfficeWindow office;
    office.addExact(5);
    Project project = office.document().projectToSave();
    change(project);
    const QString path = sandbox_->path(QStringLiteral("hostile.c2sproj"));
    return writeProject(toPath(path), project) ? path : QString();
  }

 private slots:
  void init() { sandbox_ = std::make_unique<test::Sandbox>(); }
  void cleanup() { sandbox_.reset(); }

  void namesAreText() {
    const QString path = projectWith([](Project& project) {
      project.blueprint.metadata.image = "/nowhere/" + kMarkup + ".png";
      project.slam_maps[0].name = kMarkup;
      for (Anchor& anchor : project.slam_maps[0].anchors) anchor.name = anchor.note = kMarkup;
    });
    OfficeWindow office(false);
    QVERIFY(office.window.files().openProject(path));
    QTRY_VERIFY_WITH_TIMEOUT(office.hasMessage(QStringLiteral("image-0")), test::kPatience);
    QCOMPARE(richTextIn(office.window), QString());
    QVERIFY(!office.window.grab().isNull());
  }

  void namesInAProjectorAreText() {
    const QString path = sandbox_->path(QStringLiteral("<img src=x>.c2s"));
    OfficeWindow office;
    QVERIFY(edit::renameSlamMap(office.document(), office.document().currentMapName(), kMarkup));
    office.addExact(5);
    QVERIFY(office.waitUntilSolved());
    QVERIFY(office.window.exports().exportProjector(path));
    QVERIFY(office.window.exports().inspectProjector(path));
    QVERIFY(office.hasMessage(QStringLiteral("inspect")));
    QCOMPARE(richTextIn(office.window), QString());
  }

  void hugeNamesAreCutWhereTheyAreDrawn() {
    const std::string huge(100'000, 'a');
    const QString path = projectWith([&](Project& project) {
      project.slam_maps[0].name = huge;
      for (Anchor& anchor : project.slam_maps[0].anchors) anchor.name = anchor.note = huge;
    });
    OfficeWindow office(false);
    const int width = office.window.width();
    QVERIFY(office.openSolved(path));
    QVERIFY(!office.window.grab().isNull());
    QCOMPARE(office.window.width(), width);
    QCOMPARE(office.document().currentMapName(), huge);
    QCOMPARE(office.document().anchors()[0].name, huge);
  }

  void numbersLeadNowhere_data() {
    QTest::addColumn<double>("number");
    for (const double number : {1e308, -1e308, 1e20, 2e9, 1e-308}) QTest::addRow("%g", number) << number;
  }
  void numbersLeadNowhere() {
    QFETCH(double, number);
    const QString path = projectWith([&](Project& project) {
      const QString text = QString::number(number, 'g', 17);
      project.view_state_json =
          toStd(QStringLiteral("{\"views\":{\"blueprint\":{\"x_m\":%1,\"y_m\":0,\"m_per_px\":0.05,"
                               "\"rotation_rad\":%1},\"slam\":{\"x_m\":1,\"y_m\":%1,"
                               "\"m_per_px\":%1,\"rotation_rad\":0}}}")
                    .arg(text));
      project.slam_maps[0].anchors[0].in_blueprint.x() = number;
      project.slam_maps[0].anchors[1].in_slam.y() = number;
    });
    OfficeWindow office(false);
    QVERIFY(office.window.files().openProject(path));
    QVERIFY(office.waitUntilReady());
    for (const Side side : {Side::kBlueprint, Side::kSlam}) {
      const QPointF center = office.window.view(side).viewState().center_m;
      QVERIFY(std::abs(center.x()) <= kLargestCoordinate && std::abs(center.y()) <= kLargestCoordinate);
    }
    for (const AnchorId id : {1, 2, 3}) {
      office.window.views().centerOn(id);
      QVERIFY(!office.window.grab().isNull());
    }
    QTRY_VERIFY_WITH_TIMEOUT(office.session().alignment().status() != AlignmentStatus::kSolving, test::kPatience);
    QVERIFY(!office.window.grab().isNull());
  }

  void farAnchorsAreNotImported() {
    const QString path = sandbox_->path(QStringLiteral("far.csv"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("id,blueprint_x,blueprint_y,slam_x,slam_y\n7,1e308,1,2,3\n8,1,2,3,4\n");
    file.close();
    OfficeWindow office;
    QVERIFY(office.window.exports().importAnchors(path));
    QCOMPARE(office.document().anchors().size(), std::size_t(1));
    QVERIFY(office.hasMessage(QStringLiteral("import")));
  }
};

QTEST_MAIN(HostileTest)
#include "hostile_test.moc"
