// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/anchor_editing.h"

#include "ui/support/office_window.h"

#include <QInputDialog>
#include <QTimer>

using namespace cad2slam;
using test::OfficeWindow;

class AnchorEditingTest : public QObject {
  Q_OBJECT

 private:
  std::optional<test::Sandbox> sandbox_;

  /// Rescales as by hand; what is in the dialog stays where `text` is null.
  static void rescale(OfficeWindow& office, const QString& text) {
    QTimer driver;
    connect(&driver, &QTimer::timeout, &driver, [text] {
      auto* dialog = qobject_cast<QInputDialog*>(QApplication::activeModalWidget());
      if (!dialog) return;
      if (!text.isNull()) dialog->setTextValue(text);
      dialog->accept();
    });
    driver.start(20);
    office.window.actionTable()[ActionId::kRescale]->trigger();
  }
  static double resolution(OfficeWindow& office) {
    return office.document().project().blueprint.metadata.resolution_m_per_px;
  }

 private slots:
  void init() { sandbox_.emplace(); }

  void aScaleThatIsLeftAloneKeepsItsDigits() {
    OfficeWindow office(false);
    constexpr double kOdd = 0.0254 / 3.0;
    QVERIFY(office.window.files().setImage(Side::kBlueprint, OfficeWindow::sample("blueprint.png"), kOdd));
    const int steps = office.document().undoStack().count();
    rescale(office, {});
    QCOMPARE(office.document().undoStack().count(), steps);
    QVERIFY(resolution(office) == kOdd);
    rescale(office, QStringLiteral("0.02"));
    QCOMPARE(resolution(office), 0.02);
  }

  void aScaleThatCouldNotBeSavedIsRefused() {
    OfficeWindow office;
    const double before = resolution(office);
    for (const char* text : {"1000000000", "10001", "0.0000001", "0", "-1", "wide"}) {
      office.window.messages().remove(QStringLiteral("toast"));
      rescale(office, QLatin1String(text));
      QVERIFY2(resolution(office) == before, text);
      QVERIFY2(office.hasMessage(QStringLiteral("toast")), text);
    }
    rescale(office, QStringLiteral("10000"));
    QCOMPARE(resolution(office), 10000.0);
    QVERIFY(office.window.files().saveProjectTo(sandbox_->path(QStringLiteral("coarse.c2sproj"))));
  }
};

QTEST_MAIN(AnchorEditingTest)
#include "anchor_editing_test.moc"
