// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "cad2slam/projection/projector_arrays.h"

#include <QtTest>

#include "support/projector_samples.h"

using namespace cad2slam;

class ProjectorArraysTest : public QObject {
  Q_OBJECT

 private slots:
  void thereAndBack() {
    const ProjectorData data = test::sampleProjector(4, 3);
    const ProjectorArrays arrays = arraysOf(data);
    QCOMPARE(arrays.node_tile.size(), std::size_t{12});
    QCOMPARE(arrays.node_slam[7][2], data.node_slam[7].heading);
    ProjectorData back = test::sampleProjector(5, 5);  // of which nothing may be left
    setNodes(back, arrays);
    back.edges = data.edges;
    back.anchors = data.anchors;
    back.check_poses = data.check_poses;
    QVERIFY(test::sameProjector(back, data));
  }
};

QTEST_APPLESS_MAIN(ProjectorArraysTest)
#include "projector_arrays_test.moc"
