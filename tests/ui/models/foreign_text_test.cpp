// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/models/foreign_text.h"

#include <QTest>
#include <QTextDocument>

using namespace cad2slam;

class ForeignTextTest : public QObject {
  Q_OBJECT

 private slots:
  void markupIsShownLetterByLetter_data() {
    QTest::addColumn<QString>("text");
    for (const char* text : {"<b>bold</b>", "a <img src=/dev/zero> b", "<table><tr><td>", "plan & <site>\nsecond line",
                             "no markup", "5 < 6", "&lt;b&gt;", ""})
      QTest::newRow(text) << QString::fromLatin1(text);
  }
  void markupIsShownLetterByLetter() {
    QFETCH(QString, text);
    const QString plain = asPlainText(text);
    QTextDocument shown;
    Qt::mightBeRichText(plain) ? shown.setHtml(plain) : shown.setPlainText(plain);
    QCOMPARE(shown.toPlainText(), text);
  }

  void longTextsEndInAnEllipsis() {
    QCOMPARE(shortened(QString(60, QLatin1Char('a'))), QString(60, QLatin1Char('a')));
    const QString cut = shortened(QString(100'000, QLatin1Char('a')));
    QCOMPARE(cut, QString(60, QLatin1Char('a')) + QChar(0x2026));
    // No half of a letter stays behind.
    const QString letter = QString::fromUcs4(U"\U0001F3E2");
    QCOMPARE(letter.size(), 2);
    const QString odd = shortened(QLatin1Char('a') + letter.repeated(100));
    QCOMPARE(odd, QLatin1Char('a') + letter.repeated(29) + QChar(0x2026));
  }
};

QTEST_MAIN(ForeignTextTest)
#include "foreign_text_test.moc"
