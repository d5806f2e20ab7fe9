// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/cheat_sheet.h"
#include "ui/dialogs/export_dialog.h"
#include "ui/dialogs/scale_dialog.h"
#include "ui/dialogs/settings_dialog.h"
#include "ui/document/project_commands.h"
#include "ui/main_window/appearance.h"
#include "ui/main_window/exports.h"
#include "ui/panels/anchor_panel.h"
#include "ui/panels/preview_panel.h"
#include "ui/panels/status_strip.h"
#include "ui/support/office_window.h"

#include <QAccessible>
#include <QFile>
#include <QImage>
#include <QRegularExpression>
#include <QScrollArea>
#include <QScrollBar>
#include <QSet>
#include <QTableView>
#include <QXmlStreamReader>

using namespace cad2slam;
using test::OfficeWindow;

namespace {

/// A picture with hardly any colours shows nothing.
int colorsIn(const QImage& image) {
  QSet<QRgb> colors;
  for (int y = 0; y < image.height(); y += 3)
    for (int x = 0; x < image.width(); x += 3) colors.insert(image.pixel(x, y));
  return int(colors.size());
}

QRect changedPart(const QImage& before, const QImage& after) {
  QRect part;
  for (int y = 0; y < after.height(); ++y)
    for (int x = 0; x < after.width(); ++x)
      if (before.pixel(x, y) != after.pixel(x, y)) part |= QRect(x, y, 1, 1);
  return part;
}

}  // namespace

class LookingTest : public QObject {
  Q_OBJECT

 private:
  std::optional<test::Sandbox> sandbox_;

 private slots:
  void scenario24_aLargeBlueprintIsShownWhileItsCellsAreRead() {
    const test::Sandbox sandbox;
    const QString image = sandbox.path(QStringLiteral("large.png"));
    QImage white(5000, 5000, QImage::Format_Grayscale8);
    white.fill(Qt::white);
    QVERIFY(white.save(image));
    OfficeWindow office(false);
    QVERIFY(office.window.files().setImage(Side::kSlam, OfficeWindow::sample("slam_1.yaml")));
    QVERIFY(QTest::qWaitFor([&] { return office.session().rasters().frame(Side::kSlam).has_value(); }, 30'000));
    edit::addAnchor(office.document(), {5.0, 5.0}, {0.0, 0.0});
    QStringList reasons;
    connect(&office.session().rasters(), &RasterStore::changed, this, [&](Side side) {
      const RasterStore& rasters = office.session().rasters();
      if (side == Side::kBlueprint && rasters.frame(side) && !rasters.grid(side))
        reasons += office.window.preview().view().reason();
    });
    QVERIFY(office.window.files().setImage(Side::kBlueprint, image, 0.01));
    QVERIFY(office.waitUntilReady());
    QCOMPARE(reasons, QStringList{QStringLiteral("Loading the images...")});
  }

  void init() { sandbox_.emplace(); }

  void scenario15_everyPreviewModeWithAnyNumberOfAnchors_data() {
    QTest::addColumn<int>("count");
    for (const int count : {0, 1, 2, 3, 30}) QTest::addRow("%d anchors", count) << count;
  }
  void scenario15_everyPreviewModeWithAnyNumberOfAnchors() {
    QFETCH(int, count);
    OfficeWindow office;
    office.addExact(std::size_t(count));
    if (count > 0) QVERIFY(office.waitUntilSolved());
    for (int mode = 0; mode < kPreviewModeCount; ++mode) {
      office.window.preview().setMode(static_cast<PreviewMode>(mode));
      QTRY_VERIFY2_WITH_TIMEOUT(colorsIn(office.window.preview().view().grab().toImage()) > 8,
                                qPrintable(QStringLiteral("mode %1").arg(mode)), test::kPatience);
    }
  }

  void scenario15_allSlamMapsOfAProjectWithoutChoosingThem() {
    OfficeWindow office(false);
    QVERIFY(office.openSolved(OfficeWindow::sample("office.c2sproj")));
    Alignment& alignment = office.session().alignment();
    const auto& maps = office.document().project().slam_maps;
    QCOMPARE(maps.size(), std::size_t(2));
    const std::string other = maps[1].name;
    QVERIFY(!alignment.results().contains(other));  // nobody looks at it yet
    office.window.preview().setMode(PreviewMode::kAllMaps);
    QTRY_VERIFY_WITH_TIMEOUT(alignment.otherStatus(other) == AlignmentStatus::kUpToDate, test::kPatience);
    const SolveResultPtr result = alignment.results().at(other);
    QCOMPARE(result->solution.anchors_used, maps[1].anchors.size());
    // An edit of the current map leaves it, a new setting does not.
    edit::moveAnchor(office.document(), office.document().anchors()[0].id, Side::kSlam,
                     office.document().anchors()[0].in_slam + Eigen::Vector2d(0.1, 0.0),
                     office.document().newGesture());
    QVERIFY(office.waitUntilSolved());
    QCOMPARE(alignment.results().at(other), result);
    const Project& project = office.document().project();
    edit::changeSettings(office.document(),
                         {defaultSettings(Model::kRigid), project.cell_size_m, office.document().state().limits});
    QTRY_VERIFY_WITH_TIMEOUT(alignment.otherStatus(other) == AlignmentStatus::kUpToDate, test::kPatience);
    QVERIFY(alignment.results().at(other) != result);
    // Its ink is in the picture.
    const auto has_ink = [&](QRgb ink) {
      const QImage image = office.window.preview().view().picture().image;
      for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
          if (image.pixel(x, y) == ink) return true;
      return false;
    };
    QTRY_VERIFY_WITH_TIMEOUT(has_ink(qRgb(0x00, 0x9a, 0x44)), test::kPatience);
    // Another mode no longer wants it.
    office.window.preview().setMode(PreviewMode::kOverlay);
    QVERIFY(alignment.otherStatus(other) == AlignmentStatus::kNotReady);
  }

  void scenario15_solvingTheOthersCanBeStopped() {
    OfficeWindow office(false);
    QVERIFY(office.openSolved(OfficeWindow::sample("office.c2sproj")));
    Alignment& alignment = office.session().alignment();
    const std::string other = office.document().project().slam_maps[1].name;
    office.window.preview().setMode(PreviewMode::kAllMaps);
    QVERIFY(alignment.areOthersBusy());
    QVERIFY(office.window.actionTable()[ActionId::kCancelSolve]->isEnabled());
    office.window.actionTable()[ActionId::kCancelSolve]->trigger();
    QVERIFY(alignment.otherStatus(other) == AlignmentStatus::kCancelled);
    QVERIFY(alignment.status() == AlignmentStatus::kUpToDate);
    QTest::qWait(300);
    QVERIFY(!alignment.results().contains(other));
    office.window.actionTable()[ActionId::kSolveAgain]->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(alignment.otherStatus(other) == AlignmentStatus::kUpToDate, test::kPatience);
  }

  // Not shown before it takes long, but whoever is quick enough may stop it.
  void aSolveCanBeStoppedAtOnce() {
    OfficeWindow office;
    office.addExact(6);
    QVERIFY(office.waitUntilSolved());
    const Anchor& anchor = office.document().anchors()[0];
    edit::moveAnchor(office.document(), anchor.id, Side::kSlam, anchor.in_slam + Eigen::Vector2d(0.1, 0.0),
                     office.document().newGesture());
    QVERIFY(office.window.actionTable()[ActionId::kCancelSolve]->isEnabled());
    office.window.actionTable()[ActionId::kCancelSolve]->trigger();
    QVERIFY(office.session().alignment().status() == AlignmentStatus::kCancelled);
    QVERIFY(!office.window.actionTable()[ActionId::kCancelSolve]->isEnabled());
  }

  void scenario16_linkedViewsShowTheSamePlace() {
    OfficeWindow office;
    office.addExact(12);
    QVERIFY(office.waitUntilSolved());
    MapView& left = office.window.view(Side::kBlueprint);
    MapView& right = office.window.view(Side::kSlam);
    left.setFocus();
    office.window.actionTable()[ActionId::kLink]->setChecked(true);
    int changes = 0;
    connect(&left, &MapView::viewStateChanged, this, [&] { ++changes; });
    connect(&right, &MapView::viewStateChanged, this, [&] { ++changes; });
    left.centerOn(toQPointF(office.pairs[4].in_blueprint), false);
    left.zoomBy(3.0);
    left.setRotation(kPi / 2.0);
    QCoreApplication::processEvents();
    QVERIFY2(changes <= 12, qPrintable(QString::number(changes)));  // each view follows once, they do not chase
    const auto there = office.session().carry(Side::kBlueprint, left.viewState().center_m);
    QVERIFY(there.has_value());
    QVERIFY(QLineF(right.viewState().center_m, there->point_m).length() < 1e-6);
    QVERIFY(std::abs(wrapAngle(right.viewState().rotation_rad + there->turn_rad - left.viewState().rotation_rad)) <
            1e-9);
    // The same from the right, and off means off.
    right.zoomBy(2.0);
    QVERIFY(std::abs(left.viewState().m_per_px * there->scale / right.viewState().m_per_px - 1.0) < 0.05);
    const ViewState kept = left.viewState();
    office.window.actionTable()[ActionId::kLink]->setChecked(false);
    QVERIFY(left.viewState() == kept);
    right.zoomBy(2.0);
    QVERIFY(left.viewState() == kept);
  }

  void scenario17_theMirroredCursorIsWhereTheProjectorSays() {
    OfficeWindow office;
    office.addExact(30);
    QVERIFY(office.waitUntilSolved());
    for (std::size_t i = 0; i < 10; ++i) {
      const auto carried = office.session().carry(Side::kBlueprint, toQPointF(office.pairs[i].in_blueprint));
      const Projection exact = office.session().alignment().result()->projector.slamFromBlueprint(
          {office.pairs[i].in_blueprint, 0.0}, OutsidePolicy::kRigid);
      QVERIFY(carried && exact.ok());
      QVERIFY((toEigen(carried->point_m) - exact.pose.translation).norm() < 0.05);
      const auto back = office.session().carry(Side::kSlam, carried->point_m);
      QVERIFY(back.has_value());
      QVERIFY((toEigen(back->point_m) - office.pairs[i].in_blueprint).norm() < 1e-5);
    }
    // The messages that come change the size of the views.
    QTRY_VERIFY_WITH_TIMEOUT(office.hasMessage(QStringLiteral("diagnosis-")), test::kPatience);
    QTest::qWait(100);
    // And it is drawn there: the middle of what a hover changes in the other view.
    office.window.actionTable()[ActionId::kMarkers]->setChecked(false);
    MapView& left = office.window.view(Side::kBlueprint);
    MapView& right = office.window.view(Side::kSlam);
    int seen = 0;
    for (std::size_t i = 0; i < 14 && seen < 10; ++i) {
      const QPoint at = left.widgetFromMetres(toQPointF(office.pairs[i].in_blueprint)).toPoint();
      const Projection exact = office.session().alignment().result()->projector.slamFromBlueprint(
          {toEigen(left.metresFromWidget(at)), 0.0}, OutsidePolicy::kRigid);
      const QPointF expected = right.widgetFromMetres(toQPointF(exact.pose.translation));
      if (!QRectF(right.rect()).adjusted(60, 60, -60, -60).contains(expected)) continue;  // not beside a decoration
      QTest::mouseMove(&left, at + QPoint(200, 200));
      QEvent leave(QEvent::Leave);
      QCoreApplication::processEvents();
      QCoreApplication::sendEvent(&left, &leave);
      const QImage before = right.grab().toImage();
      QTest::mouseMove(&left, at);
      QCoreApplication::processEvents();
      const QImage after = right.grab().toImage();
      const QRect changed = changedPart(before, after);
      QVERIFY(!changed.isEmpty());
      const QPointF middle = QRectF(changed).center() / after.devicePixelRatio();
      QVERIFY2(QLineF(middle, expected).length() <= 1.0,
               qPrintable(QString::number(QLineF(middle, expected).length())));
      ++seen;
    }
    QCOMPARE(seen, 10);
  }

  void aRescaledBlueprintShowsTheSamePart() {
    OfficeWindow office;
    office.addExact(12);
    QVERIFY(office.waitUntilSolved());
    MapView& view = office.window.view(Side::kBlueprint);
    MapView& preview = office.window.preview().view();
    QVERIFY(preview.isFitted());
    view.zoomBy(3.0);
    view.centerOn(toQPointF(office.pairs[4].in_blueprint), false);
    const auto corner_px = [](const MapView& of) { return of.imagePixelFromMetres(of.metresFromWidget({0.0, 0.0})); };
    const QPointF seen = corner_px(view);
    const QPointF seen_in_preview = corner_px(preview);
    const auto is_kept = [&] {
      return QLineF(corner_px(view), seen).length() < 0.01 &&
             QLineF(corner_px(preview), seen_in_preview).length() < 0.01 && preview.isFitted() && !view.isFitted();
    };
    edit::rescaleBlueprint(office.document(), 1.3);
    QVERIFY(office.waitUntilSolved());
    QTRY_VERIFY_WITH_TIMEOUT(is_kept(), test::kPatience);
    office.document().undoStack().undo();
    QVERIFY(office.waitUntilSolved());
    QTRY_VERIFY_WITH_TIMEOUT(is_kept(), test::kPatience);
    office.document().undoStack().redo();
    QVERIFY(office.waitUntilSolved());
    QTRY_VERIFY_WITH_TIMEOUT(is_kept(), test::kPatience);
  }

  void everySlamMapIsSeenAgainAsItWasLeft() {
    OfficeWindow office;
    const std::string first = office.document().currentMapName();
    MapView& view = office.window.view(Side::kSlam);
    view.zoomBy(4.0);
    view.centerOn(toQPointF(office.pairs[4].in_slam), false);
    const ViewState of_first = view.viewState();
    QVERIFY(office.window.files().setImage(Side::kSlam, OfficeWindow::sample("slam_2.yaml")));
    QVERIFY(office.waitUntilReady());
    const std::string second = office.document().currentMapName();
    QVERIFY(second != first);
    QVERIFY(view.isFitted());
    const auto show = [&](const std::string& map) {
      office.document().setCurrentMap(map);
      return office.waitUntilReady();
    };
    QVERIFY(show(first));
    QVERIFY(view.viewState() == of_first);
    QVERIFY(show(second));
    QVERIFY(view.isFitted());
    const QJsonObject seen = office.window.views().seenMaps();
    QCOMPARE(seen.size(), 2);
    QVERIFY(seen[toQString(second)].toObject()[u"fitted"].toBool());
    const QString saved = sandbox_->path(QStringLiteral("views.c2sproj"));
    QVERIFY(office.window.files().saveProjectTo(saved));
    office.document().reset(Project{}, {});
    QVERIFY(office.window.views().seenMaps().isEmpty());
    QVERIFY(office.window.files().openProject(saved) && office.waitUntilReady());
    QVERIFY(view.isFitted());
    QVERIFY(show(first));
    QVERIFY(view.viewState() == of_first);
  }

  void everyColumnIsSeenInTheWindowOfTheStart() {
    OfficeWindow office;
    office.addExact(12);
    office.window.resize(1360, 860);
    const QTableView* table = office.window.anchorPanel().table();
    QTRY_COMPARE(table->horizontalScrollBar()->maximum(), 0);
    for (int column = 0; column < AnchorTableModel::kColumnCount; ++column) QVERIFY(table->columnWidth(column) >= 30);
    // In a smaller one the verdicts come before notes and names.
    office.window.resize(1024, 700);
    const auto right = [&](int column) { return table->columnViewportPosition(column) + table->columnWidth(column); };
    QTRY_VERIFY(right(AnchorTableModel::kFlag) <= table->viewport()->width());
    QCOMPARE(table->horizontalScrollBar()->value(), 0);
  }

  void scenario27_everyFieldAndButtonHasANameForScreenReaders() {
    OfficeWindow office;
    office.addExact(4);
    QVERIFY(office.waitUntilSolved());
    SettingsDialog settings(&office.window, {defaultSettings(Model::kStretch), std::nullopt, {}}, {});
    ScaleDialog scale(&office.window, toPath(OfficeWindow::sample("blueprint.png")), Side::kBlueprint);
    CheatSheet keys(&office.window, office.window.actionTable());
    ExportDialog gate(&office.window, exportChecks(office.session()));
    QStringList nameless;
    const std::initializer_list<QWidget*> windows{&office.window, &settings, &scale, &keys, &gate};
    for (QWidget* window : windows) {
      for (QWidget* widget : window->findChildren<QWidget*>()) {
        if (widget->window() != window || widget->focusPolicy() == Qt::NoFocus || widget->isHidden()) continue;
        if (widget->objectName().startsWith(QStringLiteral("qt_")) || qobject_cast<QScrollArea*>(widget)) continue;
        if (widget->inherits("QTabBar") || widget->inherits("QTabWidget")) continue;  // its tabs have names
        QAccessibleInterface* known = QAccessible::queryAccessibleInterface(widget);
        if (known && known->text(QAccessible::Name).isEmpty())
          nameless +=
              QStringLiteral("%1 %2").arg(QLatin1String(widget->metaObject()->className()), widget->objectName());
      }
    }
    QVERIFY2(nameless.isEmpty(), qPrintable(nameless.join(QStringLiteral(", "))));
  }

  void theCheatSheetFitsASmallScreenWithoutScrolling() {
    OfficeWindow office(false);
    CheatSheet keys(&office.window, office.window.actionTable());
    keys.show();
    keys.resize(1280, 800);
    const auto* area = keys.findChild<QScrollArea*>();
    QVERIFY(area);
    QTRY_VERIFY(!area->verticalScrollBar()->isVisible() && !area->horizontalScrollBar()->isVisible());
  }

  void scenario27_everyActionCanBeReachedAndEveryWidgetHasAName() {
    OfficeWindow office;
    for (const QAction* action : office.window.actionTable().all()) {
      QVERIFY(!action->text().isEmpty());
      QVERIFY2(!action->toolTip().isEmpty(), qPrintable(action->text()));
      bool in_menu = false;
      for (const QObject* object : action->associatedObjects()) in_menu = in_menu || object->inherits("QMenu");
      QVERIFY2(in_menu, qPrintable(action->text()));
    }
    QMultiMap<QString, QString> by_key;
    for (const QAction* action : office.window.actionTable().all())
      for (const QKeySequence& key : action->shortcuts()) by_key.insert(key.toString(), action->text());
    for (const QString& key : by_key.uniqueKeys()) QVERIFY2(by_key.count(key) == 1, qPrintable(key));
    for (const Side side : {Side::kBlueprint, Side::kSlam})
      QVERIFY(!office.window.view(side).accessibleName().isEmpty());
  }

  void scenario27_everyTextIsTranslated_data() {
    QTest::addColumn<QString>("language");
    QTest::newRow("German") << QStringLiteral("de");
    QTest::newRow("Spanish") << QStringLiteral("es");
  }
  void scenario27_everyTextIsTranslated() {
    QFETCH(QString, language);
    QFile file(QStringLiteral(CAD2SLAM_SAMPLE_MAPS "/../resources/i18n/cad2slam_%1.ts").arg(language));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QXmlStreamReader xml(&file);
    static const QRegularExpression kPlace(QStringLiteral("%\\d|%n"));
    const auto places = [](const QString& text) {
      QStringList found;
      for (auto match = kPlace.globalMatch(text); match.hasNext();) found += match.next().captured();
      found.sort();
      return found;
    };
    QString source;
    while (!xml.atEnd()) {
      if (xml.readNext() != QXmlStreamReader::StartElement) continue;
      if (xml.name() == QStringLiteral("source")) source = xml.readElementText();
      if (xml.name() == QStringLiteral("translation"))
        QVERIFY2(!xml.attributes().hasAttribute(QStringLiteral("type")), qPrintable(source));
      const bool is_text = xml.name() == QStringLiteral("numerusform") ||
                           (xml.name() == QStringLiteral("translation") && !source.contains(QStringLiteral("%n")));
      if (is_text) QCOMPARE(places(xml.readElementText()), places(source));
    }
    QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
    applyLanguage(language);
    OfficeWindow office(false);
    QVERIFY(!office.window.status().hint().contains(QStringLiteral("Choose")));
    applyLanguage(QStringLiteral("en"));
  }

  void englishCountsAnchors() {
    const auto imported = [](int count) {
      return QCoreApplication::translate("cad2slam::Exports", "%n anchor(s) imported", nullptr, count);
    };
    for (const char* language : {"en", "en_GB", "C", "fi"}) {
      applyLanguage(QString::fromLatin1(language));
      QCOMPARE(imported(1), QStringLiteral("1 anchor imported"));
      QCOMPARE(imported(2), QStringLiteral("2 anchors imported"));
    }
    applyLanguage(QStringLiteral("en"));
  }
};

QTEST_MAIN(LookingTest)
#include "looking_test.moc"
