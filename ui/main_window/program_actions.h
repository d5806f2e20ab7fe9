// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace cad2slam {

class MainWindow;

/// Settings, appearance, help and the guided tour: actions of the program rather than of the project.
void connectProgramActions(MainWindow& window);
/// Opens the bundled sample and shows the first step. Without the sample only the hints remain.
void startTour(MainWindow& window);
/// Writes the report with pictures of both maps as a whole; problems end in the message bar.
bool saveReport(MainWindow& window, const QString& path);
/// Puts the test pose to typed numbers, in the frame of the active view.
void askTestPose(MainWindow& window);
/// Asks for a file of poses and the map they are of, and shows them.
void askPoses(MainWindow& window);
void pastePoses(MainWindow& window);

}  // namespace cad2slam
