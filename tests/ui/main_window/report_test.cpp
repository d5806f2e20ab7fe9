// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/report.h"

#include "ui/main_window/appearance.h"
#include "ui/main_window/exports.h"
#include "ui/main_window/program_actions.h"
#include "ui/support/office_window.h"

#include <QAbstractTextDocumentLayout>
#include <QApplication>
#include <QFile>
#include <QImage>
#include <QPainter>
#include <QTextDocument>
#include <QTextTable>

using namespace cad2slam;
using test::OfficeWindow;

class ReportTest : public QObject {
  Q_OBJECT

 private:
  std::optional<test::Sandbox> sandbox_;

  static QTextTable* anchorTable(QTextDocument& text) {
    for (QTextFrame* frame : text.rootFrame()->childFrames())
      if (auto* table = qobject_cast<QTextTable*>(frame); table && table->columns() == 8) return table;
    return nullptr;
  }

 private slots:
  void init() { sandbox_.emplace(); }

  void numbersStayInOneLineAndRowsOnOnePage() {
    OfficeWindow office;
    for (int i = 0; i < 3; ++i) office.addExact(30);  // on several pages
    edit::rename(office.document(), 7, "north stairs");
    const auto text = reportDocument(office.session(), {});
    QTextTable* table = anchorTable(*text);
    QVERIFY(table);
    const double page_height = text->pageSize().height();
    QCOMPARE(table->rows(), 91);
    int last_page = 0;
    for (int row = 0; row < table->rows(); ++row) {
      double top = 1e9;
      double bottom = 0.0;
      for (int column = 0; column < table->columns(); ++column) {
        const QTextBlock block = table->cellAt(row, column).firstCursorPosition().block();
        const QRectF box = text->documentLayout()->blockBoundingRect(block);
        top = std::min(top, box.top());
        bottom = std::max(bottom, box.bottom());
        if (row > 0) QCOMPARE(block.layout()->lineCount(), 1);
      }
      QVERIFY2(int(top / page_height) == int((bottom - 1.0) / page_height), qPrintable(QString::number(row)));
      last_page = int(bottom / page_height);
    }
    QVERIFY(last_page > 0);
    QVERIFY(text->pageCount() > last_page);
  }

  void itSaysWhatItsFiguresAreNot() {
    OfficeWindow office;
    office.addExact(6);
    QVERIFY(office.waitUntilSolved());
    const QString stale = QStringLiteral("an earlier state");
    const QString unsaved = QStringLiteral("not saved in its file");
    QVERIFY(reportHtml(office.session(), {}).contains(unsaved));
    QVERIFY(!reportHtml(office.session(), {}).contains(stale));
    QVERIFY(office.window.files().saveProjectTo(sandbox_->path(QStringLiteral("site.c2sproj"))));
    QVERIFY(!reportHtml(office.session(), {}).contains(unsaved));
    edit::deleteAnchors(office.document(), {3});
    QVERIFY(reportHtml(office.session(), {}).contains(stale));
    QVERIFY(
        office.window.exports().suggestion(QStringLiteral("-report.pdf")).endsWith(QStringLiteral("/site-report.pdf")));
  }

  void thereIsNoneOfNothing() {
    OfficeWindow office(false);
    const QAction* report = office.window.actionTable()[ActionId::kExportReport];
    QVERIFY(!report->isEnabled());
    QVERIFY(report->toolTip().contains(QStringLiteral("load both")));
    office.loadMaps();
    QVERIFY(report->isEnabled());
    QVERIFY(!report->toolTip().contains(QStringLiteral("load both")));
  }

  void itIsBlackOnWhiteInEveryTheme() {
    OfficeWindow office;
    const QPalette before = QApplication::palette();
    applyTheme(Theme::kDark);
    const auto text = reportDocument(office.session(), {});
    QImage page(text->pageSize().toSize(), QImage::Format_Grayscale8);
    page.fill(Qt::white);
    QPainter painter(&page);
    drawReportPage(painter, *text, 0);
    painter.end();
    applyTheme(Theme::kSystem);
    QApplication::setPalette(before);
    int ink = 0;
    for (int y = 0; y < page.height(); ++y)
      for (int x = 0; x < page.width(); ++x) ink += qGray(page.pixel(x, y)) < 64 ? 1 : 0;
    QVERIFY2(ink > 500, qPrintable(QString::number(ink)));
  }

  void itIsWrittenAsPdf() {
    OfficeWindow office;
    office.addExact(6);
    QVERIFY(office.waitUntilSolved());
    const QString path = sandbox_->path(QStringLiteral("report.pdf"));
    QVERIFY(saveReport(office.window, path));
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QVERIFY(file.read(5) == "%PDF-");
    QVERIFY(file.size() > 10'000);
  }
};

QTEST_MAIN(ReportTest)
#include "report_test.moc"
