// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStyledItemDelegate>
#include <QValidator>

namespace cad2slam {

/// Lets an editor close only on a number; decimal point and comma are both understood.
class NumberValidator : public QValidator {
  Q_OBJECT

 public:
  using QValidator::QValidator;
  [[nodiscard]] State validate(QString& text, int& position) const override;
};

/// Edits cells of the table. What is being typed is the user's: a solve that ends meanwhile does not overwrite it.
class CellDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  void setEditorData(QWidget* editor, const QModelIndex& index) const override;
};

/// Writes the verdict on an anchor in the colour of its marker.
class FlagDelegate : public CellDelegate {
  Q_OBJECT

 public:
  using CellDelegate::CellDelegate;

 protected:
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override;
};

/// Edits coordinates in the table: text that is no number stays in the editor, marked, with the reason beside it.
class CoordinateDelegate : public CellDelegate {
  Q_OBJECT

 public:
  using CellDelegate::CellDelegate;
  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

}  // namespace cad2slam
