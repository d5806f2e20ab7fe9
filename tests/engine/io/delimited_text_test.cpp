// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/io/delimited_text.h"

#include <QtTest>

using namespace cad2slam;
using Fields = std::vector<std::string>;

namespace {

struct Split {
  std::vector<Fields> records;
  std::vector<std::size_t> lines;
  std::vector<std::size_t> complaints;
};

Split split(std::string_view text, char separator = ',') {
  RecordReader reader(text, separator);
  Split result;
  while (const std::optional<TextRecord> record = reader.next()) {
    if (!record->complaint.empty()) {
      result.complaints.push_back(record->line);
      continue;
    }
    result.records.push_back(record->fields);
    result.lines.push_back(record->line);
  }
  return result;
}

}  // namespace

class DelimitedTextTest : public QObject {
  Q_OBJECT

 private slots:
  void anyLineEndEndsALine() {
    const std::vector<Fields> expected{{"a", "b"}, {"c"}};
    for (const char* text : {"a,b\nc", "a,b\r\nc\r\n", "a,b\rc\r", "\n\n a , b \n\t\n# note\nc\n", "a,b # note\nc"}) {
      QCOMPARE(split(text).records, expected);
    }
    QCOMPARE(split("a\n\n\r\n#\nb").lines, (std::vector<std::size_t>{1, 5}));
  }

  void separatorsSeparate() {
    QCOMPARE(split("1;2,5; ;", ';').records, (std::vector<Fields>{{"1", "2,5", "", ""}}));
    QCOMPARE(split("\t1\t 2 ", '\t').records, (std::vector<Fields>{{"", "1", "2"}}));
    QCOMPARE(split("  1 \t 2   3  # note", ' ').records, (std::vector<Fields>{{"1", "2", "3"}}));
    QCOMPARE(split("a,,", ',').records, (std::vector<Fields>{{"a", "", ""}}));
  }

  void quotesHoldEverything() {
    QCOMPARE(split("\"a,\"\"b\"\"\r\n c\" , d # note\nnext").records,
             (std::vector<Fields>{{"a,\"b\"\r\n c", "d"}, {"next"}}));
    QCOMPARE(split("\"a\nb\"\nc").lines, (std::vector<std::size_t>{1, 3}));
    QCOMPARE(split("\"a b\" 2", ' ').records, (std::vector<Fields>{{"a b", "2"}}));
    QCOMPARE(split("5\" pipe,6").records, (std::vector<Fields>{{"5\" pipe", "6"}}));  // an inch sign is no quote
  }

  void aLostQuoteCostsOneLine() {
    const Split lost = split("1,\"never closed\n2,b\n3,\"c\"\n");
    QCOMPARE(lost.complaints, (std::vector<std::size_t>{1}));
    QCOMPARE(lost.records, (std::vector<Fields>{{"2", "b"}, {"3", "c"}}));
    const Split behind = split("1,\"a\"b\n2,\"c\"\n");
    QCOMPARE(behind.complaints, (std::vector<std::size_t>{1}));
    QCOMPARE(behind.records, (std::vector<Fields>{{"2", "c"}}));
  }

  void manyLostQuotesAreReadInLinearTime() {
    // Each of these lines would like to read to the end of the text.
    std::string text;
    for (int k = 0; k < 300000; ++k) text += "\"\"\"\n";
    std::size_t count = 0;
    RecordReader reader(text, ',');
    while (reader.next()) ++count;
    QVERIFY(count > 0);
  }

  void textFieldsMayHoldNumberSigns() {
    RecordReader reader("1 # no,x # yes", ',');
    QCOMPARE(reader.next()->fields, (Fields{"1"}));
    RecordReader text_reader("1,x # yes,2 # no", ',');
    text_reader.setTextField([](std::size_t field) { return field == 1; });
    QCOMPARE(text_reader.next()->fields, (Fields{"1", "x # yes", "2"}));
  }
};

QTEST_APPLESS_MAIN(DelimitedTextTest)
#include "delimited_text_test.moc"
