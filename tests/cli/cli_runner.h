// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/resource.h>

#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QStringList>
#include <QTemporaryDir>

#include <csignal>
#include <optional>

namespace cad2slam::testing {

/// How one run of cad2slam-cli ended.
struct CliRun {
  int exit_code = -1;  ///< -1: it crashed, was killed or did not end in time
  QString out;
  QString err;

  [[nodiscard]] QJsonObject json() const { return QJsonDocument::fromJson(out.toUtf8()).object(); }
  /// The one sentence of a failure; empty when there is more or less than one line.
  [[nodiscard]] QString sentence() const {
    const QStringList all = err.split('\n', Qt::SkipEmptyParts);
    return all.size() == 1 ? all.first() : QString();
  }
  [[nodiscard]] QStringList lines() const { return out.split('\n', Qt::SkipEmptyParts); }
  /// What went wrong, without warnings.
  [[nodiscard]] QStringList errors() const {
    QStringList found;
    for (const QString& line : err.split('\n', Qt::SkipEmptyParts)) {
      if (!line.startsWith("cad2slam-cli: warning: ")) found << line;
    }
    return found;
  }
};

/// What a run may use.
struct CliLimits {
  std::optional<rlim_t> file_bytes;  ///< writing beyond fails, as on a full disk
  QString output;                    ///< file that takes standard output
};

inline void limitMemory() {
#ifndef __SANITIZE_ADDRESS__  // which reserves terabytes
  constexpr rlim_t kBytes = rlim_t{3} << 30;
  const rlimit limit{kBytes, kBytes};
  setrlimit(RLIMIT_AS, &limit);
#endif
}

inline void prepare(QProcess& process, const QString& folder, const CliLimits& limits = {}) {
  process.setWorkingDirectory(folder);
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert("OPENBLAS_NUM_THREADS", "1");
  process.setProcessEnvironment(environment);
  if (!limits.output.isEmpty()) process.setStandardOutputFile(limits.output);
  process.setChildProcessModifier([file_bytes = limits.file_bytes] {
    limitMemory();
    if (!file_bytes) return;
    const rlimit limit{*file_bytes, *file_bytes};
    setrlimit(RLIMIT_FSIZE, &limit);
    std::signal(SIGXFSZ, SIG_IGN);  // write() then says so instead
  });
}

/// Runs cad2slam-cli in `folder`.
inline CliRun runCli(const QString& folder, const QStringList& arguments, const QByteArray& input = {},
                     const CliLimits& limits = {}) {
  QProcess process;
  prepare(process, folder, limits);
  process.start(CAD2SLAM_CLI, arguments);
  process.write(input);
  process.closeWriteChannel();
  constexpr int kPatience_ms = 300'000;  // for sanitizers on a busy machine
  if (!process.waitForFinished(kPatience_ms)) process.kill();
  CliRun run;
  if (process.exitStatus() == QProcess::NormalExit) run.exit_code = process.exitCode();
  run.out = QString::fromUtf8(process.readAllStandardOutput());
  run.err = QString::fromUtf8(process.readAllStandardError());
  return run;
}

inline CliRun runCli(const QStringList& arguments) {
  return runCli(QDir::currentPath(), arguments);
}

inline QString siteFile(const QString& site, const QString& file) {
  return QString(CAD2SLAM_SAMPLE_MAPS) + '/' + site + '/' + file;
}

inline QByteArray bytesOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

inline bool overwrite(const QString& path, const QByteArray& bytes) {
  QFile file(path);
  return file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size();
}

/// A folder of its own with the office of the sample maps.
class OfficeFolder {
 public:
  OfficeFolder() {
    const QDir site(QString(CAD2SLAM_SAMPLE_MAPS) + "/office");
    for (const char* name : {"blueprint.yaml", "blueprint.png", "slam_1.yaml", "slam_1.png", "anchors_1.csv"}) {
      QFile::copy(site.filePath(name), folder_.filePath(name));
    }
  }

  [[nodiscard]] QString path() const { return folder_.path(); }
  [[nodiscard]] QString file(const QString& name) const { return folder_.filePath(name); }
  [[nodiscard]] QStringList names() const {
    return QDir(folder_.path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot, QDir::Name);
  }
  [[nodiscard]] CliRun run(const QStringList& arguments, const QByteArray& input = {},
                           const CliLimits& limits = {}) const {
    return runCli(path(), arguments, input, limits);
  }
  /// Arguments that solve the office; coarse cells, as only the way there is of interest.
  [[nodiscard]] static QStringList solveArguments(const QStringList& more) {
    return QStringList{"solve",     "--blueprint",   "blueprint.yaml", "--slam", "slam_1.yaml",
                       "--anchors", "anchors_1.csv", "--cell-size",    "2"} +
           more;
  }

 private:
  QTemporaryDir folder_;
};

}  // namespace cad2slam::testing
