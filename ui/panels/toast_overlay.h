// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

class QVBoxLayout;

namespace cad2slam {

/// A narrow place over the lower edge of a widget, for what is shown for some seconds: nothing moves when it comes or
/// goes. Hidden while there is nothing in it.
class ToastOverlay : public QWidget {
  Q_OBJECT

 public:
  /// `under`: what it lies over; it is that widget's sibling, so that no layout of it is touched.
  explicit ToastOverlay(QWidget& under);

  [[nodiscard]] QVBoxLayout& rows() { return *rows_; }
  /// After rows have come or gone.
  void settle();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QWidget& under_;
  QVBoxLayout* rows_;
};

}  // namespace cad2slam
