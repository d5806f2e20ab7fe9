// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QStringList>

namespace cad2slam::testing {

struct CliRun {
  int exit_code = -1;
  QByteArray output;
  QByteArray errors;

  [[nodiscard]] QJsonObject json() const { return QJsonDocument::fromJson(output).object(); }
  /// The one sentence of a failure; empty when there is more or less than one line.
  [[nodiscard]] QString sentence() const {
    const QByteArrayList lines = errors.trimmed().split('\n');
    return lines.size() == 1 ? QString::fromUtf8(lines.first()) : QString();
  }
};

inline CliRun runCli(const QStringList& arguments) {
  QProcess process;
  process.start(CAD2SLAM_CLI, arguments);
  process.waitForFinished(-1);
  CliRun run;
  if (process.exitStatus() == QProcess::NormalExit) run.exit_code = process.exitCode();
  run.output = process.readAllStandardOutput();
  run.errors = process.readAllStandardError();
  return run;
}

inline QString siteFile(const QString& site, const QString& file) {
  return QString(CAD2SLAM_SAMPLE_MAPS) + '/' + site + '/' + file;
}

inline void writeText(const QString& path, const QByteArray& text) {
  QFile file(path);
  if (file.open(QIODevice::WriteOnly)) file.write(text);
}

}  // namespace cad2slam::testing
