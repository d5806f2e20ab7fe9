// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/services/autosave.h"

#include "cad2slam/io/atomic_file.h"
#include "cad2slam/io/project_file.h"
#include "ui/convert.h"
#include "ui/engine_sentences.h"
#include "ui/services/guarded.h"

#include <QDir>
#include <QStandardPaths>
#include <QUuid>

#include <algorithm>
#include <utility>

namespace cad2slam {
namespace {

constexpr std::size_t kLongestPath = 1 << 16;

QString lockOf(const QString& folder) {
  return folder + QStringLiteral("/lock");
}
QString pathFileOf(const QString& folder) {
  return folder + QStringLiteral("/path");
}
QString versionFile(const QString& folder, int version) {
  return QStringLiteral("%1/%2.c2sproj").arg(folder).arg(version, 8, 10, QLatin1Char('0'));
}

}  // namespace

bool Recoverable::isOvertaken() const {
  const QFileInfo saved(project_path);
  return !project_path.isEmpty() && saved.exists() && saved.lastModified() > last_edit;
}

Autosave::Autosave(ProjectDocument& document, const QString& root, QObject* parent)
    : QObject(parent), document_(document), root_(root) {
  connect(&document_, &ProjectDocument::changed, this, [this](const ChangeEvent& event) {
    if (event.interim) return;
    if (!document_.isModified()) return clear();
    // The first edit is announced before the undo stack counts it, so as unmodified; then it is told as a saved state.
    if (event.what != Changes(Change::kSavedState) || !lock_) write();
  });
}

Autosave::~Autosave() = default;

QString Autosave::defaultRoot() {
  return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + QStringLiteral("/journal");
}

bool Autosave::prepare() {
  if (lock_) return true;
  folder_ = root_ + QLatin1Char('/') + QUuid::createUuid().toString(QUuid::WithoutBraces);
  if (!QDir().mkpath(folder_)) {
    if (!std::exchange(failure_told_, true))
      emit failed(tr("%1 cannot be created, so nothing is autosaved").arg(folder_));
    return false;
  }
  lock_ = std::make_shared<QLockFile>(lockOf(folder_));
  lock_->setStaleLockTime(0);  // only the death of the program ends it
  lock_->tryLock(0);
  return true;
}

void Autosave::write() {
  if (!prepare()) return;
  lane_.start(
      [this, project = document_.projectToSave(), path = document_.path(), folder = folder_, version = ++newest_] {
        if (version < newest_) return;
        const Result<void> outcome = guarded([&]() -> Result<void> {
          if (Result<void> kept = writeFileAtomically(toPath(pathFileOf(folder)), path.string()); !kept) return kept;
          if (Result<void> kept = writeProject(toPath(versionFile(folder, version)), project); !kept) return kept;
          return {};
        });
        const QStringList versions = QDir(folder).entryList({QStringLiteral("*.c2sproj")}, QDir::Files, QDir::Name);
        for (int i = 0; i + kVersions < versions.size(); ++i) QFile::remove(folder + QLatin1Char('/') + versions[i]);
        QMetaObject::invokeMethod(
            this, [this, outcome] { tell(outcome); }, Qt::QueuedConnection);
      });
}

bool Autosave::flush() {
  lane_.waitForDone();
  return newest_ > 0 && QFileInfo::exists(versionFile(folder_, newest_));
}

void Autosave::tell(const Result<void>& outcome) {
  if (outcome) {
    failure_told_ = false;
    emit written();
  } else if (!std::exchange(failure_told_, true)) {
    emit failed(toSentence(outcome.error()));
  }
}

void Autosave::clear() {
  if (!lock_) return;
  ++newest_;
  lane_.start([lock = std::exchange(lock_, nullptr), folder = std::exchange(folder_, QString())]() mutable {
    lock.reset();
    QDir(folder).removeRecursively();
  });
}

std::vector<Recoverable> Autosave::findRecoverable(const QString& root) {
  std::vector<Recoverable> found;
  for (const QFileInfo& entry : QDir(root).entryInfoList(QDir::Dirs | QDir::NoDotAndDotDot)) {
    const QString folder = entry.absoluteFilePath();
    QLockFile lock(lockOf(folder));
    lock.setStaleLockTime(0);
    if (!lock.tryLock(0)) continue;  // that program lives
    QStringList versions = QDir(folder).entryList({QStringLiteral("*.c2sproj")}, QDir::Files, QDir::Name);
    if (versions.isEmpty()) {  // it died before its first edit was on disk
      lock.unlock();
      QDir(folder).removeRecursively();
      continue;
    }
    Recoverable recoverable;
    recoverable.folder = folder;
    bool readable = false;
    while (!versions.isEmpty() && !readable) {
      const QString file = folder + QLatin1Char('/') + versions.takeLast();
      Result<Project> project = readProject(toPath(file));
      readable = project.has_value();
      if (readable) recoverable.project = *std::move(project);
      if (!readable && recoverable.unreadable.isEmpty()) recoverable.unreadable = toSentence(project.error());
      if (readable || recoverable.last_edit.isNull()) recoverable.last_edit = QFileInfo(file).lastModified();
    }
    if (readable) recoverable.unreadable.clear();
    lock.unlock();
    if (const Result<std::string> path = readFile(toPath(pathFileOf(folder)), kLongestPath))
      recoverable.project_path = toQString(std::filesystem::path(*path));
    found.push_back(std::move(recoverable));
  }
  std::sort(found.begin(), found.end(),
            [](const Recoverable& a, const Recoverable& b) { return a.last_edit > b.last_edit; });
  return found;
}

void Autosave::discard(const Recoverable& recoverable) {
  QDir(recoverable.folder).removeRecursively();
}

}  // namespace cad2slam
