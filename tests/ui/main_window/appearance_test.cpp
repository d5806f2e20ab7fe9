// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/appearance.h"

#include <QApplication>
#include <QDir>
#include <QKeySequence>
#include <QLibraryInfo>
#include <QLocale>
#include <QPainter>
#include <QPalette>
#include <QStyle>
#include <QStyleOptionButton>
#include <QTest>

#include <algorithm>
#include <cmath>

using namespace cad2slam;

namespace {

/// 1 for equal colours, 21 for black on white (WCAG).
double contrast(const QColor& a, const QColor& b) {
  const auto luminance = [](const QColor& color) {
    const auto linear = [](double part) {
      return part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) + 0.0722 * linear(color.blueF());
  };
  const auto [low, high] = std::minmax(luminance(a), luminance(b));
  return (high + 0.05) / (low + 0.05);
}

}  // namespace

class AppearanceTest : public QObject {
  Q_OBJECT

  static void addThemes() {
    QTest::addColumn<int>("theme");
    QTest::newRow("system") << int(Theme::kSystem);
    QTest::newRow("light") << int(Theme::kLight);
    QTest::newRow("dark") << int(Theme::kDark);
    QTest::newRow("high contrast") << int(Theme::kHighContrast);
  }

 private slots:
  void cleanup() {
    applyTheme(Theme::kSystem);
    applyLanguage(QStringLiteral("en"));
    QLocale::setDefault(QLocale::c());
  }

  void secondaryTextsCanBeRead_data() { addThemes(); }
  void secondaryTextsCanBeRead() {
    QFETCH(int, theme);
    applyTheme(static_cast<Theme>(theme));
    const QPalette palette = QApplication::palette();
    for (const QPalette::ColorRole below : {QPalette::Window, QPalette::Base, QPalette::AlternateBase})
      QVERIFY(contrast(palette.color(QPalette::PlaceholderText), palette.color(below)) >= 4.5);
  }

  void checkBoxesAreSeen_data() { addThemes(); }
  void checkBoxesAreSeen() {
    QFETCH(int, theme);
    applyTheme(static_cast<Theme>(theme));
    const QPalette palette = QApplication::palette();
    for (const bool checked : {false, true}) {
      QStyleOptionButton option;
      option.rect = QRect(4, 4, 16, 16);
      option.state = QStyle::State_Enabled | (checked ? QStyle::State_On : QStyle::State_Off);
      option.palette = palette;
      option.palette.setColor(QPalette::Text, Qt::yellow);  // of a selected row
      QImage picture(24, 24, QImage::Format_ARGB32_Premultiplied);
      picture.fill(palette.color(QPalette::Base));
      QPainter painter(&picture);
      QApplication::style()->drawPrimitive(QStyle::PE_IndicatorItemViewItemCheck, &option, &painter, nullptr);
      painter.end();
      double of_frame = 1.0;
      for (int x = 0; x < 12; ++x)
        of_frame = std::max(of_frame, contrast(picture.pixelColor(x, 12), picture.pixelColor(0, 0)));
      QVERIFY(of_frame >= 3.0);
      double inside = 1.0;
      for (int x = 8; x < 16; ++x)
        for (int y = 8; y < 16; ++y)
          inside = std::max(inside, contrast(picture.pixelColor(x, y), palette.color(QPalette::Base)));
      QVERIFY(checked ? inside >= 4.5 : inside < 1.2);
    }
  }

  void qtSpeaksTheLanguageOfTheProgram() {
    const QDir folder(QLibraryInfo::path(QLibraryInfo::TranslationsPath));
    if (!folder.exists(QStringLiteral("qtbase_de.qm"))) QSKIP("Qt's own translations are not installed");
    applyLanguage(QStringLiteral("de"));
    QCOMPARE(QCoreApplication::translate("QPlatformTheme", "Cancel"), QStringLiteral("Abbrechen"));
    QCOMPARE(QKeySequence(QStringLiteral("Ctrl+Z")).toString(QKeySequence::NativeText), QStringLiteral("Strg+Z"));
    applyLanguage(QStringLiteral("es"));
    QCOMPARE(QCoreApplication::translate("QPlatformTheme", "Cancel"), QStringLiteral("Cancelar"));
  }
};

QTEST_MAIN(AppearanceTest)
#include "appearance_test.moc"
