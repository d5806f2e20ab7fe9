// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/recovery.h"

#include "ui/support/documents.h"
#include "ui/support/office_window.h"

#include <QDateTime>
#include <QFile>
#include <QProcess>
#include <QThread>

#include <csignal>

using namespace cad2slam;
using test::OfficeWindow;

namespace {

constexpr char kVictimFlag[] = "--edit-until-killed";

}  // namespace

/// What a program that did not end by itself leaves behind.
class RecoveryTest : public QObject {
  Q_OBJECT

 private:
  std::optional<test::Sandbox> sandbox_;

  static void write(const QString& path, const QByteArray& text) {
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(text);
  }
  static void setAge(const QString& path, int seconds) {
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadWrite));
    QVERIFY(file.setFileTime(QDateTime::currentDateTime().addSecs(-seconds), QFileDevice::FileModificationTime));
  }
  /// The journal of a dead program, with one version.
  static QString leaveJournal(const QString& project_path, const QByteArray& version) {
    const QString folder = Autosave::defaultRoot() + QStringLiteral("/dead");
    QDir().mkpath(folder);
    write(folder + QStringLiteral("/path"), project_path.toUtf8());
    if (!version.isEmpty()) write(folder + QStringLiteral("/00000001.c2sproj"), version);
    return folder;
  }
  static QByteArray smallJournal() {
    return QByteArray::fromStdString(formatProject(test::smallProject(), "/nowhere/site.c2sproj"));
  }
  static QString recoveryText(OfficeWindow& office) {
    for (const Message& message : office.window.messages().messages())
      if (message.id.startsWith(QStringLiteral("recovery-"))) return message.text;
    return {};
  }

 private slots:
  void init() {
    sandbox_.emplace();
    QDir(Autosave::defaultRoot()).removeRecursively();
  }

  void scenario19_killedWhileEditingLosesAtMostTheLastGesture_data() {
    QTest::addColumn<int>("edits");
    QTest::newRow("after the first") << 1;
    QTest::newRow("in the middle") << 25;
  }
  void scenario19_killedWhileEditingLosesAtMostTheLastGesture() {
    QFETCH(int, edits);
    const QString root = Autosave::defaultRoot();
    QProcess victim;
    victim.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    victim.start(QCoreApplication::applicationFilePath(), {QLatin1String(kVictimFlag), root, QString::number(edits)});
    QVERIFY(victim.waitForStarted(test::kPatience));
    int told = 0;  // edits the victim knows to be on disk
    QElapsedTimer since;
    since.start();
    while (told < edits && since.elapsed() < test::kPatience) {
      victim.waitForReadyRead(1000);
      while (victim.canReadLine()) told = victim.readLine().trimmed().toInt();
    }
    QVERIFY(told >= edits);
    ::kill(pid_t(victim.processId()), SIGKILL);
    victim.waitForFinished();
    while (victim.canReadLine()) told = victim.readLine().trimmed().toInt();

    const std::vector<Recoverable> found = Autosave::findRecoverable(root);
    QCOMPARE(found.size(), std::size_t(1));
    QVERIFY(int(found[0].project.slam_maps.at(0).anchors.size()) >= told);
    QCOMPARE(found[0].project_path, QStringLiteral("/nowhere/site.c2sproj"));

    OfficeWindow office(false);
    QVERIFY(office.window.recovery().offer());
    QVERIFY(office.pressCure(QStringLiteral("recovery-"), QStringLiteral("Recover")));
    QVERIFY(int(office.document().anchors().size()) >= told);
    QVERIFY(office.document().isModified());
    // It is this run's to keep now; the dead one's is gone.
    QVERIFY(Autosave::findRecoverable(root).empty());
    QVERIFY(!office.window.recovery().offer());
    office.document().reset(Project{}, {});
  }

  void aCleanEndLeavesNothingToRecover() {
    {
      OfficeWindow office;
      office.addExact(3);
      office.window.recovery().autosave().flush();
      QVERIFY(office.window.files().saveProjectTo(sandbox_->path(QStringLiteral("site.c2sproj"))));
      office.window.recovery().autosave().flush();
    }
    QVERIFY(Autosave::findRecoverable(Autosave::defaultRoot()).empty());
  }

  void aProjectSavedSinceIsNotReplacedByAnOldJournal() {
    const QString path = sandbox_->path(QStringLiteral("site.c2sproj"));
    OfficeWindow office;
    office.addExact(5);
    QVERIFY(office.window.files().saveProjectTo(path));
    const QString folder = leaveJournal(path, smallJournal());
    setAge(folder + QStringLiteral("/00000001.c2sproj"), 3600);
    QVERIFY(office.window.recovery().offer());
    QVERIFY2(recoveryText(office).contains(QStringLiteral("saved again")), qPrintable(recoveryText(office)));
    QVERIFY(office.pressCure(QStringLiteral("recovery-"), QStringLiteral("Recover")));
    QVERIFY(office.document().anchors().empty());
    QVERIFY(office.document().path().empty());
    QVERIFY(office.document().isModified());
    QVERIFY(!QDir(folder).exists());
    office.document().reset(Project{}, {});
  }

  void aJournalNewerThanItsProjectTakesItsPlace() {
    const QString path = sandbox_->path(QStringLiteral("site.c2sproj"));
    OfficeWindow office(false);
    write(path, smallJournal());
    setAge(path, 3600);
    leaveJournal(path, smallJournal());
    QVERIFY(office.window.recovery().offer());
    QVERIFY2(!recoveryText(office).contains(QStringLiteral("saved again")), qPrintable(recoveryText(office)));
    QVERIFY(office.pressCure(QStringLiteral("recovery-"), QStringLiteral("Recover")));
    QCOMPARE(toQString(office.document().path()), path);
    office.document().reset(Project{}, {});
  }

  void whatIsOfferedIsKnownByItsImages() {
    AnchorList anchors(2);
    anchors[0].id = 1;
    anchors[1].id = 2;
    Project project = test::smallProject();
    project.slam_maps.front().anchors = anchors;
    leaveJournal({}, QByteArray::fromStdString(formatProject(project, "/nowhere/site.c2sproj")));
    OfficeWindow office(false);
    QVERIFY(office.window.recovery().offer());
    QVERIFY2(recoveryText(office).contains(QStringLiteral("Images: blueprint.png, slam.png; anchors: 2")),
             qPrintable(recoveryText(office)));
  }

  void aJournalThatCannotBeReadStaysAndIsTold() {
    const QString folder =
        leaveJournal(QStringLiteral("/nowhere/site.c2sproj"), R"({"format":"cad2slam-project","version":2})");
    OfficeWindow office(false);
    QVERIFY(office.window.recovery().offer());
    const QString told = recoveryText(office);
    QVERIFY2(told.contains(QStringLiteral("site.c2sproj")) && told.contains(QStringLiteral("newer program")),
             qPrintable(told));
    QVERIFY(QFile::exists(folder + QStringLiteral("/00000001.c2sproj")));
    QVERIFY(!office.pressCure(QStringLiteral("recovery-"), QStringLiteral("Recover")));
    QVERIFY(office.pressCure(QStringLiteral("recovery-"), QStringLiteral("Discard")));
    QVERIFY(!QDir(folder).exists());
    QVERIFY(!office.hasMessage(QStringLiteral("recovery-")));
  }

  void aJournalWithoutAProjectGoesAwaySilently() {
    const QString folder = leaveJournal(QStringLiteral("/nowhere/site.c2sproj"), {});
    OfficeWindow office(false);
    QVERIFY(!office.window.recovery().offer());
    QVERIFY(!QDir(folder).exists());
  }

  void anOlderVersionIsTakenWhereTheNewestIsBroken() {
    const QString folder = leaveJournal({}, smallJournal());
    write(folder + QStringLiteral("/00000002.c2sproj"), "{");
    const std::vector<Recoverable> found = Autosave::findRecoverable(Autosave::defaultRoot());
    QCOMPARE(found.size(), std::size_t(1));
    QVERIFY(found[0].unreadable.isEmpty());
    QCOMPARE(found[0].project.slam_maps.size(), std::size_t(1));
  }
};

/// Adds anchors as fast as the journal takes them and tells how many are on disk. A single one waits for its end.
static int editUntilKilled(int argc, char** argv) {
  QCoreApplication app(argc, argv);
  ProjectDocument document;
  Autosave autosave(document, QString::fromLocal8Bit(argv[2]));
  document.reset(test::smallProject(), "/nowhere/site.c2sproj");
  QFile out;
  if (!out.open(stdout, QIODevice::WriteOnly)) return 1;
  for (int count = 1;; ++count) {
    edit::addAnchor(document, {0.1 * count, 1.0}, {2.0, 0.2 * count});
    autosave.flush();
    out.write(QByteArray::number(count) + '\n');
    out.flush();
    if (QByteArray(argv[3]) == "1") QThread::sleep(600);
  }
}

int main(int argc, char** argv) {
  if (argc == 4 && qstrcmp(argv[1], kVictimFlag) == 0) return editUntilKilled(argc, argv);
  QApplication app(argc, argv);
  RecoveryTest test;
  return QTest::qExec(&test, argc, argv);
}
#include "recovery_test.moc"
