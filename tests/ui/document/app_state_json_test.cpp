// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/document/app_state_json.h"

#include "ui/support/documents.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QTest>

using namespace cad2slam;

class AppStateJsonTest : public QObject {
  Q_OBJECT

 private slots:
  void whatNewerVersionsKeepInTheViewStateSurvives() {
    Project project = test::smallProject();
    project.view_state_json = R"({"lenses":[{"x":1.5}],"locked":true,"class_limits":{"ok_m":0.5,"shape":"round"},)"
                              R"("views":{"minimap":{"on":true}}})";
    ProjectDocument document;
    document.reset(project, {});
    document.setLocked(false);
    const QJsonObject saved =
        QJsonDocument::fromJson(QByteArray::fromStdString(document.projectToSave().view_state_json)).object();
    QCOMPARE(saved[u"lenses"].toArray().at(0).toObject()[u"x"].toDouble(), 1.5);
    QCOMPARE(saved[u"class_limits"].toObject()[u"shape"].toString(), QStringLiteral("round"));
    QCOMPARE(saved[u"class_limits"].toObject()[u"ok_m"].toDouble(), 0.5);
    QVERIFY(saved[u"views"].toObject()[u"minimap"].toObject()[u"on"].toBool());
    QVERIFY(!saved[u"locked"].toBool());
  }

  void hostileViewStateFallsBackToDefaults() {
    Project project = test::smallProject();
    for (const char* text : {"", "[]", "{\"next_anchor_id\":1e300,\"class_limits\":{\"ok_m\":-1},\"snapped\":[1]}",
                             "{\"next_anchor_id\":\"x\",\"views\":7,\"class_limits\":null}", "{{{"}) {
      project.view_state_json = text;
      ProjectDocument document;
      document.reset(project, {});
      QCOMPARE(document.nextId(), AnchorId(1));
      QVERIFY(document.state().limits == ClassLimits{});
    }
  }
};

QTEST_GUILESS_MAIN(AppStateJsonTest)
#include "app_state_json_test.moc"
