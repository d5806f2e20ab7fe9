// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/engine_sentences.h"

#include "cad2slam/anchors/anchor_checks.h"
#include "cad2slam/io/anchors_csv.h"
#include "cad2slam/io/map_file.h"
#include "cad2slam/io/project_file.h"
#include "cad2slam/io/projector_file.h"
#include "cad2slam/mesh/mesh_builder.h"
#include "cad2slam/solver/mesh_solver.h"
#include "support/temporary_folder.h"
#include "ui/convert.h"
#include "ui/main_window/appearance.h"

#include <QCoreApplication>
#include <QHash>
#include <QRegularExpression>
#include <QTest>
#include <QTranslator>

#include <algorithm>
#include <memory>
#include <utility>

using namespace cad2slam;
using test::TemporaryFolder;

namespace {

/// A language in which each sentence of the engine is the same in brackets, or what the test says. Installed while the
/// object lives.
class BracketLanguage : public QTranslator {
 public:
  BracketLanguage() { QCoreApplication::installTranslator(this); }
  ~BracketLanguage() override { QCoreApplication::removeTranslator(this); }

  [[nodiscard]] bool isEmpty() const override { return false; }
  QString translate(const char* context, const char* source, const char*, int) const override {
    if (qstrcmp(context, "Engine") != 0) return {};
    const QString english = QString::fromUtf8(source);
    asked_ += english;
    return other_words_.value(english, QLatin1Char('[') + english + QLatin1Char(']'));
  }

  void say(const QString& english, const QString& other) { other_words_[english] = other; }
  QStringList takeAsked() { return std::exchange(asked_, {}); }

 private:
  QHash<QString, QString> other_words_;
  mutable QStringList asked_;
};

const QRegularExpression kInserted(QStringLiteral("%[0-9]"));

QStringList placesOf(const QString& text) {
  QStringList found;
  for (auto match = kInserted.globalMatch(text); match.hasNext();) found += match.next().captured();
  return found;
}

/// The sentence with `value` in all places; a # in there is the number of the place.
QString sentenceWith(const QString& pattern, const QString& value) {
  const QStringList literals = pattern.split(kInserted);
  QString sentence = literals.first();
  for (qsizetype k = 1; k < literals.size(); ++k)
    sentence += QString(value).replace(QLatin1Char('#'), QString::number(k)) + literals[k];
  return sentence;
}

QString capitalized(QString text) {
  if (!text.isEmpty()) text[0] = text[0].toUpper();
  return text;
}

template <class T>
QString translationOf(const Result<T>& failed) {
  return toSentence(failed.error());
}

}  // namespace

class EngineSentencesTest : public QObject {
  Q_OBJECT

 private slots:
  void placesAreNumberedInOrder() {
    QStringList seen;
    for (const char* english : enginePatterns()) {
      const QString pattern = QString::fromUtf8(english);
      QStringList expected;
      for (int k = 1; k <= placesOf(pattern).size(); ++k) expected += QStringLiteral("%%1").arg(k);
      QCOMPARE(placesOf(pattern), expected);
      QVERIFY2(expected.size() <= 9, english);
      // Without words between two places nobody knows where the one ends.
      QVERIFY2(!pattern.contains(QRegularExpression(QStringLiteral("%[1-9]%[1-9]"))), english);
      QVERIFY2(pattern.contains(QRegularExpression(QStringLiteral("[a-z]{2}"))), english);
      QVERIFY2(!seen.contains(pattern), english);
      seen += pattern;
    }
    QVERIFY(!seen.isEmpty());
  }

  void englishStaysAsItIs_data() {
    QTest::addColumn<QString>("value");
    QTest::newRow("number") << QStringLiteral("3.14");
    QTest::newRow("empty") << QString();
    QTest::newRow("place") << QStringLiteral("%1");
    QTest::newRow("other place") << QStringLiteral("%2%1%9");
    QTest::newRow("percent") << QStringLiteral("50 %");
    QTest::newRow("colons") << QStringLiteral("/a: b/c.yaml:7: d");
    QTest::newRow("lines") << QStringLiteral("a\nb\r\n");
    QTest::newRow("backslash") << QStringLiteral("\\1 \\E .* $");
    QTest::newRow("brackets") << QStringLiteral("'(x]'");
    QTest::newRow("other script") << QStringLiteral("\u56fe \u00fc \U0001f916");
    QTest::newRow("words of the engine") << QStringLiteral(" is missing; there is no such file");
    QTest::newRow("a whole sentence") << QStringLiteral("is damaged: its header was changed");
  }
  void englishStaysAsItIs() {
    QFETCH(QString, value);
    for (const char* language : {"", "en"}) {
      if (*language != '\0') applyLanguage(QString::fromLatin1(language));
      for (const char* english : enginePatterns()) {
        const std::string message = toStd(sentenceWith(QString::fromUtf8(english), value));
        for (const std::string& where : {std::string(), std::string("/maps/a: b.yaml:7"), std::string("anchor 12")}) {
          const Error error{ErrorCode::kMalformed, message, where};
          QCOMPARE(toSentence(error), capitalized(toQString(error.sentence())));
        }
        QCOMPARE(translatedSentence(message), toQString(message));
      }
    }
  }

  void whatStandsByItselfBeginsWithACapitalLetter() {
    QCOMPARE(toSentence({ErrorCode::kDegenerate, "the mesh has no node", ""}), QStringLiteral("The mesh has no node"));
    QCOMPARE(toSentence({ErrorCode::kDegenerate, "its number is used twice", "anchor 3"}),
             QStringLiteral("Anchor 3: its number is used twice"));
    QCOMPARE(toSentence({ErrorCode::kMalformed, "is empty", "maps/slam.yaml"}),
             QStringLiteral("maps/slam.yaml: is empty"));
    QCOMPARE(translatedSentence("the mesh has no node"), QStringLiteral("the mesh has no node"));
  }

  void namesThatAreNoUtf8AreShownAsBefore() {
    for (const char* name : {"/maps/\xff.yaml", "/maps/\xe2\x82", "/maps/\xf0\x9f", "\xc3"}) {
      const Error error{ErrorCode::kUnreadable, std::string("cannot be written: ") + name, name};
      QCOMPARE(toSentence(error), toQString(error.sentence()));
    }
  }

  void everySentenceIsRecognised() {
    BracketLanguage language;
    for (const char* english : enginePatterns()) {
      const QString pattern = QString::fromUtf8(english);
      const QString sentence = sentenceWith(pattern, QStringLiteral("<#>"));
      language.takeAsked();
      QCOMPARE(translatedSentence(toStd(sentence)), QLatin1Char('[') + sentence + QLatin1Char(']'));
      QCOMPARE(language.takeAsked(), QStringList(pattern));
    }
  }

  void whatFailsInTheEngineIsTranslated() {
    const BracketLanguage language;
    const TemporaryFolder folder;

    const std::filesystem::path project = folder.path("site is missing.c2sproj");
    QCOMPARE(translationOf(readProject(project)), toQString(project) + QStringLiteral(": [there is no such file]"));

    const std::filesystem::path yaml = folder.write("map.yaml", "image: map.pgm\nresolution: twice\n");
    QCOMPARE(translationOf(readMapYaml(yaml)),
             toQString(yaml) + QStringLiteral(":2: [resolution must be a number from 1e-06 to 10000, not 'twice']"));

    const auto hall = OccupancyGrid(*MapFrame::create(0.1, 20, 20, Pose2{}), cv::Mat(20, 20, CV_8UC1, cv::Scalar(0)));
    MeshSolver solver(std::make_shared<const Mesh>(*buildMesh(hall, 0.5)));
    QCOMPARE(translationOf(solver.solve({}, defaultSettings(Model::kStretch))),
             QStringLiteral("[there is no enabled anchor; at least one pair of corresponding points is needed]"));

    const Anchor anchor{12, {1.0, 1.0}, {1.0, 1.0}};
    QCOMPARE(translationOf(checkAnchors({anchor, anchor}, {})),
             QStringLiteral("[anchor 12]: [its number is used twice]"));
  }

  void reasonsInReasonsAreTranslated() {
    const BracketLanguage language;
    const TemporaryFolder folder;
    const std::filesystem::path anchors = folder.write("anchors.csv", "1,a,2,3,4\n");
    QCOMPARE(translationOf(readAnchors(anchors)),
             toQString(anchors) + QStringLiteral(":1: [no line can be read as an anchor; the first one "
                                                 "[blueprint_x 'a' is not a finite number]]"));
    const Result<AnchorImport> some = parseAnchorsCsv("1,1,2,3,4\n1,1,2,3,4\n", "anchors.csv");
    QCOMPARE(translatedSentence(some->rejected.at(0).reason), QStringLiteral("[the id 1 already stands in line 1]"));

    const std::string header = R"({"nodes":{"dtype":[]}})";
    const std::string file = std::string(1, static_cast<char>(header.size())) + std::string(7, '\0') + header;
    QCOMPARE(translationOf(parseProjectorFile(file, "/a.c2s")),
             QStringLiteral("/a.c2s: [has a header that [has [a list] where it should not, in 'nodes']]"));
  }

  void anyReasonMayStandInAReason() {
    const BracketLanguage language;
    for (const char* outer : {"cannot be written: %1", "has a header that %1", "no anchor can be read: %1",
                              "no line can be read as an anchor; the first one %1"}) {
      QCOMPARE(std::count_if(enginePatterns().begin(), enginePatterns().end(),
                             [&](const char* pattern) { return qstrcmp(pattern, outer) == 0; }),
               1);
      for (const char* inner : enginePatterns()) {
        const QString reason = sentenceWith(QString::fromUtf8(inner), QStringLiteral("<#>"));
        QCOMPARE(translatedSentence(toStd(sentenceWith(QString::fromUtf8(outer), reason))),
                 QLatin1Char('[') + sentenceWith(QString::fromUtf8(outer), QStringLiteral("[%1]").arg(reason)) +
                     QLatin1Char(']'));
      }
    }
  }

  void aLanguageMayOrderItsWords() {
    BracketLanguage language;
    language.say(QStringLiteral("the id %1 already stands in line %2"), QStringLiteral("%2 has %1, 100 % of it, %3"));
    QCOMPARE(translatedSentence("the id %2 already stands in line %1"), QStringLiteral("%1 has %2, 100 % of it, %3"));
  }

  void whatIsNotKnownStays() {
    const BracketLanguage language;
    for (const char* unknown : {"", "%1", "nobody says this", "there is no such file, is there", "50 % of %1: %2"}) {
      QCOMPARE(translatedSentence(unknown), QString::fromUtf8(unknown));
      const Error error{ErrorCode::kInternal, unknown, "/tmp/50 %1/map.yaml:3"};
      QCOMPARE(toSentence(error), toQString(error.sentence()));
    }
    // A file may be called like a sentence.
    QCOMPARE(toSentence({ErrorCode::kMalformed, "is empty", "/tmp/the image is missing"}),
             QStringLiteral("/tmp/the image is missing: [is empty]"));
  }

  void everySentenceHasATranslation_data() {
    QTest::addColumn<QString>("language");
    QTest::newRow("German") << QStringLiteral("de");
    QTest::newRow("Spanish") << QStringLiteral("es");
  }
  void everySentenceHasATranslation() {
    QFETCH(QString, language);
    QTranslator translator;
    QVERIFY(translator.load(QStringLiteral(":/i18n/cad2slam_%1.qm").arg(language)));
    for (const char* english : enginePatterns()) {
      const QString translation = translator.translate("Engine", english);
      QVERIFY2(!translation.isEmpty(), english);
      QStringList places = placesOf(translation);
      places.sort();
      QVERIFY2(places == placesOf(QString::fromUtf8(english)), qPrintable(translation));
      QVERIFY2(translation.endsWith(QLatin1Char('.')) == QByteArray(english).endsWith('.'), qPrintable(translation));
    }
  }
};

QTEST_GUILESS_MAIN(EngineSentencesTest)
#include "engine_sentences_test.moc"
