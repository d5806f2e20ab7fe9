// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/appearance.h"

#include "ui/main_window/clear_boxes.h"

#include <QApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QPalette>
#include <QSettings>
#include <QStyle>
#include <QStyleFactory>
#include <QTranslator>
#include <QWidget>

#include <algorithm>

namespace cad2slam {
namespace {

struct Colors {
  QRgb window;
  QRgb base;
  QRgb alternate;
  QRgb text;
  QRgb disabled;
  QRgb button;
  QRgb highlight;
  QRgb highlighted_text;
  QRgb link;
};

constexpr Colors kLight{0xffefefef, 0xffffffff, 0xfff6f6f6, 0xff1c1c1c, 0xff8a8a8a,
                        0xffe6e6e6, 0xff2a78c8, 0xffffffff, 0xff0b5cad};
constexpr Colors kDark{0xff2b2d30, 0xff1f2123, 0xff26282b, 0xffe8e8e8, 0xff85888c,
                       0xff3a3d41, 0xff3d8fe0, 0xffffffff, 0xff7db8f0};
// Black on white at full strength with a strong yellow: what is left of a screen in the sun.
constexpr Colors kContrast{0xffffffff, 0xffffffff, 0xffffffff, 0xff000000, 0xff505050,
                           0xffffffff, 0xff000000, 0xffffff00, 0xff0000c0};

/// Of texts that are second to others, and still have to be read: Qt's own grey is too faint for that.
QColor secondaryText(const QPalette& palette) {
  constexpr double kOfText = 0.7;
  const QColor text = palette.color(QPalette::Active, QPalette::WindowText);
  const QColor window = palette.color(QPalette::Active, QPalette::Window);
  const auto mix = [](int of_text, int of_window) {
    return static_cast<int>(kOfText * of_text + (1.0 - kOfText) * of_window);
  };
  return {mix(text.red(), window.red()), mix(text.green(), window.green()), mix(text.blue(), window.blue())};
}

QPalette paletteOf(const Colors& colors) {
  QPalette palette{QColor(colors.button), QColor(colors.window)};
  palette.setColor(QPalette::Window, colors.window);
  palette.setColor(QPalette::Base, colors.base);
  palette.setColor(QPalette::AlternateBase, colors.alternate);
  palette.setColor(QPalette::Button, colors.button);
  for (const QPalette::ColorRole role :
       {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText})
    palette.setColor(role, colors.text);
  for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    palette.setColor(QPalette::Disabled, role, colors.disabled);
  palette.setColor(QPalette::ToolTipBase, colors.base);
  palette.setColor(QPalette::Highlight, colors.highlight);
  palette.setColor(QPalette::HighlightedText, colors.highlighted_text);
  palette.setColor(QPalette::Link, colors.link);
  return palette;
}

}  // namespace

Appearance readAppearance() {
  const QSettings settings;
  Appearance appearance;
  const int theme = settings.value(QStringLiteral("theme"), 0).toInt();
  appearance.theme = static_cast<Theme>(std::clamp(theme, 0, static_cast<int>(Theme::kHighContrast)));
  appearance.language = settings.value(QStringLiteral("language")).toString();
  return appearance;
}

void writeAppearance(const Appearance& appearance) {
  QSettings settings;
  settings.setValue(QStringLiteral("theme"), static_cast<int>(appearance.theme));
  settings.setValue(QStringLiteral("language"), appearance.language);
}

void applyTheme(Theme theme) {
  static const QString kSystemStyle = QApplication::style()->objectName();
  static const QPalette kSystemPalette = QApplication::palette();
  // Only Fusion takes every colour from the palette.
  const QString style = theme == Theme::kSystem ? kSystemStyle : QStringLiteral("Fusion");
  if (style.compare(QLatin1String("Fusion"), Qt::CaseInsensitive) == 0) {
    QApplication::setStyle(new ClearBoxes);
  } else {
    QApplication::setStyle(QStyleFactory::create(style));
  }
  QPalette palette = theme == Theme::kSystem  ? kSystemPalette
                     : theme == Theme::kLight ? paletteOf(kLight)
                     : theme == Theme::kDark  ? paletteOf(kDark)
                                              : paletteOf(kContrast);
  palette.setColor(QPalette::PlaceholderText, secondaryText(palette));
  QApplication::setPalette(palette);
  QString sheet;
  if (theme == Theme::kHighContrast)
    sheet = QStringLiteral(
        "QToolButton:checked, QToolButton:focus, QPushButton, QLineEdit, QComboBox { border: 2px solid black; }"
        "QAbstractItemView::item:selected { background: black; color: yellow; }"
        "QPushButton, QLineEdit, QComboBox { padding: 3px 8px; }"
        "*:focus { outline: 2px solid black; }");
  qApp->setStyleSheet(sheet);
  // Sheets of single widgets have looked up the colours of the palette before.
  for (QWidget* widget : QApplication::allWidgets())
    if (const QString own = widget->styleSheet(); !own.isEmpty()) {
      widget->setStyleSheet({});
      widget->setStyleSheet(own);
    }
}

void applyLanguage(const QString& language) {
  const QLocale locale = language.isEmpty() ? QLocale::system() : QLocale(language);
  QLocale::setDefault(locale);
  static QTranslator own;
  static QTranslator of_qt;
  QCoreApplication::removeTranslator(&own);
  QCoreApplication::removeTranslator(&of_qt);
  const auto load = [](const QLocale& of) {
    return own.load(of, QStringLiteral("cad2slam"), QStringLiteral("_"), QStringLiteral(":/i18n"));
  };
  // Where nothing else is there, English knows at least singular and plural.
  if (load(locale) || load(QLocale(QLocale::English))) QCoreApplication::installTranslator(&own);
  if (of_qt.load(locale, QStringLiteral("qtbase"), QStringLiteral("_"),
                 QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
    QCoreApplication::installTranslator(&of_qt);
}

}  // namespace cad2slam
