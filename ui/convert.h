// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFile>
#include <QPointF>
#include <QString>

#include <Eigen/Core>

#include <filesystem>
#include <string>

namespace cad2slam {

// The one bridge between the engine's types and Qt's.

inline QString toQString(const std::string& text) {
  return QString::fromStdString(text);
}
inline std::string toStd(const QString& text) {
  return text.toStdString();
}

inline QString toQString(const std::filesystem::path& path) {
  return QFile::decodeName(QByteArray::fromStdString(path.string()));
}
inline std::filesystem::path toPath(const QString& path) {
  return QFile::encodeName(path).toStdString();
}

inline QPointF toQPointF(const Eigen::Vector2d& point) {
  return {point.x(), point.y()};
}
inline Eigen::Vector2d toEigen(const QPointF& point) {
  return {point.x(), point.y()};
}

}  // namespace cad2slam
