// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>

#include <optional>

namespace cad2slam {

class MainWindow;

/// A few steps on the bundled sample building; each goes on by itself when it was done. Deletes itself at its end.
class Tour : public QObject {
  Q_OBJECT

 public:
  explicit Tour(MainWindow& window, std::optional<QString> sample = sampleFolder());

  /// The folder of the bundled sample, where there is one.
  [[nodiscard]] static std::optional<QString> sampleFolder();

  void start();

 private:
  void refresh();
  void finish();
  [[nodiscard]] QString textOfStep(int step) const;
  [[nodiscard]] int stepOf() const;

  MainWindow& window_;
  std::optional<QString> sample_;
  int step_ = -1;
  bool looked_ = false;
};

}  // namespace cad2slam
