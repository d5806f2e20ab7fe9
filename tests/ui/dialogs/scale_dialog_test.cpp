// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/scale_dialog.h"

#include "ui/convert.h"
#include "ui/support/office_window.h"

#include <QLineEdit>

using namespace cad2slam;

namespace {

/// The dialog over the sample's blueprint, and a hand that draws in it.
class Shown {
 public:
  Shown() : dialog(nullptr, toPath(test::OfficeWindow::sample("blueprint.png")), Side::kBlueprint) {
    dialog.show();
    (void)QTest::qWaitForWindowExposed(&dialog);
    view = dialog.findChild<MapView*>();
    (void)QTest::qWaitFor([this] { return view->frame().has_value(); }, test::kPatience);
    view->fit();
  }
  [[nodiscard]] QPoint at(const QPointF& pixel) const { return view->widgetFromMetres(pixel).toPoint(); }
  void click(const QPointF& pixel) { QTest::mouseClick(view, Qt::LeftButton, {}, at(pixel)); }

  ScaleDialog dialog;
  MapView* view = nullptr;
};

}  // namespace

class ScaleDialogTest : public QObject {
  Q_OBJECT

 private slots:
  void afterBothEndsTheLengthIsTyped() {
    Shown shown;
    shown.click({300.0, 400.0});
    shown.click({700.0, 400.0});
    QWidget* typed_into = shown.dialog.focusWidget();
    QCOMPARE(typed_into, shown.dialog.findChild<QLineEdit*>(QStringLiteral("length")));
    QTest::keyClicks(typed_into, QStringLiteral("20"));
    QVERIFY(shown.dialog.metresPerPixel());
    QVERIFY(std::abs(*shown.dialog.metresPerPixel() / (20.0 / 400.0) - 1.0) < 0.03);  // clicks are whole pixels
  }

  void anEndCanBeDragged() {
    Shown shown;
    shown.click({300.0, 400.0});
    shown.click({700.0, 400.0});
    QTest::keyClicks(shown.dialog.focusWidget(), QStringLiteral("20"));
    const auto drag = [&](const QPoint& from, const QPoint& to) {
      QTest::mousePress(shown.view, Qt::LeftButton, {}, from);
      for (int step = 1; step <= 5; ++step) QTest::mouseMove(shown.view, from + (to - from) * step / 5);
    };
    drag(shown.at({700.0, 400.0}), shown.at({1100.0, 400.0}));
    QTest::mouseRelease(shown.view, Qt::LeftButton, {}, shown.at({1100.0, 400.0}));
    QVERIFY(std::abs(*shown.dialog.metresPerPixel() / (20.0 / 800.0) - 1.0) < 0.03);
    // Esc puts it back.
    const double dragged = *shown.dialog.metresPerPixel();
    drag(shown.at({1100.0, 400.0}), shown.at({1100.0, 900.0}));
    QVERIFY(*shown.dialog.metresPerPixel() < dragged);
    shown.view->setFocus();
    QTest::keyClick(shown.view, Qt::Key_Escape);
    QCOMPARE(*shown.dialog.metresPerPixel(), dragged);
    QVERIFY(shown.dialog.isVisible());
    QTest::mouseRelease(shown.view, Qt::LeftButton, {}, shown.at({1100.0, 900.0}));
    QCOMPARE(*shown.dialog.metresPerPixel(), dragged);
  }
};

QTEST_MAIN(ScaleDialogTest)
#include "scale_dialog_test.moc"
