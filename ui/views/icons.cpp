// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/views/icons.h"

#include <QFile>
#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QPixmapCache>
#include <QRegularExpression>
#include <QSvgRenderer>

#include <algorithm>

static void initIconResources() {  // a library's resources are not found by themselves; must lie outside a namespace
  Q_INIT_RESOURCE(icons);
}

namespace cad2slam {
namespace {

QColor lineColor(QIcon::Mode mode) {
  const QPalette palette = QGuiApplication::palette();
  switch (mode) {
    case QIcon::Disabled:
      return palette.color(QPalette::Disabled, QPalette::ButtonText);
    case QIcon::Selected:
      return palette.color(QPalette::Active, QPalette::HighlightedText);
    case QIcon::Normal:
    case QIcon::Active:
      break;
  }
  return palette.color(QPalette::Active, QPalette::ButtonText);
}

QColor accentColor(QIcon::Mode mode) {
  if (mode == QIcon::Disabled || mode == QIcon::Selected) return lineColor(mode);
  const bool dark = QGuiApplication::palette().color(QPalette::Button).lightness() < 128;
  return dark ? QColor(0x6c, 0xb1, 0xff) : QColor(0x1e, 0x66, 0xd0);
}

class RecoloredSvg : public QIconEngine {
 public:
  RecoloredSvg(QString name, QByteArray drawing) : name_(std::move(name)), drawing_(std::move(drawing)) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
    QByteArray colored = drawing_;
    colored.replace("currentColor", lineColor(mode).name().toLatin1());
    colored.replace("accentColor", accentColor(mode).name().toLatin1());
    if (mode == QIcon::Disabled) {  // fixed colours have no disabled shade of their own
      static const QRegularExpression kStrong(QStringLiteral("\"#(?!fff)[0-9a-fA-F]+\""));
      colored = QString::fromUtf8(colored)
                    .replace(kStrong, QLatin1Char('"') + lineColor(mode).name() + QLatin1Char('"'))
                    .toUtf8();
    }
    QSvgRenderer renderer(colored);
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    const int side = std::min(rect.width(), rect.height());
    QRect square(0, 0, side, side);
    square.moveCenter(rect.center());
    renderer.render(painter, square);
    painter->restore();
  }

  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    const QString key = QStringLiteral("cad2slam_%1_%2x%3_%4_%5")
                            .arg(name_)
                            .arg(size.width())
                            .arg(size.height())
                            .arg(lineColor(mode).rgba())
                            .arg(accentColor(mode).rgba());
    QPixmap pixmap;
    if (QPixmapCache::find(key, &pixmap)) return pixmap;
    pixmap = QPixmap(size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    paint(&painter, QRect(QPoint(0, 0), size), mode, state);
    painter.end();
    QPixmapCache::insert(key, pixmap);
    return pixmap;
  }

  QIconEngine* clone() const override { return new RecoloredSvg(name_, drawing_); }
  bool isNull() override { return drawing_.isEmpty(); }

 private:
  QString name_;
  QByteArray drawing_;
};

}  // namespace

QIcon icon(const QString& name) {
  initIconResources();
  QFile file(QStringLiteral(":/icons/%1.svg").arg(name));
  if (!file.open(QFile::ReadOnly)) return {};
  return QIcon(new RecoloredSvg(name, file.readAll()));
}

}  // namespace cad2slam
