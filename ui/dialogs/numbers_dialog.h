// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>
#include <QString>

#include <optional>
#include <vector>

class QLineEdit;
class QPushButton;

namespace cad2slam {

/// Asks for a few numbers: coordinates of an anchor, a pose. OK waits until each field holds one.
class NumbersDialog : public QDialog {
  Q_OBJECT

 public:
  struct Field {
    QString label;  ///< with the unit
    std::optional<double> value;
  };
  NumbersDialog(QWidget* parent, const QString& title, const std::vector<Field>& fields);

  /// A field that was left alone keeps the digits it does not show.
  [[nodiscard]] double value(std::size_t field) const;

 private:
  void refresh();

  struct Entry {
    QLineEdit* edit = nullptr;
    QString text;  // as first shown
    double value = 0.0;
  };
  std::vector<Entry> entries_;
  QPushButton* ok_;
};

}  // namespace cad2slam
